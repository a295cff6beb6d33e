//! A level ground with a landscape's blotches: value noise on a lattice hashed with integers, so that WGSL draws the
//! same. Blotches too small for a pixel fade to their mean.

use crate::color::Rgb;
use crate::math::smoothstep;
use crate::scene::Ground;
use crate::weather::Light;
use glam::{DVec3, Vec3};

/// The pattern repeats after this many metres along x and z: a scene moved by whole periods stands on the same ground.
pub const GROUND_PERIOD_M: f64 = 100_000.0;
/// Sides of the lattices' cells, metres; each divides the period.
pub const GROUND_CELLS_M: [f32; 4] = [4000.0, 1000.0, 250.0, 62.5];

/// The ground as one eye sees it at one moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundLook {
    /// Height of the eye above it, metres; above 0.
    pub eye_height: f32,
    /// Where in the pattern the eye stands, metres in 0 to the period.
    pub eye_in_pattern: [f32; 2],
    /// Radiance of its dark parts.
    pub dark: Rgb,
    /// Radiance of its bright parts.
    pub bright: Rgb,
}

impl GroundLook {
    /// None for an eye that is not above the ground.
    pub fn new(ground: &Ground, eye: DVec3, light: &Light) -> Option<Self> {
        let eye_height = (eye.y - ground.altitude_m) as f32;
        let in_pattern = |x: f64| x.rem_euclid(GROUND_PERIOD_M) as f32;
        // A level face gets the whole sky's ambient, and sun or moon by the sine of its elevation.
        let lit = light.ambient_max.rgb * 0.75 + light.directional_max * (1.4 * light.direction.y.max(0.0));
        (eye_height > 0.0).then(|| Self {
            eye_height,
            eye_in_pattern: [in_pattern(eye.x), in_pattern(eye.z)],
            dark: ground.dark * lit,
            bright: ground.bright * lit,
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
        self.dark.mix(self.bright, self.brightness(point.x, point.z, pixel_m))
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
