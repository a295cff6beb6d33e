//! The poses of all sprites that don't simply face a far eye, in one view at one moment.

use super::lock::{near_fade, near_reach};
use super::{FacingMemory, FacingRule, Pose};
use crate::camera::View;
use crate::sprites::Shapes;
use crate::weather::CloudNow;
use rayon::prelude::*;

/// A sprite's pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Posed {
    /// Index of the sprite within its cloud.
    pub sprite: u32,
    /// How it stands.
    pub pose: Pose,
}

/// Of each cloud, in order of the sprites' indices.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Poses {
    clouds: Vec<Vec<Posed>>,
}

impl Poses {
    /// Those that `view` sees by `rule` of `clouds`, whose `shapes` are; by that rule its `memory` has stepped. What is near
    /// the eye but was never seen from afar faces the eye.
    pub fn new(
        rule: &FacingRule,
        clouds: &[CloudNow<'_>],
        shapes: &Shapes,
        view: &View,
        memory: &FacingMemory,
    ) -> Self {
        if rule.across_view {
            return Self { clouds: clouds.iter().map(|cloud| in_view_plane(cloud, view)).collect() };
        }
        let reach = near_reach(view);
        let known = memory.known_in(shapes);
        let of_cloud = |(index, cloud): (usize, &CloudNow<'_>)| {
            let mut posed = Vec::new();
            memory.poses_of(rule, (known.index(index as u32), cloud), view, 2.0 * reach, |sprite, mut pose| {
                let to_eye = (view.eye - cloud.origin()).as_vec3() - cloud.sprite_now(sprite as usize).position;
                pose.fade *= near_fade(pose.towards.dot(to_eye), reach);
                posed.push(Posed { sprite, pose });
            });
            posed
        };
        Self { clouds: clouds.par_iter().enumerate().with_min_len(16).map(of_cloud).collect() }
    }

    /// Drops those for which `keeps` is false, asked for a cloud's index and a sprite's.
    pub fn retain(&mut self, keeps: impl Fn(usize, u32) -> bool) {
        for (index, posed) in self.clouds.iter_mut().enumerate() {
            posed.retain(|posed| keeps(index, posed.sprite));
        }
    }

    /// Those of the cloud of that index.
    pub fn of_cloud(&self, cloud: usize) -> &[Posed] {
        self.clouds.get(cloud).map_or(&[], Vec::as_slice)
    }

    /// The pose of one sprite, if it has one of its own.
    pub fn of_sprite(&self, cloud: usize, sprite: u32) -> Option<&Pose> {
        let posed = self.of_cloud(cloud);
        posed.binary_search_by_key(&sprite, |posed| posed.sprite).ok().map(|at| &posed[at].pose)
    }
}

/// Every sprite across the view direction.
fn in_view_plane(cloud: &CloudNow<'_>, view: &View) -> Vec<Posed> {
    let pose = Pose { towards: -view.forward, up: view.up, fade: 1.0 };
    (0..cloud.placed.sprites.len() as u32).map(|sprite| Posed { sprite, pose }).collect()
}
