//! The air that clouds move in.

use super::described::Described;
use super::row::{Row, angle, flag, number, numbers, range_of};
use super::setting::{Numbers, Setting, Value};
use super::{Number, POSITION};
use crate::scene::Weather;

const WIND_FROM_DEG: Number =
    Number::new("Wind from", &(-360.0..=360.0), "°", "Where the wind comes from, clockwise from north.");
const WIND_SPEED_MPS: Number = Number::new(
    "Wind speed",
    &(0.0..=150.0),
    "m/s",
    "How fast the wind blows: it carries clouds, and their edges lean.",
);
const WIND_SHEAR: Number = Number::new(
    "Wind shear",
    &(-4.0..=4.0),
    "",
    "How much faster the wind is at a cloud's top than in its middle: 0 not at all, 1 by half.",
);
const TURBULENCE: Number = Number::new("Turbulence", &(0.0..=1.0), "", "How much the air churns: sprites sway about.");
const HUMIDITY: Number = Number::new(
    "Humidity",
    &(0.0..=1.0),
    "",
    "As it falls from 1, clouds lose their edges and part into pieces; at 0 there are none.",
);
const TEMPERATURE_C: Number =
    Number::new("Temperature", &(-80.0..=60.0), "°C", "Near the ground; its changes lift the clouds' bases.");
const DEW_POINT_C: Number = Number::new(
    "Dew point",
    &(-80.0..=60.0),
    "°C",
    "Near the ground; bases rise by 125 m for each degree that it falls away from the temperature.",
);
const GROWTH: Number =
    Number::new("Growth of heads", &(0.01..=10.0), "", "How much clouds that follow the base tower: 1 as they are.");
const LEAN: Number = Number::new(
    "Lean",
    &(0.0..=4.0),
    "",
    "How far a cloud's edges lean with the wind: 1 by half its radius at 10 m/s, 0 not at all.",
);
const LAG_S: Number = Number::new("Lag", &(0.0..=3600.0), "s", "How long a cloud's edges take to follow the wind.");
const TURN_DEG_PER_KM: Number =
    Number::new("Turning", &(0.0..=3600.0), "°/km", "How far sprites turn while the wind blows a kilometre.");
const DAY_SPEED: Number = Number::new(
    "Day runs",
    &(0.0..=1e6),
    "×",
    "How much faster than life the time of day runs with the clock: 0 it stands, 1440 is a day a minute.",
);
const REGION_SIDE: Number = Number::new("Side", &(1.0..=1e7), "m", "Of the rectangle in which drifting clouds stay.");
const REGION_BORDER: Number =
    Number::new("Border", &(0.0..=1e6), "m", "How far within the rectangle's border clouds are whole.");

impl Described for Weather {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        numbers!(wind_from_deg: angle(WIND_FROM_DEG).keyed()),
        numbers!(wind_speed_mps: number(WIND_SPEED_MPS).keyed()),
        numbers!(wind_shear: number(WIND_SHEAR).keyed()),
        numbers!(turbulence: number(TURBULENCE).keyed()),
        numbers!(humidity: number(HUMIDITY).keyed()),
        numbers!(temperature_c: number(TEMPERATURE_C).keyed()),
        numbers!(dew_point_c: number(DEW_POINT_C).keyed()),
        numbers!(growth: number(GROWTH).keyed()),
        numbers!(lean: number(LEAN).keyed()),
        numbers!(lag_s: number(LAG_S)),
        numbers!(turn_deg_per_km: number(TURN_DEG_PER_KM)),
        numbers!(day_speed: number(DAY_SPEED)),
        Row::of(
            "region",
            flag("Wraps round", "Clouds that the wind carries out of a rectangle come in again on its other side."),
            |weather| Some(Value::Flag(weather.region.is_some())),
            |weather, value| {
                weather.region = bool::from_value(value)?.then(|| weather.region.unwrap_or_default());
                Some(())
            },
        ),
        numbers!(region?.center_x_m: number(POSITION.called("Region's middle, x"))),
        numbers!(region?.center_z_m: number(POSITION.called("Region's middle, z"))),
        numbers!(region?.width_m: number(REGION_SIDE.called("West to east"))),
        numbers!(region?.depth_m: number(REGION_SIDE.called("North to south"))),
        numbers!(region?.border_m: number(REGION_BORDER)),
    ]];
}
