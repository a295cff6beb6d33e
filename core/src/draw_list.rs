//! What to draw for one view, in order.
//!
//! Clouds and sprites outside the view are left out; the rest is sorted by the distance of its centre to the eye
//! *point*. That key does not change when the head turns, but it is approximate: quads that face the eye cross one
//! another (the truth, [`crate::raster::truth`], orders each ray's own fragments). Ties go by cloud and sprite index,
//! so the order is total whatever the input. What the artist hid ([`Hidden`]) is left out like what is out of view; it
//! keeps its place in culling, shading and the cloud's height, so hiding changes nothing about what stays.

use crate::camera::View;
use crate::scene::{BoxId, CloudId};
use crate::sprites::PlacedCloud;
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
}

/// The sprites in view, farthest first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DrawList {
    /// Back to front.
    pub sprites: Vec<DrawSprite>,
}

impl DrawList {
    /// Chooses and sorts what `view` sees of `clouds`.
    pub fn new(clouds: &[PlacedCloud], view: &View) -> Self {
        Self::hiding(clouds, view, &Hidden::default())
    }

    /// As [`DrawList::new`], without what is `hidden`.
    pub fn hiding(clouds: &[PlacedCloud], view: &View, hidden: &Hidden) -> Self {
        // Asked once, so that sprites are looked up only while boxes are hidden.
        let some_boxes = !hidden.boxes.is_empty();
        let mut sprites: Vec<DrawSprite> = clouds
            .par_iter()
            .enumerate()
            .flat_map_iter(|(cloud_index, cloud)| {
                let offset = eye_offset(cloud, view);
                let seen = view.sees_sphere(offset + cloud.center, cloud.reach) && !hidden.clouds.contains(&cloud.id);
                let of_cloud: &[_] = if seen { &cloud.sprites } else { &[] };
                of_cloud.iter().enumerate().filter_map(move |(index, sprite)| {
                    let center = offset + sprite.position;
                    let shows = view.sees_sphere(center, sprite.reach())
                        && !(some_boxes && hidden.boxes.contains(&sprite.box_id));
                    shows.then_some(DrawSprite { cloud: cloud_index as u32, sprite: index as u32, center })
                })
            })
            .collect();
        sort_back_to_front(&mut sprites);
        Self { sprites }
    }
}

/// Where a cloud's origin lies from the eye, metres. The subtraction is in f64, so it is exact far from the origin.
pub fn eye_offset(cloud: &PlacedCloud, view: &View) -> Vec3 {
    (cloud.origin - view.eye).as_vec3()
}

/// Sorts `sprites`, which stand in order of cloud and sprite index, farthest first; equally far ones stay in order.
pub fn sort_back_to_front(sprites: &mut Vec<DrawSprite>) {
    let key = |(index, sprite): (usize, &DrawSprite)| (far_first(sprite.center.length_squared()), index as u32);
    let mut order: Vec<(u32, u32)> = sprites.par_iter().enumerate().map(key).collect();
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
        let at = |cloud, sprite, z| DrawSprite { cloud, sprite, center: Vec3::new(0.0, 0.0, z) };
        let mut sprites = vec![at(0, 0, -1.0), at(0, 1, -5.0), at(1, 0, 5.0), at(1, 1, -9.0), at(2, 0, f32::INFINITY)];
        sort_back_to_front(&mut sprites);
        let order: Vec<_> = sprites.iter().map(|s| (s.cloud, s.sprite)).collect();
        assert_eq!(order, [(2, 0), (1, 1), (0, 1), (1, 0), (0, 0)]);
    }
}
