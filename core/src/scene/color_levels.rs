//! Five colours over a cloud's height: the ambient light that each height takes (W's colour levels).

use crate::color::Rgba;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One of the five levels.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ColorLevel {
    /// Height within the cloud, 0 at its bottom, 1 at its top.
    pub height: f64,
    /// Share of the ambient light that this height takes; alpha scales the sprites' opacity.
    pub color: Rgba,
}

/// Exactly five levels, lowest first. Two at one height make a step, at which the later one holds.
pub type ColorLevels = [ColorLevel; 5];

/// The levels of a new model: blue-grey below, near white above.
pub fn default_levels() -> ColorLevels {
    [
        (0.0, Rgba::new(0.30, 0.34, 0.42, 0.92)),
        (0.12, Rgba::new(0.36, 0.40, 0.47, 0.97)),
        (0.35, Rgba::new(0.52, 0.555, 0.61, 1.0)),
        (0.65, Rgba::new(0.66, 0.68, 0.71, 1.0)),
        (1.0, Rgba::new(0.74, 0.75, 0.76, 1.0)),
    ]
    .map(|(height, color)| ColorLevel { height, color })
}
