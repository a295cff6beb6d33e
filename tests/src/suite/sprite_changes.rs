//! How much a view's sprites change for each metre that they and the eye pass one another: the figures by which rules of locking are judged.
//!
//! Figures are in units of 1 / lock distance of the sprite that they are of, so that one bound holds for all sizes.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::facing::upright::RELAXING;
use cloudwright_core::facing::{Pose, Poses, lock_distance};
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::view_history::ViewHistory;
use cloudwright_core::weather::CloudNow;
use glam::DVec3;

/// Largest changes of any sprite in one step, for each metre that it and the eye pass one another, times its lock distance.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpriteChanges {
    /// Of its alpha's factor.
    pub fade: f32,
    /// Of what it faces, as a chord, weighted by how much of it shows.
    pub facing: f32,
    /// Of its up, likewise.
    pub up: f32,
}

/// What the shipped rule keeps. Steps of a flight change by less than their steepest place does.
///
/// Alpha: 3.2, as core/src/facing/lock.rs derives. Facing, weighted by alpha A ≤ |m|: |dm/|m|| · |m| = |dm| ≤ |s'| |e − n| +
/// s |e'| ≤ 1.5 · 2 + 1 = 4. Up: it turns as far as the facing, and relaxes by RELAXING times that; a sprite that simply
/// faces the eye from beyond the shell has its up by direction: 1 + tan of 64° = 3 times the turn of at most 1/2.
/// Noise of a millimetre: f32 directions are good to 10⁻⁷, by 10⁻³ m and r = 35 m that is 0.004.
pub const CHANGES: SpriteChanges = SpriteChanges { fade: 3.2, facing: 4.0, up: 4.0 * (1.0 + RELAXING) };

impl SpriteChanges {
    /// The largest of the three, as a share of what [`CHANGES`] allows it.
    pub fn share(&self) -> f32 {
        let Self { fade, facing, up } = *self;
        (fade / CHANGES.fade).max(facing / CHANGES.facing).max(up / CHANGES.up)
    }
}

/// What sprites do as `looks` see them, a step of 1/60 s each: from where, and at which second of the scene's clock.
pub fn sprite_changes(scene: &Scene, looks: &[(Camera, f64)], rules: &Rules) -> SpriteChanges {
    let derived = Derived::new(scene);
    let mut history = ViewHistory::default();
    let mut before: Option<Vec<(DVec3, Pose)>> = None;
    let mut largest = SpriteChanges::default();
    for (camera, clock_s) in looks {
        let view = View::new(camera, 96, 54);
        history.step(rules, &derived, *clock_s, &view);
        let now = all_poses(rules, &derived, *clock_s, &view, &history);
        if let Some(then) = &before {
            let radii = derived.clouds().iter().flat_map(|cloud| cloud.sprites.iter().map(|sprite| sprite.radius()));
            for (((was, a), (is, b)), radius) in then.iter().zip(&now).zip(radii) {
                let metres = was.distance(*is) as f32;
                let each = |change: f32| change / metres * lock_distance(radius);
                let shown = a.fade.min(b.fade);
                largest.fade = largest.fade.max(each((a.fade - b.fade).abs()));
                largest.facing = largest.facing.max(each(shown * a.towards.distance(b.towards)));
                largest.up = largest.up.max(each(shown * a.up.distance(b.up)));
            }
        }
        before = Some(now);
    }
    largest
}

/// Of each sprite, where it is from the eye, metres, and its pose.
fn all_poses(rules: &Rules, derived: &Derived, clock_s: f64, view: &View, history: &ViewHistory) -> Vec<(DVec3, Pose)> {
    let clouds = derived.clouds_at(clock_s, rules.of_weather());
    let poses = Poses::new(&rules.facing, &clouds, derived.shapes(), view, &history.facing);
    let of_cloud = |(index, cloud): (usize, &CloudNow<'_>)| -> Vec<(DVec3, Pose)> {
        let offset = cloud.origin() - view.eye;
        let pose = |at: u32| {
            let center = offset + cloud.sprite_now(at as usize).position.as_dvec3();
            let own = poses.of_sprite(index, at).copied();
            (center, own.unwrap_or_else(|| Pose::facing_eye(center.as_vec3(), view.up)))
        };
        (0..cloud.placed.sprites.len() as u32).map(pose).collect()
    };
    clouds.iter().enumerate().flat_map(of_cloud).collect()
}
