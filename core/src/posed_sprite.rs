//! A sprite as one eye sees it at one moment: how it is turned, and the light at its corners.
//!
//! Phases 2 and 3 put together, in one place for all who need the result on the CPU. The renderer takes the sprites of a
//! frame's list ([`crate::frame::Frame::posed`]); exporters take every sprite, in the clouds' order, as a [`Still`] shows it.

use crate::camera::View;
use crate::facing::{Facing, Pose, corners};
use crate::shading::{CornerLight, Through, corner_light, in_shade};
use crate::sprites::{Group, Sprite};
use crate::weather::{CloudNow, Light};
use glam::Vec3;

/// A sprite with its pose and its light.
#[derive(Debug, Clone, Copy)]
pub struct PosedSprite<'a> {
    /// The sprite at rest, where its light is taken.
    pub rest: &'a Sprite,
    /// The sprite as it is now; its position counts from the cloud's origin.
    pub sprite: Sprite,
    /// Its shading group.
    pub group: &'a Group,
    /// How it stands before the eye.
    pub pose: Pose,
    /// The axes of its quad.
    pub facing: Facing,
    /// Its cloud.
    pub cloud: &'a CloudNow<'a>,
    /// How much of it has condensed, 0 to 1.
    condensed: f32,
    light: &'a Light,
    /// What other clouds leave of the directional light.
    shade: f32,
    /// The sun's light that comes through its cloud, if that is lit by it.
    through: Option<Through>,
}

impl<'a> PosedSprite<'a> {
    /// The sprite of `cloud` that has that index, under `light`.
    pub fn new(cloud: &'a CloudNow<'a>, index: usize, pose: Pose, light: &'a Light) -> Self {
        let (rest, sprite) = (&cloud.placed.sprites.all()[index], cloud.sprite_now(index));
        let group = &cloud.groups()[sprite.group as usize];
        let condensed = cloud.condensed(index);
        let shade = cloud.shade_at(sprite.position);
        let through = Through::new(cloud, (index, shade), light, pose.towards);
        Self {
            rest,
            sprite,
            group,
            pose,
            facing: pose.facing(sprite.rotation),
            cloud,
            condensed,
            light,
            shade,
            through,
        }
    }

    /// Its corners, top left first and clockwise, about its centre as that counts from wherever the caller counts.
    pub fn corners(&self, center: Vec3) -> [Vec3; 4] {
        corners(center, self.facing, self.sprite.width, self.sprite.height)
    }

    /// The light on it at `offset` from its centre, as it is now; its alpha is what air and the eye's nearness leave.
    pub fn light_at(&self, offset: Vec3) -> CornerLight {
        let at_rest = self.cloud.at_rest_from(offset);
        let mut lit = corner_light(self.rest.position + at_rest, self.cloud, self.group, self.light);
        lit.directional = in_shade(lit.directional, self.shade);
        if let Some(through) = &self.through {
            through.light(&mut lit, self.cloud.in_model(at_rest) / self.rest.reach(), self.group, self.light);
        }
        lit.ambient.a *= self.pose.fade * self.condensed;
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
}

impl<'a> Still<'a> {
    /// The sprite of `cloud` that has that index.
    pub fn posed(&self, cloud: &'a CloudNow<'a>, index: usize) -> PosedSprite<'a> {
        let now = cloud.sprite_now(index);
        let center = cloud.from_eye(self.view.eye) + now.position;
        PosedSprite::new(cloud, index, Pose::still(center, now.radius(), self.view), self.light)
    }
}
