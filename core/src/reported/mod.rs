//! What a weather report means for a scene: the layers that a sky needs, its air as properties, and several reports of
//! one station as tracks.
//!
//! A [`Report`](crate::formats::metar::Report) is what stands in the text; here is what is made of it. Clouds are
//! planned, not yet placed. Several reports become smooth keys at their times: monotone cubics pass through each
//! report's values, so that the sky steps at none.

mod air;
mod layers;
mod timeline;

pub use air::{Air, EXTINCTION_AT_CONTRAST};
pub use layers::{Genus, PlannedLayer, layers};
pub use timeline::{ApplyError, SPEEDS, Unordered, apply, seconds};
