//! What has properties.

use crate::scene::{ModelId, PathId, Scene, Sun, Thing, kinds};
use std::fmt;

/// What has properties.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Owner {
    /// The scene itself.
    Scene,
    /// Place and date.
    Site,
    /// The sun.
    Sun,
    /// Light, air and exposure.
    Sky,
    /// Wind and air.
    Weather,
    /// A key of the ambient light over the day.
    AmbientKey(usize),
    /// A key of the directional light over the day.
    DirectionalKey(usize),
    /// The ground.
    Ground,
    /// What can be chosen; of a sprite, what was changed about it by hand.
    Thing(Thing),
    /// A colour level of a model.
    Level(ModelId, usize),
    /// A key of a path.
    Key(PathId, usize),
}

impl Owner {
    /// Whether it is `other`, or part of it.
    pub fn is_within(self, other: Self) -> bool {
        self == other || self.holder().is_some_and(|holder| holder.is_within(other))
    }

    /// Whether `scene` has it, and it has values to set: a sun by place and time has none.
    pub fn is_in(self, scene: &Scene) -> bool {
        match self {
            Self::Scene | Self::Site | Self::Sky | Self::Weather => true,
            Self::Sun => scene.sun != Sun::ByPlace,
            Self::AmbientKey(i) => i < scene.sky.ambient.keys.len(),
            Self::DirectionalKey(i) => i < scene.sky.directional.keys.len(),
            Self::Ground => scene.ground.is_some(),
            Self::Thing(thing) => thing.is_in(scene),
            Self::Level(id, i) => scene.model(id).is_some_and(|model| i < model.color_levels.len()),
            Self::Key(id, i) => scene.path(id).is_some_and(|path| i < path.keys.len()),
        }
    }

    /// What it is a part of, below the scene.
    fn holder(self) -> Option<Self> {
        match self {
            Self::AmbientKey(_) | Self::DirectionalKey(_) => Some(Self::Sky),
            Self::Thing(Thing::Sprite(model, each, _)) => Some(Self::Thing(Thing::Box(model, each))),
            Self::Thing(Thing::Box(model, _) | Thing::Group(model, _)) | Self::Level(model, _) => {
                Some(Self::Thing(Thing::Model(model)))
            }
            Self::Key(path, _) => Some(Self::Thing(Thing::Path(path))),
            _ => None,
        }
    }
}

impl fmt::Display for Owner {
    /// Its address.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scene => Ok(()),
            Self::Site => write!(f, "place"),
            Self::Sun => write!(f, "sun"),
            Self::Sky => write!(f, "sky"),
            Self::Weather => write!(f, "weather"),
            Self::AmbientKey(i) => write!(f, "sky/ambient/{i}"),
            Self::DirectionalKey(i) => write!(f, "sky/directional/{i}"),
            Self::Ground => write!(f, "ground"),
            Self::Thing(thing) => write_thing(f, *thing),
            Self::Level(model, i) => write!(f, "model/{model}/color_levels/{i}"),
            Self::Key(path, i) => write!(f, "path/{path}/key/{i}"),
        }
    }
}

macro_rules! addresses {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        fn write_thing(f: &mut fmt::Formatter<'_>, thing: Thing) -> fmt::Result {
            match thing {
                $(Thing::$Kind(id) => write!(f, "{}/{id}", $word),)*
                Thing::Box(model, id) => write!(f, "model/{model}/box/{id}"),
                Thing::Group(model, id) => write!(f, "model/{model}/group/{id}"),
                Thing::Sprite(model, id, index) => write!(f, "model/{model}/box/{id}/sprite/{index}"),
            }
        }
    };
}
kinds!(addresses);
