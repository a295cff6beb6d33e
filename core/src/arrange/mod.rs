//! What artists do with many things at once: duplicate, mirror, delete, join, split, group, place.
//!
//! Each is a pure function of the scene and of ids to an [`Arrangement`]: edits for one transaction of
//! [`crate::document::Document::edit`], and what is to be selected after it. Window, command line and scripts share
//! them. Ids that are gone are passed over; where nothing is left to do there are no edits, and the document makes no
//! undo point of that.
//!
//! Copies get ids of their own, since an id stands for one thing in the whole scene. Their boxes keep the `key` that
//! their random numbers are drawn by, so a copy looks like its original, hand-made changes to single sprites included.

pub mod auto_group;
pub mod clip;
mod copied;
mod copy;
pub mod delete;
pub mod duplicate;
pub mod fill;
pub mod folders;
pub mod group;
pub mod join;
pub mod keys;
pub mod mirror;
mod model_space;
mod names;
pub mod order;
pub mod place_many;
pub mod rename;
pub mod split;
pub mod sprites;
#[cfg(test)]
mod test_scenes;
pub mod transfer;

pub(crate) use copy::copy_model;
pub use model_space::ModelSpace;
pub use names::Names;

use crate::document::{Edit, ListEdit};
use crate::scene::{Cloud, CloudBox, CloudModel, HasId, IdCounter, List, ModelId, Scene, Thing};

/// Edits that belong together.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Arrangement {
    /// To be applied in order, as one transaction.
    pub edits: Vec<Edit>,
    /// What was made or changed, to be selected.
    pub made: Vec<Thing>,
}

/// Why something can't be arranged as asked.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Refusal {
    /// Joining needs two.
    #[error("choose at least two clouds to join")]
    TooFewClouds,
    /// Splitting needs a part that is not the whole.
    #[error("choose some of the cloud's boxes, but not all, to split them off")]
    NotAPart,
    /// Boxes are parts of a model.
    #[error("choose a cloud or a model to paste boxes into")]
    NoModel,
}

/// An arrangement in the making.
struct Plan<'a> {
    scene: &'a Scene,
    next_id: IdCounter,
    edits: Vec<Edit>,
    made: Vec<Thing>,
}

impl<'a> Plan<'a> {
    fn new(scene: &'a Scene) -> Self {
        Self { scene, next_id: scene.next_id, edits: Vec::new(), made: Vec::new() }
    }

    fn replace_box(&mut self, model: ModelId, cloud_box: CloudBox) {
        self.edits.push(Edit::Box(model, ListEdit::Replace(cloud_box)));
    }

    fn insert_model(&mut self, model: CloudModel) {
        self.edits.push(Edit::Model(at_end(model)));
    }

    fn insert_cloud(&mut self, cloud: Cloud) {
        self.edits.push(Edit::Cloud(at_end(cloud)));
    }

    fn done(mut self) -> Arrangement {
        if self.next_id != self.scene.next_id {
            self.edits.insert(0, Edit::NextId(self.next_id));
        }
        Arrangement { edits: self.edits, made: self.made }
    }
}

fn at_end<T: HasId>(value: T) -> ListEdit<T> {
    ListEdit::Insert { at: usize::MAX, value }
}

/// Those of `list` that have one of the `ids`, in the list's order, each once.
fn chosen<'s, T: HasId>(list: &'s List<T>, ids: &'s [T::Id]) -> impl Iterator<Item = &'s T> {
    let ids: std::collections::BTreeSet<T::Id> = ids.iter().copied().collect();
    list.iter().filter(move |each| ids.contains(&each.id()))
}
