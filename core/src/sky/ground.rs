//! A level ground with a landscape's blotches: value noise on a lattice hashed with integers, so that WGSL draws the
//! same. Blotches too small for a pixel fade to their mean.

use crate::color::Rgb;
use crate::math::smoothstep;
use crate::scene::Ground;
use crate::weather::{Light, ShadowMap, Shadows};
use glam::{DVec3, Vec3};
use std::sync::Arc;

/// The pattern repeats after this many metres along x and z: a scene moved by whole periods stands on the same ground.
pub const GROUND_PERIOD_M: f64 = 100_000.0;
/// Sides of the lattices' cells, metres; each divides the period.
pub const GROUND_CELLS_M: [f32; 4] = [4000.0, 1000.0, 250.0, 62.5];

/// The ground as one eye sees it at one moment.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundLook {
    /// Height of the eye above it, metres; above 0.
    pub eye_height: f32,
    /// Where in the pattern the eye stands, metres in 0 to the period.
    pub eye_in_pattern: [f32; 2],
    /// Radiance of its dark parts.
    pub dark: Rgb,
    /// Radiance of its bright parts.
    pub bright: Rgb,
    /// What is left of both where no directional light comes.
    pub without_sun: Rgb,
    /// The clouds' shadows, for who draws on the CPU.
    pub shadow: Option<GroundShadow>,
}

/// The clouds' shadows on the ground, as one eye sees them.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundShadow {
    map: Arc<ShadowMap>,
    shadows: Shadows,
    /// A map's place of what lies straight below the eye, texels, and how it changes a metre to the east and to the south.
    below: [f32; 2],
    east: [f32; 2],
    south: [f32; 2],
}

impl GroundShadow {
    /// Seen from an `eye`.
    pub(crate) fn new(map: Arc<ShadowMap>, shadows: Shadows, eye: DVec3) -> Self {
        let plane = &map.plane;
        let below = plane.place(DVec3::new(eye.x, plane.ground_m, eye.z));
        let [east, south] = [0, 2].map(|axis| [0, 1].map(|i| plane.axes[i][axis] / plane.texel_m[i]));
        Self { map, shadows, below, east, south }
    }

    /// What reaches the ground of the directional light at `x`, `z` metres from the eye.
    #[inline(always)]
    pub(super) fn reaches(&self, x: f32, z: f32) -> f32 {
        let place = [0, 1].map(|i| self.below[i] + x * self.east[i] + z * self.south[i]);
        self.shadows.reaches_ground(self.map.left(place))
    }
}

impl GroundLook {
    /// None for an eye that is not above the ground.
    pub fn new(ground: &Ground, eye: DVec3, light: &Light) -> Option<Self> {
        let eye_height = (eye.y - ground.altitude_m) as f32;
        let in_pattern = |x: f64| x.rem_euclid(GROUND_PERIOD_M) as f32;
        // A level face gets the whole sky's ambient, and sun or moon by the sine of its elevation.
        let sky = light.ambient_max.rgb * 0.75;
        let lit = sky + light.directional_max * (1.4 * light.direction.y.max(0.0));
        let share = |of: f32, all: f32| if all > 0.0 { of / all } else { 1.0 };
        (eye_height > 0.0).then(|| Self {
            eye_height,
            eye_in_pattern: [in_pattern(eye.x), in_pattern(eye.z)],
            dark: ground.dark * lit,
            bright: ground.bright * lit,
            without_sun: Rgb::new(share(sky.r, lit.r), share(sky.g, lit.g), share(sky.b, lit.b)),
            shadow: None,
        })
    }

    /// How far away the ground lies in a unit `direction`, metres; none at or above the horizon.
    pub fn distance(&self, direction: Vec3) -> Option<f32> {
        (direction.y < -1e-5).then(|| -self.eye_height / direction.y)
    }

    /// Length of the ground that a pixel of angle `footprint` (radians) covers, `distance` metres away in a unit
    /// `direction`.
    pub fn pixel_m(&self, direction: Vec3, distance: f32, footprint: f32) -> f32 {
        distance * footprint / direction.y.abs().max(1e-6)
    }

    /// Radiance of the ground at an eye-relative point, where a pixel covers `pixel_m` metres.
    #[inline(always)]
    pub fn color(&self, point: Vec3, pixel_m: f32) -> Rgb {
        let lit = self.dark.mix(self.bright, self.brightness(point.x, point.z, pixel_m));
        let Some(shadow) = &self.shadow else { return lit };
        lit * self.without_sun.mix(Rgb::grey(1.0), shadow.reaches(point.x, point.z))
    }

    /// 0 where it is dark, 1 where it is bright, at `x`, `z` metres from the eye.
    fn brightness(&self, x: f32, z: f32, pixel_m: f32) -> f32 {
        let [brightness] = self.brightnesses([x], [z], [pixel_m]);
        brightness
    }

    /// As many at once, in loops without branches or calls, which the compiler runs in lanes.
    #[inline(always)]
    pub(super) fn brightnesses<const N: usize>(&self, x: [f32; N], z: [f32; N], pixel_m: [f32; N]) -> [f32; N] {
        let mut sum = [0.0; N];
        let mut weight = 0.5;
        for (octave, cell) in GROUND_CELLS_M.into_iter().enumerate() {
            for i in 0..N {
                let (x, z) = (self.eye_in_pattern[0] + x[i], self.eye_in_pattern[1] + z[i]);
                let shown = 1.0 - smoothstep(0.25, 0.75, pixel_m[i] / cell);
                sum[i] += weight * shown * (lattice_noise(x / cell, z / cell, octave as u32) - 0.5);
            }
            weight *= 0.7;
        }
        sum.map(|sum| smoothstep(-0.22, 0.22, sum))
    }
}

/// Value noise in 0 to 1: smooth between random values at whole numbers.
#[inline(always)]
fn lattice_noise(x: f32, z: f32, octave: u32) -> f32 {
    let (cell_x, cell_z) = (x.floor(), z.floor());
    let fade = |t: f32| t * t * (3.0 - 2.0 * t);
    let (u, v) = (fade(x - cell_x), fade(z - cell_z));
    let period = GROUND_PERIOD_M as f32 / GROUND_CELLS_M[octave as usize];
    // In floats, which divide eight at once; whole numbers below 2²³ then stand in the low bits of 2²³ + n.
    let wrap = |cell: f32| (cell - period * (cell / period).floor() + 8_388_608.0).to_bits() & 0x007F_FFFF;
    let (x0, x1, z0, z1) = (wrap(cell_x), wrap(cell_x + 1.0), wrap(cell_z), wrap(cell_z + 1.0));
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    let near = mix(hash(x0, z0, octave), hash(x1, z0, octave), u);
    let far = mix(hash(x0, z1, octave), hash(x1, z1, octave), u);
    mix(near, far, v)
}

/// 0 to 1 from three numbers (the mixing steps of O'Neill's PCG-RXS-M-XS, 2014).
#[inline(always)]
pub(super) fn hash(x: u32, z: u32, octave: u32) -> f32 {
    let key = x.wrapping_mul(73_856_093) ^ z.wrapping_mul(19_349_663) ^ octave.wrapping_mul(83_492_791);
    let state = key.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    // 24 bits: exact in f32, and as a signed number one instruction.
    (((word >> 22) ^ word) >> 8) as i32 as f32 / 16_777_216.0
}
