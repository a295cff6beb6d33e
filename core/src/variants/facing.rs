//! Ways for sprites near the eye that fail: what W describes before the lock, on the way to it, and literally; and what
//! most engines do.

use crate::facing::{FacingRule, Locked};
use crate::math::unit_or;
use glam::Vec3;

/// Every sprite always faces the eye: near ones spin.
pub const NO_LOCK: FacingRule = FacingRule { name: "no lock", reach: 0.0, turn: no_lock, across_view: false };

/// Locked within the lock distance, not faded: quads are seen edge-on, and snap back.
pub const LOCK_WITHOUT_FADE: FacingRule =
    FacingRule { name: "locked, not faded", reach: 1.0, turn: lock_without_fade, across_view: false };

/// Locked and multiplied with the dot product of the locked and the present direction, as W has it.
pub const WANGS_DOT_PRODUCT: FacingRule =
    FacingRule { name: "locked, faded by a dot product", reach: 1.0, turn: wangs_dot_product, across_view: false };

/// Every sprite lies across the view direction: all turn when the head does.
pub const VIEW_PLANE: FacingRule =
    FacingRule { name: "across the view direction", reach: 0.0, turn: no_lock, across_view: true };

fn no_lock(to_eye: Vec3, remembered: Vec3, _: f32) -> Locked {
    Locked { towards: unit_or(to_eye, remembered), fade: 1.0 }
}

fn lock_without_fade(to_eye: Vec3, remembered: Vec3, lock_m: f32) -> Locked {
    let present = unit_or(to_eye, remembered);
    Locked { towards: if to_eye.length() < lock_m { remembered } else { present }, fade: 1.0 }
}

fn wangs_dot_product(to_eye: Vec3, remembered: Vec3, lock_m: f32) -> Locked {
    let present = unit_or(to_eye, remembered);
    if to_eye.length() < lock_m {
        return Locked { towards: remembered, fade: remembered.dot(present).clamp(0.0, 1.0) };
    }
    Locked { towards: present, fade: 1.0 }
}
