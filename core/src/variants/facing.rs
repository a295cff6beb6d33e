//! Ways for sprites near the eye that fail.

use crate::facing::Locked;
use crate::math::unit_or;
use glam::Vec3;

/// What W describes before the lock, on the way to it, and literally; and what most engines do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FacingVariant {
    /// Every sprite always faces the eye: near ones spin.
    NoLock,
    /// Locked within the lock distance, not faded: quads are seen edge-on, and snap back.
    LockWithoutFade,
    /// Locked and multiplied with the dot product of the locked and the present direction, as W has it.
    WangsDotProduct,
    /// Every sprite lies across the view direction: all turn when the head does.
    ViewPlane,
}

impl FacingVariant {
    pub(crate) fn reach(self) -> f32 {
        match self {
            Self::NoLock | Self::ViewPlane => 0.0,
            Self::LockWithoutFade | Self::WangsDotProduct => 1.0,
        }
    }

    pub(crate) fn turn(self, to_eye: Vec3, remembered: Vec3, lock_m: f32) -> Locked {
        let present = unit_or(to_eye, remembered);
        let locked = to_eye.length() < lock_m;
        match self {
            Self::NoLock | Self::ViewPlane => Locked { towards: present, fade: 1.0 },
            Self::LockWithoutFade => Locked { towards: if locked { remembered } else { present }, fade: 1.0 },
            Self::WangsDotProduct if locked => {
                Locked { towards: remembered, fade: remembered.dot(present).clamp(0.0, 1.0) }
            }
            Self::WangsDotProduct => Locked { towards: present, fade: 1.0 },
        }
    }
}
