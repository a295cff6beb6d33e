//! The light of one moment: where the sun is and how much there is.

use crate::color::{Rgb, Rgba};
use crate::scene::{Site, Scene, Sun};
use glam::Vec3;
use solar_positioning::time::JulianDate;
use solar_positioning::{Location, SolarPositions};

/// The scene's light at a time of day.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Local civil hours.
    pub time_h: f64,
    /// From anywhere in the scene to the sun, unit.
    pub sun_direction: Vec3,
    /// Greatest ambient light; its alpha scales all opacity.
    pub ambient_max: Rgba,
    /// Greatest directional light.
    pub directional_max: Rgb,
}

impl Light {
    /// The light of `scene` at `time_h` (any number; taken modulo 24).
    pub fn at(scene: &Scene, time_h: f64) -> Self {
        let ambient = scene.sky.ambient.at(time_h, Rgba::mix);
        Self {
            time_h,
            sun_direction: sun_direction(scene.sun, &scene.site, time_h),
            ambient_max: Rgba { rgb: scene.sky.ambient_tuning.of(ambient.rgb), ..ambient },
            directional_max: scene.sky.directional_tuning.of(scene.sky.directional.at(time_h, Rgb::mix)),
        }
    }
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
    // TT − UT1. Over the years that scenes are set in it moves the sun by under 0.01°.
    const DELTA_T_S: f64 = 69.0;
    let midnight = JulianDate::from_utc(
        place.date.year.into(),
        place.date.month.into(),
        place.date.day.into(),
        0,
        0,
        0.0,
        DELTA_T_S,
    )
    .ok()?;
    let hours_utc = time_h.rem_euclid(24.0) - place.utc_offset_h;
    let moment = JulianDate::new(midnight.julian_date() + hours_utc / 24.0, DELTA_T_S).ok()?;
    let location = Location { latitude: place.latitude_deg, longitude: place.longitude_deg };
    let position = SolarPositions::new().at_from_julian(moment, location, 0.0, None).ok()?;
    Some((position.azimuth(), position.elevation_angle()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Date;

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
