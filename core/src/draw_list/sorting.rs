//! When sprites are sorted again, as a value.

use super::Ranks;
use crate::camera::View;
use crate::weather::CloudNow;
use glam::{DVec3, Vec3};

/// When sprites are sorted again.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Sorting {
    /// For every frame.
    #[default]
    EachFrame,
    /// Every half second, faded over (W).
    Crossfade,
    /// Now and then, and at once.
    Lazy(LazySorting),
}

/// A way to keep an order and to mend it now and then.
#[derive(Debug, Clone, Copy)]
pub struct LazySorting {
    /// In words; no two ways have the same, and they are told apart by it.
    pub name: &'static str,
    /// A frame: sorts the ranks of all clouds if it is time.
    pub step: fn(&mut LastSort, &mut Ranks, &[CloudNow<'_>], &View),
}

/// What a lazy way remembers of when it last sorted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LastSort {
    /// From where, metres in the world.
    pub eye: DVec3,
    /// In which direction, unit.
    pub forward: Vec3,
    /// Frames to wait until the next time.
    pub wait: u32,
    /// How many of them are over.
    pub waited: u32,
}

impl Sorting {
    /// What it is, for charts.
    pub fn name(&self) -> &'static str {
        match self {
            Self::EachFrame => "each frame",
            Self::Crossfade => "each half second, faded over",
            Self::Lazy(lazy) => lazy.name,
        }
    }
}

impl PartialEq for LazySorting {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl LastSort {
    /// A whole sort for `view`.
    pub fn at(view: &View) -> Self {
        Self { eye: view.eye, forward: view.forward, wait: 0, waited: 0 }
    }
}
