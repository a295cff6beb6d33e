//! Fewer, larger sprites in place of a cloud's many, for where those are too small to tell apart (MODEL §7: merge, don't
//! select).
//!
//! A model's sprites are parted in four along their longest extents, and the parts again, until few are left: a tree as in
//! Rusinkiewicz and Levoy, *QSplat*, SIGGRAPH 2000. For each part there is a sprite that stands where its sprites do on
//! average, reaches as far as they do (their second moments are its own) and covers as much of that as they would if
//! they lay anywhere in it. It is of the sheet's tiles like all others, and is lit, turned, formed and blown as they are.

use super::{Atlas, Candidate, halves_of};
use crate::watch::Watch;
use glam::DVec3;
use std::collections::VecDeque;
use std::ops::Range;

/// So many sprites or fewer are not parted again.
const FEW: usize = 5;
/// From so many on a part is parted in four, below in two.
const MANY: usize = 12;
/// The tile of flat bases: a base that is merged with heads is none.
const FLAT_BASE: u8 = 3;
/// How much larger or smaller a sprite's area is made so that it covers enough, at most: tiles are soft, and what would
/// cover as much as a heap would reach far beyond it.
const AREA: [f64; 2] = [0.3, 1.3];
/// Sides that are as equal as this let a sprite be turned by any angle.
const ROUND: f64 = 0.8;

/// A sprite that stands for others.
#[derive(Debug, Clone, PartialEq)]
pub struct Merged {
    /// It, with box, number, group, lump and tile of the one that covers most of those.
    pub sprite: Candidate,
    /// Which of the model's sprites covers most.
    pub foremost: u32,
    /// Those it stands for, in [`Merging::order`].
    pub of: Range<u32>,
    /// Merged sprites that stand for them too; if there are none, only they themselves do.
    pub parts: Range<u32>,
    /// How far they are from it, root mean square by what each covers, metres.
    pub spread_m: f32,
    /// How far the centre of any is from it at most, metres.
    pub reach_m: f32,
    /// How many of them lie over one another in it, in the mean.
    pub layers: f32,
}

/// All merged sprites of a model.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Merging {
    /// The one for all sprites first; each before its parts.
    pub merged: Vec<Merged>,
    /// Indices of the model's sprites, those of a part side by side.
    pub order: Vec<u32>,
}

impl Merging {
    /// Of `sprites`, whose places are finite.
    pub fn new(sprites: &[Candidate]) -> Self {
        Self::watched(sprites, &Watch::default())
    }

    /// The same under a watch; none are merged if that is cancelled.
    pub(super) fn watched(sprites: &[Candidate], watch: &Watch) -> Self {
        let mut order: Vec<u32> = (0..sprites.len() as u32).collect();
        let mut merged: Vec<Merged> = Vec::new();
        if sprites.len() < 2 {
            return Self { merged, order };
        }
        let covers = Cover::all(sprites);
        merged.push(merge(sprites, &covers, &order, 0));
        let mut waiting = VecDeque::from([0]);
        while let Some(at) = waiting.pop_front() {
            let Range { start, end } = merged[at].of.clone();
            let from = merged.len() as u32;
            if (end - start) as usize > FEW {
                if watch.is_cancelled() {
                    return Self::default();
                }
                let mut first = start;
                for part in parted(sprites, &mut order[start as usize..end as usize]) {
                    merged.push(merge(sprites, &covers, part, first));
                    waiting.push_back(merged.len() - 1);
                    first += part.len() as u32;
                }
            }
            merged[at].parts = from..merged.len() as u32;
        }
        Self { merged, order }
    }

    /// Indices of the model's sprites that one stands for.
    pub fn sprites_of(&self, merged: &Merged) -> &[u32] {
        &self.order[merged.of.start as usize..merged.of.end as usize]
    }
}

/// What a sprite covers, and where.
#[derive(Debug, Clone, Copy)]
struct Cover {
    /// Its area times its tile's mean opacity, m².
    area: f64,
    /// Mean squares of how far from its centre it is across and upwards, m².
    variance: [f64; 2],
}

impl Cover {
    fn all(sprites: &[Candidate]) -> Vec<Self> {
        // Of the built-in sheet, as baked light is.
        let tiles = Atlas::built_in();
        let cover = |sprite: &Candidate| {
            let spread = f64::from(tiles.spread(sprite.tile.into()));
            let halves = halves_of([sprite.width, sprite.height].map(|side| side as f32), sprite.rotation as f32);
            Self {
                area: sprite.width * sprite.height * f64::from(tiles.mean_opacity(sprite.tile.into())),
                variance: halves.map(|half| (f64::from(half) * spread).powi(2)),
            }
        };
        sprites.iter().map(cover).collect()
    }
}

/// `order` in parts: flat bases apart from what is heaped on them, else two or four along the longest extents, of as many
/// sprites each as can be.
fn parted<'a>(sprites: &[Candidate], order: &'a mut [u32]) -> Vec<&'a [u32]> {
    let is_flat = |at: &u32| sprites[*at as usize].tile == FLAT_BASE;
    let flat = order.iter().filter(|at| is_flat(at)).count();
    if (1..order.len()).contains(&flat) {
        order.sort_unstable_by_key(|at| (!is_flat(at), *at));
        let (flat, heaped) = order.split_at(flat);
        return vec![flat, heaped];
    }
    let four = order.len() >= MANY;
    let (low, high) = halved(sprites, order);
    if !four {
        return vec![low, high];
    }
    let ((a, b), (c, d)) = (halved(sprites, low), halved(sprites, high));
    vec![a, b, c, d]
}

fn halved<'a>(sprites: &[Candidate], order: &'a mut [u32]) -> (&'a mut [u32], &'a mut [u32]) {
    let place = |at: u32| sprites[at as usize].position;
    let ends = order.iter().map(|at| (place(*at), place(*at))).reduce(|(low, high), (p, _)| (low.min(p), high.max(p)));
    let extent = ends.map_or(DVec3::ZERO, |(low, high)| high - low);
    let along = extent.max_position();
    let half = order.len() / 2;
    order.select_nth_unstable_by(half, |a, b| place(*a)[along].total_cmp(&place(*b)[along]).then(a.cmp(b)));
    order.split_at_mut(half)
}

/// One for the sprites of `part`, which begins at `first` in the order.
fn merge(sprites: &[Candidate], covers: &[Cover], part: &[u32], first: u32) -> Merged {
    let each = || part.iter().map(|at| (*at, &sprites[*at as usize], &covers[*at as usize]));
    let foremost = each().max_by(|a, b| a.2.area.total_cmp(&b.2.area).then(b.0.cmp(&a.0))).map_or(0, |(at, ..)| at);
    // What covers nothing at all still stands somewhere.
    let weight = |cover: &Cover| cover.area.max(f64::MIN_POSITIVE);
    let total: f64 = each().map(|(_, _, cover)| weight(cover)).sum();
    let mean = |of: &dyn Fn(&Candidate, &Cover) -> f64| {
        each().map(|(_, sprite, cover)| weight(cover) / total * of(sprite, cover)).sum::<f64>()
    };
    let middle = DVec3::new(
        mean(&|sprite, _| sprite.position.x),
        mean(&|sprite, _| sprite.position.y),
        mean(&|sprite, _| sprite.position.z),
    );
    let off = |sprite: &Candidate| sprite.position - middle;
    let across = mean(&|sprite, cover| {
        let off = off(sprite);
        0.5 * (off.x * off.x + off.z * off.z) + cover.variance[0]
    });
    let upwards = mean(&|sprite, cover| off(sprite).y.powi(2) + cover.variance[1]);
    let largest = &sprites[foremost as usize];
    let tiles = Atlas::built_in();
    let spread = f64::from(tiles.spread(largest.tile.into())).max(1e-3);
    let [half_width, half_height] = [across, upwards].map(|variance| variance.sqrt() / spread);
    let share = area_share(4.0 * half_width * half_height, each().map(|(_, _, cover)| cover.area), largest.tile);
    let sides = [half_width, half_height].map(|half| 2.0 * half * share.sqrt());
    let is_round = sides[0].min(sides[1]) > ROUND * sides[0].max(sides[1]);
    // What is flat lies as it did, one way or the other.
    let flipped = if foremost % 2 == 0 { 0.0 } else { std::f64::consts::PI };
    let all = Candidate {
        position: middle,
        width: sides[0],
        height: sides[1],
        rotation: if is_round { largest.rotation } else { flipped },
        moved: false,
        ..*largest
    };
    let sprite = if part.len() > 1 { all } else { *largest };
    let areas: f64 = each().map(|(_, sprite, _)| sprite.width * sprite.height).sum();
    Merged {
        layers: (areas / (sprite.width * sprite.height).max(f64::MIN_POSITIVE)) as f32,
        sprite,
        foremost,
        of: first..first + part.len() as u32,
        parts: 0..0,
        spread_m: mean(&|sprite, _| off(sprite).length_squared()).sqrt() as f32,
        reach_m: each().map(|(_, sprite, _)| off(sprite).length()).fold(0.0, f64::max) as f32,
    }
}

/// What an area is multiplied with so that a `tile` in it covers as much as those do that are strewn over it.
fn area_share(area: f64, covered: impl Iterator<Item = f64>, tile: u8) -> f64 {
    let clear: f64 = covered.map(|covered| 1.0 - (covered / area.max(f64::MIN_POSITIVE)).min(1.0)).product();
    let opacity = f64::from(Atlas::built_in().mean_opacity(tile.into())).max(1e-3);
    ((1.0 - clear) / opacity).clamp(AREA[0], AREA[1])
}
