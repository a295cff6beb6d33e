//! What to draw for one view, in order.
//!
//! Clouds and sprites outside the view are left out; the rest is sorted by the distance of its centre to the eye
//! *point*. That key does not change when the head turns, but it is approximate: quads that face the eye cross one
//! another (the truth, [`crate::raster::truth`], orders each ray's own fragments). Ties go by cloud and sprite index,
//! so the order is total whatever the input. What the artist hid ([`Hidden`]) is left out like what is out of view; it
//! keeps its place in culling, shading and the cloud's height, so hiding changes nothing about what stays. Sprites near the
//! eye bring a pose of their own; those that it has faded away, and clouds that have not begun to form, are left out.

mod order;
mod ranks;
mod sorting;

pub use order::{FADE_STEPS, OrderMemory};
pub use ranks::Ranks;
pub use sorting::{LastSort, LazySorting, Sorting};

use crate::camera::View;
use crate::detail::Subset;
use crate::facing::{Pose, Poses};
use crate::scene::{BoxId, CloudId};
use crate::weather::CloudNow;
use glam::Vec3;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// What is not to be drawn, though it is in the scene: the view's affair, never saved.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Hidden {
    /// Whole clouds.
    pub clouds: BTreeSet<CloudId>,
    /// The sprites of these boxes, in every cloud of their model.
    pub boxes: BTreeSet<BoxId>,
    /// The haze before everything.
    pub haze: bool,
    /// The ground.
    pub ground: bool,
}

/// A sprite to draw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawSprite {
    /// Index of its cloud.
    pub cloud: u32,
    /// Index of the sprite within its cloud.
    pub sprite: u32,
    /// Its centre relative to the eye, metres, world axes.
    pub center: Vec3,
    /// Index of its pose in the list's, or [`FACES_EYE`].
    pub pose: u32,
}

/// In place of an index: the sprite simply faces the eye and is not faded.
pub const FACES_EYE: u32 = u32::MAX;

/// What is drawn for one view, farthest first, in runs.
///
/// Who draws goes by the runs. Measures and the truth go by the sprites alone ([`DrawList::sprites_alone`]), whatever
/// stands among them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DrawList {
    /// Those of all runs, back to front.
    pub sprites: Vec<DrawSprite>,
    /// Of those that don't simply face the eye.
    pub poses: Vec<Pose>,
    /// Back to front.
    pub runs: Vec<Run>,
}

/// A part of a list that is drawn, and faded, by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Run {
    /// The list's sprites from that index to where the next run of sprites begins.
    Sprites {
        /// The first.
        from: usize,
        /// A factor of their alpha, 0 to 1.
        fade: f32,
    },
}

/// What a list is chosen from.
#[derive(Debug, Clone, Copy)]
pub struct Choice<'a> {
    /// All clouds.
    pub clouds: &'a [CloudNow<'a>],
    /// The sprites near the eye.
    pub poses: &'a Poses,
    /// The sprites that are drawn by the detail asked for.
    pub subset: &'a Subset<'a>,
    /// What is not to be drawn.
    pub hidden: &'a Hidden,
}

/// A list's sprites by themselves, in its order: nothing that stands in for any, and no run's fade.
#[derive(Debug, Clone, Copy)]
pub struct SpritesAlone<'a>(&'a [DrawSprite]);

impl<'a> SpritesAlone<'a> {
    /// Back to front.
    pub fn in_order(self) -> &'a [DrawSprite] {
        self.0
    }
}

impl DrawList {
    /// What the truth takes.
    pub fn sprites_alone(&self) -> SpritesAlone<'_> {
        SpritesAlone(&self.sprites)
    }

    /// Of sprites alone, back to front, in one run.
    pub fn of_sprites(sprites: Vec<DrawSprite>, poses: Vec<Pose>) -> Self {
        Self { sprites, poses, runs: vec![Run::Sprites { from: 0, fade: 1.0 }] }
    }

    /// The runs of sprites, back to front, each with its fade.
    pub fn sprite_runs(&self) -> impl Iterator<Item = (&[DrawSprite], f32)> {
        let begin = |Run::Sprites { from, fade }: &Run| (*from, *fade);
        let ends = self.runs.iter().skip(1).map(begin).map(|(from, _)| from).chain([self.sprites.len()]);
        let runs = self.runs.iter().map(begin).zip(ends);
        runs.map(|((from, fade), end)| (self.sprites.get(from..end).unwrap_or_default(), fade))
    }

    /// Chooses what `view` sees, and sorts it: by `order`, or by distance now.
    pub fn new(choice: &Choice<'_>, view: &View, order: Option<&Ranks>) -> Self {
        let mut list = Self::unsorted(choice, view);
        match order {
            None => sort_back_to_front(&mut list.sprites),
            Some(ranks) => sort_by_key(&mut list.sprites, |drawn| ranks.of(drawn.cloud, drawn.sprite)),
        }
        list
    }

    fn unsorted(choice: &Choice<'_>, view: &View) -> Self {
        let Choice { clouds, poses, subset, hidden } = choice;
        // Asked once, so that sprites are looked up only while boxes are hidden.
        let some_boxes = !hidden.boxes.is_empty();
        let first_pose: Vec<u32> = (0..clouds.len())
            .scan(0, |count, cloud| {
                let first = *count;
                *count += poses.of_cloud(cloud).len() as u32;
                Some(first)
            })
            .collect();
        let sprites = clouds.par_iter().enumerate().flat_map_iter(|(cloud_index, cloud)| {
            let placed = cloud.placed;
            let offset = cloud.from_eye(view.eye);
            let seen = view.sees_sphere(offset + cloud.center_now(), cloud.reach_now())
                && !hidden.clouds.contains(&placed.id)
                && cloud.shows();
            let of_cloud: &[_] = if seen { &placed.sprites } else { &[] };
            let mut posed = poses.of_cloud(cloud_index).iter().zip(first_pose[cloud_index]..).peekable();
            of_cloud.iter().zip(0..).filter_map(move |(sprite, index)| {
                let pose = posed.next_if(|(posed, _)| posed.sprite == index);
                let now = cloud.sprite_now(index as usize);
                let center = offset + now.position;
                let shows = view.sees_sphere(center, now.reach())
                    && cloud.condensed(index as usize) > 0.0
                    && pose.is_none_or(|(posed, _)| posed.pose.fade > 0.0)
                    && !(some_boxes && hidden.boxes.contains(&sprite.box_id))
                    && subset.has(cloud_index, sprite, index);
                let pose = pose.map_or(FACES_EYE, |(_, pose)| pose);
                shows.then_some(DrawSprite { cloud: cloud_index as u32, sprite: index, center, pose })
            })
        });
        let poses = (0..clouds.len()).flat_map(|cloud| poses.of_cloud(cloud)).map(|posed| posed.pose).collect();
        Self::of_sprites(sprites.collect(), poses)
    }

    /// Every sprite there is, wherever `view` looks.
    pub(crate) fn of_all(clouds: &[CloudNow<'_>], view: &View) -> Self {
        let all = clouds.iter().zip(0..).flat_map(|(cloud, cloud_index)| {
            let offset = cloud.from_eye(view.eye);
            (0..cloud.placed.sprites.len() as u32).map(move |index| {
                let center = offset + cloud.sprite_now(index as usize).position;
                DrawSprite { cloud: cloud_index, sprite: index, center, pose: FACES_EYE }
            })
        });
        let mut sprites = all.collect();
        sort_back_to_front(&mut sprites);
        Self::of_sprites(sprites, Vec::new())
    }

    /// How a sprite of the list stands before the eye of `view`, which the list was made for.
    pub fn pose(&self, drawn: &DrawSprite, view: &View) -> Pose {
        let own = self.poses.get(drawn.pose as usize).copied();
        own.unwrap_or_else(|| Pose::facing_eye(drawn.center, view.up_at_poles()))
    }
}

/// Sorts `sprites`, which stand in order of cloud and sprite index, farthest first; equally far ones stay in order.
pub fn sort_back_to_front(sprites: &mut Vec<DrawSprite>) {
    sort_by_key(sprites, |drawn| far_first(drawn.center.length_squared()));
}

/// Equal keys stay in order.
fn sort_by_key(sprites: &mut Vec<DrawSprite>, key: impl Fn(&DrawSprite) -> u32 + Sync) {
    let mut order: Vec<(u32, u32)> =
        sprites.par_iter().enumerate().map(|(index, drawn)| (key(drawn), index as u32)).collect();
    // A radix sort keeps equal keys in order.
    radsort::sort_by_key(&mut order, |(key, _)| *key);
    *sprites = order.into_par_iter().map(|(_, index)| sprites[index as usize]).collect();
}

/// Rises as the distance falls. The bits of non-negative floats are ordered as the floats are, infinity and NaN beyond.
fn far_first(distance_squared: f32) -> u32 {
    !distance_squared.to_bits()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn far_first_then_by_index() {
        let at = |cloud, sprite, z| DrawSprite { cloud, sprite, center: Vec3::new(0.0, 0.0, z), pose: FACES_EYE };
        let mut sprites = vec![at(0, 0, -1.0), at(0, 1, -5.0), at(1, 0, 5.0), at(1, 1, -9.0), at(2, 0, f32::INFINITY)];
        sort_back_to_front(&mut sprites);
        let order: Vec<_> = sprites.iter().map(|s| (s.cloud, s.sprite)).collect();
        assert_eq!(order, [(2, 0), (1, 1), (0, 1), (1, 0), (0, 0)]);
    }
}
