//! Light that is baked: how much of it comes through a cloud to each sprite, from each of a set of directions (MODEL §10,
//! W's future work).
//!
//! On the edit clock, in the model's space, so that placements share it. Of each sprite and direction it keeps the light
//! that is left at its middle and how that changes towards its corners, which turn with the eye: all in one word. What is
//! kept is e^(−τ/10), as most of what thick cloud lets through goes by that, and it can be mixed and is a byte.

mod along;
mod ball;
mod directions;
mod gathered;

pub use ball::{Ball, Ray};
pub use directions::{Around, Directions};
pub use gathered::gathered;

use crate::watch::Watch;
use along::Along;
use glam::Vec3;
use rayon::prelude::*;
use std::sync::Arc;

/// What ships: 13 directions above the horizon.
pub const DIRECTIONS: Directions = Directions::parted(2);
/// Words that each sprite has: those directions', and one for straight down.
pub const WORDS: usize = DIRECTIONS.count() + 1;
/// How far a corner is drawn to its sprite's middle where light is taken: else outlines of single sprites show.
pub const DRAWN: f32 = 0.55;
/// The share of an optical depth that e is raised to the negative of.
pub const FALLOFF: f32 = 0.1;

/// With more sprites, light is baked for five directions, of the middles alone.
pub const MANY: usize = 50_000;
/// With more sprites, so many stand for all, each for several.
const MOST_BALLS: usize = 16_384;
/// What a sprite costs, in a unit of work of about 10 ns.
const BAKING: u64 = 2_400;

/// The light that is baked of a model's sprites.
#[derive(Debug, Clone, PartialEq)]
pub struct Baked {
    directions: Directions,
    words: Arc<[u32]>,
}

/// The light that is left around the middle of a sprite, 0 to 1: e^(−τ/10).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Left {
    /// At the middle.
    pub middle: f32,
    /// How it changes from there to where one reach of the sprite is drawn to, along the model's axes.
    pub change: Vec3,
}

/// A sprite that stands for others, for [`Baked::with_merged`].
#[derive(Debug, Clone, Copy)]
pub struct Whole<'a> {
    /// Half its diagonal, metres.
    pub reach: f32,
    /// What it stands for; something.
    pub parts: &'a [Part],
}

/// A sprite that another stands for.
#[derive(Debug, Clone, Copy)]
pub struct Part {
    /// Its number.
    pub sprite: usize,
    /// What it counts; not nothing.
    pub weight: f32,
    /// Where it is from the other, metres.
    pub offset: Vec3,
    /// Half of what it measures along the axes, metres.
    pub half: Vec3,
    /// Half its diagonal, metres.
    pub reach: f32,
}

impl Left {
    /// At a point, in reaches of the sprite from its middle.
    #[inline]
    pub fn at(self, offset: Vec3) -> f32 {
        (self.middle + self.change.dot(offset)).clamp(0.0, 1.0)
    }

    fn packed(self) -> u32 {
        let signed = |share: f32| ((share.clamp(-1.0, 1.0) * 127.0).round() as i8).to_ne_bytes()[0];
        let [x, y, z] = self.change.to_array().map(signed);
        u32::from_le_bytes([(self.middle.clamp(0.0, 1.0) * 255.0).round() as u8, x, y, z])
    }

    fn unpacked(word: u32) -> Self {
        let [middle, x, y, z] = word.to_le_bytes();
        let signed = |byte: u8| f32::from(i8::from_ne_bytes([byte])) * (1.0 / 127.0);
        Self { middle: f32::from(middle) * (1.0 / 255.0), change: Vec3::new(signed(x), signed(y), signed(z)) }
    }
}

impl Baked {
    /// What is baked of sprites that are those balls, for `directions`; parts are missing if `watch` is cancelled. The same
    /// bytes on any number of threads.
    pub fn new(balls: &[Ball], directions: Directions, watch: &Watch) -> Self {
        let few = few_of(balls);
        let mut ways = directions.all();
        ways.push(Vec3::NEG_Y);
        let work = BAKING / ways.len() as u64;
        let column = |way: &Vec3| -> Vec<u32> {
            let along = Along::new(*way, &few);
            let left = |ball| left_at(&along, ball, balls.len() <= MANY).packed();
            watch.along(work, balls).map(left).collect()
        };
        let columns: Vec<Vec<u32>> = ways.par_iter().map(column).collect();
        let of =
            |sprite: usize| columns.iter().map(move |column| column.get(sprite).copied().unwrap_or(u32::MAX >> 24));
        Self { directions, words: (0..balls.len()).flat_map(of).collect() }
    }

    /// The directions for which it is baked.
    pub fn directions(&self) -> Directions {
        self.directions
    }

    /// All words, sprite by sprite: its directions', then that of straight down.
    pub fn words(&self) -> &Arc<[u32]> {
        &self.words
    }

    /// Of the sprite of that number, from the directions `around` the light's.
    #[inline]
    pub fn from(&self, sprite: usize, around: &Around) -> Left {
        let of_sprite = self.of(sprite);
        let mut left = Left { middle: 0.0, change: Vec3::ZERO };
        for (at, share) in around.at.iter().zip(around.share) {
            let each = Left::unpacked(of_sprite[*at as usize]);
            left.middle += share * each.middle;
            left.change += share * each.change;
        }
        left
    }

    /// Of the sprite of that number, from straight up and straight down.
    #[inline]
    pub fn up_and_down(&self, sprite: usize) -> [Left; 2] {
        let of_sprite = self.of(sprite);
        let down = self.directions.count();
        [down / 2, down].map(|at| Left::unpacked(of_sprite[at]))
    }

    #[inline]
    fn of(&self, sprite: usize) -> &[u32] {
        let words = self.directions.count() + 1;
        &self.words[sprite * words..][..words]
    }

    /// The same for other directions, mixed of those that are there.
    #[must_use]
    pub fn mixed_for(&self, directions: Directions) -> Self {
        let around: Vec<Around> = directions.all().iter().map(|each| self.directions.around(*each)).collect();
        let of = |sprite: usize| {
            let [_, down] = self.up_and_down(sprite);
            around.iter().map(|around| self.from(sprite, around).packed()).chain([down.packed()]).collect::<Vec<_>>()
        };
        Self { directions, words: (0..self.sprites()).flat_map(of).collect() }
    }

    /// Of other sprites, each as the one of that number here.
    #[must_use]
    pub fn of_numbers(&self, numbers: impl Iterator<Item = usize>) -> Self {
        Self { directions: self.directions, words: numbers.flat_map(|sprite| self.of(sprite).to_vec()).collect() }
    }

    /// The same with more sprites behind, each of which stands for some of these: what is left at those on average, and how
    /// that changes over them. Each with its reach, metres, and those it stands for, with where they are from it, metres.
    #[must_use]
    pub fn with_merged<'a>(&self, merged: impl Iterator<Item = Whole<'a>>) -> Self {
        let words = self.directions.count() + 1;
        let of = |each: Whole<'a>| (0..words).map(move |word| self.merged(&each, word).packed());
        Self { directions: self.directions, words: self.words.iter().copied().chain(merged.flat_map(of)).collect() }
    }

    /// The plane that comes nearest to what is left over all quads of those.
    fn merged(&self, merged: &Whole<'_>, word: usize) -> Left {
        let left = |part: &Part| Left::unpacked(self.of(part.sprite)[word]);
        let total: f32 = merged.parts.iter().map(|part| part.weight).sum();
        let middle = merged.parts.iter().map(|part| part.weight / total * left(part).middle).sum::<f32>();
        let (mut slopes, mut squares) = (Vec3::ZERO, Vec3::ZERO);
        for part in merged.parts {
            let (own, share) = (left(part), part.weight / total);
            let along = part.half * part.half * 0.25;
            slopes += share * (part.offset * (own.middle - middle) + own.change / (part.reach * DRAWN) * along);
            squares += share * (part.offset * part.offset + along);
        }
        let slope = slopes / squares.max(Vec3::splat(1e-6));
        Left { middle, change: slope * merged.reach * DRAWN }
    }

    /// How many sprites it is of.
    pub fn sprites(&self) -> usize {
        self.words.len() / (self.directions.count() + 1)
    }
}

/// The optical depth from `point` on towards a unit vector, metres from the middle of the balls' sprites: ball by ball.
pub fn optical_depth(balls: &[Ball], point: Vec3, direction: Vec3) -> f32 {
    balls.iter().map(|ball| ball.depth_beyond(point, Ray::towards(direction))).sum()
}

/// What light is left of, at an optical depth.
#[inline]
fn left_of(depth: f32) -> f32 {
    libm::expf(-FALLOFF * depth)
}

/// Corners of a tetrahedron about a ball's middle, as far from it as corners of its quad are drawn to: the fewest points that
/// tell a mean and a change, and nearer to what corners have than the middle, where the own ball is deepest.
pub const PROBES: [Vec3; 4] = [
    Vec3::new(PROBE, PROBE, PROBE),
    Vec3::new(PROBE, -PROBE, -PROBE),
    Vec3::new(-PROBE, PROBE, -PROBE),
    Vec3::new(-PROBE, -PROBE, PROBE),
];
/// 1/√3.
const PROBE: f32 = 0.577_350_26;

fn left_at(along: &Along, ball: &Ball, with_change: bool) -> Left {
    if !with_change {
        return Left { middle: left_of(along.depth_from(ball.center)), change: Vec3::ZERO };
    }
    let half = ball.half();
    let left = PROBES.map(|probe| left_of(along.depth_from(ball.center + probe * half * DRAWN)));
    // The plane nearest to four values: their slope is three quarters of the sum of each times where it stands.
    let slope = PROBES.iter().zip(left).map(|(probe, left)| *probe * left).sum::<Vec3>() * 0.75;
    let reach = (half.x * half.x + half.y * half.y).sqrt();
    Left { middle: left.iter().sum::<f32>() * 0.25, change: slope * reach / half }
}

/// The balls, or of too many some, each as deep as those it stands for.
fn few_of(balls: &[Ball]) -> Vec<Ball> {
    let each = balls.len().div_ceil(MOST_BALLS).max(1);
    balls.iter().step_by(each).map(|ball| Ball { depth: ball.depth * each as f32, ..*ball }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Light that falls evenly over some sprites falls so over the one that stands for them.
    #[test]
    fn merged_light_is_the_plane_through_its_parts() {
        let (slope, middle, reach) = (Vec3::new(0.002, -0.001, 0.0005), 0.5, 50.0);
        let places: Vec<Vec3> = (0..27)
            .map(|at| Vec3::new((at % 3 - 1) as f32, (at / 3 % 3 - 1) as f32, (at / 9 - 1) as f32) * 80.0)
            .collect();
        let left = |place: &Vec3| Left { middle: middle + slope.dot(*place), change: slope * reach * DRAWN };
        let words = places.iter().flat_map(|place| [left(place).packed(); WORDS]).collect();
        let baked = Baked { directions: DIRECTIONS, words };
        let part = |(sprite, offset): (usize, &Vec3)| Part {
            sprite,
            weight: 1.0,
            offset: *offset,
            half: Vec3::splat(35.0),
            reach,
        };
        let parts: Vec<Part> = places.iter().enumerate().map(part).collect();
        let whole = baked.with_merged([Whole { reach: 150.0, parts: &parts }].into_iter());
        assert_eq!(whole.sprites(), places.len() + 1);
        for left in whole.up_and_down(places.len()) {
            // Half a step of a byte each way; slopes are rounded by half of 1/127 over a sprite's reach, and again over the
            // whole's, which is three times as long.
            assert!((left.middle - middle).abs() <= 1.0 / 255.0, "{left:?}");
            let wanted = slope * 150.0 * DRAWN;
            assert!((left.change - wanted).abs().max_element() <= 2.0 / 127.0, "{left:?} for {wanted}");
        }
    }
}
