//! Colour levels that several scenes share.

use cloudwright_core::color::Rgba;
use cloudwright_core::scene::{ColorLevel, ColorLevels};

/// Levels from height, red, green, blue, alpha.
pub fn levels(rows: [(f64, f32, f32, f32, f32); 5]) -> ColorLevels {
    rows.map(|(height, r, g, b, a)| ColorLevel { height, color: Rgba::new(r, g, b, a) })
}

/// A heap: dark blue-grey below, near white above.
pub fn heap() -> ColorLevels {
    levels([
        (0.0, 0.27, 0.31, 0.39, 0.95),
        (0.10, 0.32, 0.36, 0.44, 0.98),
        (0.32, 0.50, 0.54, 0.60, 1.0),
        (0.65, 0.66, 0.68, 0.71, 1.0),
        (1.0, 0.74, 0.75, 0.76, 1.0),
    ])
}
