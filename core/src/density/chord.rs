//! Opacity along chords through a cloud: of its sprites, and of a grid that stands in for them.

use super::{DensityGrid, Vapour};
use crate::facing::Pose;
use crate::posed_sprite::PosedSprite;
use crate::random::{draw, unit};
use crate::sprites::{Atlas, TILE_SIZE};
use crate::watch::Watch;
use glam::Vec3;
use rayon::prelude::*;

/// Chords of a cloud.
pub const CHORDS: usize = 1000;
/// Of the chords' dice.
const SEED: u64 = 0x00C4_04D5;
/// After so many casts a line is taken, though others would be as likely.
const MOST_CASTS: u32 = 20_000;

/// A straight line through a cloud, and how opaque the sprites are along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chord {
    /// A point of it, metres from where the first cloud has its origin.
    pub through: Vec3,
    /// Unit.
    pub direction: Vec3,
    /// Of the sprites, each facing whoever looks along the chord from far away; 0 to 1.
    pub opacity: f32,
}

/// How far the opacities along a grid's chords are from the sprites', 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChordError {
    /// Of all chords.
    pub mean: f32,
    /// Half are nearer.
    pub median: f32,
    /// One in a hundred is farther.
    pub p99: f32,
}

/// [`CHORDS`], the same each time: in all directions alike, and from each evenly over the outline, which is that of the
/// spheres that hold sprites. So thin rims count as much as they show. Fewer if `watch` is cancelled.
pub fn through(vapour: &Vapour<'_>, watch: &Watch) -> Vec<Chord> {
    let spheres = Spheres::of(vapour);
    let chord = |number: u32| {
        let (through, direction) = spheres.line(number, watch)?;
        let mut clear = 1.0;
        for (at, offset) in spheres.met(through, direction) {
            let [cloud, sprite] = spheres.sprites[at];
            let pose = Pose::facing_eye(direction, Vec3::Y);
            clear *=
                1.0 - alpha(&PosedSprite::new(vapour.clouds[cloud], sprite, pose, vapour.light), vapour.atlas, -offset);
        }
        Some(Chord { through, direction, opacity: 1.0 - clear })
    };
    (0..CHORDS as u32).into_par_iter().filter_map(chord).collect()
}

/// The spheres that hold the sprites that show.
#[derive(Default)]
struct Spheres {
    /// The number of the cloud, and of the sprite in it.
    sprites: Vec<[usize; 2]>,
    /// Metres from where the first cloud has its origin.
    centers: Vec<Vec3>,
    /// Metres.
    radii: Vec<f32>,
    /// The sum of the squares of the radii up to each.
    areas: Vec<f64>,
}

impl Spheres {
    fn of(vapour: &Vapour<'_>) -> Self {
        let mut all = Self::default();
        let mut area = 0.0;
        for (number, cloud) in vapour.clouds.iter().enumerate() {
            let from_origin = (cloud.origin() - vapour.origin()).as_vec3();
            for index in 0..cloud.placed.sprites.len() {
                let posed = PosedSprite::new(cloud, index, Pose::facing_eye(Vec3::NEG_Z, Vec3::Y), vapour.light);
                let radius = posed.sprite.reach();
                if posed.light_at(Vec3::ZERO).ambient.a > 0.0 && radius > 0.0 {
                    area += f64::from(radius) * f64::from(radius);
                    all.sprites.push([number, index]);
                    all.centers.push(from_origin + posed.sprite.position);
                    all.radii.push(radius);
                    all.areas.push(area);
                }
            }
        }
        all
    }

    /// A line through one of them: through each place of their outline as likely as through any other. Where many lie
    /// behind one another, a line would be chosen by each of them, so of those only one in so many is taken.
    fn line(&self, number: u32, watch: &Watch) -> Option<(Vec3, Vec3)> {
        let whole = *self.areas.last()?;
        for cast in 0..MOST_CASTS {
            if watch.is_cancelled() {
                return None;
            }
            let [which, away, around, up] = draw(SEED, 0, number, 2 * cast).map(unit);
            let [turn, taken, ..] = draw(SEED, 0, number, 2 * cast + 1).map(unit);
            let direction = on_sphere(up, turn);
            let index = self.areas.partition_point(|sum| *sum < which * whole).min(self.radii.len() - 1);
            let (right, above) = direction.any_orthonormal_pair();
            let around = around * std::f64::consts::TAU;
            let [x, y] = [libm::cos(around), libm::sin(around)].map(|share| (share * away.sqrt()) as f32);
            let through = self.centers[index] + (right * x + above * y) * self.radii[index];
            // Most casts are turned down by the first few spheres.
            let most = (1.0 / taken) as usize;
            if self.met(through, direction).take(most + 1).count() <= most || cast + 1 == MOST_CASTS {
                return Some((through, direction));
            }
        }
        None
    }

    /// Those that a line meets, in their order.
    fn met(&self, through: Vec3, direction: Vec3) -> impl Iterator<Item = (usize, Vec3)> {
        let away = move |(index, (center, radius)): (usize, (&Vec3, &f32))| {
            let offset = *center - through;
            (offset.cross(direction).length_squared() < radius * radius).then_some((index, offset))
        };
        self.centers.iter().zip(&self.radii).enumerate().filter_map(away)
    }
}

/// Even over the sphere, as height and heading are.
fn on_sphere(up: f64, turn: f64) -> Vec3 {
    let (up, turn) = (2.0 * up - 1.0, turn * std::f64::consts::TAU);
    let level = (1.0 - up * up).max(0.0).sqrt();
    Vec3::new((libm::cos(turn) * level) as f32, up as f32, (libm::sin(turn) * level) as f32)
}

/// A sprite's alpha where a line that it faces meets it, which goes through what lies `away` from its middle.
fn alpha(posed: &PosedSprite<'_>, atlas: &Atlas, away: Vec3) -> f32 {
    let sprite = &posed.sprite;
    let x = 0.5 + away.dot(posed.facing.right) / sprite.width;
    let y = 0.5 - away.dot(posed.facing.up) / sprite.height;
    if !((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y)) {
        return 0.0;
    }
    let [top_left, top_right, bottom_right, bottom_left] =
        posed.corners(Vec3::ZERO).map(|offset| posed.light_at(offset).ambient.a);
    mix(mix(top_left, top_right, x), mix(bottom_left, bottom_right, x), y) * texel(atlas, sprite.tile, x, y)
}

fn mix(from: f32, to: f32, share: f32) -> f32 {
    from + (to - from) * share
}

/// A tile's alpha at a share of its width from the left and of its height from the top, between its texels' middles.
fn texel(atlas: &Atlas, tile: u8, x: f32, y: f32) -> f32 {
    let level = atlas.level(tile.into(), 0);
    let [x, y] = [x, y].map(|share| (share * TILE_SIZE as f32 - 0.5).clamp(0.0, (TILE_SIZE - 1) as f32));
    let of = |column: usize, row: usize| {
        let [column, row] = [column, row].map(|place| place.min(TILE_SIZE - 1));
        f32::from(level.texels[row * TILE_SIZE + column][3]) / 255.0
    };
    let (column, row) = (x as usize, y as usize);
    let upper = mix(of(column, row), of(column + 1, row), x.fract());
    mix(upper, mix(of(column, row + 1), of(column + 1, row + 1), x.fract()), y.fract())
}

/// The factor of all extinction by which the opacities along chords are nearest to the sprites' on average, and what is
/// left then. Chords count from what lies `from_corner` of the grid.
pub(super) fn fit(grid: &DensityGrid, from_corner: Vec3, chords: &[Chord]) -> (f32, ChordError) {
    let depth = |chord: &Chord| grid.depth(from_corner + chord.through, chord.direction);
    let depths: Vec<f32> = chords.par_iter().map(depth).collect();
    let errors = |factor: f32| {
        let error = move |(chord, depth): (&Chord, &f32)| (1.0 - libm::expf(-depth * factor) - chord.opacity).abs();
        chords.iter().zip(&depths).map(error)
    };
    // From an eighth to eight times, in steps of 1 %.
    let factors = (-209..=209).map(|step| libm::powf(1.01, step as f32));
    let mean = |factor: f32| errors(factor).sum::<f32>() / chords.len().max(1) as f32;
    let best = factors.map(|factor| (mean(factor), factor)).min_by(|a, b| a.0.total_cmp(&b.0));
    let factor = best.map_or(1.0, |(_, factor)| factor);
    let mut left: Vec<f32> = errors(factor).collect();
    left.sort_by(f32::total_cmp);
    let at = |share: f32| left.get((left.len() as f32 * share) as usize).copied().unwrap_or(0.0);
    (factor, ChordError { mean: mean(factor), median: at(0.5), p99: at(0.99) })
}
