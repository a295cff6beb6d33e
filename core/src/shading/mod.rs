//! Phase 3, on the camera clock: the light at a sprite's corners (W).
//!
//! Ambient light comes through the five colour levels by height, directional light through the shading group by the
//! angle to the sun. The twin in WGSL is render/src/pass/sprites/sprites.wgsl.

mod through;
mod veil;

pub use crate::scene::level_color;
pub(crate) use through::{FORWARD, FROM_BELOW, HALO, SCATTERED, SKY_KEPT_OUT, STRAIGHT};
pub use through::{Through, in_shade};
pub(crate) use veil::{BEFORE_THE_EYE, MOST_OPAQUE};
pub use veil::{Veil, veil};

use crate::color::{Rgb, Rgba};
use crate::math::unit_or;
use crate::sprites::Group;
use crate::weather::{CloudNow, Light};
use glam::Vec3;

/// The light at one corner, linear, straight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CornerLight {
    /// Height within the cloud, 0 to 1.
    pub height: f32,
    /// The sky's share, with the opacity as far as the cloud has formed.
    pub ambient: Rgba,
    /// The sun's share.
    pub directional: Rgb,
}

impl CornerLight {
    /// What the tile is multiplied with: both lights, the sky's alpha.
    pub fn color(&self) -> Rgba {
        Rgba { rgb: self.ambient.rgb + self.directional, a: self.ambient.a }
    }
}

/// The light at `point`, which counts from the cloud's origin and is at rest, for a sprite of `group`.
pub fn corner_light(point: Vec3, cloud: &CloudNow<'_>, group: &Group, light: &Light) -> CornerLight {
    let placed = cloud.placed;
    let height = placed.height_of(point.y);
    let level = level_color(cloud.color_levels(), height);
    let opacity = cloud.opacity_at(placed.radii_of(point));
    CornerLight {
        height,
        ambient: Rgba {
            rgb: level.rgb * light.ambient_max.rgb,
            a: (level.a * light.ambient_max.a).clamp(0.0, 1.0) * opacity,
        },
        directional: light.directional_max
            * directional_share(point - group.center, group.c, cloud.direction_at_rest(light.direction)),
    }
}

/// g(d) with d the cosine between `outward` (centre to corner) and the sun: Cmin at −1, Cmed at 0, Cmax at 1.
///
/// The sources' slides take the vector from vertex to centre, which lights the dark side. A corner at the group's
/// centre has d = 0.
pub fn directional_share(outward: Vec3, [c_min, c_med, c_max]: [f32; 3], sun_direction: Vec3) -> f32 {
    let d = unit_or(outward, Vec3::ZERO).dot(sun_direction).clamp(-1.0, 1.0);
    if d < 0.0 { c_med + (c_med - c_min) * d } else { c_med + (c_max - c_med) * d }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_side_that_faces_the_sun_is_bright() {
        let c = [0.1, 0.4, 1.0];
        for (outward, want) in [
            (Vec3::X * 9.0, 1.0),
            (Vec3::NEG_X, 0.1),
            (Vec3::Y * 1e-30, 0.4),
            (Vec3::ZERO, 0.4),
            (Vec3::new(1.0, 3.0_f32.sqrt(), 0.0), 0.7),
        ] {
            let got = directional_share(outward, c, Vec3::X);
            assert!((got - want).abs() < 1e-6, "{outward}: {got}, want {want}");
        }
    }
}
