//! Clouds, groups and sprites as the page's textures hold them: words by the four. The layout is that of
//! render/src/cloud_data.rs.

use super::super::Leaving;
use super::block::Block;
use super::moving;
use crate::baked::{Ball, WORDS};
use crate::derived::Derived;
use crate::scene::ModelId;
use crate::sprites::{Group, PlacedCloud, SoftLight, Sprite};
use crate::weather::CloudNow;
use rustc_hash::FxHashMap;
use serde::Serialize;
use std::sync::Arc;

/// Where a cloud's things stand.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Listed {
    /// Metres in the world.
    origin: [f64; 3],
    first_sprite: usize,
    sprites: usize,
    first_key: usize,
    keys: usize,
    /// Of its colour levels; clouds of one model share them.
    first_level_key: usize,
    level_keys: usize,
    /// The balls that stand for it where it shades another: the first, and how many.
    few: usize,
    few_balls: usize,
}

/// All of them.
#[derive(Debug, Default)]
pub(super) struct Clouds {
    pub(super) listed: Vec<Listed>,
    sprites: Vec<[u32; 8]>,
    groups: Vec<[f32; 8]>,
    clouds: Vec<[f32; 40]>,
    stirs: Vec<[u32; 4]>,
    /// What is baked of each sprite, of a model once.
    baked: Vec<[u32; 16]>,
    /// Each sprite's optical depth, and balls: centre, half across and upwards, depth.
    depths: Vec<[f32; 1]>,
    balls: Vec<[f32; 6]>,
    /// Of which words that is, and where they begin.
    known_baked: Vec<(Arc<[u32]>, usize)>,
    keys: Vec<[f32; moving::CLOUD_NUMBERS]>,
    air: Vec<[f32; moving::AIR_NUMBERS]>,
    levels: Vec<[f32; moving::LEVEL_NUMBERS]>,
    /// Whether there are tracks of groups' light, which the page has not.
    pub(super) has_keyed_groups: bool,
}

impl Clouds {
    /// Those that are to leave; some are missing if the watch is cancelled.
    pub(super) fn new(leaving: &Leaving<'_>, times_s: &[f64]) -> Self {
        let Leaving { derived, now, watch, .. } = *leaving;
        let mut all = Self { air: moving::air(derived.clouds().first(), derived, times_s), ..Self::default() };
        let mut models: FxHashMap<ModelId, [usize; 2]> = FxHashMap::default();
        watch.expect(now.clouds.len() as u64);
        for cloud in watch.along(1, &now.clouds) {
            let first_sprite = all.add_sprites(cloud.placed, cloud.groups());
            let [first_level_key, level_keys] = *models
                .entry(cloud.placed.cloud.model)
                .or_insert_with(|| all.add_levels(cloud.placed, derived, times_s));
            let keys = moving::cloud(cloud.placed, derived, &moving::times_s(leaving, Some(cloud.placed.id)));
            let casts = cloud.placed.casts();
            all.depths.extend(casts.depths.iter().map(|depth| [*depth]));
            let few = all.balls.len();
            all.balls.extend(casts.few.iter().map(ball_numbers));
            all.listed.push(Listed {
                origin: cloud.placed.origin.to_array(),
                first_sprite,
                sprites: cloud.placed.sprites.len(),
                first_key: all.keys.len(),
                keys: keys.len(),
                first_level_key,
                level_keys,
                few,
                few_balls: casts.few.len(),
            });
            all.keys.extend(keys);
            let first_baked = all.add_baked(cloud);
            all.clouds.push(cloud_numbers(cloud, first_baked as f32 - first_sprite as f32));
        }
        all
    }

    fn add_sprites(&mut self, placed: &PlacedCloud, groups: &[Group]) -> usize {
        let (first_sprite, first_group) = (self.sprites.len(), self.groups.len());
        self.sprites.extend(placed.sprites.iter().map(|sprite| sprite_words(sprite, first_group)));
        self.groups.extend(groups.iter().map(group_numbers));
        if !self.air.is_empty() {
            self.stirs.extend(placed.stirs()[..placed.sprites.len()].iter().map(crate::sprites::Stir::packed));
        }
        first_sprite
    }

    /// Adds what is baked of a cloud's sprites, if anything and not yet there; where it begins.
    fn add_baked(&mut self, cloud: &CloudNow<'_>) -> usize {
        let Some(baked) = cloud.baked else { return 0 };
        if let Some((_, first)) = self.known_baked.iter().find(|(known, _)| Arc::ptr_eq(known, baked.words())) {
            return *first;
        }
        let first = self.baked.len();
        let of_sprite = |words: &[u32]| std::array::from_fn(|word| words.get(word).copied().unwrap_or_default());
        let own = baked.words().chunks_exact(WORDS).take(cloud.placed.sprites.len());
        self.baked.extend(own.map(of_sprite));
        self.known_baked.push((Arc::clone(baked.words()), first));
        first
    }

    /// Adds the keys of the levels of a cloud's model: the first, and how many.
    fn add_levels(&mut self, placed: &PlacedCloud, derived: &Derived, times_s: &[f64]) -> [usize; 2] {
        let (first, keys) = (self.levels.len(), moving::levels(placed, derived, times_s));
        self.has_keyed_groups |= moving::moves_groups(placed, derived, times_s);
        let count = keys.len();
        self.levels.extend(keys);
        [first, count]
    }

    /// Adds their sections.
    pub(super) fn write(&self, block: &mut Block) {
        block.add("sprites", self.sprites.as_flattened());
        block.add("groups", self.groups.as_flattened());
        block.add("clouds", self.clouds.as_flattened());
        block.add("stirs", self.stirs.as_flattened());
        block.add("baked", self.baked.as_flattened());
        block.add("depths", self.depths.as_flattened());
        block.add("balls", self.balls.as_flattened());
        block.add("cloud_keys", self.keys.as_flattened());
        block.add("air_keys", self.air.as_flattened());
        block.add("level_keys", self.levels.as_flattened());
    }
}

fn sprite_words(sprite: &Sprite, first_group: usize) -> [u32; 8] {
    let (sin, cos) = libm::sincosf(sprite.rotation);
    let [x, y, z] = sprite.position.to_array();
    let [a, b, c, d, e, f, g] = [x, y, z, sprite.width, sprite.height, sin, cos].map(f32::to_bits);
    let group = first_group as u32 + sprite.group;
    [a, b, c, d, e, f, g, group << 4 | u32::from(sprite.tile & 15)]
}

fn ball_numbers(ball: &Ball) -> [f32; 6] {
    let ([x, y, z], half) = (ball.center.to_array(), ball.half());
    [x, y, z, half.x, half.y, ball.depth]
}

fn group_numbers(group: &Group) -> [f32; 8] {
    let ([x, y, z], [c_min, c_med, c_max]) = (group.center.to_array(), group.c);
    [x, y, z, c_min, c_med, c_max, 0.0, 0.0]
}

/// Centre, 1 / radius; bottom, top, the highest level's height, radius; the other heights; the levels' colours; where what is
/// baked begins, from its sprites, self-shadow, halo, reach; sine and cosine of its heading, largest radius of a sprite, nothing.
fn cloud_numbers(cloud: &CloudNow<'_>, baked_from_sprites: f32) -> [f32; 40] {
    let PlacedCloud { center, radius, bottom, top, .. } = *cloud.placed;
    let levels = cloud.color_levels();
    let heights = levels.map(|level| level.height as f32);
    let mut numbers = [0.0; 40];
    numbers[..3].copy_from_slice(&center.to_array());
    numbers[3] = if radius > 0.0 { 1.0 / radius } else { 0.0 };
    numbers[4..8].copy_from_slice(&[bottom, top, heights[4], radius]);
    numbers[8..12].copy_from_slice(&heights[..4]);
    for (slot, level) in numbers[12..32].chunks_mut(4).zip(levels) {
        slot.copy_from_slice(&level.color.to_array());
    }
    (numbers[35], numbers[38]) = (cloud.placed.reach, cloud.placed.largest);
    if cloud.baked.is_some() {
        let SoftLight { self_shadow, halo } = cloud.placed.soft_light;
        numbers[32..35].copy_from_slice(&[baked_from_sprites, self_shadow, halo]);
        numbers[36..38].copy_from_slice(&cloud.placed.heading);
    }
    numbers
}
