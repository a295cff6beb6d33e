//! A cloud's sprites as they leave, for formats that have them one by one.

use crate::scene::BoxId;
use crate::weather::CloudNow;
use glam::DVec3;

/// A sprite that leaves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LeftSprite {
    /// From where the cloud stands, along the world's axes, metres.
    pub(super) position: DVec3,
    /// Metres.
    pub(super) width: f64,
    /// Metres.
    pub(super) height: f64,
    /// Counter-clockwise as seen, −180 to 180.
    pub(super) rotation_deg: f64,
    /// 0 to 15, row by row.
    pub(super) tile: u8,
    /// Index into the cloud's groups.
    pub(super) group: usize,
    /// Its box.
    pub(super) box_id: BoxId,
    /// Its number within the box.
    pub(super) index: u32,
}

/// Those of a cloud, in their order.
pub(super) fn left_sprites<'a>(cloud: &'a CloudNow<'_>) -> impl Iterator<Item = LeftSprite> + 'a {
    // Near one another far from the world's origin: so nothing is lost to rounding.
    let origin = cloud.placed.origin - cloud.placed.cloud.position;
    (0..cloud.placed.sprites.len()).map(move |at| {
        let sprite = cloud.sprite_now(at);
        let degrees = f64::from(sprite.rotation).to_degrees();
        LeftSprite {
            position: origin + sprite.position.as_dvec3(),
            width: sprite.width.into(),
            height: sprite.height.into(),
            rotation_deg: (degrees + 180.0).rem_euclid(360.0) - 180.0,
            tile: sprite.tile,
            group: sprite.group as usize,
            box_id: sprite.box_id,
            index: sprite.index,
        }
    })
}
