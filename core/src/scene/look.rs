//! Light, air, exposure and ground.

use super::{DailyKey, DailyTable};
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
    /// How far the exposure follows an eye that gets used to dim light: 0 for a camera, 1 for an eye.
    #[serde(default, skip_serializing_if = "is_none")]
    pub adaptation: f64,
    /// How dense the air inside a cloud looks: 0 for none, 1 as dense as the cloud's sprites.
    #[serde(default = "as_it_is", skip_serializing_if = "is_as_it_is")]
    pub inside_density: f64,
    /// How bright the stars are: 0 for none, 1 as they are.
    #[serde(default = "as_it_is", skip_serializing_if = "is_as_it_is")]
    pub stars: f64,
    /// How bright the moon and its light are: 0 for none, 1 as it is.
    #[serde(default = "as_it_is", skip_serializing_if = "is_as_it_is")]
    pub moon: f64,
    /// How dark the shadows are that clouds cast on one another, on the ground and on aircraft: 0 for none, 1 as they are.
    #[serde(default, skip_serializing_if = "is_none")]
    pub cloud_shadows: f64,
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

fn is_none(strength: &f64) -> bool {
    *strength == 0.0
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
            ambient: over_the_day(
                Rgba::new(0.50, 0.56, 0.67, 1.0),
                &[
                    (34.0, 17.5, Rgba::new(0.46, 0.53, 0.65, 1.0)),
                    (19.0, 19.0, Rgba::new(0.35, 0.44, 0.62, 1.0)),
                    (9.0, 20.0, Rgba::new(0.225, 0.32, 0.54, 1.0)),
                    (2.5, 20.75, Rgba::new(0.13, 0.18, 0.34, 1.0)),
                    (0.0, 21.05, Rgba::new(0.07, 0.097, 0.19, 1.0)),
                    (-3.0, 21.45, Rgba::new(0.020, 0.026, 0.052, 1.0)),
                    (-6.0, 21.9, Rgba::new(0.0085, 0.011, 0.025, 1.0)),
                    (-10.0, 22.45, Rgba::new(0.0050, 0.0068, 0.0145, 1.0)),
                    (-16.0, 23.6, Rgba::new(0.0037, 0.0050, 0.0102, 1.0)),
                ],
            ),
            directional: over_the_day(
                Rgb::new(1.00, 0.94, 0.84),
                &[
                    (34.0, 17.5, Rgb::new(1.10, 0.98, 0.80)),
                    (15.0, 19.4, Rgb::new(1.32, 0.91, 0.50)),
                    (8.5, 20.1, Rgb::new(1.36, 0.78, 0.28)),
                    (4.0, 20.6, Rgb::new(1.20, 0.54, 0.16)),
                    (0.0, 21.05, Rgb::new(0.45, 0.19, 0.055)),
                    (-2.0, 21.3, Rgb::new(0.010, 0.012, 0.018)),
                    (-12.0, 22.75, Rgb::new(0.050, 0.060, 0.085)),
                ],
            ),
            turbidity: 2.5,
            gain: 0.65,
            haze_length_m: 26_000.0,
            exposure_ev: 0.0,
            adaptation: as_it_is(),
            inside_density: as_it_is(),
            stars: as_it_is(),
            moon: as_it_is(),
            cloud_shadows: as_it_is(),
            ambient_tuning: Tuning::default(),
            directional_tuning: Tuning::default(),
        }
    }
}

/// Noon's value, and those at elevations of the sun, degrees, on its way down, each about when that is at midsummer in Seattle;
/// on its way up it is the same. By night clouds are as dark as that: lit by the sky around them, they must not outshine it.
fn over_the_day<T: Copy>(noon: T, evening: &[(f64, f64, T)]) -> DailyTable<T> {
    const NOON_H: f64 = 13.18;
    // In hundredths: people read them.
    let mirrored = |hour: f64| ((2.0 * NOON_H - hour) * 100.0).round() / 100.0;
    let key = |hour, sun_deg, value| DailyKey { hour, sun_deg: Some(sun_deg), value };
    let morning = evening.iter().rev().map(|(sun_deg, hour, value)| key(mirrored(*hour), *sun_deg, *value));
    let evening = evening.iter().map(|(sun_deg, hour, value)| key(*hour, *sun_deg, *value));
    let noon = [DailyKey { hour: 13.0, sun_deg: None, value: noon }];
    DailyTable { keys: morning.chain(noon).chain(evening).collect() }
}

impl Default for Ground {
    fn default() -> Self {
        Self { altitude_m: 0.0, dark: Rgb::new(0.035, 0.058, 0.034), bright: Rgb::new(0.125, 0.135, 0.062) }
    }
}
