//! Where on Earth and when, and with that the sun.

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::str::FromStr;

/// A place and a day.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Site {
    /// North is positive.
    pub latitude_deg: f64,
    /// East is positive.
    pub longitude_deg: f64,
    /// Hours that local time is ahead of UTC.
    pub utc_offset_h: f64,
    /// The day, `YYYY-MM-DD`.
    pub date: Date,
}

/// Where the sun stands.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Sun {
    /// As on Earth, from place, date and time of day.
    #[default]
    ByPlace,
    /// Set by hand, at any time of day.
    ByHand {
        /// Clockwise from north, seen from above.
        heading_deg: f64,
        /// Above the horizon.
        elevation_deg: f64,
    },
}

/// A day of the proleptic Gregorian calendar, years 1 to 5999 (what the sun's model covers). In files `"YYYY-MM-DD"`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Date {
    /// 1 to 5999.
    pub year: u16,
    /// 1 to 12.
    pub month: u8,
    /// 1 to 31.
    pub day: u8,
}

/// A text that is no day.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("“{0}” is not a day: write YYYY-MM-DD, such as 2004-06-21")]
pub struct NotADate(String);

impl Date {
    /// How many days its month has.
    fn days_in_month(year: u16, month: u8) -> u8 {
        let leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
        match month {
            2 if leap => 29,
            2 => 28,
            4 | 6 | 9 | 11 => 30,
            _ => 31,
        }
    }
}

impl FromStr for Date {
    type Err = NotADate;
    fn from_str(text: &str) -> Result<Self, NotADate> {
        let mut parts = text.split('-');
        let read = |part: Option<&str>, digits: usize| -> Option<u16> {
            part.filter(|p| p.len() == digits && p.bytes().all(|b| b.is_ascii_digit()))?.parse().ok()
        };
        let year = read(parts.next(), 4).filter(|y| (1..=5999).contains(y));
        let month = read(parts.next(), 2).filter(|m| (1..=12).contains(m)).map(|m| m as u8);
        let day = read(parts.next(), 2).map(|d| d as u8);
        match (year, month, day, parts.next()) {
            (Some(year), Some(month), Some(day), None) if (1..=Self::days_in_month(year, month)).contains(&day) => {
                Ok(Self { year, month, day })
            }
            _ => Err(NotADate(text.into())),
        }
    }
}

impl fmt::Display for Date {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04}-{:02}-{:02}", self.year, self.month, self.day)
    }
}

impl Serialize for Date {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Date {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
    }
}

impl JsonSchema for Date {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Date".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({ "type": "string", "pattern": "^[0-9]{4}-[0-9]{2}-[0-9]{2}$" })
    }
}

impl Default for Site {
    /// Seattle at midsummer, on daylight saving time.
    fn default() -> Self {
        Self {
            latitude_deg: 47.5,
            longitude_deg: -122.3,
            utc_offset_h: -7.0,
            date: Date { year: 2004, month: 6, day: 21 },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_real_days() {
        for good in ["2004-02-29", "2000-02-29", "2003-12-31", "0001-01-01"] {
            assert_eq!(good.parse::<Date>().map(|d| d.to_string()).as_deref(), Ok(good));
        }
        for bad in [
            "2003-02-29",
            "1900-02-29",
            "2004-13-01",
            "2004-6-21",
            "0000-01-01",
            "6000-01-01",
            "",
            "2004-06-21-1",
            "２004-06-21",
        ] {
            assert!(bad.parse::<Date>().is_err(), "{bad}");
        }
    }
}
