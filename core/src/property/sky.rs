//! Light over the day, air, exposure and ground.

use super::described::{Described, Visitor, enter};
use super::owner::Owner;
use super::row::{Row, color, number, numbers, range_of};
use super::setting::Numbers;
use super::{ALPHA, COLOR, Number, POSITION, TIME_OF_DAY_H};
use crate::color::{Rgb, Rgba};
use crate::scene::{DailyKey, Ground, Sky};
use std::fmt::Arguments;

const EXPOSURE_EV: Number = Number::new("Exposure", &(-20.0..=20.0), "EV", "Each step doubles the light.");
const ADAPTATION: Number = Number::new(
    "Eye adaptation",
    &(0.0..=1.0),
    "",
    "How far the exposure follows an eye that gets used to dim light: 0 for a camera, 1 for an eye.",
);
const TURBIDITY: Number = Number::new("Turbidity", &(1.0..=10.0), "", "How hazy the sky is: 2 very clear, 10 milky.");
const GAIN: Number =
    Number::new("Sky gain", &(0.0..=100.0), "", "Scales the sky so that it meets the clouds' colours.");
const HAZE_LENGTH_M: Number =
    Number::new("Haze length", &(10.0..=1e9), "m", "Distance over which 63 % of a colour turns to the horizon's.");
const INSIDE_DENSITY: Number = Number::new(
    "Inside density",
    &(0.0..=4.0),
    "",
    "How dense the air inside a cloud looks: 0 for none, 1 as dense as its sprites.",
);
const STARS: Number = Number::new("Stars", &(0.0..=100.0), "", "How bright the stars are at night: 1 as they are.");
const MOON: Number =
    Number::new("Moon", &(0.0..=100.0), "", "How bright the moon is at night, and its light on clouds: 1 as it is.");

const CLOUD_SHADOWS: Number = Number::new(
    "Cloud shadows",
    &(0.0..=1.0),
    "",
    "How dark the shadows are that clouds cast on one another, on the ground and on aircraft: 0 for none.",
);

const SUN_DEG: Number = Number::new(
    "Sun's elevation",
    &(-90.0..=90.0),
    "°",
    "Where the sun stands when this key holds, before or after noon.",
);

const TUNING_SCALE: Number =
    Number::new("Light", &(0.0..=100.0), "", "Scales this light at all hours: 1 as the day's table says.");
const TUNING_TINT: Number =
    Number::new("Tint", &(0.0..=1000.0), "", "Tints this light at all hours: white leaves it as it is.");

impl Described for Sky {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        numbers!(exposure_ev: number(EXPOSURE_EV).keyed()),
        numbers!(adaptation: number(ADAPTATION).keyed()),
        numbers!(turbidity: number(TURBIDITY).keyed()),
        numbers!(gain: number(GAIN).keyed()),
        numbers!(haze_length_m: number(HAZE_LENGTH_M).keyed()),
        numbers!(inside_density: number(INSIDE_DENSITY).keyed()),
        numbers!(stars: number(STARS).keyed()),
        numbers!(moon: number(MOON).keyed()),
        numbers!(cloud_shadows: number(CLOUD_SHADOWS).keyed()),
        numbers!(ambient_tuning.scale: number(TUNING_SCALE.called("Ambient light")).keyed()),
        numbers!(ambient_tuning.tint: color(TUNING_TINT.called("Ambient tint")).keyed()),
        numbers!(directional_tuning.scale: number(TUNING_SCALE.called("Directional light")).keyed()),
        numbers!(directional_tuning.tint: color(TUNING_TINT.called("Directional tint")).keyed()),
    ]];

    fn enter_parts(&self, _: Owner, place: Arguments<'_>, visitor: &mut impl Visitor) {
        for (i, key) in self.ambient.keys.iter().enumerate() {
            enter(Owner::AmbientKey(i), format_args!("{place}.ambient[{i}]"), key, visitor);
        }
        for (i, key) in self.directional.keys.iter().enumerate() {
            enter(Owner::DirectionalKey(i), format_args!("{place}.directional[{i}]"), key, visitor);
        }
    }
}

/// At which elevation of the sun a key holds, if it goes by that.
const fn sun_deg<T>() -> Row<DailyKey<T>> {
    Row::numbers(
        "sun_deg",
        number(SUN_DEG),
        |key, _| key.sun_deg,
        |key, _, degrees| {
            if key.sun_deg.is_some() {
                key.sun_deg = Some(degrees);
            }
        },
    )
}

impl Described for DailyKey<Rgba> {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        numbers!(hour: number(TIME_OF_DAY_H)),
        sun_deg(),
        numbers!("value", value.rgb: color(COLOR)),
        numbers!(value.a: number(ALPHA)),
    ]];
}

impl Described for DailyKey<Rgb> {
    const TABLES: &'static [&'static [Row<Self>]] =
        &[&[numbers!(hour: number(TIME_OF_DAY_H)), sun_deg(), numbers!(value: color(COLOR))]];
}

impl Described for Ground {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        numbers!(altitude_m: number(POSITION.called("Altitude"))),
        numbers!(dark: color(COLOR.called("Dark")).keyed()),
        numbers!(bright: color(COLOR.called("Bright")).keyed()),
    ]];
}
