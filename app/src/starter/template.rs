//! Skies to begin a scene with: the shipped scenes, embedded, and a clear one.

use super::{empty_sky, starter_scene};
use cloudwright_core::formats::scene_file;
use cloudwright_core::problem::Problem;
use cloudwright_core::scene::Scene;

/// A sky to begin with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Template {
    /// Nothing but air.
    Clear,
    /// One small cloud.
    OneCloud,
    /// Cumulus on a fine afternoon.
    Fair,
    /// A closed grey deck.
    Overcast,
    /// A thunder cloud at dusk.
    Storm,
    /// Low cloud in the morning.
    Stratus,
    /// Clouds over a summer's day, as tracks.
    SummerDay,
    /// A front that passes, as tracks.
    Front,
}

impl Template {
    /// All, in the order in which they are offered.
    pub const ALL: [Self; 8] = [
        Self::Clear,
        Self::OneCloud,
        Self::Fair,
        Self::Overcast,
        Self::Storm,
        Self::Stratus,
        Self::SummerDay,
        Self::Front,
    ];

    /// For people.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Clear => "Clear sky",
            Self::OneCloud => "One small cloud",
            Self::Fair => "Fair weather",
            Self::Overcast => "Overcast",
            Self::Storm => "Storm at dusk",
            Self::Stratus => "Morning stratus",
            Self::SummerDay => "Summer's day",
            Self::Front => "A front passes",
        }
    }

    /// What is in it.
    pub const fn help(self) -> &'static str {
        match self {
            Self::Clear => "Nothing but air: for clouds of your own.",
            Self::OneCloud => "One cumulus of four boxes, to try things on.",
            Self::Fair => "Twenty-six cumulus of all sizes on a fine afternoon, with a flight through the tallest.",
            Self::Overcast => "A closed deck, with a flight down through it.",
            Self::Storm => "A cumulonimbus with its anvil in the last light.",
            Self::Stratus => "Low cloud over the ground in the morning.",
            Self::SummerDay => "Cumulus that grow and fade over a day: put the clock on.",
            Self::Front => "High cloud that thickens and lowers, then showers: put the clock on.",
        }
    }

    /// The scene.
    ///
    /// # Errors
    /// If an embedded file can't be read, which a test sees to.
    pub fn scene(self) -> Result<Scene, Vec<Problem>> {
        let file: &str = match self {
            Self::Clear => return Ok(empty_sky()),
            Self::OneCloud => return Ok(starter_scene()),
            Self::Fair => include_str!("../../../assets/scenes/fair_weather.cloudscene"),
            Self::Overcast => include_str!("../../../assets/scenes/overcast.cloudscene"),
            Self::Storm => include_str!("../../../assets/scenes/cumulonimbus_dusk.cloudscene"),
            Self::Stratus => include_str!("../../../assets/scenes/morning_stratus.cloudscene"),
            Self::SummerDay => include_str!("../../../assets/scenes/summer_day.cloudscene"),
            Self::Front => include_str!("../../../assets/scenes/front.cloudscene"),
        };
        scene_file::read(file.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_is_a_sound_scene_with_a_camera() {
        for template in Template::ALL {
            let scene = template.scene().expect("it can be read");
            assert!(!scene.cameras.is_empty(), "{template:?}");
            assert_eq!(scene.clouds.is_empty(), template == Template::Clear, "{template:?}");
        }
    }
}
