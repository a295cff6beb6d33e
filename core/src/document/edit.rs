//! Single edits: each sets one part of the scene and yields the edit that undoes it.

use super::{Change, EditError};
// With the types and ids that the rows name.
use crate::scene::*;
use serde::{Deserialize, Serialize};

macro_rules! edits {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        /// A named value that changes a scene.
        #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
        pub enum Edit {
            /// The scene's name.
            Name(String),
            /// The counter of ids, after taking some for new things.
            NextId(IdCounter),
            /// Local civil hours.
            TimeOfDay(f64),
            /// Place and date.
            Site(Site),
            /// Where the sun comes from.
            Sun(Sun),
            /// Light, air and exposure.
            Sky(Sky),
            /// Wind and air.
            Weather(Weather),
            /// The ground, or none.
            Ground(Option<Ground>),
            /// The scene's own sheet of tiles, or none.
            Atlas(Option<String>),
            /// A box of a model.
            Box(ModelId, ListEdit<CloudBox>),
            /// A shading group of a model.
            Group(ModelId, ListEdit<ShadingGroup>),
            $($(#[$doc])* $Kind(ListEdit<$Value>),)*
        }

        impl Edit {
            /// Changes `scene` and gives the edit that leads back.
            ///
            /// # Errors
            /// If it names something that the scene does not have; the scene is then untouched.
            pub(super) fn apply(self, scene: &mut Scene) -> Result<Self, EditError> {
                use std::mem::replace;
                Ok(match self {
                    Self::Name(name) => Self::Name(replace(&mut scene.name, name)),
                    Self::NextId(next) => Self::NextId(replace(&mut scene.next_id, next)),
                    Self::TimeOfDay(hour) => Self::TimeOfDay(replace(&mut scene.time_of_day_h, hour)),
                    Self::Site(place) => Self::Site(replace(&mut scene.site, place)),
                    Self::Sun(sun) => Self::Sun(replace(&mut scene.sun, sun)),
                    Self::Sky(sky) => Self::Sky(replace(&mut scene.sky, sky)),
                    Self::Weather(weather) => Self::Weather(replace(&mut scene.weather, weather)),
                    Self::Ground(ground) => Self::Ground(replace(&mut scene.ground, ground)),
                    Self::Atlas(atlas) => Self::Atlas(replace(&mut scene.atlas, atlas)),
                    Self::Box(model, edit) => Self::Box(model, edit.apply(&mut model_mut(scene, model)?.boxes, "box")?),
                    Self::Group(model, edit) => {
                        Self::Group(model, edit.apply(&mut model_mut(scene, model)?.groups, "group")?)
                    }
                    $(Self::$Kind(edit) => Self::$Kind(edit.apply(&mut scene.$list, $word)?),)*
                })
            }

            /// What the history calls a transaction that was given no name.
            pub fn name(&self) -> String {
                match self {
                    Self::Name(_) => "Rename scene",
                    Self::NextId(_) => "Take ids",
                    Self::TimeOfDay(_) => "Time of day",
                    Self::Site(_) => "Place and date",
                    Self::Sun(_) => "Sun",
                    Self::Sky(_) => "Sky",
                    Self::Weather(_) => "Weather",
                    Self::Ground(_) => "Ground",
                    Self::Atlas(_) => "Atlas",
                    Self::Box(..) => "Box",
                    Self::Group(..) => "Shading group",
                    $(Self::$Kind(_) => $title,)*
                }
                .into()
            }

            /// Takes `thing` out, if it stands in a list.
            pub fn removing(thing: Thing) -> Option<Self> {
                Some(match thing {
                    Thing::Box(model, id) => Self::Box(model, ListEdit::Remove(id)),
                    Thing::Group(model, id) => Self::Group(model, ListEdit::Remove(id)),
                    Thing::Sprite(..) => return None,
                    $(Thing::$Kind(id) => Self::$Kind(ListEdit::Remove(id)),)*
                })
            }

            /// Leaves `thing` as it is, if it is there and in a list of the scene: [`Self::value_mut`] then changes it.
            pub fn replacing(scene: &Scene, thing: Thing) -> Option<Self> {
                match thing {
                    $(Thing::$Kind(id) => Some(Self::$Kind(ListEdit::Replace(scene.$list.with_id(id)?.clone()))),)*
                    Thing::Box(..) | Thing::Group(..) | Thing::Sprite(..) => None,
                }
            }

            /// Adds a copy of `thing`, if it is there and in a list of the scene, and tells what the copy is.
            pub fn copying(scene: &Scene, thing: Thing, counter: &mut IdCounter) -> Option<(Self, Thing)> {
                match thing {
                    $(Thing::$Kind(id) => {
                        let old = scene.$list.with_id(id)?.clone();
                        let value = $Value { id: $Id::new(counter), ..old };
                        let copy = Thing::$Kind(value.id);
                        Some((Self::$Kind(ListEdit::Insert { at: usize::MAX, value }), copy))
                    })*
                    Thing::Box(..) | Thing::Group(..) | Thing::Sprite(..) => None,
                }
            }

            /// What it puts into a list of the scene.
            pub fn value_mut(&mut self) -> Option<&mut dyn InScene> {
                match self {
                    $(Self::$Kind(ListEdit::Insert { value, .. } | ListEdit::Replace(value)) => Some(value),)*
                    _ => None,
                }
            }

            /// What it does to which thing; none if it is of the scene's own values.
            fn of_thing(&self) -> Option<(Thing, Way)> {
                match self {
                    Self::Box(model, edit) => Some((Thing::Box(*model, edit.id()), edit.way())),
                    Self::Group(model, edit) => Some((Thing::Group(*model, edit.id()), edit.way())),
                    $(Self::$Kind(edit) => Some((Thing::$Kind(edit.id()), edit.way())),)*
                    _ => None,
                }
            }
        }
    };
}
kinds!(edits);

/// A change to one of the scene's lists.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(bound(
    serialize = "T: Serialize, T::Id: Serialize",
    deserialize = "T: Deserialize<'de>, T::Id: Deserialize<'de>"
))]
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

/// Whether a list keeps its length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    AddsOrTakes,
    Replaces,
}

impl Edit {
    /// What it touches.
    pub fn change(&self) -> Change {
        let mut change = Change::default();
        match self {
            Self::Ground(_) => change.ground = true,
            Self::Weather(_) => (change.head, change.weather) = (true, true),
            Self::Name(_) | Self::TimeOfDay(_) | Self::Site(_) | Self::Sun(_) | Self::Sky(_) | Self::Atlas(_) => {
                change.head = true;
            }
            Self::NextId(_) => {}
            // What a model consists of is touched as a whole.
            Self::Box(model, _) | Self::Group(model, _) => change.things.extend([Thing::Model(*model)]),
            listed => {
                change.weather = matches!(listed, Self::Track(_));
                change.things.extend(listed.of_thing().map(|(thing, _)| thing));
            }
        }
        // The counter goes with the lists: what they may hold depends on it.
        change.lists = self.replaces().is_none_or(|part| part == Part::NextId);
        change
    }

    /// The part of the scene that it gives another value; none if it adds to a list or takes from one.
    pub(super) fn replaces(&self) -> Option<Part> {
        Some(match self {
            Self::Name(_) => Part::Name,
            Self::NextId(_) => Part::NextId,
            Self::TimeOfDay(_) => Part::TimeOfDay,
            Self::Site(_) => Part::Site,
            Self::Sun(_) => Part::Sun,
            Self::Sky(_) => Part::Sky,
            Self::Weather(_) => Part::Weather,
            Self::Ground(_) => Part::Ground,
            Self::Atlas(_) => Part::Atlas,
            listed => match listed.of_thing()? {
                (thing, Way::Replaces) => Part::Thing(thing),
                (_, Way::AddsOrTakes) => return None,
            },
        })
    }
}

/// A part of the scene that an edit may give another value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Part {
    Name,
    NextId,
    TimeOfDay,
    Site,
    Sun,
    Sky,
    Weather,
    Ground,
    Atlas,
    Thing(Thing),
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

    fn way(&self) -> Way {
        if matches!(self, Self::Replace(_)) { Way::Replaces } else { Way::AddsOrTakes }
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
