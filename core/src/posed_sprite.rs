//! A sprite as one eye sees it at one moment: how it is turned, and the light at its corners.
//!
//! Phases 2 and 3 put together, in one place for all who need the result on the CPU. The renderer takes the sprites of a
//! frame's list ([`crate::frame::Frame::posed`]); exporters take every sprite, in the clouds' order, as a [`Still`] shows it.

use crate::camera::View;
use crate::facing::{Facing, Pose, corners};
use crate::shading::{CornerLight, corner_light};
use crate::sprites::{Group, PlacedCloud, Sprite};
use crate::weather::{CloudNow, FormingRule, Light};
use glam::Vec3;

/// A sprite with its pose and its light.
#[derive(Debug, Clone, Copy)]
pub struct PosedSprite<'a> {
    /// The sprite itself.
    pub sprite: &'a Sprite,
    /// Its shading group.
    pub group: &'a Group,
    /// How it stands before the eye.
    pub pose: Pose,
    /// The axes of its quad.
    pub facing: Facing,
    /// Its cloud.
    pub cloud: CloudNow<'a>,
    light: &'a Light,
}

impl<'a> PosedSprite<'a> {
    /// A sprite of `cloud`, under `light`.
    pub fn new(cloud: CloudNow<'a>, sprite: &'a Sprite, pose: Pose, light: &'a Light) -> Self {
        let group = &cloud.placed.groups[sprite.group as usize];
        Self { sprite, group, pose, facing: pose.facing(sprite.rotation), cloud, light }
    }

    /// Its corners, top left first and clockwise, about its centre as that counts from wherever the caller counts.
    pub fn corners(&self, center: Vec3) -> [Vec3; 4] {
        corners(center, self.facing, self.sprite.width, self.sprite.height)
    }

    /// The light on it at `point`, which counts from the cloud's origin with the sprite at rest; its alpha is what the
    /// eye's nearness leaves.
    pub fn light_at(&self, point: Vec3) -> CornerLight {
        let mut lit = corner_light(point, &self.cloud, self.group, self.light);
        lit.ambient.a *= self.pose.fade;
        lit
    }
}

/// How a still shows sprites: all of them, at any distance and in any direction.
#[derive(Debug, Clone, Copy)]
pub struct Still<'a> {
    /// Which eye they face.
    pub view: &'a View,
    /// The light on them.
    pub light: &'a Light,
    /// Seconds of the scene's clock: how far clouds have formed.
    pub clock_s: f64,
}

impl<'a> Still<'a> {
    /// A sprite of `cloud`.
    pub fn posed(&self, cloud: &'a PlacedCloud, sprite: &'a Sprite) -> PosedSprite<'a> {
        let cloud = CloudNow::at(cloud, self.clock_s, FormingRule::ClosedForm);
        let center = cloud.from_eye(self.view.eye) + cloud.position_now(sprite);
        PosedSprite::new(cloud, sprite, Pose::still(center, sprite.radius(), self.view), self.light)
    }
}
