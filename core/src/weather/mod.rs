//! A scene at a moment: what the clock, or a look at another hour, makes of it.
//!
//! A [`Moment`] is a number of seconds and, if another hour is looked at, that hour.

mod formation;
mod light;
mod moment;

pub use formation::{Formed, FormingRule, Stepped};
pub use light::{Light, sun_direction};
pub use moment::Moment;
