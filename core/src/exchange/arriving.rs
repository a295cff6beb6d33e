//! What a reader is given, and what it makes of a file: clouds for a scene, a model of what flies there, or a sky.

use super::{ArrivedModel, Note, Options};
use crate::arrange::{Names, copy_model};
use crate::document::{Edit, ListEdit};
use crate::formats::wpr::Preset;
use crate::scene::{Cloud, CloudId, CloudModel, IdCounter, Scene};
use glam::DVec3;

/// A file that comes in.
#[derive(Debug)]
pub struct Arriving<'a> {
    /// Its bytes.
    pub bytes: &'a [u8],
    /// Its name without folder and ending, for what has no name in it.
    pub name: &'a str,
    /// What was set.
    pub options: &'a Options,
}

/// What came in.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrived {
    /// What it is.
    pub content: Content,
    /// What it could not carry, or does not say.
    pub notes: Vec<Note>,
}

/// What a file holds.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// Models, each with the places where it stands.
    Clouds(Vec<ArrivedCloud>),
    /// The shape of an aircraft: the file itself stays beside the scene, which names it.
    Model(ArrivedModel),
    /// A whole scene.
    Scene(Box<Scene>),
    /// Weather to make a sky of, whose clouds plugins place.
    Weather(Box<Preset>),
}

/// A model that came in. Its ids count from 1 and are its own.
#[derive(Debug, Clone, PartialEq)]
pub struct ArrivedCloud {
    /// The model.
    pub model: CloudModel,
    /// Where it stands from where the file is put, metres; nowhere for one that is only defined.
    pub places: Vec<DVec3>,
}

impl ArrivedCloud {
    /// Edits that put `clouds` into `scene` around `at`, metres in the world, ready for one transaction; and the ids of the
    /// clouds.
    pub fn place_all(clouds: &[Self], scene: &Scene, at: DVec3) -> (Vec<Edit>, Vec<CloudId>) {
        let mut ids: IdCounter = scene.next_id;
        let mut edits = Vec::new();
        let mut placed = Vec::new();
        let mut names = Names::new(scene.models.iter().map(|model| model.name.as_str()));
        for ArrivedCloud { model, places } in clouds {
            let model = copy_model(model, names.free(&model.name), &mut ids);
            for place in places {
                let cloud = Cloud::new(CloudId::new(&mut ids), &model, at + *place);
                placed.push(cloud);
            }
            edits.push(Edit::Model(ListEdit::Insert { at: usize::MAX, value: model }));
        }
        let made = placed.iter().map(|cloud| cloud.id).collect();
        edits.extend(placed.into_iter().map(|value| Edit::Cloud(ListEdit::Insert { at: usize::MAX, value })));
        edits.insert(0, Edit::NextId(ids));
        (edits, made)
    }
}
