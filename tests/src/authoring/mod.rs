//! How the shipped scenes are made: the plugins and their parts make clouds, and sketches place them, in metres.
//!
//! The scenes are plain files that an artist could have saved; writing them from code keeps two hundred boxes
//! consistent and lets a change of taste be made in one place. `cargo run -p cloudwright-tests --bin renew` writes
//! them again.

pub mod aircraft;
mod altocumulus;
mod by_plugin;
mod cumulonimbus;
mod cumulus;
mod fair_weather;
mod far;
mod forming;
mod front;
mod lee;
mod look;
mod overcast;
mod presets;
mod single_cumulus;
mod sketch;
mod stratus;
mod summer_day;

pub use look::heap as heap_levels;
pub use presets::PRESETS;
pub use sketch::{Sketch, Strew};

use cloudwright_core::scene::Scene;

/// A scene's name and how it is made.
pub type NamedScene = (&'static str, fn() -> Scene);

/// The name of each shipped scene's file, without its ending, and how it is made.
pub const SCENES: &[NamedScene] = &[
    ("single_cumulus", single_cumulus::scene),
    ("fair_weather", fair_weather::scene),
    ("cumulonimbus_dusk", cumulonimbus::scene),
    ("morning_stratus", stratus::scene),
    ("altocumulus", altocumulus::scene),
    ("overcast", overcast::scene),
    ("forming", forming::scene),
    ("summer_day", summer_day::scene),
    ("front", front::scene),
    ("lee", lee::scene),
];
