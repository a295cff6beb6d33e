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

/// The colour levels at `height` (0 to 1): linear between levels, constant beyond the first and the last. Where two
/// levels share a height, the later one holds from that height on.
pub fn level_color(levels: &ColorLevels, height: f32) -> Rgba {
    let Some(above) = levels.iter().position(|level| level.height as f32 > height) else {
        return levels[levels.len() - 1].color;
    };
    if above == 0 {
        return levels[0].color;
    }
    let (from, to) = (&levels[above - 1], &levels[above]);
    let t = (height - from.height as f32) / (to.height as f32 - from.height as f32);
    from.color.mix(to.color, t)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey_levels(levels: [(f64, f32); 5]) -> ColorLevels {
        levels.map(|(height, v)| ColorLevel { height, color: Rgba::new(v, v, v, 1.0) })
    }

    #[test]
    fn levels_step_where_two_meet() {
        let levels = grey_levels([(0.1, 0.0), (0.5, 1.0), (0.5, 3.0), (0.5, 2.0), (0.9, 4.0)]);
        for (height, want) in [(0.0, 0.0), (0.1, 0.0), (0.3, 0.5), (0.5, 2.0), (0.7, 3.0), (0.9, 4.0), (1.0, 4.0)] {
            let got = level_color(&levels, height).rgb.r;
            assert!((got - want).abs() < 1e-5, "at {height}: {got}, want {want}");
        }
        let all_at_top = grey_levels([(1.0, 1.0), (1.0, 2.0), (1.0, 3.0), (1.0, 4.0), (1.0, 5.0)]);
        assert_eq!(level_color(&all_at_top, 0.5).rgb.r, 1.0);
        assert_eq!(level_color(&all_at_top, 1.0).rgb.r, 5.0);
    }
}
