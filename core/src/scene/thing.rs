//! What can be chosen in a scene, and what things in its lists say of themselves.

// The ids that the rows name.
use super::ids::*;
use super::kinds;
use glam::DVec3;
use serde::{Deserialize, Serialize};

macro_rules! things {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        /// Something of a scene that can be chosen.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        pub enum Thing {
            $($(#[$doc])* $Kind($Id),)*
            /// A box of a model.
            Box(ModelId, BoxId),
            /// A shading group of a model.
            Group(ModelId, GroupId),
            /// A sprite of a box of a model, by its index in the box.
            Sprite(ModelId, BoxId, u32),
        }

        impl Thing {
            /// What its kind is called: "model".
            pub fn word(self) -> &'static str {
                match self {
                    $(Self::$Kind(_) => $word,)*
                    Self::Box(..) => "box",
                    Self::Group(..) => "group",
                    Self::Sprite(..) => "sprite",
                }
            }
        }
    };
}
kinds!(things);

/// What a thing in a list of the scene says of itself.
pub trait InScene {
    /// For people; may be empty.
    fn name(&self) -> &str;

    /// The same, to change.
    fn name_mut(&mut self) -> &mut String;

    /// What it can't be without, and the field that says so: it must be there, and is not deleted alone.
    fn hangs_on(&self) -> Option<(&'static str, Thing)> {
        None
    }

    /// The same, to be another one of its kind.
    fn hang_on(&mut self, _thing: Thing) {}

    /// What it is kept in, if it is, and the field that says so: it must be there, and is deleted without it.
    fn kept_in(&self) -> Option<(&'static str, Thing)> {
        None
    }

    /// The same, to be another one of its kind, or none.
    fn keep_in(&mut self, _thing: Option<Thing>) {}

    /// Where in the world it can be taken and moved by hand, in order.
    fn poses_mut(&mut self) -> Vec<PoseMut<'_>> {
        Vec::new()
    }

    /// Points that it fills of the world, metres: for bringing it into view.
    fn points(&self) -> Vec<DVec3> {
        Vec::new()
    }

    /// It is a copy of one that stays, and would hide it or be hidden.
    fn step_aside(&mut self) {}
}

/// A place in the world with where it looks, to change.
#[derive(Debug)]
pub struct PoseMut<'a> {
    /// Metres.
    pub position: &'a mut DVec3,
    /// Degrees clockwise from north, up from level, and clockwise as seen from behind.
    pub attitude_deg: Option<[&'a mut f64; 3]>,
}
