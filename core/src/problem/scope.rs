//! What a check looks at: a whole scene, or what a change may have broken in one that was sound.
//!
//! Lists are handed out with positions, less what was not touched. A check of one thing by itself reads those; one that
//! sets things against one another asks the change, and looks at all of them where any may matter.

use crate::change::Change;
use crate::property::Owner;
use crate::scene::{CloudModel, Listed, Scene, Thing};

/// A scene and what was touched of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scope<'a> {
    pub(super) scene: &'a Scene,
    pub(super) change: &'a Change,
}

impl<'a> Scope<'a> {
    /// Whether properties of `owner` may have changed.
    pub(super) fn has(self, owner: Owner) -> bool {
        match owner {
            Owner::Ground => self.change.touches_ground(),
            Owner::Thing(Thing::Box(model, _) | Thing::Group(model, _) | Thing::Sprite(model, ..))
            | Owner::Level(model, _) => self.change.touches_model(model),
            Owner::Thing(thing) => self.change.touches(thing),
            Owner::Key(path, _) => self.change.touches(Thing::Path(path)),
            _ => self.change.touches_head(),
        }
    }

    /// Those of a kind that were touched, with their positions.
    pub(super) fn all<T: Listed>(self) -> impl Iterator<Item = (usize, &'a T)> {
        T::list(self.scene).iter().enumerate().filter(move |(_, value)| self.change.touches(T::thing(value.id())))
    }

    pub(super) fn models(self) -> impl Iterator<Item = (usize, &'a CloudModel)> {
        self.all()
    }
}

#[cfg(test)]
mod tests;
