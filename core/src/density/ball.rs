//! Sprites as balls: ellipsoids about the vertical.

use super::{Vapour, profile};
use crate::facing::Pose;
use crate::posed_sprite::PosedSprite;
use crate::weather::{CloudNow, Light};
use glam::Vec3;

/// A sprite as a ball.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ball {
    /// Metres from wherever it is counted.
    pub(super) center: Vec3,
    /// Half of what it measures along x, y and z, metres.
    pub(super) half: Vec3,
    pub(super) tile: u8,
    /// A factor of its tile's opacity, 0 to 1.
    pub(super) opacity: f32,
}

impl Ball {
    /// How far from its middle it reaches along the axes, metres.
    pub(super) fn reach(&self) -> Vec3 {
        self.half * profile::REACH
    }
}

/// Those that show, in the order of the clouds and their sprites; they count from where the first cloud has its origin.
pub(super) fn of_clouds(vapour: &Vapour<'_>) -> Vec<Ball> {
    let origin = vapour.origin();
    vapour.clouds.iter().flat_map(|cloud| of_cloud(cloud, vapour.light, (cloud.origin() - origin).as_vec3())).collect()
}

fn of_cloud<'a>(cloud: &'a CloudNow<'_>, light: &'a Light, from_origin: Vec3) -> impl Iterator<Item = Ball> + 'a {
    let ball = move |index: usize| {
        let posed = PosedSprite::new(cloud, index, Pose::facing_eye(Vec3::NEG_Z, Vec3::Y), light);
        let sprite = posed.sprite;
        // What a quad that is turned before an eye on its level measures across, if it were an ellipse.
        let (sin, cos) = (libm::sinf(sprite.rotation), libm::cosf(sprite.rotation));
        let across = |a: f32, b: f32| 0.5 * (a * a + b * b).sqrt();
        let level = across(sprite.width * cos, sprite.height * sin);
        let up = across(sprite.width * sin, sprite.height * cos);
        Ball {
            center: from_origin + sprite.position,
            half: Vec3::new(level, up, level),
            tile: sprite.tile,
            opacity: posed.light_at(Vec3::ZERO).ambient.a,
        }
    };
    let shows = |ball: &Ball| ball.opacity > 0.0 && ball.half.min_element() > 0.0 && ball.reach().is_finite();
    (0..cloud.placed.sprites.len()).map(ball).filter(move |ball| shows(ball) && ball.center.is_finite())
}
