//! Merged sprites in place of those that are too small to tell apart.
//!
//! A cloud's tree ([`Merging`]) is gone down from the one for all: a merged sprite is drawn where those that it stands for are
//! off from it by less than the tolerance, in pixels at the nearest of them, as much as the haze leaves of that; else its
//! parts are. Between four fifths of the tolerance and all of it both are, the one faded out as the other is faded in, so
//! that nothing pops on the way. That goes by where the eye is alone: it has no memory, and doesn't change as the head
//! turns.

use super::{DrawSprite, OfCloud};
use crate::facing::{Pose, Posed};
use crate::sprites::{Merged, Merging};
use std::iter::Peekable;

/// Of the tolerance: what is off by less is drawn as merged sprites alone.
const WHOLE: f32 = 0.8;
/// How many pixels off is as bad as hiding nothing where all should be hidden.
const PX_AN_OPACITY: f32 = 4.0;
/// Of two that are drawn over one another with halves of their alpha, so much more of each lets a fragment that is half
/// clear be as clear as alone.
const OVER: f32 = 0.343;

/// What is drawn of a cloud, in the order of its sprites.
#[derive(Debug, Default)]
pub(super) struct Chosen {
    pub(super) sprites: Vec<DrawSprite>,
    /// Of those that are faded; their sprites name them behind all poses that there are.
    pub(super) poses: Vec<Pose>,
}

/// Of a cloud, so that nothing is off by more than `tolerance_px` pixels. Its `posed` sprites, in order, with the numbers
/// of their poses, of which there are `pose_count` in all clouds.
pub(super) fn choose<'a>(
    of: &OfCloud<'a>,
    tolerance_px: f32,
    posed: impl Iterator<Item = (&'a Posed, u32)>,
    pose_count: u32,
) -> Chosen {
    let mut shares = Vec::new();
    let merging = &*of.now.placed.merging;
    match merging.merged.first() {
        Some(all) => Tree { of, merging, tolerance_px, found: &mut shares }.descend(0, all, 0.0),
        None => shares.extend((0..of.now.placed.sprites.len() as u32).map(|index| (index, 1.0))),
    }
    shares.sort_unstable_by_key(|(index, _)| *index);
    let mut chosen = Chosen::default();
    let mut posed = posed.peekable();
    for (index, share) in shares {
        let own = pose_of(&mut posed, index);
        let Some(drawn) = of.drawn(index, own) else { continue };
        chosen.sprites.push(if share < 1.0 {
            let pose =
                own.map_or_else(|| Pose::facing_eye(drawn.center, of.view.up_at_poles()), |(posed, _)| posed.pose);
            chosen.poses.push(Pose { fade: pose.fade * over(share), ..pose });
            DrawSprite { pose: pose_count + chosen.poses.len() as u32 - 1, ..drawn }
        } else {
            drawn
        });
    }
    chosen
}

fn pose_of<'a>(posed: &mut Peekable<impl Iterator<Item = (&'a Posed, u32)>>, index: u32) -> Option<(&'a Posed, u32)> {
    while posed.next_if(|(posed, _)| posed.sprite < index).is_some() {}
    posed.next_if(|(posed, _)| posed.sprite == index)
}

/// A factor of a fragment's alpha, of a share of it: the two shares of one sum to it in thin air, and to more where it
/// hides most.
fn over(share: f32) -> f32 {
    share * (1.0 + OVER * (1.0 - share))
}

/// The way down a cloud's tree.
struct Tree<'a, 'b> {
    of: &'b OfCloud<'a>,
    merging: &'b Merging,
    tolerance_px: f32,
    /// Indices of sprites with their share.
    found: &'b mut Vec<(u32, f32)>,
}

impl Tree<'_, '_> {
    /// Goes down from the merged sprite of that number, of which as much as `above` is drawn as one that it is a part of.
    fn descend(&mut self, at: u32, merged: &Merged, above: f32) {
        let now = self.of.now;
        let index = now.placed.sprites.len() as u32 + at;
        let sprite = now.sprite_now(index as usize);
        let center = self.of.offset + sprite.position;
        let reach_m = now.length_now(merged.reach_m) + now.air_m();
        // A quad reaches as far as its diagonal.
        let quad_m = std::f32::consts::SQRT_2 * now.largest_now();
        if !self.of.view.sees_sphere(center, (reach_m + quad_m).max(sprite.reach())) {
            return;
        }
        let nearest_m = center.length() - reach_m;
        let off_px = now.length_now(merged.spread_m) / (nearest_m * self.of.view.pixel());
        let opaque = now.opacity_at_height(now.placed.sprites.all()[index as usize].position.y);
        // Several thin ones over one another hide more than one of them.
        let hides = 1.0 - libm::powf(1.0 - opaque, merged.layers.max(1.0)) - opaque;
        let seen_px = (off_px + PX_AN_OPACITY * hides) * libm::expf(-nearest_m / self.of.choice.haze_length_m);
        let share = if nearest_m > 2.0 * quad_m {
            ((self.tolerance_px - seen_px) / ((1.0 - WHOLE) * self.tolerance_px)).clamp(0.0, 1.0)
        } else {
            // Sprites near the eye turn and fade by themselves.
            0.0
        };
        if share > above {
            self.found.push((index, share - above));
        }
        let below = share.max(above);
        if below >= 1.0 {
            return;
        }
        if merged.parts.is_empty() {
            self.found.extend(self.merging.sprites_of(merged).iter().map(|sprite| (*sprite, 1.0 - below)));
        }
        for part in merged.parts.clone() {
            self.descend(part, &self.merging.merged[part as usize], below);
        }
    }
}
