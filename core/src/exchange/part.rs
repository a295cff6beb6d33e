//! What a scene consists of, as far as formats differ in what they carry of it.

use crate::scene::{Scene, Weather};
use schemars::JsonSchema;
use serde::Serialize;

/// A part of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// Where sprites are, how large, how turned, and their tiles.
    Sprites,
    /// Which sprites take the sun as one lump.
    Groups,
    /// Ambient light over each cloud's height.
    ColorLevels,
    /// How far clouds have formed.
    Formation,
    /// Layers of cloud: how much of the sky, from where to where.
    Layers,
    /// Wind and air.
    Weather,
    /// What the scene's clock moves.
    Motion,
    /// A sheet of tiles of the scene's own.
    Atlas,
    /// Sun, sky and haze.
    Light,
    /// What lies below.
    Ground,
    /// Named views.
    Cameras,
    /// Flights.
    Paths,
    /// What flies.
    Aircraft,
    /// What stands.
    Props,
}

impl Part {
    /// All of them.
    pub const ALL: [Self; 14] = [
        Self::Sprites,
        Self::Groups,
        Self::ColorLevels,
        Self::Formation,
        Self::Layers,
        Self::Weather,
        Self::Motion,
        Self::Atlas,
        Self::Light,
        Self::Ground,
        Self::Cameras,
        Self::Paths,
        Self::Aircraft,
        Self::Props,
    ];

    /// In a word or two.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sprites => "sprites",
            Self::Groups => "shading groups",
            Self::ColorLevels => "colour levels",
            Self::Formation => "formation",
            Self::Layers => "layers",
            Self::Weather => "wind and air",
            Self::Motion => "motion",
            Self::Atlas => "atlas",
            Self::Light => "light",
            Self::Ground => "ground",
            Self::Cameras => "cameras",
            Self::Paths => "paths",
            Self::Aircraft => "aircraft",
            Self::Props => "props",
        }
    }

    /// Whether there is any of it in `scene` that would be missed.
    pub fn is_in(self, scene: &Scene) -> bool {
        match self {
            Self::Sprites | Self::Groups | Self::ColorLevels => !scene.clouds.is_empty(),
            Self::Formation => scene
                .clouds
                .iter()
                .any(|cloud| cloud.formation.is_some() || cloud.formed.is_some() || cloud.opacity < 1.0),
            // Measured of the clouds, whose sprites say it already.
            Self::Layers => false,
            Self::Weather => scene.weather != Weather::default(),
            Self::Motion => !scene.tracks.is_empty() || scene.weather.wind_speed_mps > 0.0,
            Self::Atlas => scene.atlas.is_some(),
            Self::Light => true,
            Self::Ground => scene.ground.is_some(),
            Self::Cameras => !scene.cameras.is_empty(),
            Self::Paths => !scene.paths.is_empty(),
            Self::Aircraft => !scene.aircraft.is_empty(),
            Self::Props => !scene.props.is_empty(),
        }
    }
}
