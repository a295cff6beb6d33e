//! Phase 2, on the camera clock: how a sprite turns to the eye, and how much of it shows near it.
//!
//! Every sprite faces the eye *point*, not the view plane (W), turned about that axis by its own rotation. Near the eye
//! it stops turning and fades ([`lock`]); near the poles it carries its up along ([`upright`]). Both need to know where
//! the eye has been: [`FacingMemory`] holds that for one view, for the few sprites that it matters to. A still has no
//! history: everything faces the eye, upright by direction alone. That case's twin in WGSL is
//! render/src/pass/sprites/sprites.wgsl; sprites with a [`Pose`] of their own are turned here for every renderer.

mod lock;
mod memory;
mod poses;
mod rule;
pub mod upright;

pub use lock::{LOCK_SHARE, Locked, SHELL, lock, lock_distance, lock_reach, near_fade, near_reach};
pub use memory::FacingMemory;
pub use poses::{Posed, Poses};
pub use rule::FacingRule;

use crate::camera::View;
use crate::math::unit_or;
use glam::{Vec2, Vec3};

/// The axes of a sprite's quad, unit vectors; `right` × `up` points where it faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facing {
    /// Towards the sprite's right, its own rotation included.
    pub right: Vec3,
    /// Towards the sprite's top.
    pub up: Vec3,
}

/// How a sprite stands before the eye, its own rotation left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// What it faces, unit.
    pub towards: Vec3,
    /// Its up before it is rotated: across `towards`, unit.
    pub up: Vec3,
    /// A factor of its alpha, 0 to 1.
    pub fade: f32,
}

impl Pose {
    /// The pose of a sprite that is far from the eye: `center` is eye-relative, metres. One whose centre is the eye
    /// faces along +z.
    pub fn facing_eye(center: Vec3, camera_up: Vec3) -> Self {
        let towards = unit_or(-center, Vec3::Z);
        Self { towards, up: upright::still(towards, camera_up), fade: 1.0 }
    }

    /// The pose of a sprite of `radius` metres in a still, at any distance.
    pub fn still(center: Vec3, radius: f32, view: &View) -> Self {
        let pose = Self::facing_eye(center, view.up_at_poles());
        let fade = lock(-center, pose.towards, lock_distance(radius)).fade;
        Self { fade: fade * near_fade(center.length(), near_reach(view)), ..pose }
    }

    /// The quad's axes, turned by the sprite's own `rotation`, radians counter-clockwise as seen.
    pub fn facing(&self, rotation: f32) -> Facing {
        let level_right = self.up.cross(self.towards);
        let (sin, cos) = (libm::sinf(rotation), libm::cosf(rotation));
        Facing { right: level_right * cos + self.up * sin, up: self.up * cos - level_right * sin }
    }
}

/// The corners of a quad in units of its half sides: top left, top right, bottom right, bottom left.
pub const CORNERS: [Vec2; 4] = [Vec2::new(-1.0, 1.0), Vec2::new(1.0, 1.0), Vec2::new(1.0, -1.0), Vec2::new(-1.0, -1.0)];

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
                let facing = Pose::facing_eye(center, camera_up).facing(0.3);
                let normal = facing.right.cross(facing.up);
                let to_eye = unit_or(-center, Vec3::Z);
                assert!(normal.distance(to_eye) < 1e-5, "{center} {camera_up}: {normal}");
                assert!((facing.right.length() - 1.0).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn turns_counter_clockwise_as_seen() {
        let facing = Pose::facing_eye(Vec3::NEG_Z, Vec3::Y).facing(std::f32::consts::FRAC_PI_2);
        assert!(facing.up.distance(Vec3::NEG_X) < 1e-6, "a quarter turn brings the top to the left: {}", facing.up);
    }
}
