//! The sun's light that comes through a cloud to a sprite: self-shadow and halo (MODEL §10, W's future work).
//!
//! What a group's side takes of the sun (W) gives way to what the cloud lets through, by the artist's share. The two
//! exponentials were fitted to a path tracer's pictures: the slow one stands for light that has been scattered many times,
//! the fast one for what comes straight. The twin in WGSL is render/src/pass/sprites/sprites.wgsl.

use super::CornerLight;
use crate::baked::Left;
use crate::color::Rgb;
use crate::sprites::{Group, SoftLight};
use crate::weather::{CloudNow, Light};
use glam::Vec3;

/// Of the light that has been scattered, e^(−.1 τ), and of the straight one, e^(−.8 τ).
pub(crate) const SCATTERED: f32 = 0.85;
pub(crate) const STRAIGHT: f32 = 0.25;
/// What of the sky's light does not reach the middle of a thick cloud.
pub(crate) const SKY_KEPT_OUT: f32 = 0.28;
/// What of that which does comes from below, off a ground that sends a fifth of its light back.
pub(crate) const FROM_BELOW: f32 = 0.2;
/// How far light is thrown forward: Henyey and Greenstein's g (*Diffuse radiation in the galaxy*, 1941).
pub(crate) const FORWARD: f32 = 0.75;
/// The halo of a strength of 1, as a share of what is thrown forward.
pub(crate) const HALO: f32 = 0.35;

/// The light around one sprite.
#[derive(Debug, Clone, Copy)]
pub struct Through {
    sun: Left,
    up: Left,
    down: Left,
    self_shadow: f32,
    /// What thin cloud shows of the directional light.
    halo: f32,
    /// What other clouds leave of that, e^(−τ/10).
    shade: f32,
}

impl Through {
    /// Of the sprite of that index, which other clouds leave so much light, seen from a direction; none if its cloud is lit by
    /// its groups alone.
    #[inline]
    pub fn new(cloud: &CloudNow<'_>, (index, shade): (usize, f32), light: &Light, towards_eye: Vec3) -> Option<Self> {
        let baked = cloud.baked?;
        let SoftLight { self_shadow, halo } = cloud.placed.soft_light;
        let around = baked.directions().around(cloud.in_model(cloud.direction_at_rest(light.direction)));
        let [up, down] = baked.up_and_down(index);
        let halo = halo * HALO * thrown(-towards_eye.dot(light.direction));
        Some(Self { sun: baked.from(index, &around), up, down, self_shadow, halo, shade })
    }

    /// The same seen from all directions alike, as what is around an eye within the cloud.
    pub fn all_around(cloud: &CloudNow<'_>, of: (usize, f32), light: &Light) -> Option<Self> {
        const EVEN: f32 = 0.25 * std::f32::consts::FRAC_1_PI;
        let halo = cloud.placed.soft_light.halo * HALO * EVEN;
        Some(Self { halo, ..Self::new(cloud, of, light, light.direction)? })
    }

    /// Has `lit`, which is so by its `group`, lit by it at `offset` from the sprite's middle, in its reaches along the axes of
    /// its model.
    #[inline]
    pub fn light(&self, lit: &mut CornerLight, offset: Vec3, group: &Group, light: &Light) {
        let sun = self.sun.at(offset) * self.shade;
        let sun_4 = (sun * sun) * (sun * sun);
        let let_through = group.c[2] * (SCATTERED * sun + STRAIGHT * sun_4 * sun_4);
        let open = (1.0 - FROM_BELOW) * self.up.at(offset).sqrt() + FROM_BELOW * self.down.at(offset).sqrt();
        let kept: Rgb = lit.directional * (1.0 - self.self_shadow);
        lit.directional = kept + light.directional_max * (self.self_shadow * let_through + self.halo * sun_4);
        lit.ambient.rgb = lit.ambient.rgb * (1.0 - self.self_shadow * SKY_KEPT_OUT * (1.0 - open));
    }
}

/// A light that other clouds have left so much of, e^(−τ/10), and that goes by a group's sides.
#[inline]
pub fn in_shade(directional: Rgb, shade: f32) -> Rgb {
    if shade >= 1.0 {
        return directional;
    }
    let shade_4 = (shade * shade) * (shade * shade);
    directional * ((SCATTERED * shade + STRAIGHT * shade_4 * shade_4) / (SCATTERED + STRAIGHT))
}

/// How much of the light is thrown on so that it turns by an angle of that cosine, 1 in all over the sphere.
#[inline]
fn thrown(cos: f32) -> f32 {
    const G: f32 = FORWARD;
    let spread = (1.0 + G * G - 2.0 * G * cos.clamp(-1.0, 1.0)).max(1e-6);
    (1.0 - G * G) * (0.25 * std::f32::consts::FRAC_1_PI) / (spread * spread.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_thrown_is_all_there_is() {
        let steps = 20_000;
        let sum: f64 = (0..steps)
            .map(|i| f64::from(thrown((i as f32 + 0.5) / steps as f32 * 2.0 - 1.0)) * 2.0 / f64::from(steps))
            .sum::<f64>()
            * std::f64::consts::TAU;
        assert!((sum - 1.0).abs() < 1e-4, "{sum}");
    }
}
