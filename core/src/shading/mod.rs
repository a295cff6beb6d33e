//! Phase 3, on the camera clock: the light at a sprite's corners (W).
//!
//! Ambient light comes through the five colour levels by height, directional light through the shading group by the
//! angle to the sun. The twin in WGSL is render/src/pass/sprites/sprites.wgsl.

mod veil;

pub(crate) use veil::{BEFORE_THE_EYE, MOST_OPAQUE};
pub use veil::{Veil, veil};

use crate::color::{Rgb, Rgba};
use crate::math::unit_or;
use crate::scene::ColorLevels;
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

/// The colour levels at `height` (0 to 1): linear between levels, constant beyond the first and the last. Where two
/// levels share a height, the later one holds from that height on.
pub fn level_color(levels: &ColorLevels, height: f32) -> Rgba {
    let Some(above) = levels.iter().position(|level| level.height as f32 > height) else {
        return levels[levels.len() - 1].color;
    };
    if above == 0 {
        return levels[0].color;
    }
    let (from, to) = (&levels[above - 1], &levels[above]);
    let t = (height - from.height as f32) / (to.height as f32 - from.height as f32);
    from.color.mix(to.color, t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::ColorLevel;

    fn grey_levels(levels: [(f64, f32); 5]) -> ColorLevels {
        levels.map(|(height, v)| ColorLevel { height, color: Rgba::new(v, v, v, 1.0) })
    }

    #[test]
    fn levels_step_where_two_meet() {
        let levels = grey_levels([(0.1, 0.0), (0.5, 1.0), (0.5, 3.0), (0.5, 2.0), (0.9, 4.0)]);
        for (height, want) in [(0.0, 0.0), (0.1, 0.0), (0.3, 0.5), (0.5, 2.0), (0.7, 3.0), (0.9, 4.0), (1.0, 4.0)] {
            let got = level_color(&levels, height).rgb.r;
            assert!((got - want).abs() < 1e-5, "at {height}: {got}, want {want}");
        }
        let all_at_top = grey_levels([(1.0, 1.0), (1.0, 2.0), (1.0, 3.0), (1.0, 4.0), (1.0, 5.0)]);
        assert_eq!(level_color(&all_at_top, 0.5).rgb.r, 1.0);
        assert_eq!(level_color(&all_at_top, 1.0).rgb.r, 5.0);
    }

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
