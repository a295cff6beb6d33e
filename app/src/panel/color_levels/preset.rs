//! Sets of colour levels to start from.

use cloudwright_core::color::Rgba;
use cloudwright_core::scene::{ColorLevel, ColorLevels};

/// Name and levels, lowest first.
pub(super) struct Preset {
    pub(super) name: &'static str,
    rows: [(f64, [f32; 4]); 5],
}

impl Preset {
    pub(super) fn levels(&self) -> ColorLevels {
        self.rows.map(|(height, [r, g, b, a])| ColorLevel { height, color: Rgba::new(r, g, b, a) })
    }
}

/// The first is what a new model has.
pub(super) const ALL: &[Preset] = &[
    Preset {
        name: "Fair weather",
        rows: [
            (0.0, [0.30, 0.34, 0.42, 0.92]),
            (0.12, [0.36, 0.40, 0.47, 0.97]),
            (0.35, [0.52, 0.555, 0.61, 1.0]),
            (0.65, [0.66, 0.68, 0.71, 1.0]),
            (1.0, [0.74, 0.75, 0.76, 1.0]),
        ],
    },
    Preset {
        name: "Bright noon",
        rows: [
            (0.0, [0.46, 0.51, 0.60, 0.94]),
            (0.15, [0.56, 0.60, 0.67, 0.98]),
            (0.4, [0.72, 0.75, 0.79, 1.0]),
            (0.7, [0.86, 0.87, 0.89, 1.0]),
            (1.0, [0.95, 0.95, 0.95, 1.0]),
        ],
    },
    Preset {
        name: "Rain",
        rows: [
            (0.0, [0.085, 0.10, 0.125, 1.0]),
            (0.1, [0.11, 0.125, 0.15, 1.0]),
            (0.35, [0.20, 0.22, 0.25, 1.0]),
            (0.7, [0.36, 0.38, 0.42, 1.0]),
            (1.0, [0.50, 0.52, 0.55, 1.0]),
        ],
    },
    Preset {
        name: "Warm dusk",
        rows: [
            (0.0, [0.22, 0.19, 0.27, 0.94]),
            (0.15, [0.34, 0.25, 0.30, 0.97]),
            (0.4, [0.60, 0.42, 0.38, 1.0]),
            (0.7, [0.80, 0.62, 0.50, 1.0]),
            (1.0, [0.92, 0.80, 0.68, 1.0]),
        ],
    },
    Preset {
        name: "Thin veil",
        rows: [
            (0.0, [0.58, 0.63, 0.71, 0.12]),
            (0.25, [0.64, 0.68, 0.74, 0.28]),
            (0.5, [0.71, 0.74, 0.78, 0.38]),
            (0.75, [0.77, 0.79, 0.82, 0.30]),
            (1.0, [0.82, 0.83, 0.85, 0.10]),
        ],
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::scene::{Category, CloudModel, IdCounter, ModelId};

    #[test]
    fn the_first_is_the_default_and_all_are_sound() {
        let new = CloudModel::new(ModelId::new(&mut IdCounter::default()), "new", Category::Stratus);
        assert_eq!(ALL[0].levels(), new.color_levels);
        for preset in ALL {
            let levels = preset.levels();
            assert!(levels.windows(2).all(|pair| pair[0].height <= pair[1].height), "{}", preset.name);
            assert!(levels.iter().all(|level| (0.0..=1.0).contains(&level.color.a)), "{}", preset.name);
        }
    }
}
