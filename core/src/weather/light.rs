//! The light of one moment: where sun and moon are and how much there is.

use super::celestial::{celestial_from_world, moon_direction, sun_direction};
use super::sun_day::on_day;
use crate::color::{Rgb, Rgba};
use crate::math::smoothstep;
use crate::scene::Scene;
use glam::{Mat3, Vec3};

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
        let ambient = on_day(&scene.sky.ambient, scene.sun, &scene.site).at(time_h, Rgba::mix);
        let sun_direction = sun_direction(scene.sun, &scene.site, time_h);
        let night = (sun_direction.y < 0.0).then(|| Night {
            sun_sine: sun_direction.y,
            moon_direction: moon_direction(scene.sun, &scene.site, time_h, sun_direction),
            celestial_from_world: celestial_from_world(&scene.site, time_h).as_mat3(),
            stars: scene.sky.stars as f32,
            moon: scene.sky.moon as f32,
        });
        let (direction, share) = night.map_or((sun_direction, 1.0), |night| night.directional(sun_direction));
        let directional = on_day(&scene.sky.directional, scene.sun, &scene.site).at(time_h, Rgb::mix);
        let directional = scene.sky.directional_tuning.of(directional);
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

impl Light {
    /// What an eye that has got used to this light sees it brighter by, if it does so by that `share`, 0 to 1: some of what the
    /// light lacks to that of a late afternoon, and no more than to tell clouds from sky.
    pub fn brightened(&self, share: f32) -> f32 {
        let there = self.ambient_max.rgb.luminance() + SUN_TO_EYE * self.directional_max.luminance();
        let lacking = libm::log2f(USED_TO / there.max(1e-6)).clamp(0.0, MOST_LACKING);
        libm::exp2f(share.clamp(0.0, 1.0) * ADAPTED * lacking)
    }
}

/// Luminance of light that an eye sees as it is; what the directional light adds to the ambient one.
const USED_TO: f32 = 0.45;
const SUN_TO_EYE: f32 = 0.2;
/// How much of each halving of the light an eye makes up for, and of how many at most.
const ADAPTED: f32 = 0.45;
const MOST_LACKING: f32 = 7.0;

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
