//! Ready-made colour levels: moods that suit any cloud, and those of each preset.
//!
//! Levels are shares of the sky's ambient light, so a mood tints whatever light the hour gives.

use super::Preset;
use crate::color::Rgba;
use crate::scene::{ColorLevel, ColorLevels};
use std::sync::LazyLock;

/// Five colour levels under a name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LevelPreset {
    /// As in scripts.
    pub name: &'static str,
    /// As on screen.
    pub label: &'static str,
    /// The levels.
    pub levels: ColorLevels,
}

impl LevelPreset {
    /// All of them: moods first, then the presets' own.
    pub fn all() -> &'static [Self] {
        static ALL: LazyLock<Vec<LevelPreset>> = LazyLock::new(|| {
            let of_preset = |preset: &Preset| {
                let levels = preset.scene().models.first()?.color_levels;
                Some(LevelPreset { name: preset.name, label: preset.label, levels })
            };
            MOODS.iter().copied().chain(Preset::ALL.iter().filter_map(of_preset)).collect()
        });
        &ALL
    }

    /// The levels of that name.
    pub fn by_name(name: &str) -> Option<&'static Self> {
        Self::all().iter().find(|preset| preset.name == name)
    }
}

/// Height, red, green, blue, alpha.
type Row = (f64, f32, f32, f32, f32);

const fn mood(name: &'static str, label: &'static str, [a, b, c, d, e]: [Row; 5]) -> LevelPreset {
    const fn level((height, r, g, b, a): Row) -> ColorLevel {
        ColorLevel { height, color: Rgba::new(r, g, b, a) }
    }
    LevelPreset { name, label, levels: [level(a), level(b), level(c), level(d), level(e)] }
}

const MOODS: [LevelPreset; 8] = [
    mood(
        "bright_noon",
        "Bright noon",
        [
            (0.0, 0.44, 0.48, 0.55, 0.96),
            (0.15, 0.51, 0.55, 0.61, 1.0),
            (0.4, 0.63, 0.66, 0.70, 1.0),
            (0.7, 0.73, 0.75, 0.77, 1.0),
            (1.0, 0.80, 0.81, 0.82, 1.0),
        ],
    ),
    mood(
        "overcast",
        "Overcast",
        [
            (0.0, 0.34, 0.37, 0.42, 0.92),
            (0.2, 0.38, 0.41, 0.46, 0.98),
            (0.45, 0.43, 0.46, 0.50, 1.0),
            (0.75, 0.48, 0.50, 0.53, 1.0),
            (1.0, 0.52, 0.54, 0.57, 1.0),
        ],
    ),
    mood(
        "rain",
        "Rain",
        [
            (0.0, 0.16, 0.18, 0.22, 0.80),
            (0.2, 0.18, 0.20, 0.25, 1.0),
            (0.45, 0.24, 0.26, 0.31, 1.0),
            (0.75, 0.32, 0.34, 0.39, 1.0),
            (1.0, 0.41, 0.43, 0.47, 1.0),
        ],
    ),
    mood(
        "storm",
        "Storm",
        [
            (0.0, 0.10, 0.12, 0.14, 1.0),
            (0.12, 0.12, 0.15, 0.17, 1.0),
            (0.35, 0.20, 0.24, 0.26, 1.0),
            (0.65, 0.36, 0.39, 0.41, 1.0),
            (1.0, 0.52, 0.54, 0.56, 1.0),
        ],
    ),
    mood(
        "dusk_warm",
        "Dusk, warm",
        [
            (0.0, 0.28, 0.24, 0.34, 0.96),
            (0.15, 0.36, 0.30, 0.39, 1.0),
            (0.4, 0.54, 0.42, 0.42, 1.0),
            (0.7, 0.72, 0.54, 0.44, 1.0),
            (1.0, 0.86, 0.64, 0.46, 1.0),
        ],
    ),
    mood(
        "dawn_rose",
        "Dawn, rose",
        [
            (0.0, 0.34, 0.34, 0.45, 0.94),
            (0.15, 0.41, 0.39, 0.49, 1.0),
            (0.4, 0.57, 0.48, 0.55, 1.0),
            (0.7, 0.73, 0.58, 0.61, 1.0),
            (1.0, 0.84, 0.66, 0.66, 1.0),
        ],
    ),
    mood(
        "moonlight",
        "Moonlight",
        [
            (0.0, 0.22, 0.27, 0.40, 0.96),
            (0.15, 0.27, 0.33, 0.47, 1.0),
            (0.4, 0.40, 0.47, 0.61, 1.0),
            (0.7, 0.53, 0.60, 0.73, 1.0),
            (1.0, 0.63, 0.70, 0.82, 1.0),
        ],
    ),
    mood(
        "thin_veil",
        "Thin veil",
        [
            (0.0, 0.50, 0.53, 0.59, 0.20),
            (0.25, 0.54, 0.56, 0.61, 0.42),
            (0.5, 0.58, 0.60, 0.64, 0.50),
            (0.75, 0.62, 0.63, 0.66, 0.40),
            (1.0, 0.65, 0.66, 0.68, 0.18),
        ],
    ),
];
