//! How much of each cloud is drawn: a share of its sprites, those that cover most.
//!
//! A sprite counts by its area times its tile's mean opacity. What is dropped is dropped in every view, so nothing pops;
//! what stays is drawn as it was, neither larger nor more opaque, so a cloud gets thinner. Its centre, height and
//! shading groups stay those of all its sprites, so its colours don't change. (Growing what stays, as Cook, Halstead,
//! Planck and Ryu do in *Stochastic Simplification of Aggregate Detail*, 2007, would blend as many fragments as before,
//! and fragments are what clouds cost.)

use crate::sprites::{Atlas, Cover, Sprite};
use crate::weather::CloudNow;
use rayon::prelude::*;
use std::cmp::Ordering;

/// How much of each cloud is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Detail {
    /// Share of its sprites, 0 to 1, rounded up to whole ones.
    pub kept: f32,
}

impl Detail {
    /// All of it.
    pub const FULL: Self = Self { kept: 1.0 };
}

/// Which sprites that comes to: always the same of the same clouds; of equal ones the first. Each cloud's sprites keep what
/// was chosen of them, so that frames look it up.
#[derive(Debug, Clone)]
pub struct Subset<'a> {
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
        Self { atlas, least }
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
