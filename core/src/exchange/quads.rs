//! Sprites as quads, as one camera sees them in the light of one moment.

use super::Note;
use crate::color::Rgba;
use crate::facing::Pose;
use crate::posed_sprite::{PosedSprite, Still};
use crate::weather::{CloudNow, Formed};
use glam::Vec3;

/// A sprite as a quad.
pub(super) struct Quad {
    pub(super) tile: u8,
    /// From the cloud's origin, metres.
    pub(super) center: Vec3,
    /// Top left first, clockwise, from the cloud's origin.
    pub(super) corners: [Vec3; 4],
    /// Linear light as it is exposed, not cut at 1, and straight alpha; in the corners' order.
    pub(super) colors: [[f32; 4]; 4],
}

/// The sprites of a cloud from the farthest to the nearest. Those of one that `forms` as if it were whole: how far it
/// is, its material says.
pub(super) fn quads(cloud: &CloudNow<'_>, forms: bool, still: Still<'_>, exposure: f32) -> Vec<Quad> {
    let whole = CloudNow { formed: Formed::WHOLE, opacity: 1.0, ..cloud.clone() };
    let cloud = if forms { &whole } else { cloud };
    let mut quads: Vec<Quad> = (0..cloud.placed.sprites.len())
        .map(|index| {
            let sprite = cloud.sprite_now(index);
            // Nothing fades before a camera that leaves its place.
            let towards_eye = cloud.from_eye(still.view.eye) + sprite.position;
            let pose = Pose::facing_eye(towards_eye, still.view.up);
            let posed = PosedSprite::new(cloud, index, pose, still.light);
            let colors = posed.corners(Vec3::ZERO).map(|offset| {
                let Rgba { rgb, a } = posed.light_at(offset).color();
                let [r, g, b] = (rgb * exposure).to_array();
                [r, g, b, a]
            });
            Quad { tile: sprite.tile, center: sprite.position, corners: posed.corners(sprite.position), colors }
        })
        .collect();
    let eye = cloud.from_eye(still.view.eye);
    quads.sort_by(|a, b| (b.center + eye).length().total_cmp(&(a.center + eye).length()));
    quads
}

/// How many corners are brighter than a colour can be where 1 is the most.
pub(super) fn too_bright(quads: &[Quad]) -> usize {
    let is_bright = |[r, g, b, _]: &&[f32; 4]| r.max(*g).max(*b) > 1.0;
    quads.iter().flat_map(|quad| &quad.colors).filter(is_bright).count()
}

/// What became of so many corners, if any.
pub(super) fn note_of_cut(corners: usize) -> Option<Note> {
    (corners > 0).then(|| Note::changed(format!("{corners} corners"), "brighter than 1, which is cut"))
}
