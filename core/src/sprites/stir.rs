//! What the air makes of each sprite: how loosely it hangs in its cloud, when it condenses, how it turns and sways.
//!
//! Made of the sprite's place in its cloud and of random numbers of its own, once and when first asked for: a scene without
//! weather has none of it. What the GPU is given are these very values (MODEL §9).

use crate::math::smoothstep;
use crate::random::{draw, unit};
use crate::scene::BoxId;
use glam::Vec3;
use std::sync::{Arc, OnceLock};

/// Of a sprite, whatever the weather.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stir {
    /// How freely it moves, 0 in the core and for flat bases, 1 at the edge and for wisps.
    pub looseness: f32,
    /// The humidity, stretched, around which it condenses, 0 to 1.
    pub threshold: f32,
    /// How it turns as the wind goes by, −1 to 1.
    pub turn: f32,
    /// How much it sways, 0 to 1.
    pub sway: f32,
    /// Where its three swings begin, whole turns from 0 to 1.
    pub phases: [f32; 3],
}

/// Those of a cloud's sprites, shared by its copies.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stirs(Arc<OnceLock<Box<[Stir]>>>);

impl PartialEq for Stirs {
    /// They follow from the sprites, whether or not they have been made.
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// Which draw of a sprite's random numbers they are made of; phase 1 has those before.
const BLOCK: u32 = 16;
/// The same for the noise's lattice.
const LATTICE: u32 = 17;
/// Of the two noises by which a cloud parts, in its radii, and the share of the second.
const WAVELENGTHS: [f32; 2] = [0.5, 0.21];
const FINER: f32 = 0.4;
/// How much a threshold goes by a sprite's place, and how much by the noise.
const BY_PLACE: f32 = 0.4;
const FLAT_BASE: u8 = 3;
/// What even a sprite in the core sways.
const LEAST_SWAY: f32 = 0.25;

/// Where a sprite is in its cloud, and which it is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Within {
    pub(super) box_id: BoxId,
    pub(super) index: u32,
    pub(super) tile: u8,
    /// Its shorter side over its longer one.
    pub(super) squareness: f32,
    /// How far from the cloud's centre, in its radii.
    pub(super) radii: f32,
    /// How far from the middle of its base: across in half the extent of the centres, up in all of it.
    pub(super) from_base: Vec3,
    /// From the cloud's centre, in its radii.
    pub(super) from_center: Vec3,
}

impl Stirs {
    pub(super) fn get_or_make(&self, make: impl FnOnce() -> Box<[Stir]>) -> &[Stir] {
        self.0.get_or_init(make)
    }
}

impl Stir {
    /// Of a sprite of a cloud of that seed.
    pub(super) fn of(sprite: Within, seed: u64) -> Self {
        let Within { box_id, index, tile, squareness, radii, from_base, from_center } = sprite;
        let [turn, phases, ..] = draw(seed, box_id.0, index, BLOCK);
        let is_flat = tile == FLAT_BASE;
        let looseness = match tile {
            FLAT_BASE => 0.0,
            wisp if wisp < FLAT_BASE => 1.0,
            _ => smoothstep(0.5, 1.0, radii),
        };
        let noise = broken(from_center, seed);
        let still = |share: f32| if is_flat { 0.0 } else { share };
        let round_share = smoothstep(0.6, 0.95, squareness);
        // As many bits as the GPU is given.
        let ten_bits = |shift: u32| (phases >> shift & 1023) as f32 / 1024.0;
        Self {
            looseness,
            // By the plain distance from the centre, what is left of a heap would be a ball: heads go before the base.
            threshold: (BY_PLACE * from_base.length().min(1.0) + (1.0 - BY_PLACE) * noise).clamp(0.0, 1.0),
            // What lies flat would stand on end.
            turn: still((round_share * (unit(turn) as f32 * 2.0 - 1.0) * 32_767.0).round() / 32_767.0),
            sway: still(((LEAST_SWAY + (1.0 - LEAST_SWAY) * looseness) * 32_767.0).round() / 32_767.0),
            phases: [ten_bits(0), ten_bits(10), ten_bits(20)],
        }
    }

    /// As four words: looseness and threshold as floats, turn and sway as signed 16-bit shares, the phases as 10 bits each.
    pub fn packed(&self) -> [u32; 4] {
        let share = |value: f32| u32::from((value * 32_767.0).round() as i16 as u16);
        let [a, b, c] = self.phases.map(|phase| (phase * 1024.0) as u32);
        [
            self.looseness.to_bits(),
            self.threshold.to_bits(),
            share(self.turn) | share(self.sway) << 16,
            a | b << 10 | c << 20,
        ]
    }
}

/// 0 to 1: pieces, and rags of pieces.
fn broken(from_center: Vec3, seed: u64) -> f32 {
    let [coarse, fine] = WAVELENGTHS.map(|wavelength| noise(from_center / wavelength, seed));
    let mean = coarse + FINER * (fine - coarse);
    // A mean is seldom far from a half: spread again, so that as much of a cloud goes at each humidity.
    smoothstep(0.2, 0.8, mean)
}

/// 0 to 1, smooth, with one random value for each whole place.
fn noise(at: Vec3, seed: u64) -> f32 {
    let (cell, within) = (at.floor(), at - at.floor());
    let ease = within * within * (Vec3::splat(3.0) - 2.0 * within);
    let corner = |dx: u32, dy: u32, dz: u32| {
        let [x, y, z] = (cell + Vec3::new(dx as f32, dy as f32, dz as f32)).to_array().map(|x| x as i32 as u32);
        unit(draw(seed, u64::from(x) | u64::from(y) << 32, z, LATTICE)[0]) as f32
    };
    let mix = |a: f32, b: f32, t: f32| a + t * (b - a);
    let along = |dy, dz| mix(corner(0, dy, dz), corner(1, dy, dz), ease.x);
    mix(mix(along(0, 0), along(1, 0), ease.y), mix(along(0, 1), along(1, 1), ease.y), ease.z)
}
