//! When a model's light is baked, and what lights its sprites until then.
//!
//! Shared by the model's placements and by copies of the caches, so that what one thread has baked all have.

use super::candidates::middle;
use super::{Atlas, Candidate, PopulatedModel};
use crate::baked::{Baked, Ball, DIRECTIONS, Directions, MANY, Part, Whole};
use crate::scene::{ColorLevels, level_color};
use crate::watch::Watch;
use rustc_hash::FxHashMap;
use std::sync::{Arc, OnceLock};

/// What is baked of a model, or is to be.
#[derive(Debug, Clone)]
pub(crate) struct Bake(Arc<Inner>);

#[derive(Debug)]
struct Inner {
    sprites: Arc<PopulatedModel>,
    levels: ColorLevels,
    /// Of the sprites as they were before an edit; until the new are baked, they are lit by that.
    before: Option<Baked>,
    baked: OnceLock<Baked>,
}

impl PartialEq for Bake {
    /// It follows from the sprites, whether or not it is baked yet.
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Bake {
    /// Of those sprites under those colour levels, where before there was another.
    pub(crate) fn new(sprites: Arc<PopulatedModel>, levels: ColorLevels, before: Option<&Self>) -> Self {
        let before = before.and_then(|before| before.known_for(&sprites));
        Self(Arc::new(Inner { sprites, levels, before, baked: OnceLock::new() }))
    }

    /// Whether it is of those.
    pub(crate) fn is_of(&self, sprites: &Arc<PopulatedModel>, levels: &ColorLevels) -> bool {
        let opacities = |levels: &ColorLevels| levels.map(|level| (level.height, level.color.a));
        Arc::ptr_eq(&self.0.sprites, sprites) && opacities(&self.0.levels) == opacities(levels)
    }

    /// What light is left, as far as it is known.
    pub(crate) fn known(&self) -> Option<&Baked> {
        self.0.baked.get().or(self.0.before.as_ref())
    }

    /// Whether it is baked.
    pub(crate) fn is_done(&self) -> bool {
        self.0.baked.get().is_some()
    }

    /// Bakes it, if it is not; whether it is then: not if `watch` is cancelled.
    pub(crate) fn finish(&self, watch: &Watch) -> bool {
        if !self.is_done() {
            let balls = balls_of(&self.0.sprites.sprites, &self.0.levels);
            let baked = if balls.len() > MANY {
                Baked::new(&balls, Directions::parted(1), watch).mixed_for(DIRECTIONS)
            } else {
                Baked::new(&balls, DIRECTIONS, watch)
            };
            if watch.is_cancelled() {
                return false;
            }
            let baked = with_merged(&baked, &self.0.sprites, &balls);
            // Another thread may have been sooner, with the same.
            let _ = self.0.baked.set(baked);
        }
        true
    }

    /// Of other sprites, what these have of the same box and index; of new ones, what the one before them has.
    fn known_for(&self, sprites: &Arc<PopulatedModel>) -> Option<Baked> {
        let known = self.known().filter(|known| known.sprites() > 0)?;
        if Arc::ptr_eq(&self.0.sprites, sprites) {
            return Some(known.clone());
        }
        let key = |each: &Candidate| (each.box_id, each.index);
        let at: FxHashMap<_, usize> =
            self.0.sprites.sprites.iter().enumerate().map(|(at, each)| (key(each), at)).collect();
        let mut last = 0;
        let merged = sprites.merging.merged.iter().map(|merged| &merged.sprite);
        let numbers = sprites.sprites.iter().chain(merged).map(|each| {
            last = at.get(&key(each)).copied().unwrap_or(last);
            last
        });
        Some(known.of_numbers(numbers))
    }
}

/// What is baked of a model's own sprites, which are those `balls`, and what the merged ones have of that.
fn with_merged(baked: &Baked, populated: &PopulatedModel, balls: &[Ball]) -> Baked {
    let PopulatedModel { sprites, merging, .. } = populated;
    let reach = |sprite: &Candidate| 0.5 * sprite.width.hypot(sprite.height) as f32;
    let parts: Vec<Vec<Part>> = merging
        .merged
        .iter()
        .map(|merged| {
            let part = |at: &u32| {
                let (sprite, ball) = (&sprites[*at as usize], &balls[*at as usize]);
                Part {
                    sprite: *at as usize,
                    weight: ((sprite.width * sprite.height) as f32).max(f32::MIN_POSITIVE),
                    offset: (sprite.position - merged.sprite.position).as_vec3(),
                    half: ball.half(),
                    reach: reach(sprite),
                }
            };
            merging.sprites_of(merged).iter().map(part).collect()
        })
        .collect();
    baked.with_merged(
        merging.merged.iter().zip(&parts).map(|(merged, parts)| Whole { reach: reach(&merged.sprite), parts }),
    )
}

/// Sprites of a model as balls that count from the middle of them; colour levels thin some.
pub fn balls_of(sprites: &[Candidate], levels: &ColorLevels) -> Vec<Ball> {
    let low = sprites.iter().map(|each| each.position.y - each.radius()).fold(f64::MAX, f64::min);
    let high = sprites.iter().map(|each| each.position.y + each.radius()).fold(f64::MIN, f64::max);
    let height_of = |y: f64| if high > low { ((y - low) / (high - low)).clamp(0.0, 1.0) } else { 0.0 };
    let middle = middle(sprites);
    // Of the built-in sheet, whatever sheet a scene shows: what is baked then depends on the model alone, and other sheets
    // have the same kinds of tiles in the same places.
    let tiles = Atlas::built_in();
    let ball = |sprite: &Candidate| {
        let opacity = level_color(levels, height_of(sprite.position.y) as f32).a.clamp(0.0, 1.0);
        let halves = halves_of([sprite.width, sprite.height].map(|side| side as f32), sprite.rotation as f32);
        Ball::new((sprite.position - middle).as_vec3(), halves, tiles.mean_opacity(sprite.tile.into()) * opacity)
    };
    sprites.iter().map(ball).collect()
}

/// Half of what a quad of those sides measures across and upwards that is turned by that angle before an eye on its level,
/// if it were an ellipse.
pub(crate) fn halves_of([width, height]: [f32; 2], rotation: f32) -> [f32; 2] {
    let (sin, cos) = libm::sincosf(rotation);
    let half = |a: f32, b: f32| 0.5 * (a * a + b * b).sqrt();
    [half(width * cos, height * sin), half(width * sin, height * cos)]
}
