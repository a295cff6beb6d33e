//! The air inside a cloud: what the sprites around the eye would hide if they could be seen from within.
//!
//! A sprite that the eye enters is locked and fades, and half of all sprites lie behind the eye: from within, a cloud
//! looks thinner than the same way through it does from outside, and downwards the air is clear (MODEL §4). The mend is
//! a veil before everything, as thick as what has faded away: each sprite is taken for a ball of its own optical depth,
//! of which an eye inside has half before it in the mean, whichever way it looks. It comes as the sprite goes, so it is
//! continuous through the cloud's border and as bounded as the fading is.

use super::{Through, corner_light, in_shade};
use crate::camera::View;
use crate::color::{Premultiplied, Rgb};
use crate::draw_list::Hidden;
use crate::facing::{Poses, lock_reach};
use crate::sprites::Atlas;
use crate::weather::{CloudNow, Light};

/// Before the eye, in every direction alike.
pub type Veil = Premultiplied;

/// No single sprite counts as more opaque than this: its optical depth would be infinite.
pub(crate) const MOST_OPAQUE: f32 = 0.995;
/// Of a ball's depth, what lies before an eye inside it.
pub(crate) const BEFORE_THE_EYE: f32 = 0.5;

/// The veil around the eye of `view`, and the sun's share of its colour. `density` scales its optical depth: 0 for none, 1 as dense as the sprites.
pub fn veil(
    (clouds, poses): (&[CloudNow<'_>], &Poses),
    (view, light, atlas, hidden): (&View, &Light, &Atlas, &Hidden),
    density: f32,
) -> (Veil, Rgb) {
    let (mut depth, mut lit, mut sunlit) = (0.0_f32, Rgb::BLACK, Rgb::BLACK);
    if density <= 0.0 {
        return (Veil::CLEAR, Rgb::BLACK);
    }
    for (index, cloud) in clouds.iter().enumerate().filter(|(_, cloud)| !hidden.clouds.contains(&cloud.placed.id)) {
        let eye = (view.eye - cloud.origin()).as_vec3();
        for posed in poses.of_cloud(index) {
            let (rest, sprite) =
                (&cloud.placed.sprites[posed.sprite as usize], cloud.sprite_now(posed.sprite as usize));
            let gone = 1.0 - posed.pose.fade;
            if gone <= 0.0
                || sprite.position.distance(eye) > lock_reach(sprite.radius())
                || hidden.boxes.contains(&sprite.box_id)
            {
                continue;
            }
            let group = &cloud.groups()[sprite.group as usize];
            let at_rest = cloud.at_rest_from(eye - sprite.position);
            let mut corner = corner_light(rest.position + at_rest, cloud, group, light);
            let shade = cloud.shade_at(sprite.position);
            corner.directional = in_shade(corner.directional, shade);
            if let Some(through) = Through::all_around(cloud, (posed.sprite as usize, shade), light) {
                through.light(&mut corner, cloud.in_model(at_rest) / rest.reach(), group, light);
            }
            let color = corner.color();
            let condensed = cloud.condensed(posed.sprite as usize);
            let opacity = (color.a * condensed * atlas.mean_opacity(sprite.tile.into())).min(MOST_OPAQUE);
            let share = -libm::log1pf(-opacity) * BEFORE_THE_EYE * gone;
            depth += share;
            lit = lit + color.rgb * share;
            sunlit = sunlit + corner.directional * share;
        }
    }
    if depth <= 0.0 {
        return (Veil::CLEAR, Rgb::BLACK);
    }
    let a = -libm::expm1f(-depth * density);
    let Rgb { r, g, b } = lit * (a / depth);
    (Veil { r, g, b, a }, sunlit * (a / depth))
}
