//! Light, air, exposure and ground.

use super::DailyTable;
use crate::color::{Rgb, Rgba};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The light on the clouds over the day, and the air they hang in.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sky {
    /// Greatest ambient light over the day; its alpha scales all opacity.
    pub ambient: DailyTable<Rgba>,
    /// Greatest directional light over the day.
    pub directional: DailyTable<Rgb>,
    /// 1 to 10: how hazy the sky's own light is (Hosek and Wilkie 2012).
    pub turbidity: f64,
    /// Scales the sky's light so that it meets the clouds' colours.
    pub gain: f64,
    /// Distance in metres at which 1 − 1/e of a colour has turned to the horizon's.
    pub haze_length_m: f64,
    /// Each step doubles the light.
    pub exposure_ev: f64,
    /// How dense the air inside a cloud looks: 0 for none, 1 as dense as the cloud's sprites.
    #[serde(default = "as_it_is", skip_serializing_if = "is_as_it_is")]
    pub inside_density: f64,
    /// How bright the stars are: 0 for none, 1 as they are.
    #[serde(default = "as_it_is", skip_serializing_if = "is_as_it_is")]
    pub stars: f64,
    /// How bright the moon and its light are: 0 for none, 1 as it is.
    #[serde(default = "as_it_is", skip_serializing_if = "is_as_it_is")]
    pub moon: f64,
    /// Scales and tints the ambient light of all hours.
    #[serde(default, skip_serializing_if = "Tuning::is_default")]
    pub ambient_tuning: Tuning,
    /// Scales and tints the directional light of all hours.
    #[serde(default, skip_serializing_if = "Tuning::is_default")]
    pub directional_tuning: Tuning,
}

/// What the light of a whole day is multiplied with.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Tuning {
    /// How much of it there is: 1 as the day's table says.
    pub scale: f64,
    /// A colour that it passes through: white leaves it as it is.
    pub tint: Rgb,
}

impl Default for Tuning {
    fn default() -> Self {
        Self { scale: 1.0, tint: Rgb::grey(1.0) }
    }
}

impl Tuning {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }

    /// Of a light.
    pub fn of(&self, light: Rgb) -> Rgb {
        light * self.tint * self.scale as f32
    }
}

fn as_it_is() -> f64 {
    1.0
}

fn is_as_it_is(strength: &f64) -> bool {
    *strength == as_it_is()
}

/// A level ground with a landscape's blotches in two colours.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ground {
    /// Height of the ground in the world, metres.
    pub altitude_m: f64,
    /// Share of the light it sends back, where it is darker: woods, water.
    pub dark: Rgb,
    /// Share of the light it sends back, where it is brighter: fields.
    pub bright: Rgb,
}

impl Default for Sky {
    fn default() -> Self {
        Self {
            ambient: DailyTable::new([
                (0.0, Rgba::new(0.030, 0.036, 0.060, 1.0)),
                (4.4, Rgba::new(0.030, 0.036, 0.060, 1.0)),
                (5.3, Rgba::new(0.16, 0.16, 0.23, 1.0)),
                (6.5, Rgba::new(0.32, 0.34, 0.43, 1.0)),
                (9.0, Rgba::new(0.46, 0.53, 0.64, 1.0)),
                (13.0, Rgba::new(0.50, 0.56, 0.67, 1.0)),
                (17.5, Rgba::new(0.46, 0.53, 0.64, 1.0)),
                (20.0, Rgba::new(0.32, 0.33, 0.45, 1.0)),
                (21.0, Rgba::new(0.176, 0.176, 0.27, 1.0)),
                (22.3, Rgba::new(0.030, 0.036, 0.060, 1.0)),
            ]),
            directional: DailyTable::new([
                (0.0, Rgb::new(0.050, 0.060, 0.085)),
                (4.9, Rgb::new(0.010, 0.012, 0.018)),
                (5.5, Rgb::new(1.06, 0.40, 0.175)),
                (6.5, Rgb::new(1.27, 0.80, 0.47)),
                (9.0, Rgb::new(1.10, 0.99, 0.82)),
                (13.0, Rgb::new(1.00, 0.94, 0.84)),
                (17.5, Rgb::new(1.10, 0.97, 0.80)),
                (19.6, Rgb::new(1.33, 0.78, 0.40)),
                (20.6, Rgb::new(1.19, 0.47, 0.188)),
                (21.3, Rgb::new(0.010, 0.012, 0.018)),
            ]),
            turbidity: 2.5,
            gain: 0.65,
            haze_length_m: 26_000.0,
            exposure_ev: 0.0,
            inside_density: as_it_is(),
            stars: as_it_is(),
            moon: as_it_is(),
            ambient_tuning: Tuning::default(),
            directional_tuning: Tuning::default(),
        }
    }
}

impl Default for Ground {
    fn default() -> Self {
        Self { altitude_m: 0.0, dark: Rgb::new(0.035, 0.058, 0.034), bright: Rgb::new(0.125, 0.135, 0.062) }
    }
}
