//! A scene at a moment: what the clock, or a look at another hour, makes of it.
//!
//! A [`Moment`] is a number of seconds and, if another hour is looked at, that hour. [`SceneNow`] is what a frame is made
//! from: sky, light and ground, and of each cloud a [`CloudNow`]. It is a pure function of the scene and the
//! moment: any instant, in any order, and nothing of it touches the document, or what is derived on the edit clock.

mod air;
mod celestial;
mod cloud_now;
mod course;
mod curve;
mod formation;
mod lag;
mod light;
mod moment;
mod pieces;
mod scene_now;
mod shade;
pub mod shadows;
mod streaming;
mod sums;
mod sun_day;
mod timeline;
mod wind;

pub(crate) use air::SWINGS_S;
pub use air::{AirNow, CONDENSING, SWAY, sine};
pub use celestial::{celestial_from_world, moon_direction, sun_direction};
pub use cloud_now::{CloudNow, InAir, Look, REACH, Turn};
pub use course::clouds_now;
pub use curve::Curve;
pub use formation::{Formed, FormingRule, Stepped};
pub use light::{Light, Night};
pub use moment::Moment;
pub use scene_now::SceneNow;
pub use shade::{Shade, ShadeNode};
pub use shadows::{KeptShadows, ShadowMap, Shadows};
pub use streaming::{SteppedStreaming, StreamingRule, WeatherRules};
pub use sun_day::{SunDay, on_day};
pub use timeline::Timeline;
pub use wind::{FULL_LEAN_MPS, Lean, MOST_LEAN, Wind, WindTracks};
