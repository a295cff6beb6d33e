//! How much of each cloud is drawn.
//!
//! Either by what can be told apart: where a cloud's sprites are so small that fewer, larger ones in their place
//! ([`crate::sprites::Merging`]) are off by no more than a tolerance, those are drawn. Or a share of its sprites, those that
//! cover most: a sprite counts by its area times its tile's mean opacity. What is dropped is dropped in every view, so
//! nothing pops; what stays is drawn as it was, neither larger nor more opaque, so a cloud gets thinner. Its centre, height
//! and shading groups stay those of all its sprites, so its colours don't change.

use crate::sprites::{Atlas, Cover, Sprite};
use crate::weather::CloudNow;
use rayon::prelude::*;
use std::cmp::Ordering;

/// How much of each cloud is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Detail {
    /// Share of its sprites, 0 to 1, rounded up to whole ones.
    pub kept: f32,
    /// How far what is drawn in place of sprites may be from them, root mean square, pixels; 0 for the sprites themselves.
    pub tolerance_px: f32,
}

impl Detail {
    /// All of it.
    pub const FULL: Self = Self { kept: 1.0, tolerance_px: 0.0 };
    /// What can be told apart: within a mean FLIP of 0.01 of all sprites, from every camera of the shipped scenes at 480 × 270.
    pub const AUTOMATIC: Self = Self { tolerance_px: 1.2, ..Self::FULL };

    /// As much as keeps the picture about within a mean FLIP of that of all sprites, at most 1; all of them for 0 and less.
    /// Measured over the shipped scenes, it grows with the square of what sprites are off.
    pub fn within(flip: f32) -> Self {
        let share = if flip > 1.0 { 100.0 } else { flip / 0.01 };
        Self { tolerance_px: Self::AUTOMATIC.tolerance_px * share.sqrt(), ..Self::FULL }
    }
}

/// Which sprites that comes to: always the same of the same clouds; of equal ones the first. Each cloud's sprites keep what
/// was chosen of them, so that frames look it up.
#[derive(Debug, Clone)]
pub struct Subset<'a> {
    detail: Detail,
    atlas: &'a Atlas,
    /// Of each cloud the least that stays, if any does; none where all do.
    least: Option<Vec<Option<Cover>>>,
}

impl<'a> Subset<'a> {
    /// Of `clouds`, whose tiles are those of `atlas`.
    pub fn new(detail: Detail, clouds: &[CloudNow<'_>], atlas: &'a Atlas) -> Self {
        let least_of = |CloudNow { placed: cloud, .. }: &CloudNow<'_>| {
            let count = (cloud.sprites.len() as f64 * f64::from(detail.kept.max(0.0))).ceil() as usize;
            cloud.sprites.least_of(count, atlas)
        };
        let least = (detail.kept < 1.0).then(|| clouds.par_iter().map(least_of).collect());
        Self { detail, atlas, least }
    }

    /// What was asked for.
    pub fn detail(&self) -> Detail {
        self.detail
    }

    /// Whether nothing is left out.
    pub fn is_all(&self) -> bool {
        self.least.is_none()
    }

    /// Whether that sprite of the cloud of that index, in which it has the index `at`, is drawn.
    pub fn has(&self, cloud: usize, sprite: &Sprite, at: u32) -> bool {
        let Some(least) = &self.least else { return true };
        let least = least.get(cloud).copied().flatten();
        least.is_some_and(|least| Cover::of(sprite, at, self.atlas).most_first(&least) != Ordering::Greater)
    }
}
