//! Colour levels that several scenes share.

use cloudwright_core::color::Rgba;
use cloudwright_core::scene::{ColorLevel, ColorLevels};

/// Levels from height, red, green, blue, alpha.
pub fn levels(rows: [(f64, f32, f32, f32, f32); 5]) -> ColorLevels {
    rows.map(|(height, r, g, b, a)| ColorLevel { height, color: Rgba::new(r, g, b, a) })
}

/// A heap: dark blue-grey below, paler above, but never so pale that the sun has nothing to add: the lit side is the
/// sun's.
pub fn heap() -> ColorLevels {
    levels([
        (0.0, 0.24, 0.28, 0.35, 0.96),
        (0.12, 0.29, 0.33, 0.40, 0.98),
        (0.34, 0.42, 0.46, 0.51, 1.0),
        (0.65, 0.52, 0.54, 0.57, 1.0),
        (1.0, 0.60, 0.61, 0.63, 1.0),
    ])
}
