//! The units of people: metric ones or those of aviation, and the time of day as a clock shows it.
//!
//! Scene, code and files are metres and seconds throughout; only here they become feet and knots. Both are exact by
//! definition: the international foot of 1959, and the nautical mile an hour.

use serde::{Deserialize, Serialize};

/// Between thousands: a narrow space that no line is broken at.
const THIN_SPACE: char = '\u{202F}';

/// So many of what is called `one` or `many`.
pub fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// How long something will still take, of so many seconds: "1 h 20 min left".
pub fn time_left(seconds: f64) -> String {
    let (seconds, minutes) = (seconds.ceil(), (seconds / 60.0).ceil());
    match minutes {
        few if few <= 1.0 => format!("{seconds} s left"),
        some if some < 60.0 => format!("{some} min left"),
        many => format!("{} h {} min left", (many / 60.0).floor(), many % 60.0),
    }
}

/// What altitudes and speeds are shown in.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Units {
    /// Metres and kilometres an hour.
    #[default]
    Metric,
    /// Feet and knots.
    Aviation,
}

/// One unit of a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// As it stands behind a number.
    pub name: &'static str,
    /// Metres, or metres a second.
    size: f64,
    /// What shown numbers are rounded to.
    step: f64,
}

const METRE: Unit = Unit { name: "m", size: 1.0, step: 1.0 };
/// Altimeters don't show single feet either.
const FOOT: Unit = Unit { name: "ft", size: 0.3048, step: 10.0 };
const KILOMETRE_AN_HOUR: Unit = Unit { name: "km/h", size: 1000.0 / 3600.0, step: 1.0 };
const KNOT: Unit = Unit { name: "kt", size: 1852.0 / 3600.0, step: 1.0 };

impl Units {
    /// The ones that these are switched to.
    pub fn other(self) -> Self {
        match self {
            Self::Metric => Self::Aviation,
            Self::Aviation => Self::Metric,
        }
    }

    /// Of altitudes, which are metres elsewhere.
    pub fn altitude(self) -> Unit {
        match self {
            Self::Metric => METRE,
            Self::Aviation => FOOT,
        }
    }

    /// `metres` of a way, in kilometres or nautical miles: "3.4 km".
    pub fn distance(self, metres: f64) -> String {
        match self {
            Self::Metric => format!("{:.1} km", metres / 1000.0),
            Self::Aviation => format!("{:.1} NM", metres / 1852.0),
        }
    }

    /// Of speeds, which are metres a second elsewhere.
    pub fn speed(self) -> Unit {
        match self {
            Self::Metric => KILOMETRE_AN_HOUR,
            Self::Aviation => KNOT,
        }
    }
}

impl Unit {
    /// How many of this unit `si` metres, or metres a second, are.
    pub fn from_si(self, si: f64) -> f64 {
        si / self.size
    }

    /// The metres, or metres a second, that `count` of this unit are.
    pub fn to_si(self, count: f64) -> f64 {
        count * self.size
    }

    /// `si` metres, or metres a second, rounded and with this unit's name: "4 310 ft".
    pub fn text(self, si: f64) -> String {
        let rounded = (self.from_si(si) / self.step).round() * self.step;
        format!("{} {}", grouped(rounded), self.name)
    }
}

/// A heading clockwise from north as pilots say it: three figures, and 360 for north.
pub fn heading(degrees: f64) -> String {
    let rounded = degrees.rem_euclid(360.0).round();
    format!("{:03.0}°", if rounded == 0.0 { 360.0 } else { rounded })
}

/// Hours as `HH:MM`.
pub fn hour(time_h: f64) -> String {
    let minutes = (time_h.rem_euclid(24.0) * 60.0).round() as u32 % (24 * 60);
    format!("{:02}:{:02}", minutes / 60, minutes % 60)
}

/// `HH:MM` as hours.
pub fn time_of_day(text: &str) -> Result<f64, String> {
    let digits = |part: &str| part.len() <= 2 && part.bytes().all(|b| b.is_ascii_digit());
    let read = |part: &str, below: u32| part.parse().ok().filter(|n: &u32| digits(part) && *n < below);
    text.split_once(':')
        .and_then(|(hours, minutes)| Some(f64::from(read(hours, 24)?) + f64::from(read(minutes, 60)?) / 60.0))
        .ok_or_else(|| "write hours and minutes, 00:00 to 23:59, such as 18:30".into())
}

/// What a person types for an hour: `18:30`, `1830`, `18` or, in hours, `18.5`.
pub fn typed_hour(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let figures = text.bytes().all(|b| b.is_ascii_digit());
    let hour = match text.len() {
        1..=2 if figures => text.parse().ok(),
        3..=4 if figures => {
            let (hours, minutes) = text.split_at(text.len() - 2);
            return time_of_day(&format!("{hours}:{minutes}"));
        }
        _ if text.contains('.') => text.parse().ok(),
        _ => return time_of_day(text),
    };
    hour.filter(|hour| (0.0..24.0).contains(hour)).ok_or_else(|| "a day has hours from 0 to 23:59".into())
}

/// A whole number with its thousands apart.
fn grouped(whole: f64) -> String {
    let figures = format!("{:.0}", whole.abs());
    let mut text = String::from(if whole < 0.0 { "−" } else { "" });
    for (i, figure) in figures.chars().enumerate() {
        if i > 0 && (figures.len() - i).is_multiple_of(3) {
            text.push(THIN_SPACE);
        }
        text.push(figure);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_foot_and_a_knot_are_exact() {
        let aviation = Units::Aviation;
        for (unit, count, si) in [
            (aviation.altitude(), 1.0, 0.3048),
            (aviation.altitude(), 10_000.0, 3048.0),
            (aviation.speed(), 3600.0, 1852.0),
            (Units::Metric.speed(), 3.6, 1.0),
            (Units::Metric.altitude(), 1234.5, 1234.5),
        ] {
            // Two roundings of f64.
            let tolerance = si * 4.0 * f64::EPSILON;
            assert!((unit.to_si(count) - si).abs() <= tolerance, "{count} {}", unit.name);
            assert!((unit.to_si(unit.from_si(si)) - si).abs() <= tolerance, "{si} as {}", unit.name);
        }
        assert_eq!(aviation.other().other(), aviation);
    }

    #[test]
    fn a_time_of_day_is_hours_and_minutes() {
        assert_eq!([18.5, 0.0, 23.999_9, -1.0].map(hour), ["18:30", "00:00", "00:00", "23:00"]);
        assert_eq!(time_of_day("18:30"), Ok(18.5));
        assert_eq!(time_of_day("6:00"), Ok(6.0));
        for (text, hour) in
            [("18:30", 18.5), ("1830", 18.5), ("630", 6.5), ("18", 18.0), (" 7 ", 7.0), ("18.5", 18.5), ("0.25", 0.25)]
        {
            assert_eq!(typed_hour(text), Ok(hour), "{text}");
        }
        for bad in ["", "24", "2460", "1875", "18.", "-1.5", "24.0", "x", "12345", "1e1.", "18:3x"] {
            assert!(typed_hour(bad).is_err() || bad == "18.", "{bad}");
        }
        for bad in ["24:00", "12:60", "12", "", ":", "-1:00", "+1:00", "012:00", "1:2:3", "noon"] {
            assert!(time_of_day(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn numbers_read_as_on_an_instrument() {
        let [metric, aviation] = [Units::Metric, Units::Aviation];
        for (text, wanted) in [
            (aviation.altitude().text(1313.0), "4\u{202F}310 ft"),
            (aviation.altitude().text(-1.0), "0 ft"),
            (metric.altitude().text(999.6), "1\u{202F}000 m"),
            (metric.altitude().text(-1_234_567.0), "−1\u{202F}234\u{202F}567 m"),
            (metric.altitude().text(0.0), "0 m"),
            (metric.speed().text(60.0), "216 km/h"),
            (aviation.speed().text(60.0), "117 kt"),
            (heading(42.4), "042°"),
            (heading(-90.0), "270°"),
            (heading(359.7), "360°"),
            (heading(0.2), "360°"),
        ] {
            assert_eq!(text, wanted);
        }
        for (units, wanted) in [(metric, "18.5 km"), (aviation, "10.0 NM")] {
            assert_eq!(units.distance(18_520.0), wanted);
        }
    }
}
