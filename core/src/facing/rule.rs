//! Which rule sprites near the eye follow, as a value.

use super::lock::{Locked, SHELL, lock};
use glam::Vec3;

/// How sprites near the eye turn and fade.
#[derive(Debug, Clone, Copy)]
pub struct FacingRule {
    /// In words; no two rules have the same, and they are told apart by it.
    pub name: &'static str,
    /// From which distance on a sprite faces the eye whatever was before, in lock distances.
    pub reach: f32,
    /// Which way a sprite faces and how much of it shows, by the arguments of [`lock`].
    pub turn: fn(Vec3, Vec3, f32) -> Locked,
    /// Whether all sprites lie across the view direction instead.
    pub across_view: bool,
}

impl FacingRule {
    /// Locked and faded without a jump ([`lock`]): what ships.
    pub const BOUNDED: Self = Self { name: "locked and faded", reach: SHELL, turn: lock, across_view: false };
}

impl PartialEq for FacingRule {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}
