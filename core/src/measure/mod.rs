//! Figures about scenes and pictures: pure functions that cost nothing unless they are asked for.

mod overdraw;

pub use overdraw::{Overdraw, overdraw};
