//! Light, air, exposure and ground.

use super::DailyTable;
use crate::color::{Rgb, Rgba};
use crate::parameter;
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
                (0.0, Rgba::new(0.020, 0.026, 0.045, 1.0)),
                (4.5, Rgba::new(0.035, 0.042, 0.070, 1.0)),
                (5.5, Rgba::new(0.24, 0.24, 0.34, 1.0)),
                (6.5, Rgba::new(0.52, 0.52, 0.64, 1.0)),
                (9.0, Rgba::new(0.80, 0.86, 0.98, 1.0)),
                (13.0, Rgba::new(0.86, 0.93, 1.06, 1.0)),
                (17.5, Rgba::new(0.80, 0.86, 0.98, 1.0)),
                (20.0, Rgba::new(0.52, 0.50, 0.66, 1.0)),
                (21.2, Rgba::new(0.22, 0.22, 0.34, 1.0)),
                (22.3, Rgba::new(0.035, 0.042, 0.070, 1.0)),
            ]),
            directional: DailyTable::new([
                (0.0, Rgb::new(0.012, 0.014, 0.020)),
                (4.9, Rgb::new(0.012, 0.014, 0.020)),
                (5.6, Rgb::new(0.85, 0.34, 0.16)),
                (6.6, Rgb::new(1.00, 0.62, 0.36)),
                (9.0, Rgb::new(0.76, 0.68, 0.56)),
                (13.0, Rgb::new(0.66, 0.62, 0.56)),
                (17.5, Rgb::new(0.78, 0.68, 0.55)),
                (19.8, Rgb::new(1.08, 0.58, 0.28)),
                (20.8, Rgb::new(0.90, 0.34, 0.14)),
                (21.5, Rgb::new(0.012, 0.014, 0.020)),
            ]),
            turbidity: parameter::TURBIDITY.default,
            gain: parameter::SKY_GAIN.default,
            haze_length_m: parameter::HAZE_LENGTH_M.default,
            exposure_ev: 0.0,
        }
    }
}

impl Default for Ground {
    fn default() -> Self {
        Self { altitude_m: 0.0, dark: Rgb::new(0.035, 0.058, 0.034), bright: Rgb::new(0.125, 0.135, 0.062) }
    }
}
