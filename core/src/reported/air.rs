//! A report's air as values of a scene's properties.

use crate::formats::metar::{Report, WindFrom};
use crate::scene::Scene;
use schemars::JsonSchema;
use serde::Serialize;

/// −ln 0.02: how much light is lost over the distance at which a dark thing has 2 % of contrast left (Koschmieder,
/// *Theorie der horizontalen Sichtweite*, 1924). So extinction is this by the visibility, and a scene's haze length,
/// over which 63 % of a colour goes, the visibility by this.
pub const EXTINCTION_AT_CONTRAST: f64 = 3.912;

/// What a scene takes from a report, beside clouds. What the report does not know is none.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Air {
    /// Where the wind comes from, clockwise from north; none if there is none or it varies.
    pub wind_from_deg: Option<f64>,
    /// Mean speed, metres a second.
    pub wind_speed_mps: Option<f64>,
    /// Degrees Celsius.
    pub temperature_c: Option<f64>,
    /// Degrees Celsius, at most the temperature.
    pub dew_point_c: Option<f64>,
    /// Of saturated air's vapour, 0 to 1, by Magnus' formula over water (Alduchov and Eskridge 1996). No property is set
    /// by it: a scene's humidity is what its clouds have, not what the ground has.
    pub relative_humidity: Option<f64>,
    /// Metres; where the report only says that one sees at least so far, no shorter than the scene's own.
    pub haze_length_m: Option<f64>,
    /// Local civil hours at the scene's offset from UTC, 0 to below 24.
    pub time_of_day_h: f64,
}

impl Air {
    /// What `report` says to `scene`.
    pub fn of(report: &Report, scene: &Scene) -> Self {
        let temperature_c = report.temperature_c;
        // Rounded apart, the dew point may stand a degree above the temperature.
        let dew_point_c = report.dew_point_c.map(|dew_point| temperature_c.map_or(dew_point, |t| dew_point.min(t)));
        let haze_length_m = report.visibility.map(|visibility| {
            let length = (visibility.m / EXTINCTION_AT_CONTRAST).max(10.0);
            if visibility.or_more { length.max(scene.sky.haze_length_m) } else { length }
        });
        let utc_h = f64::from(report.hour) + f64::from(report.minute) / 60.0;
        Self {
            wind_from_deg: report.wind.and_then(|wind| match wind.from {
                WindFrom::Deg(deg) => Some(deg),
                _ => None,
            }),
            wind_speed_mps: report.wind.map(|wind| wind.speed_mps),
            temperature_c,
            dew_point_c,
            relative_humidity: temperature_c.zip(dew_point_c).map(|(t, d)| vapour(d) / vapour(t)),
            haze_length_m,
            time_of_day_h: (utc_h + scene.site.utc_offset_h).rem_euclid(24.0).min(23.999_999_999),
        }
    }

    /// Means by weight of what is known; of the wind's direction that of its vectors. The time of day is the first's.
    pub(super) fn between(weighed: &[(f64, Self)]) -> Self {
        let mean = |value: fn(&Self) -> Option<f64>| {
            let known = || weighed.iter().filter_map(|(weight, air)| Some((weight, value(air)?)));
            let weight: f64 = known().map(|(weight, _)| weight).sum();
            (weight > 0.0).then(|| known().map(|(weight, value)| weight * value).sum::<f64>() / weight)
        };
        let part = |turn: fn(f64) -> f64| {
            let winds =
                weighed.iter().filter_map(|(weight, air)| Some((weight, air.wind_from_deg?, air.wind_speed_mps?)));
            winds.map(|(weight, from_deg, mps)| weight * mps * turn(from_deg.to_radians())).sum::<f64>()
        };
        let (east, north) = (part(libm::sin), part(libm::cos));
        let is_blown = libm::hypot(east, north) > 1e-9;
        Self {
            wind_from_deg: is_blown.then(|| libm::atan2(east, north).to_degrees().rem_euclid(360.0)),
            wind_speed_mps: mean(|air| air.wind_speed_mps),
            temperature_c: mean(|air| air.temperature_c),
            dew_point_c: mean(|air| air.dew_point_c),
            relative_humidity: mean(|air| air.relative_humidity),
            haze_length_m: mean(|air| air.haze_length_m),
            time_of_day_h: weighed.first().map_or(0.0, |(_, air)| air.time_of_day_h),
        }
    }

    /// As addresses of properties and their values, without what is not known.
    pub fn values(&self) -> Vec<(&'static str, f64)> {
        let values = [
            ("weather/wind_from_deg", self.wind_from_deg),
            ("weather/wind_speed_mps", self.wind_speed_mps),
            ("weather/temperature_c", self.temperature_c),
            ("weather/dew_point_c", self.dew_point_c),
            ("sky/haze_length_m", self.haze_length_m),
            ("time_of_day_h", Some(self.time_of_day_h)),
        ];
        values.into_iter().filter_map(|(address, value)| Some((address, value?))).collect()
    }
}

/// Saturated vapour's pressure over water, in parts of that at 0 °C.
fn vapour(celsius: f64) -> f64 {
    libm::exp(17.625 * celsius / (243.04 + celsius))
}
