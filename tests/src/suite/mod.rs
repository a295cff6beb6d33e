//! The suite where methods fail: one table of situations, each with the bound that the shipped method keeps and the
//! methods that must break it.
//!
//! A [`Situation`] is a [`Stage`] (a scene of few sprites, who looks at it and when), a [`Bound`] with its reason, and
//! the names of those methods of the table ([`cloudwright_core::method`]) whose known fault shows there. Bounds are
//! derived, not fitted: most scenes are made so that each pixel can be worked out ([`studio`]). [`judge`] runs every
//! method through every situation; [`report()`] prints what came of it. Situations are from MODEL §4 to §6 and from what
//! W, SkyWorks and SimGear are known to get wrong. What runs on a GPU is held against the CPU in tests/gpu_pictures.

mod bounds;
mod figure;
mod flights;
mod forming;
pub mod heap_flights;
mod report;
mod sprite_changes;
mod stage;
mod stills;
pub mod studio;
mod table;
mod weather;

pub use bounds::{Bound, ROUNDING, STOP};
pub use figure::Figure;
pub use report::report;
pub use sprite_changes::{CHANGES, SpriteChanges, sprite_changes};
pub use stage::{Look, Stage};
pub use table::{Cell, Must, Row, judge};

/// A row of the table.
#[derive(Debug, Clone, Copy)]
pub struct Situation {
    /// In a few words.
    pub name: &'static str,
    /// How it is made, in a sentence.
    pub about: &'static str,
    /// Makes it.
    pub stage: fn() -> Stage,
    /// What the shipped method keeps.
    pub bound: Bound,
    /// The names of the methods that must break that.
    pub breaks: &'static [&'static str],
}

/// All situations: flights, forming, weather, stills.
pub fn situations() -> impl Iterator<Item = &'static Situation> {
    flights::SITUATIONS.iter().chain(forming::SITUATIONS).chain(weather::SITUATIONS).chain(stills::SITUATIONS)
}
