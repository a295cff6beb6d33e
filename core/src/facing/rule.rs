//! Which rule sprites near the eye follow: the one that ships, or one of the sources' that fail.

use super::lock::{Locked, SHELL, lock};
use crate::variants::FacingVariant;
use glam::Vec3;

/// How sprites near the eye turn and fade.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FacingRule {
    /// Locked and faded without a jump ([`lock`]).
    #[default]
    Bounded,
    /// Kept for charts and tests.
    Variant(FacingVariant),
}

impl FacingRule {
    /// From which distance on a sprite faces the eye whatever was before, in lock distances.
    pub(super) fn reach(self) -> f32 {
        match self {
            Self::Bounded => SHELL,
            Self::Variant(variant) => variant.reach(),
        }
    }

    /// Which way a sprite faces and how much of it shows; see [`lock`] for the arguments.
    pub(super) fn turn(self, to_eye: Vec3, remembered: Vec3, lock_m: f32) -> Locked {
        match self {
            Self::Bounded => lock(to_eye, remembered, lock_m),
            Self::Variant(variant) => variant.turn(to_eye, remembered, lock_m),
        }
    }

    /// Whether all sprites lie in the view's plane instead.
    pub(super) fn is_in_view_plane(self) -> bool {
        self == Self::Variant(FacingVariant::ViewPlane)
    }
}
