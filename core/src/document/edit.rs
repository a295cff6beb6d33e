//! Single edits: each sets one part of the scene and yields the edit that undoes it.

use super::{Change, EditError};
use crate::scene::{
    Aircraft, AircraftId, BoxId, Camera, CameraId, CameraPath, Cloud, CloudBox, CloudId, CloudModel, Ground, GroupId,
    HasId, IdCounter, List, ModelId, PathId, Place, Scene, ShadingGroup, Sky, Sun,
};

/// A named value that changes a scene.
#[derive(Debug, Clone, PartialEq)]
pub enum Edit {
    /// The scene's name.
    Name(String),
    /// The counter of ids, after taking some for new things.
    NextId(IdCounter),
    /// Local civil hours.
    TimeOfDay(f64),
    /// Place and date.
    Place(Place),
    /// Where the sun comes from.
    Sun(Sun),
    /// Light, air and exposure.
    Sky(Sky),
    /// The ground, or none.
    Ground(Option<Ground>),
    /// The scene's own sheet of tiles, or none.
    Atlas(Option<String>),
    /// A camera.
    Camera(ListEdit<Camera>),
    /// A cloud model.
    Model(ListEdit<CloudModel>),
    /// A box of a model.
    Box(ModelId, ListEdit<CloudBox>),
    /// A shading group of a model.
    Group(ModelId, ListEdit<ShadingGroup>),
    /// A placed cloud.
    Cloud(ListEdit<Cloud>),
    /// A camera path.
    Path(ListEdit<CameraPath>),
    /// An aircraft.
    Aircraft(ListEdit<Aircraft>),
}

/// A change to one of the scene's lists.
#[derive(Debug, Clone, PartialEq)]
pub enum ListEdit<T: HasId> {
    /// Puts `value` at position `at` (at the end if that is beyond it).
    Insert {
        /// Position in the list.
        at: usize,
        /// What to insert.
        value: T,
    },
    /// Takes the one of that id out.
    Remove(T::Id),
    /// Puts the value in the place of the one that has its id.
    Replace(T),
}

impl Edit {
    /// Changes `scene` and gives the edit that leads back.
    ///
    /// # Errors
    /// If it names something that the scene does not have; the scene is then untouched.
    pub(super) fn apply(self, scene: &mut Scene) -> Result<Self, EditError> {
        let swap = |place: &mut _, new| std::mem::replace(place, new);
        Ok(match self {
            Self::Name(name) => Self::Name(std::mem::replace(&mut scene.name, name)),
            Self::NextId(next) => Self::NextId(std::mem::replace(&mut scene.next_id, next)),
            Self::TimeOfDay(hour) => Self::TimeOfDay(swap(&mut scene.time_of_day_h, hour)),
            Self::Place(place) => Self::Place(std::mem::replace(&mut scene.place, place)),
            Self::Sun(sun) => Self::Sun(std::mem::replace(&mut scene.sun, sun)),
            Self::Sky(sky) => Self::Sky(std::mem::replace(&mut scene.sky, sky)),
            Self::Ground(ground) => Self::Ground(std::mem::replace(&mut scene.ground, ground)),
            Self::Atlas(atlas) => Self::Atlas(std::mem::replace(&mut scene.atlas, atlas)),
            Self::Camera(edit) => Self::Camera(edit.apply(&mut scene.cameras, "camera")?),
            Self::Model(edit) => Self::Model(edit.apply(&mut scene.models, "model")?),
            Self::Box(model, edit) => Self::Box(model, edit.apply(&mut model_mut(scene, model)?.boxes, "box")?),
            Self::Group(model, edit) => Self::Group(model, edit.apply(&mut model_mut(scene, model)?.groups, "group")?),
            Self::Cloud(edit) => Self::Cloud(edit.apply(&mut scene.clouds, "cloud")?),
            Self::Path(edit) => Self::Path(edit.apply(&mut scene.paths, "path")?),
            Self::Aircraft(edit) => Self::Aircraft(edit.apply(&mut scene.aircraft, "aircraft")?),
        })
    }

    /// What it touches.
    pub fn change(&self) -> Change {
        let mut change = Change::default();
        match self {
            Self::Ground(_) => change.ground = true,
            Self::Name(_) | Self::TimeOfDay(_) | Self::Place(_) | Self::Sun(_) | Self::Sky(_) | Self::Atlas(_) => {
                change.head = true;
            }
            Self::NextId(_) => {}
            Self::Camera(edit) => change.cameras.extend([edit.id()]),
            Self::Model(edit) => change.models.extend([edit.id()]),
            Self::Box(model, _) | Self::Group(model, _) => change.models.extend([*model]),
            Self::Cloud(edit) => change.clouds.extend([edit.id()]),
            Self::Path(edit) => change.paths.extend([edit.id()]),
            Self::Aircraft(edit) => change.aircraft.extend([edit.id()]),
        }
        // The counter goes with the lists: what they may hold depends on it.
        change.lists = self.replaces().is_none_or(|part| part == Part::NextId);
        change
    }

    /// What the history calls a transaction that was given no name.
    pub fn name(&self) -> String {
        match self {
            Self::Name(_) => "Rename scene",
            Self::NextId(_) => "Take ids",
            Self::TimeOfDay(_) => "Time of day",
            Self::Place(_) => "Place and date",
            Self::Sun(_) => "Sun",
            Self::Sky(_) => "Sky",
            Self::Ground(_) => "Ground",
            Self::Atlas(_) => "Atlas",
            Self::Camera(_) => "Camera",
            Self::Model(_) => "Cloud model",
            Self::Box(..) => "Box",
            Self::Group(..) => "Shading group",
            Self::Cloud(_) => "Cloud",
            Self::Path(_) => "Path",
            Self::Aircraft(_) => "Aircraft",
        }
        .into()
    }

    /// The part of the scene that it gives another value; none if it adds to a list or takes from one.
    pub(super) fn replaces(&self) -> Option<Part> {
        Some(match self {
            Self::Name(_) => Part::Name,
            Self::NextId(_) => Part::NextId,
            Self::TimeOfDay(_) => Part::TimeOfDay,
            Self::Place(_) => Part::Place,
            Self::Sun(_) => Part::Sun,
            Self::Sky(_) => Part::Sky,
            Self::Ground(_) => Part::Ground,
            Self::Atlas(_) => Part::Atlas,
            Self::Camera(ListEdit::Replace(camera)) => Part::Camera(camera.id),
            Self::Model(ListEdit::Replace(model)) => Part::Model(model.id),
            Self::Box(model, ListEdit::Replace(cloud_box)) => Part::Box(*model, cloud_box.id),
            Self::Group(model, ListEdit::Replace(group)) => Part::Group(*model, group.id),
            Self::Cloud(ListEdit::Replace(cloud)) => Part::Cloud(cloud.id),
            Self::Path(ListEdit::Replace(path)) => Part::Path(path.id),
            Self::Aircraft(ListEdit::Replace(aircraft)) => Part::Aircraft(aircraft.id),
            Self::Camera(_)
            | Self::Model(_)
            | Self::Box(..)
            | Self::Group(..)
            | Self::Cloud(_)
            | Self::Path(_)
            | Self::Aircraft(_) => return None,
        })
    }
}

/// A part of the scene that an edit may give another value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Part {
    Name,
    NextId,
    TimeOfDay,
    Place,
    Sun,
    Sky,
    Ground,
    Atlas,
    Camera(CameraId),
    Model(ModelId),
    Box(ModelId, BoxId),
    Group(ModelId, GroupId),
    Cloud(CloudId),
    Path(PathId),
    Aircraft(AircraftId),
}

fn model_mut(scene: &mut Scene, id: ModelId) -> Result<&mut CloudModel, EditError> {
    scene.models.with_id_mut(id).ok_or_else(|| EditError::NotFound { kind: "model", id: id.to_string() })
}

impl<T: HasId> ListEdit<T> {
    fn id(&self) -> T::Id {
        match self {
            Self::Insert { value, .. } | Self::Replace(value) => value.id(),
            Self::Remove(id) => *id,
        }
    }

    fn apply(self, list: &mut List<T>, kind: &'static str) -> Result<Self, EditError> {
        let id = self.id();
        let found = list.position(id);
        let missing = || EditError::NotFound { kind, id: id.to_string() };
        Ok(match self {
            Self::Insert { .. } if found.is_some() => {
                return Err(EditError::Taken { kind, id: id.to_string() });
            }
            Self::Insert { at, value } => {
                list.insert(at.min(list.len()), value);
                Self::Remove(id)
            }
            Self::Remove(_) => {
                let at = found.ok_or_else(missing)?;
                Self::Insert { at, value: list.remove(at) }
            }
            Self::Replace(value) => Self::Replace(std::mem::replace(&mut list[found.ok_or_else(missing)?], value)),
        })
    }
}
