//! Where the sun, the moon and the stars stand.
//!
//! The moon is that of the Astronomical Almanac's low-precision formulas (page D22; the largest terms of Brown's theory,
//! within 0.3° from 1900 to 2100, degrees off in other millennia), seen from the ground and not from the Earth's middle. The
//! stars turn about the pole with sidereal time; precession is left out, as no star of ours has a name.

use crate::scene::{Site, Sun};
use glam::{DMat3, DVec3, Vec3};
use solar_positioning::time::JulianDate;
use solar_positioning::{Location, SolarPositions};

/// TT − UT1, seconds. Over the years that scenes are set in it moves the sun by under 0.01°.
const DELTA_T_S: f64 = 69.0;
const J2000: f64 = 2_451_545.0;

/// A local civil hour (any number; taken modulo 24) of the place's day; none out of the calendar's range.
fn julian_date(place: &Site, time_h: f64) -> Option<JulianDate> {
    let date = place.date;
    let midnight =
        JulianDate::from_utc(date.year.into(), date.month.into(), date.day.into(), 0, 0, 0.0, DELTA_T_S).ok()?;
    let hours_utc = time_h.rem_euclid(24.0) - place.utc_offset_h;
    JulianDate::new(midnight.julian_date() + hours_utc / 24.0, DELTA_T_S).ok()
}

/// From the scene to the sun, unit: by the Solar Position Algorithm (Reda and Andreas 2004) at the place and date, or
/// by hand. The sun stands still where a place or date is out of the algorithm's range.
pub fn sun_direction(sun: Sun, place: &Site, time_h: f64) -> Vec3 {
    let (heading_deg, elevation_deg) = match sun {
        Sun::ByHand { heading_deg, elevation_deg } => (heading_deg, elevation_deg),
        Sun::ByPlace => by_place(place, time_h).unwrap_or((180.0, 45.0)),
    };
    let (heading, elevation) = (heading_deg.to_radians(), elevation_deg.to_radians());
    let level = libm::cos(elevation);
    Vec3::new((libm::sin(heading) * level) as f32, libm::sin(elevation) as f32, (-libm::cos(heading) * level) as f32)
}

fn by_place(place: &Site, time_h: f64) -> Option<(f64, f64)> {
    let moment = julian_date(place, time_h)?;
    let location = Location { latitude: place.latitude_deg, longitude: place.longitude_deg };
    let position = SolarPositions::new().at_from_julian(moment, location, 0.0, None).ok()?;
    Some((position.azimuth(), position.elevation_angle()))
}

/// The Julian date of an hour of the night that begins on the place's day: what is before noon is the morning after, so that
/// nothing jumps at midnight.
fn night_date(place: &Site, time_h: f64) -> Option<f64> {
    let morning_after = if time_h.rem_euclid(24.0) < 12.0 { 1.0 } else { 0.0 };
    Some(julian_date(place, time_h)?.julian_date() + morning_after)
}

/// From the scene to the moon, unit: by place, date and hour; of a sun set by hand, opposite it, so that one is full and
/// up where the other is down. It is opposite too where a place or date is out of range.
pub fn moon_direction(sun: Sun, place: &Site, time_h: f64, sun_direction: Vec3) -> Vec3 {
    let by_place = || Some(seen_from_the_ground(place, night_date(place, time_h)?).as_vec3());
    let found = if sun == Sun::ByPlace { by_place() } else { None };
    found.unwrap_or(-sun_direction)
}

/// From the scene's axes to those of the stars: z to the northern celestial pole, x to the vernal equinox.
pub fn celestial_from_world(place: &Site, time_h: f64) -> DMat3 {
    celestial_axes(place, night_date(place, time_h).unwrap_or(J2000))
}

fn celestial_axes(place: &Site, date: f64) -> DMat3 {
    let sidereal_deg = 280.46062 + 360.985_647_37 * (date - J2000) + place.longitude_deg;
    let (sin, cos) = libm::sincos(sidereal_deg.rem_euclid(360.0).to_radians());
    let (pole_up, pole_north) = libm::sincos(place.latitude_deg.to_radians());
    // The world's east, up and south as the stars' axes say them.
    let east = DVec3::new(-sin, cos, 0.0);
    let up = DVec3::new(pole_north * cos, pole_north * sin, pole_up);
    DMat3::from_cols(east, up, east.cross(up))
}

fn seen_from_the_ground(place: &Site, date: f64) -> DVec3 {
    let centuries = (date - J2000) / 36_525.0;
    let sum = |terms: &[(f64, f64, f64)], wave: fn(f64) -> f64| -> f64 {
        let term =
            |(size, at, rate): &(f64, f64, f64)| size * wave((at + rate * centuries).rem_euclid(360.0).to_radians());
        terms.iter().map(term).sum()
    };
    let longitude = (218.32 + 481_267.881 * centuries + sum(&LONGITUDE, libm::sin)).rem_euclid(360.0).to_radians();
    let latitude = sum(&LATITUDE, libm::sin).to_radians();
    let parallax = (0.9508 + sum(&PARALLAX, libm::cos)).to_radians();
    let ecliptic = DVec3::new(
        libm::cos(latitude) * libm::cos(longitude),
        libm::cos(latitude) * libm::sin(longitude),
        libm::sin(latitude),
    );
    let (sin, cos) = libm::sincos((23.439 - 0.013 * centuries).to_radians());
    let equatorial = DVec3::new(ecliptic.x, cos * ecliptic.y - sin * ecliptic.z, sin * ecliptic.y + cos * ecliptic.z);
    let world = celestial_axes(place, date).transpose() * equatorial;
    // The eye stands an Earth's radius, the sine of the parallax in distances of the moon, above its middle.
    (world - DVec3::Y * libm::sin(parallax)).normalize()
}

/// Degrees: how much, from where, and how far in a century.
const LONGITUDE: [(f64, f64, f64); 6] = [
    (6.29, 135.0, 477_198.87),
    (-1.27, 259.3, -413_335.36),
    (0.66, 235.7, 890_534.22),
    (0.21, 269.9, 954_397.74),
    (-0.19, 357.5, 35_999.05),
    (-0.11, 186.5, 966_404.03),
];
const LATITUDE: [(f64, f64, f64); 4] =
    [(5.13, 93.3, 483_202.02), (0.28, 228.2, 960_400.89), (-0.28, 318.3, 6_003.15), (-0.17, 217.6, -407_332.21)];
const PARALLAX: [(f64, f64, f64); 4] = [
    (0.0518, 135.0, 477_198.87),
    (0.0095, 259.3, -413_335.36),
    (0.0078, 235.7, 890_534.22),
    (0.0028, 269.9, 954_397.74),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Date;

    fn at(latitude_deg: f64, longitude_deg: f64, date: &str) -> Site {
        Site { latitude_deg, longitude_deg, utc_offset_h: 0.0, date: date.parse::<Date>().expect("a day") }
    }

    #[test]
    fn the_moon_of_known_moments() {
        let apart_deg = |place: &Site, hour: f64| {
            let sun = sun_direction(Sun::ByPlace, place, hour);
            moon_direction(Sun::ByPlace, place, hour, sun).angle_between(sun).to_degrees()
        };
        // Total eclipses: of the sun over Dallas, 8 April 2024, 18:42 UTC; of the moon, 8 November 2022, 10:59 UTC.
        let dallas = apart_deg(&at(32.78, -96.80, "2024-04-08"), 18.7);
        assert!(dallas < 0.4, "{dallas}");
        let eclipsed = apart_deg(&at(40.0, -100.0, "2022-11-07"), 10.99);
        assert!(eclipsed > 178.5, "{eclipsed}");
        // First quarter, 24 April 2026, 02:32 UTC: 90° along the ecliptic, seen from the Earth's middle.
        let quarter = apart_deg(&at(0.0, -120.0, "2026-04-23"), 2.53);
        assert!((quarter - 90.0).abs() < 1.5, "{quarter}");
    }

    /// Meeus, *Astronomical Algorithms*, example 47.a: 12 April 1992, 0h TD, α 134.688°, δ 13.768° from the Earth's middle.
    #[test]
    fn the_moon_of_meeus() {
        let date = 2_448_724.5;
        // Where it is straight overhead, the middle and the ground see it in one direction.
        let beneath = Site { latitude_deg: 13.768, longitude_deg: 0.0, ..Site::default() };
        let sidereal_deg = 280.46062 + 360.985_647_37 * (date - J2000);
        let beneath = Site { longitude_deg: (134.688 - sidereal_deg).rem_euclid(360.0), ..beneath };
        let off_deg = seen_from_the_ground(&beneath, date).angle_between(DVec3::Y).to_degrees();
        assert!(off_deg < 0.3, "{off_deg}");
    }

    #[test]
    fn stars_turn_about_the_pole_once_a_sidereal_day() {
        let place = at(47.5, -122.3, "2004-06-21");
        let star = DVec3::new(0.6, 0.0, 0.8);
        let seen = |hour: f64| celestial_from_world(&place, hour).transpose() * star;
        let pole = celestial_from_world(&place, 3.0).transpose() * DVec3::Z;
        let (up, north) = (47.5_f64.to_radians().sin(), 47.5_f64.to_radians().cos());
        assert!((pole - DVec3::new(0.0, up, -north)).length() < 1e-9, "{pole}");
        // Six sidereal hours are a right angle about it, to the west above it.
        let [from, to] = [seen(2.0), seen(2.0 + 6.0 * 0.997_269_57)].map(|v| (v - pole * v.dot(pole)).normalize());
        assert!(from.dot(to).abs() < 1e-6 && from.cross(to).dot(pole) < 0.0, "{from} {to}");
    }

    #[test]
    fn a_sun_by_hand_has_a_full_moon() {
        let sun = Sun::ByHand { heading_deg: 30.0, elevation_deg: -25.0 };
        let down = sun_direction(sun, &Site::default(), 1.0);
        assert_eq!(moon_direction(sun, &Site::default(), 1.0, down), -down);
    }

    #[test]
    fn the_sun_of_a_known_place_and_time() {
        // NREL's own example (SPA technical report, table A5.1): Golden, 17 October 2003, 12:30:30, UTC−7:
        // zenith 50.11162°, azimuth 194.34024°. The report's site lies 1,830 m high and has refraction: 0.02°.
        let golden = Site {
            latitude_deg: 39.742476,
            longitude_deg: -105.1786,
            utc_offset_h: -7.0,
            date: Date { year: 2003, month: 10, day: 17 },
        };
        let (heading, elevation) = by_place(&golden, 12.0 + 30.5 / 60.0).expect("in range");
        assert!((heading - 194.34024).abs() < 0.02, "{heading}");
        assert!((elevation - (90.0 - 50.11162)).abs() < 0.02, "{elevation}");
    }

    #[test]
    fn directions_by_hand() {
        let direction = |heading_deg, elevation_deg| {
            sun_direction(Sun::ByHand { heading_deg, elevation_deg }, &Site::default(), 3.0)
        };
        assert!(direction(90.0, 0.0).distance(Vec3::X) < 1e-6, "east");
        assert!(direction(0.0, 0.0).distance(Vec3::NEG_Z) < 1e-6, "north");
        assert!(direction(17.0, 90.0).distance(Vec3::Y) < 1e-6, "overhead");
    }
}
