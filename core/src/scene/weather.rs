//! The air that clouds move in: wind, humidity, temperature, and where a sky wraps round.
//!
//! A scene whose weather is as by default stands still. What each of these does to clouds is said in `crate::weather`
//! (MODEL §9).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Wind and air. What the file leaves out has its default: no wind, all clouds whole.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Weather {
    /// Where the wind comes from, clockwise from north.
    pub wind_from_deg: f64,
    /// How fast it blows, metres a second.
    pub wind_speed_mps: f64,
    /// How much faster it is at a cloud's top than in its middle, as a share: 0 for none, 1 for half as much again.
    pub wind_shear: f64,
    /// How much the air churns, 0 to 1.
    pub turbulence: f64,
    /// Relative humidity, 0 to 1: as it falls, clouds lose their edges and part into pieces.
    pub humidity: f64,
    /// Of the air near the ground, °C. Only its changes count: clouds stand where they were put.
    pub temperature_c: f64,
    /// Of the air near the ground, °C. Each degree that it lies further below the temperature lifts bases by 125 m.
    pub dew_point_c: f64,
    /// Heights above their bases are multiplied with this, in clouds that follow the base.
    pub growth: f64,
    /// How far a cloud's edges lean with the wind: 1 for half its radius at 10 m/s, 0 for not at all.
    pub lean: f64,
    /// How long a cloud's edges take to follow the wind, seconds.
    pub lag_s: f64,
    /// How far sprites turn for each kilometre that the wind blows, degrees.
    pub turn_deg_per_km: f64,
    /// How much faster than life the time of day runs with the scene's clock: 0 for not at all, 1440 for a day in a
    /// minute. Keys of the time of day are in its place.
    pub day_speed: f64,
    /// Where clouds that the wind carries out come in again on the other side; none: they go on.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub region: Option<Region>,
}

/// A rectangle in which drifting clouds stay, metres. Near its border they dissipate, and form again beyond.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// Its middle, eastwards.
    pub center_x_m: f64,
    /// Its middle, southwards.
    pub center_z_m: f64,
    /// From west to east.
    pub width_m: f64,
    /// From north to south.
    pub depth_m: f64,
    /// How far within its border clouds are whole.
    pub border_m: f64,
}

impl Default for Weather {
    fn default() -> Self {
        Self {
            wind_from_deg: 270.0,
            wind_speed_mps: 0.0,
            wind_shear: 0.5,
            turbulence: 0.0,
            humidity: 1.0,
            temperature_c: 15.0,
            dew_point_c: 7.0,
            growth: 1.0,
            lean: 1.0,
            lag_s: 20.0,
            turn_deg_per_km: 20.0,
            day_speed: 0.0,
            region: None,
        }
    }
}

impl Default for Region {
    fn default() -> Self {
        Self { center_x_m: 0.0, center_z_m: 0.0, width_m: 20_000.0, depth_m: 20_000.0, border_m: 2_000.0 }
    }
}

impl Weather {
    pub(super) fn is_default(&self) -> bool {
        *self == Self::default()
    }
}
