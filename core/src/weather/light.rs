//! The light of one moment: where sun and moon are and how much there is.

use super::celestial::{celestial_from_world, julian_date, moon_direction};
use crate::color::{Rgb, Rgba};
use crate::math::smoothstep;
use crate::scene::{Scene, Site, Sun};
use glam::{Mat3, Vec3};
use solar_positioning::{Location, SolarPositions};

/// The scene's light at a time of day.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Local civil hours.
    pub time_h: f64,
    /// From anywhere in the scene to the sun, unit.
    pub sun_direction: Vec3,
    /// From anywhere in the scene to what the directional light comes from, unit: the sun, or at night the moon.
    pub direction: Vec3,
    /// Greatest ambient light; its alpha scales all opacity.
    pub ambient_max: Rgba,
    /// Greatest directional light.
    pub directional_max: Rgb,
    /// What the sky holds besides; none while the sun is up.
    pub night: Option<Night>,
}

/// The night's share of a moment, and where its lights stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Night {
    /// Sine of the sun's elevation, below 0.
    pub sun_sine: f32,
    /// From anywhere in the scene to the moon, unit.
    pub moon_direction: Vec3,
    /// From the scene's axes to those in which the stars stand still.
    pub celestial_from_world: Mat3,
    /// How bright the stars are, 1 as they are.
    pub stars: f32,
    /// How bright the moon is, 1 as it is.
    pub moon: f32,
}

impl Light {
    /// The light of `scene` at `time_h` (any number; taken modulo 24).
    pub fn at(scene: &Scene, time_h: f64) -> Self {
        let ambient = scene.sky.ambient.at(time_h, Rgba::mix);
        let sun_direction = sun_direction(scene.sun, &scene.site, time_h);
        let night = (sun_direction.y < 0.0).then(|| Night {
            sun_sine: sun_direction.y,
            moon_direction: moon_direction(scene.sun, &scene.site, time_h, sun_direction),
            celestial_from_world: celestial_from_world(&scene.site, time_h).as_mat3(),
            stars: scene.sky.stars as f32,
            moon: scene.sky.moon as f32,
        });
        let (direction, share) = night.map_or((sun_direction, 1.0), |night| night.directional(sun_direction));
        let directional = scene.sky.directional_tuning.of(scene.sky.directional.at(time_h, Rgb::mix));
        Self {
            time_h,
            sun_direction,
            direction,
            ambient_max: Rgba { rgb: scene.sky.ambient_tuning.of(ambient.rgb), ..ambient },
            directional_max: directional * share,
            night,
        }
    }
}

/// Sines of the sun's elevation, −1° and −5°, between which it stops lighting the clouds.
const SUN_GOES: [f32; 2] = [-0.017_452, -0.087_156];
/// And −5° and −9°, between which the moon begins to.
const MOON_COMES: [f32; 2] = [-0.087_156, -0.156_434];
/// Sine of the elevation, 5°, from which the moon gives all its light.
const MOON_IS_UP: f32 = 0.087_156;

impl Night {
    /// Where the directional light comes from, and what share there is of what the day's table says: the sun's, which fades,
    /// then the moon's, which comes; it turns from one to the other where there is none.
    fn directional(&self, sun_direction: Vec3) -> (Vec3, f32) {
        if self.sun_sine > SUN_GOES[1] {
            return (sun_direction, smoothstep(SUN_GOES[1], SUN_GOES[0], self.sun_sine));
        }
        let comes = 1.0 - smoothstep(MOON_COMES[1], MOON_COMES[0], self.sun_sine);
        let up = smoothstep(0.0, MOON_IS_UP, self.moon_direction.y);
        let lit = 0.5 * (1.0 - self.moon_direction.dot(sun_direction));
        (self.moon_direction, self.moon * comes * up * lit)
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
    let moment = julian_date(place, time_h)?;
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
