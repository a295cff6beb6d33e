//! The scene itself: its name, where and when it is, and where the sun comes from.

use super::described::Described;
use super::row::{Row, angle, flag, number, numbers, range_of, setting, text};
use super::setting::{Numbers, Setting, Value};
use super::{HEADING_DEG, Number, TIME_OF_DAY_H};
use crate::scene::{Site, Scene, Sun};

impl Described for Scene {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        setting!(name: text("Name", "For people.")),
        numbers!(time_of_day_h: number(TIME_OF_DAY_H).cyclic(24.0).keyed()),
    ]];
}

const LATITUDE_DEG: Number = Number::new("Latitude", &(-90.0..=90.0), "°", "North is positive.");
const LONGITUDE_DEG: Number = Number::new("Longitude", &(-180.0..=180.0), "°", "East is positive.");
const UTC_OFFSET_H: Number = Number::new("UTC offset", &(-14.0..=14.0), "h", "Hours that local time is ahead of UTC.");

impl Described for Site {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        numbers!(latitude_deg: number(LATITUDE_DEG)),
        numbers!(longitude_deg: angle(LONGITUDE_DEG)),
        numbers!(utc_offset_h: number(UTC_OFFSET_H)),
        setting!(date: text("Date", "The day, YYYY-MM-DD.")),
    ]];
}

const ELEVATION_DEG: Number =
    Number::new("Sun elevation", &(-90.0..=90.0), "°", "Height of the sun above the horizon.");

/// Where a sun set by hand begins: in the south, half way up.
const BY_HAND: Sun = Sun::ByHand { heading_deg: 180.0, elevation_deg: 45.0 };

impl Described for Sun {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        Row::of(
            "by_hand",
            flag("Sun by hand", "Where the sun stands, whatever place and time say."),
            |sun| Some(Value::Flag(*sun != Self::ByPlace)),
            |sun, value| {
                *sun = match (bool::from_value(value)?, *sun) {
                    (false, _) => Self::ByPlace,
                    (true, Self::ByPlace) => BY_HAND,
                    (true, by_hand) => by_hand,
                };
                Some(())
            },
        ),
        Row::numbers(
            "by_hand.heading_deg",
            angle(HEADING_DEG.called("Sun heading")).keyed(),
            |sun, _| if let Self::ByHand { heading_deg, .. } = sun { Some(*heading_deg) } else { None },
            |sun, _, number| {
                if let Self::ByHand { heading_deg, .. } = sun {
                    *heading_deg = number;
                }
            },
        ),
        Row::numbers(
            "by_hand.elevation_deg",
            number(ELEVATION_DEG).keyed(),
            |sun, _| if let Self::ByHand { elevation_deg, .. } = sun { Some(*elevation_deg) } else { None },
            |sun, _, number| {
                if let Self::ByHand { elevation_deg, .. } = sun {
                    *elevation_deg = number;
                }
            },
        ),
    ]];
}
