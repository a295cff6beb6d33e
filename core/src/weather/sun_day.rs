//! The sun's day at a place: at which hours it stands how high.
//!
//! Twilight goes by the sun's elevation and not by the clock, so keys of the tables over the day may be placed by it: then
//! one table holds at every place and in every season.

use super::celestial::sun_direction;
use crate::scene::{DailyKey, DailyTable, Site, Sun};

/// A sun that passes a place on one day.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SunDay {
    /// Local hour at which it stands highest.
    noon_h: f64,
    /// Sine and cosine of the latitude.
    latitude: [f64; 2],
    /// Sine and cosine of its declination, at 12:00: it moves by 0.4° a day at most.
    declination: [f64; 2],
}

impl SunDay {
    /// None of a sun set by hand, and at the poles, where its height has no hour.
    pub fn of(sun: Sun, place: &Site) -> Option<Self> {
        if sun != Sun::ByPlace {
            return None;
        }
        let at_12 = sun_direction(sun, place, 12.0).as_dvec3();
        let (sin, cos) = libm::sincos(place.latitude_deg.to_radians());
        // From east, up and south to the pole, the equator above the horizon, and east.
        let sin_declination = at_12.y * sin - at_12.z * cos;
        let cos_declination = (1.0 - sin_declination * sin_declination).max(0.0).sqrt();
        if !(cos.abs() > 1e-3 && cos_declination > 1e-3) {
            return None;
        }
        let west_of_noon = libm::atan2(-at_12.x, at_12.y * cos + at_12.z * sin);
        let noon_h = 12.0 - west_of_noon.to_degrees() / 15.0;
        Some(Self { noon_h, latitude: [sin, cos], declination: [sin_declination, cos_declination] })
    }

    /// The local hour, 0 to 24, at which it stands at that elevation, before or after noon; none if it never does.
    /// Within a minute or two.
    pub fn hour_of(&self, elevation_deg: f64, after_noon: bool) -> Option<f64> {
        let ([sin_a, cos_a], [sin_b, cos_b]) = (self.latitude, self.declination);
        let cos = (libm::sin(elevation_deg.to_radians()) - sin_a * sin_b) / (cos_a * cos_b);
        let from_noon_h = (cos.abs() <= 1.0).then(|| libm::acos(cos).to_degrees() / 15.0)?;
        let hour = if after_noon { self.noon_h + from_noon_h } else { self.noon_h - from_noon_h };
        Some(hour.rem_euclid(24.0))
    }
}

/// `table` with the hours that its keys by the sun have where `sun` passes `place`; those that it never reaches there are left
/// out, if others stay. With a sun by hand they keep the hours that they say.
pub fn on_day<T: Copy>(table: &DailyTable<T>, sun: Sun, place: &Site) -> DailyTable<T> {
    let goes_by_sun = table.keys.iter().any(|key| key.sun_deg.is_some());
    let Some(day) = goes_by_sun.then(|| SunDay::of(sun, place)).flatten() else { return table.clone() };
    let placed = |key: &DailyKey<T>| match key.sun_deg {
        None => Some(*key),
        Some(elevation_deg) => Some(DailyKey { hour: day.hour_of(elevation_deg, key.hour >= 12.0)?, ..*key }),
    };
    let mut keys: Vec<DailyKey<T>> = table.keys.iter().filter_map(placed).collect();
    keys.sort_by(|a, b| a.hour.total_cmp(&b.hour));
    // Of two that fall together, the one that comes later in the file holds.
    keys.dedup_by(|later, first| {
        let together = later.hour - first.hour < 1e-6;
        if together {
            *first = *later;
        }
        together
    });
    if keys.is_empty() { table.clone() } else { DailyTable { keys } }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Date;

    fn place(latitude_deg: f64, longitude_deg: f64, utc_offset_h: f64, date: &str) -> Site {
        Site { latitude_deg, longitude_deg, utc_offset_h, date: date.parse::<Date>().expect("a day") }
    }

    /// Against the full algorithm: where the sun is at the hour that the closed form says.
    #[test]
    fn the_sun_stands_there_then() {
        for place in [
            Site::default(),
            place(-33.9, 18.4, 2.0, "2024-12-21"),
            place(0.0, 100.0, 7.0, "2024-03-20"),
            place(64.1, -21.9, 0.0, "2024-09-10"),
        ] {
            let day = SunDay::of(Sun::ByPlace, &place).expect("a day");
            for elevation_deg in [20.0, 5.0, 0.0, -4.0, -6.0, -12.0] {
                for after_noon in [false, true] {
                    let hour = day.hour_of(elevation_deg, after_noon).expect("it gets there");
                    let got = f64::from(sun_direction(Sun::ByPlace, &place, hour).y.asin().to_degrees());
                    assert!((got - elevation_deg).abs() < 0.4, "{place:?}, {elevation_deg}°: {got}° at {hour}");
                    let rises =
                        sun_direction(Sun::ByPlace, &place, hour + 0.1).y > sun_direction(Sun::ByPlace, &place, hour).y;
                    assert_eq!(rises, !after_noon, "{place:?}, {elevation_deg}° at {hour}");
                }
            }
        }
    }

    #[test]
    fn keys_by_the_sun_come_when_it_does() {
        let key = |hour, sun_deg, value| DailyKey { hour, sun_deg, value };
        let table = DailyTable {
            keys: vec![
                key(5.0, Some(-6.0), 1.0_f32),
                key(12.0, None, 2.0),
                key(20.0, Some(-6.0), 3.0),
                key(21.0, Some(-18.0), 4.0),
            ],
        };
        let hours = |site: &Site| {
            on_day(&table, Sun::ByPlace, site).keys.iter().map(|key| (key.hour, key.value)).collect::<Vec<_>>()
        };
        let summer = hours(&Site::default());
        let winter = hours(&Site { utc_offset_h: -8.0, date: "2004-12-21".parse().expect("a day"), ..Site::default() });
        // Seattle: civil dusk at 21:50 in June, 16:55 in December (NOAA).
        let dusk =
            |hours: &[(f64, f32)]| hours.iter().find(|(_, value)| *value == 3.0).map_or(f64::NAN, |(hour, _)| *hour);
        assert!((dusk(&summer) - 21.83).abs() < 0.1 && (dusk(&winter) - 16.92).abs() < 0.1, "{summer:?} {winter:?}");
        assert!(summer.is_sorted_by(|a, b| a.0 < b.0), "astronomical dusk is after midnight: {summer:?}");
        // What the sun never reaches is left out: at midsummer it sinks to −6.6° at 60° north, to −2.6° at 64°.
        for (latitude_deg, expected) in [(60.0, vec![1.0, 2.0, 3.0]), (64.0, vec![2.0])] {
            let north = hours(&place(latitude_deg, 0.0, 0.0, "2024-06-21"));
            let mut values: Vec<f32> = north.iter().map(|(_, value)| *value).collect();
            values.sort_by(f32::total_cmp);
            assert_eq!(values, expected, "at {latitude_deg}°: {north:?}");
        }
        let by_hand = Sun::ByHand { heading_deg: 0.0, elevation_deg: 3.0 };
        assert_eq!(on_day(&table, by_hand, &Site::default()), table);
        for latitude_deg in [90.0, -90.0] {
            assert_eq!(on_day(&table, Sun::ByPlace, &Site { latitude_deg, ..Site::default() }).keys.len(), 4);
        }
    }
}
