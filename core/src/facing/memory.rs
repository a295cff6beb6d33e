//! Where an eye has been, as far as sprites must know: the direction in which each was last faced from beyond the shell
//! around the eye, and the up that it carries.
//!
//! Only sprites that are near the eye, or near straight above or below it, or not yet relaxed, are remembered; all else
//! follows from the eye's place alone. A cloud out of reach of both costs two comparisons, and nothing for each sprite.
//! Steps are made in order by whoever flies; what a view shows between two steps is one more step that is thrown away.

use super::lock::{Locked, lock_distance, lock_reach};
use super::rule::FacingRule;
use super::{Pose, upright};
use crate::camera::View;
use crate::math::unit_or;
use crate::sprites::{Known, Shapes};
use crate::weather::CloudNow;
use glam::{DVec3, Vec3};
use rustc_hash::FxHashMap;

/// What one view remembers of the sprites around it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FacingMemory {
    /// At the last step.
    eye: Option<DVec3>,
    /// Of the clouds at the last step.
    shapes: Option<Shapes>,
    /// By the cloud's index then; sprites in order of theirs.
    clouds: FxHashMap<u32, Vec<Remembered>>,
}

/// One sprite's history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Remembered {
    pub(super) sprite: u32,
    /// To the eye when that was last beyond the shell, unit.
    pub(super) faced: Vec3,
    pub(super) pose: Pose,
}

impl FacingMemory {
    /// Goes on to `eye` by `rule`, through `clouds`, whose `shapes` are. Nothing is remembered at the first step, and of a
    /// cloud that is new or has other sprites than at the last: those near the eye face it, upright by `camera_up`.
    pub fn step(&mut self, rule: &FacingRule, clouds: &[CloudNow<'_>], shapes: &Shapes, eye: DVec3, camera_up: Vec3) {
        let all_known = self.known_in(shapes);
        let mut next: FxHashMap<u32, Vec<Remembered>> = FxHashMap::default();
        for (index, cloud) in (0..).zip(clouds) {
            let known = all_known.index(index);
            let before = self.of_cloud(known);
            let to_eye = ToEye::new(cloud, eye, self.eye.filter(|_| known.is_some()), 0.0);
            if before.is_empty() && !to_eye.is_near(cloud) && !to_eye.is_polar(cloud) {
                continue;
            }
            let mut remembered = Vec::with_capacity(before.len());
            to_eye.each(cloud, before, rule, (true, camera_up), |sprite, keeps| {
                if keeps {
                    remembered.push(sprite);
                }
            });
            if !remembered.is_empty() {
                next.insert(index, remembered);
            }
        }
        (self.clouds, self.shapes, self.eye) = (next, Some(shapes.clone()), Some(eye));
    }

    /// What the cloud that had that index at the last step is remembered for.
    fn of_cloud(&self, index: Option<u32>) -> &[Remembered] {
        index.and_then(|index| self.clouds.get(&index)).map_or(&[], Vec::as_slice)
    }

    /// How many sprites are remembered.
    pub fn sprite_count(&self) -> usize {
        self.clouds.values().map(Vec::len).sum()
    }

    /// Every sprite of a cloud whose pose is not that of a far one in a still, as `view` sees it now; sprites nearer
    /// than `nearest` metres among them. `known`: the cloud's index at the last step, if it is remembered.
    pub(super) fn poses_of(
        &self,
        rule: &FacingRule,
        (known, cloud): (Option<u32>, &CloudNow<'_>),
        view: &View,
        nearest: f32,
        mut found: impl FnMut(u32, Pose),
    ) {
        let before = self.of_cloud(known);
        let last = self.eye.filter(|_| known.is_some());
        let to_eye = ToEye::new(cloud, view.eye, last, nearest);
        // Without a history the poles are the still's affair.
        let polar_too = last.is_some();
        if !before.is_empty() || to_eye.is_near(cloud) || (polar_too && to_eye.is_polar(cloud)) {
            to_eye.each(cloud, before, rule, (polar_too, view.up_at_poles()), |sprite, _| {
                found(sprite.sprite, sprite.pose);
            });
        }
    }

    /// Which of the clouds of `shapes` it remembers.
    pub(super) fn known_in(&self, shapes: &Shapes) -> Known {
        shapes.known_from(self.shapes.as_ref())
    }
}

/// From a cloud's origin to the eye, now and at the last step; metres.
struct ToEye {
    now: Vec3,
    before: Vec3,
    /// Sprites nearer than this are near, whatever their size.
    nearest: f32,
}

impl ToEye {
    /// An eye that has not been anywhere was where it is.
    fn new(cloud: &CloudNow<'_>, eye: DVec3, before: Option<DVec3>, nearest: f32) -> Self {
        let origin = cloud.origin();
        let now = (eye - origin).as_vec3();
        Self { now, before: before.map_or(now, |before| (before - origin).as_vec3()), nearest }
    }

    /// Whether some sprite may be within its shell.
    fn is_near(&self, cloud: &CloudNow<'_>) -> bool {
        let reach = cloud.radius_now() + lock_reach(cloud.largest_now());
        (self.now - cloud.center_now()).length() < reach + self.nearest
    }

    /// Whether some sprite may be near straight above or below the eye: the cone around the pole, widened by the sphere
    /// that holds the centres.
    fn is_polar(&self, cloud: &CloudNow<'_>) -> bool {
        let (center, radius) = (self.now - cloud.center_now(), cloud.radius_now());
        let across = glam::Vec2::new(center.x, center.z).length();
        across - radius < POLAR_TANGENT * (center.y.abs() + radius)
    }

    /// Steps each sprite that is remembered or has to be; `keeps` tells whether it needs to be remembered further.
    fn each(
        &self,
        cloud: &CloudNow<'_>,
        before: &[Remembered],
        rule: &FacingRule,
        (polar_too, camera_up): (bool, Vec3),
        mut found: impl FnMut(Remembered, bool),
    ) {
        let mut before = before.iter().peekable();
        for index in 0..cloud.placed.sprites.len() as u32 {
            let sprite = cloud.sprite_now(index as usize);
            let remembered = before.next_if(|remembered| remembered.sprite == index);
            let position = sprite.position;
            let to_eye = self.now - position;
            let distance_squared = to_eye.length_squared();
            let shell = rule.reach * lock_distance(sprite.radius());
            let within = |distance: f32| distance_squared < distance * distance;
            // sin² of the elevation, without the root.
            let polar = to_eye.y * to_eye.y > upright::POLE[0] * upright::POLE[0] * distance_squared;
            let turns = within(shell.max(self.nearest)) || (polar && polar_too);
            if !turns && remembered.is_none() {
                continue;
            }
            let past = remembered.copied().unwrap_or_else(|| self.past(position, index, camera_up));
            let faced = if within(shell) { past.faced } else { unit_or(to_eye, past.faced) };
            let Locked { towards, fade } = (rule.turn)(to_eye, faced, lock_distance(sprite.radius()));
            let up = upright::carry(past.pose.up, past.pose.towards, towards);
            let keeps = within(shell) || polar || up != upright::world(towards, up);
            found(Remembered { sprite: index, faced, pose: Pose { towards, up, fade } }, keeps);
        }
    }

    /// What there would be to remember of a sprite that was far from the eye at the last step.
    fn past(&self, position: Vec3, index: u32, camera_up: Vec3) -> Remembered {
        let pose = Pose::facing_eye(position - self.before, camera_up);
        Remembered { sprite: index, faced: pose.towards, pose }
    }
}

/// Of the angle from the pole at which [`upright::POLE`] begins: √(1 − 0.9²) / 0.9.
const POLAR_TANGENT: f32 = 0.484_322_1;
