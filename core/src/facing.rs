//! Phase 2, on the camera clock: how a sprite turns to the eye.
//!
//! Every sprite faces the eye *point*, not the view plane (W), turned about that axis by its own rotation. No rule of
//! direction alone gives a continuous upright, so a still takes world up, and towards the poles the camera's up.
//! The twin in WGSL is render/src/pass/sprites/sprites.wgsl.

use crate::math::{across, smoothstep, unit_or};
use glam::{Vec2, Vec3};

/// The axes of a sprite's quad, unit vectors; `right` × `up` points at the eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facing {
    /// Towards the sprite's right, its own rotation included.
    pub right: Vec3,
    /// Towards the sprite's top.
    pub up: Vec3,
}

/// Between these sines of the elevation the upright turns from the world's up to the camera's.
pub const POLE: [f32; 2] = [0.90, 0.99];

/// The corners of a quad in units of its half sides: top left, top right, bottom right, bottom left.
pub const CORNERS: [Vec2; 4] = [Vec2::new(-1.0, 1.0), Vec2::new(1.0, 1.0), Vec2::new(1.0, -1.0), Vec2::new(-1.0, -1.0)];

/// How a sprite at `center` (eye-relative) is turned, with `rotation` radians counter-clockwise as seen.
///
/// A sprite whose centre is the eye faces along +z.
pub fn face_eye(center: Vec3, rotation: f32, camera_up: Vec3) -> Facing {
    let to_eye = unit_or(-center, Vec3::Z);
    let upright = upright(to_eye, camera_up);
    let level_right = upright.cross(to_eye);
    let (sin, cos) = (libm::sinf(rotation), libm::cosf(rotation));
    Facing { right: level_right * cos + upright * sin, up: upright * cos - level_right * sin }
}

/// The unturned sprite's up: across `to_eye`, unit.
fn upright(to_eye: Vec3, camera_up: Vec3) -> Vec3 {
    let fallback = across(if to_eye.x.abs() < 0.8 { Vec3::X } else { Vec3::Z }, to_eye).normalize();
    let pole = smoothstep(POLE[0], POLE[1], to_eye.y.abs());
    let world = unit_or(across(Vec3::Y, to_eye), Vec3::ZERO);
    let camera = unit_or(across(camera_up, to_eye), world);
    unit_or(world * (1.0 - pole) + camera * pole, fallback)
}

/// The four corners of a quad at `center`, in the order of [`CORNERS`].
pub fn corners(center: Vec3, facing: Facing, width: f32, height: f32) -> [Vec3; 4] {
    CORNERS.map(|c| center + facing.right * (c.x * 0.5 * width) + facing.up * (c.y * 0.5 * height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_the_eye_upright_everywhere() {
        for center in [
            Vec3::new(0.0, 0.0, -100.0),
            Vec3::new(50.0, -30.0, 8.0),
            Vec3::Y,
            Vec3::NEG_Y * 1e6,
            Vec3::ZERO,
            Vec3::X * 1e-20,
        ] {
            for camera_up in [Vec3::Y, Vec3::NEG_Z, Vec3::ZERO] {
                let facing = face_eye(center, 0.3, camera_up);
                let normal = facing.right.cross(facing.up);
                let to_eye = unit_or(-center, Vec3::Z);
                assert!(normal.distance(to_eye) < 1e-5, "{center} {camera_up}: {normal}");
                assert!((facing.right.length() - 1.0).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn turns_counter_clockwise_as_seen() {
        let facing = face_eye(Vec3::NEG_Z, std::f32::consts::FRAC_PI_2, Vec3::Y);
        assert!(facing.up.distance(Vec3::NEG_X) < 1e-6, "a quarter turn brings the top to the left: {}", facing.up);
    }
}
