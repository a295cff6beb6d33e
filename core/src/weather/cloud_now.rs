//! A cloud at a moment: what of it the clock moves.
//!
//! A placed cloud is at rest. What the clock makes of it, however it does, is said here for the whole cloud: where it has
//! been carried, how it has grown, how far it has formed. Where a sprite is now follows ([`CloudNow::position_now`]);
//! what turns, fades, sorts or bounds sprites goes by that. Their light goes by where they are at rest, so that what moves
//! doesn't flicker (MODEL §9). The twin in WGSL is render/src/pass/sprites/sprites.wgsl.

use super::{Formed, FormingRule};
use crate::sprites::{PlacedCloud, Sprite};
use glam::{DVec3, Vec3};

/// A cloud at one moment.
#[derive(Debug, Clone, Copy)]
pub struct CloudNow<'a> {
    /// The cloud at rest.
    pub placed: &'a PlacedCloud,
    /// How far it has formed.
    pub formed: Formed,
    /// How far it has been carried from where it is placed, metres along the world's axes.
    pub displacement: DVec3,
    /// What heights above its bottom are multiplied with: 1 as it is placed. Sprites keep their size.
    pub growth: f32,
    /// A factor of its sprites' alpha, 0 to 1.
    pub opacity: f32,
}

impl<'a> CloudNow<'a> {
    /// The whole cloud as it is placed.
    pub fn at_rest(placed: &'a PlacedCloud) -> Self {
        Self { placed, formed: Formed::WHOLE, displacement: DVec3::ZERO, growth: 1.0, opacity: 1.0 }
    }

    /// The cloud at `clock_s`, seconds of the scene's clock, where clouds form by that rule.
    pub fn at(placed: &'a PlacedCloud, clock_s: f64, forming: FormingRule) -> Self {
        Self { formed: forming.formed(placed.formation.as_ref(), clock_s), ..Self::at_rest(placed) }
    }

    /// Where its origin is, metres in the world.
    pub fn origin(&self) -> DVec3 {
        self.placed.origin + self.displacement
    }

    /// Where its origin lies from `eye`, metres. The subtraction is in f64, so it is exact far from the world's origin.
    pub fn from_eye(&self, eye: DVec3) -> Vec3 {
        (self.origin() - eye).as_vec3()
    }

    /// Where that sprite's centre is, metres from the cloud's origin.
    pub fn position_now(&self, sprite: &Sprite) -> Vec3 {
        self.point_now(sprite.position)
    }

    /// How far that sprite is from where it is at rest, metres; both count from the cloud's origin.
    pub fn moved(&self, sprite: &Sprite) -> Vec3 {
        self.position_now(sprite) - sprite.position
    }

    /// Where the middle of the sprites' centres is, metres from the cloud's origin.
    pub fn center_now(&self) -> Vec3 {
        self.point_now(self.placed.center)
    }

    /// What no distance between two points of it has grown by more than.
    pub fn stretch(&self) -> f32 {
        self.growth.max(1.0)
    }

    /// Opacity at a distance from its centre, in radii and at rest.
    pub fn opacity_at(&self, radii: f32) -> f32 {
        self.formed.opacity(radii) * self.opacity
    }

    /// Whether there is anything of it.
    pub fn shows(&self) -> bool {
        self.formed.shows() && self.opacity > 0.0
    }

    fn point_now(&self, point: Vec3) -> Vec3 {
        // At rest what is added is zero, and every bit stays.
        Vec3 { y: point.y + (point.y - self.placed.bottom) * (self.growth - 1.0), ..point }
    }
}

/// All of `clouds` at `clock_s`, as [`CloudNow::at`].
pub fn clouds_now(clouds: &[PlacedCloud], clock_s: f64, forming: FormingRule) -> Vec<CloudNow<'_>> {
    clouds.iter().map(|cloud| CloudNow::at(cloud, clock_s, forming)).collect()
}
