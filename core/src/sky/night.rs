//! The sky at night: a glow that one can see by, stars and moon. None of it is there while the sun is up; it comes smoothly
//! as the sun goes down.
//!
//! The twin in WGSL is render/src/pass/sky/night.wgsl; the glow, which hazes clouds too, is in render/src/shader/dome.wgsl.

use super::stars::{self, Spot, Star};
use crate::color::Rgb;
use crate::math::{exp, smoothstep};
use crate::weather::Night;
use glam::{Mat3, Vec3};

/// Sines of the sun's elevation between which each comes: the glow from the horizon to −12°, the moon to −6°, the stars from
/// −4° to −14°.
const GLOW_COMES: [f32; 2] = [0.0, -0.207_912];
const MOON_COMES: [f32; 2] = [0.0, -0.104_528];
const STARS_COME: [f32; 2] = [-0.069_756, -0.241_922];
/// Radiance of the air's own glow, overhead and at the horizon, chosen by eye: the darkest that shows on a screen.
const GLOW: [Rgb; 2] = [Rgb::new(0.0035, 0.0050, 0.0105), Rgb::new(0.0095, 0.0125, 0.0200)];
/// What a full moon overhead adds to it.
const MOONLIT: [Rgb; 2] = [Rgb::new(0.0035, 0.0070, 0.0150), Rgb::new(0.0085, 0.0125, 0.0200)];
/// Light of the faintest star, radiance times solid angle: it shows as a hint in pixels of a thousandth of a radian.
const FAINTEST: f32 = 3.5e-8;
/// Radiance of the moon's bright parts, and of its night, which the Earth lights.
const MOON: [Rgb; 2] = [Rgb::new(1.35, 1.29, 1.16), Rgb::new(0.010, 0.012, 0.016)];
/// Half the moon's width, 0.26°, radians.
pub const MOON_RADIUS: f32 = 0.004_538;
/// The glow around it: radiance at the disc, and the square of the angle, radians, at which half of it is left.
const HALOS: [[f32; 2]; 2] = [[0.055, 0.000_5], [0.012, 0.03]];
/// Optical depths of the air overhead.
const AIR: Rgb = Rgb::new(0.10, 0.16, 0.27);
/// Dark seas: middles to the celestial east and north, and radii, in the moon's own. Imbrium, Serenitatis, Tranquillitatis,
/// Crisium, Fecunditatis, Procellarum, Humorum, Nubium.
const SEAS: [[f32; 3]; 8] = [
    [0.25, 0.50, 0.33],
    [-0.27, 0.45, 0.22],
    [-0.45, 0.13, 0.27],
    [-0.79, 0.28, 0.14],
    [-0.72, -0.10, 0.20],
    [0.62, 0.22, 0.40],
    [0.60, -0.40, 0.16],
    [0.22, -0.35, 0.26],
];

/// What the dome holds at night.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NightSky {
    /// Radiance of the glow overhead and at the horizon.
    pub glow: [Rgb; 2],
    /// Light of the faintest star.
    pub stars: f32,
    /// How bright the moon is.
    pub moon: f32,
    /// From the eye to the moon, unit.
    pub moon_direction: Vec3,
    /// From the eye to the sun, unit.
    pub sun_direction: Vec3,
    /// From the scene's axes to the stars'.
    pub celestial_from_world: Mat3,
}

impl NightSky {
    /// By a sky's gain.
    pub(crate) fn new(night: &Night, sun_direction: Vec3, gain: f32) -> Self {
        let come = |[from, to]: [f32; 2]| 1.0 - smoothstep(to, from, night.sun_sine);
        let lit = 0.5 * (1.0 - night.moon_direction.dot(sun_direction));
        let moonlit = night.moon * come(MOON_COMES) * lit * smoothstep(-0.05, 0.5, night.moon_direction.y);
        let glow = |i: usize| (GLOW[i] + MOONLIT[i] * moonlit) * (gain * come(GLOW_COMES));
        Self {
            glow: [glow(0), glow(1)],
            stars: FAINTEST * night.stars * come(STARS_COME) * gain,
            moon: night.moon * come(MOON_COMES) * gain,
            moon_direction: night.moon_direction,
            sun_direction,
            celestial_from_world: night.celestial_from_world,
        }
    }

    /// The air's glow at the sine of an elevation, 0 to 1.
    pub(super) fn glow(&self, up: f32) -> Rgb {
        let low = (1.0 - up) * (1.0 - up);
        self.glow[0].mix(self.glow[1], low * low)
    }

    /// Moon and stars in a unit `direction`, in pixels so wide, radians.
    pub fn lights(&self, direction: Vec3, pixel: f32) -> Rgb {
        self.moon(direction, pixel) + self.stars(direction, pixel, |spot, direction| stars::radiance(direction, spot))
    }

    /// One of the stars.
    pub(super) fn star(&self, star: &Star, direction: Vec3, pixel: f32) -> Rgb {
        self.stars(direction, pixel, |spot, direction| spot.radiance(star, direction))
    }

    fn stars(&self, direction: Vec3, pixel: f32, radiance: impl Fn(&Spot, Vec3) -> Rgb) -> Rgb {
        if direction.y <= 0.0 || self.stars <= 0.0 {
            return Rgb::BLACK;
        }
        // The moon hides them, its night too.
        let seen = self.stars * (1.0 - self.disc(direction, pixel));
        radiance(&Spot::new(pixel), self.celestial_from_world * direction) * through_air(direction.y) * seen
    }

    /// How much of a pixel the moon's disc covers; the disc of a coarse picture is three quarters of a pixel wide at least.
    fn disc(&self, direction: Vec3, pixel: f32) -> f32 {
        let apart = (direction - self.moon_direction).length();
        ((moon_radius(pixel) - apart) / pixel + 0.5).clamp(0.0, 1.0)
    }

    /// The moon, lit by the sun from where that is, and the glow around it.
    pub(super) fn moon(&self, direction: Vec3, pixel: f32) -> Rgb {
        if direction.y <= 0.0 || self.moon <= 0.0 {
            return Rgb::BLACK;
        }
        let offset = direction - self.moon_direction;
        let lit = 0.5 * (1.0 - self.moon_direction.dot(self.sun_direction));
        let halo = |[peak, half]: [f32; 2]| peak * half / (half + offset.length_squared());
        let mut color = Rgb::new(0.72, 0.88, 1.10) * (lit * (halo(HALOS[0]) + halo(HALOS[1])));
        let disc = self.disc(direction, pixel);
        if disc > 0.0 {
            let radius = moon_radius(pixel);
            let share = MOON_RADIUS / radius;
            color = color + self.face(offset / radius) * (disc * share * share);
        }
        color * through_air(direction.y) * self.moon
    }

    /// The moon's face at a place off its middle, in its radii.
    fn face(&self, place: Vec3) -> Rgb {
        let normal = place - self.moon_direction * (1.0 - place.length_squared()).max(0.0).sqrt();
        let day = smoothstep(0.0, 0.35, normal.dot(self.sun_direction));
        let middle = self.celestial_from_world * self.moon_direction;
        let east = crate::math::unit_or(Vec3::new(-middle.y, middle.x, 0.0), Vec3::X);
        let on_sphere = self.celestial_from_world * place;
        let (x, y) = (on_sphere.dot(east), on_sphere.dot(middle.cross(east)));
        let dry = SEAS.iter().fold(1.0, |dry, [sea_x, sea_y, radius]| {
            let apart = ((x - sea_x) * (x - sea_x) + (y - sea_y) * (y - sea_y)).sqrt();
            dry * (0.62 + 0.38 * smoothstep(0.55 * radius, 1.15 * radius, apart))
        });
        MOON[0] * (dry.max(0.5) * day) + MOON[1]
    }
}

/// As seen in pixels so wide.
fn moon_radius(pixel: f32) -> f32 {
    MOON_RADIUS.max(0.75 * pixel)
}

/// What of a light in the sky gets through the air at the sine of an elevation: redder and less, down to the horizon.
fn through_air(up: f32) -> Rgb {
    let airs = -1.0 / (up + 0.02);
    Rgb::new(exp(AIR.r * airs), exp(AIR.g * airs), exp(AIR.b * airs))
}
