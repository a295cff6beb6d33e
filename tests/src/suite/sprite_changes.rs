//! How much a view's sprites change for each metre flown: the figures by which rules of locking are judged.
//!
//! Figures are in units of 1 / lock distance of the sprite that they are of, so that one bound holds for all sizes.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::facing::upright::RELAXING;
use cloudwright_core::facing::{Pose, Poses, lock_distance};
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sprites::{PlacedCloud, Sprite};
use cloudwright_core::view_history::ViewHistory;
use glam::DVec3;

/// Largest changes of any sprite in one step, for each metre flown, times its lock distance.
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
/// Alpha: 6, as core/src/facing/lock.rs derives. Facing, weighted by alpha A ≤ |m|: |dm/|m|| · |m| = |dm| ≤ |s'| |e − n| +
/// s |e'| ≤ 3 · 2 + 1 = 7. Up: it turns as far as the facing, and relaxes by RELAXING times that; a sprite that simply
/// faces the eye from beyond the shell has its up by direction: 1 + tan of 64° = 3 times the turn of at most 1/1.5.
/// Noise of a millimetre: f32 directions are good to 10⁻⁷, by 10⁻³ m and r = 35 m that is 0.004.
pub const CHANGES: SpriteChanges = SpriteChanges { fade: 6.0, facing: 7.0, up: 7.0 * (1.0 + RELAXING) };

impl SpriteChanges {
    /// The largest of the three, as a share of what [`CHANGES`] allows it.
    pub fn share(&self) -> f32 {
        let Self { fade, facing, up } = *self;
        (fade / CHANGES.fade).max(facing / CHANGES.facing).max(up / CHANGES.up)
    }
}

/// What sprites do along `cameras`, a step of 1/60 s each.
pub fn sprite_changes(scene: &Scene, cameras: &[Camera], rules: &Rules) -> SpriteChanges {
    let derived = Derived::new(scene);
    let mut history = ViewHistory::default();
    let mut before: Option<(DVec3, Vec<Pose>)> = None;
    let mut largest = SpriteChanges::default();
    for camera in cameras {
        let view = View::new(camera, 96, 54);
        history.step(rules, &derived, 0.0, &view);
        let now = all_poses(rules, &derived, &view, &history);
        if let Some((eye, then)) = &before {
            let metres = view.eye.distance(*eye) as f32;
            let radii = derived.clouds().iter().flat_map(|cloud| cloud.sprites.iter().map(|sprite| sprite.radius()));
            for ((a, b), radius) in then.iter().zip(&now).zip(radii) {
                let each = |change: f32| change / metres * lock_distance(radius);
                let shown = a.fade.min(b.fade);
                largest.fade = largest.fade.max(each((a.fade - b.fade).abs()));
                largest.facing = largest.facing.max(each(shown * a.towards.distance(b.towards)));
                largest.up = largest.up.max(each(shown * a.up.distance(b.up)));
            }
        }
        before = Some((view.eye, now));
    }
    largest
}

fn all_poses(rules: &Rules, derived: &Derived, view: &View, history: &ViewHistory) -> Vec<Pose> {
    let clouds = derived.clouds_at(0.0, rules.of_weather());
    let poses = Poses::new(&rules.facing, &clouds, derived.shapes(), view, &history.facing);
    let of_cloud = |(index, cloud): (usize, &PlacedCloud)| -> Vec<Pose> {
        let offset = (cloud.origin - view.eye).as_vec3();
        let pose = |(sprite, at): (&Sprite, u32)| {
            poses.of_sprite(index, at).copied().unwrap_or_else(|| Pose::facing_eye(offset + sprite.position, view.up))
        };
        cloud.sprites.iter().zip(0..).map(pose).collect()
    };
    derived.clouds().iter().enumerate().flat_map(of_cloud).collect()
}
