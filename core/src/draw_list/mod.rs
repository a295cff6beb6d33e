//! What to draw for one view, in order.
//!
//! Clouds and sprites outside the view are left out; the rest is sorted by the distance of its centre to the eye
//! *point*. That key does not change when the head turns, but it is approximate: quads that face the eye cross one
//! another (the truth, [`crate::raster::truth`], orders each ray's own fragments). Ties go by cloud and sprite index,
//! so the order is total whatever the input. What the artist hid ([`Hidden`]) is left out like what is out of view; it
//! keeps its place in culling, shading and the cloud's height, so hiding changes nothing about what stays. Sprites near the
//! eye bring a pose of their own; those that it has faded away, and clouds that have not begun to form, are left out.

mod merged;
mod order;
mod ranks;
mod sorting;

pub use order::{FADE_STEPS, OrderMemory};
pub use ranks::Ranks;
pub use sorting::{LastSort, LazySorting, Sorting};

use crate::camera::View;
use crate::detail::Subset;
use crate::facing::{Pose, Posed, Poses};
use crate::scene::{BoxId, CloudId};
use crate::weather::CloudNow;
use glam::Vec3;
use merged::Chosen;
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
    /// Metres over which haze takes all but 1/e of what can be told apart.
    pub haze_length_m: f32,
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
        // In an older order merged sprites have no place.
        let tolerance_px = if order.is_none() { choice.subset.detail().tolerance_px } else { 0.0 };
        let mut list = Self::unsorted(choice, view, tolerance_px);
        match order {
            None => sort_back_to_front(&mut list.sprites),
            Some(ranks) => sort_by_key(&mut list.sprites, |drawn| ranks.of(drawn.cloud, drawn.sprite)),
        }
        list
    }

    fn unsorted(choice: &Choice<'_>, view: &View, tolerance_px: f32) -> Self {
        let Choice { clouds, poses, hidden, .. } = *choice;
        // Asked once, so that sprites are looked up only while boxes are hidden.
        let some_boxes = !hidden.boxes.is_empty();
        let first_pose: Vec<u32> = (0..clouds.len())
            .scan(0, |count, cloud| {
                let first = *count;
                *count += poses.of_cloud(cloud).len() as u32;
                Some(first)
            })
            .collect();
        let of_cloud = |(index, now)| OfCloud::new(index, now, choice, view, some_boxes);
        let posed_of = |index: usize| poses.of_cloud(index).iter().zip(first_pose[index]..);
        let mut all_poses: Vec<Pose> =
            (0..clouds.len()).flat_map(|cloud| poses.of_cloud(cloud)).map(|posed| posed.pose).collect();
        // A merged sprite is of several boxes and covers what none of its parts does.
        if tolerance_px > 0.0 && !some_boxes && choice.subset.is_all() {
            let pose_count = all_poses.len() as u32;
            let choose = |of: OfCloud<'_>| {
                if of.is_seen() {
                    merged::choose(&of, tolerance_px, posed_of(of.index), pose_count)
                } else {
                    Chosen::default()
                }
            };
            let chosen: Vec<Chosen> =
                clouds.par_iter().enumerate().with_min_len(16).map(of_cloud).map(choose).collect();
            let mut sprites = Vec::with_capacity(chosen.iter().map(|chosen| chosen.sprites.len()).sum());
            for Chosen { sprites: of_cloud, poses } in chosen {
                let before = all_poses.len() as u32 - pose_count;
                sprites.extend(of_cloud.into_iter().map(|drawn| match drawn.pose {
                    FACES_EYE => drawn,
                    own if own < pose_count => drawn,
                    faded => DrawSprite { pose: faded + before, ..drawn },
                }));
                all_poses.extend(poses);
            }
            return Self::of_sprites(sprites, all_poses);
        }
        let sprites = clouds.par_iter().enumerate().map(of_cloud).flat_map_iter(|of| {
            let mut posed = posed_of(of.index).peekable();
            let count = if of.is_seen() { of.now.placed.sprites.len() as u32 } else { 0 };
            (0..count).filter_map(move |index| of.drawn(index, posed.next_if(|(posed, _)| posed.sprite == index)))
        });
        Self::of_sprites(sprites.collect(), all_poses)
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

/// A cloud whose sprites are chosen from.
struct OfCloud<'a> {
    index: usize,
    now: &'a CloudNow<'a>,
    /// From the eye to its origin, metres.
    offset: Vec3,
    choice: &'a Choice<'a>,
    view: &'a View,
    /// Whether any box is hidden.
    some_boxes: bool,
}

impl<'a> OfCloud<'a> {
    fn new(index: usize, now: &'a CloudNow<'a>, choice: &'a Choice<'a>, view: &'a View, some_boxes: bool) -> Self {
        Self { index, now, offset: now.from_eye(view.eye), choice, view, some_boxes }
    }

    /// Whether anything of it may be.
    fn is_seen(&self) -> bool {
        self.view.sees_sphere(self.offset + self.now.center_now(), self.now.reach_now())
            && !self.choice.hidden.clouds.contains(&self.now.placed.id)
            && self.now.shows()
    }

    /// The sprite of that index, which may be a merged one's, and which has that pose of its own; none if it doesn't show.
    fn drawn(&self, index: u32, posed: Option<(&Posed, u32)>) -> Option<DrawSprite> {
        let Choice { subset, hidden, .. } = self.choice;
        let now = self.now.sprite_now(index as usize);
        let center = self.offset + now.position;
        let shows = self.view.sees_sphere(center, now.reach())
            && self.now.condensed(index as usize) > 0.0
            && posed.is_none_or(|(posed, _)| posed.pose.fade > 0.0)
            && !(self.some_boxes && hidden.boxes.contains(&now.box_id))
            && subset.has(self.index, &now, index);
        let pose = posed.map_or(FACES_EYE, |(_, pose)| pose);
        shows.then_some(DrawSprite { cloud: self.index as u32, sprite: index, center, pose })
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
