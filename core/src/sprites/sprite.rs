//! A sprite; a cloud's sprites, shared by its copies, and which of them cover most.
//!
//! Which cover most depends on nothing but them and their tiles. It is worked out when a picture first asks, and kept
//! where they are: a frame looks it up, and what is placed anew has nothing of the old.

use super::Atlas;
use crate::scene::BoxId;
use crate::version::Version;
use glam::Vec3;
use std::cmp::Ordering;
use std::ops::Deref;
use std::sync::{Arc, Mutex, PoisonError};

/// More choices than methods ask for of one cloud at a time; the oldest goes.
const KEPT: usize = 4;

/// A sprite that is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sprite {
    /// Centre, metres, relative to the cloud's `origin`, along the world's axes.
    pub position: Vec3,
    /// Metres.
    pub width: f32,
    /// Metres.
    pub height: f32,
    /// Radians, counter-clockwise as seen.
    pub rotation: f32,
    /// 0 to 15, row by row.
    pub tile: u8,
    /// Index into the cloud's groups.
    pub group: u32,
    /// Its box.
    pub box_id: BoxId,
    /// Its number within the box.
    pub index: u32,
}

impl Sprite {
    /// Half the longer side, metres (MODEL §2).
    pub fn radius(&self) -> f32 {
        self.width.max(self.height) * 0.5
    }

    /// Half the diagonal, metres: the sphere that holds the quad however it is turned.
    pub fn reach(&self) -> f32 {
        0.5 * (self.width * self.width + self.height * self.height).sqrt()
    }
}

/// A cloud's sprites, in the order of boxes and indices; behind them those that may stand for some of them.
#[derive(Debug, Clone)]
pub struct Sprites {
    all: Arc<[Sprite]>,
    /// How many are the cloud's own.
    own: usize,
    choices: Arc<Mutex<Choices>>,
}

/// What was worked out of them.
#[derive(Debug, Default)]
struct Choices {
    /// The last one at the end.
    kept: Vec<Choice>,
    made: u64,
}

/// Of so many sprites that cover most the one that covers least, with the tiles of a sheet.
#[derive(Debug, Clone, Copy)]
struct Choice {
    atlas: Version,
    count: usize,
    least: Cover,
}

/// What one sprite covers: its area times its tile's mean opacity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cover {
    area: f32,
    at: u32,
}

impl Sprites {
    /// Of `all`, the first `own` are the cloud's.
    pub(super) fn with_merged(all: Arc<[Sprite]>, own: usize) -> Self {
        Self { own: own.min(all.len()), all, choices: Arc::default() }
    }

    /// The cloud's own, and behind them the merged ones in their order ([`super::Merging`]).
    pub fn all(&self) -> &[Sprite] {
        &self.all
    }

    /// Whether these are kept where `other` is, as copies are.
    pub fn are(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.all, &other.all)
    }

    /// Of the `count` sprites that cover most with the tiles of `atlas`, or of all if there are fewer, the one that covers
    /// least; of equal ones the first cover most. None of none.
    pub fn least_of(&self, count: usize, atlas: &Atlas) -> Option<Cover> {
        let count = count.min(self.len());
        let last = count.checked_sub(1)?;
        // Nothing in it can be left half done.
        let mut choices = self.choices.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = choices.kept.iter().find(|each| (each.atlas, each.count) == (atlas.version(), count)) {
            return Some(known.least);
        }
        let mut covers: Vec<Cover> = self.iter().zip(0..).map(|(sprite, at)| Cover::of(sprite, at, atlas)).collect();
        let least = *covers.select_nth_unstable_by(last, Cover::most_first).1;
        if choices.kept.len() == KEPT {
            choices.kept.remove(0);
        }
        choices.kept.push(Choice { atlas: atlas.version(), count, least });
        choices.made += 1;
        Some(least)
    }

    /// How often [`Sprites::least_of`] had to be worked out, so that tests can prove that it is kept.
    pub fn choices_made(&self) -> u64 {
        self.choices.lock().unwrap_or_else(PoisonError::into_inner).made
    }
}

impl Cover {
    /// Of a sprite that has the index `at` in its cloud.
    pub fn of(sprite: &Sprite, at: u32, atlas: &Atlas) -> Self {
        Self { area: sprite.width * sprite.height * atlas.mean_opacity(sprite.tile.into()), at }
    }

    /// The order in which sprites are kept: by what they cover, of equal ones the first.
    pub fn most_first(&self, other: &Self) -> Ordering {
        other.area.total_cmp(&self.area).then(self.at.cmp(&other.at))
    }
}

/// The cloud's own.
impl Deref for Sprites {
    type Target = [Sprite];

    fn deref(&self) -> &[Sprite] {
        &self.all[..self.own]
    }
}

/// Without merged ones.
impl FromIterator<Sprite> for Sprites {
    fn from_iter<I: IntoIterator<Item = Sprite>>(sprites: I) -> Self {
        let all: Arc<[Sprite]> = sprites.into_iter().collect();
        let own = all.len();
        Self::with_merged(all, own)
    }
}

/// Whatever was worked out of them.
impl PartialEq for Sprites {
    fn eq(&self, other: &Self) -> bool {
        (self.own, &self.all) == (other.own, &other.all)
    }
}
