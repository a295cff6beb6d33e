//! The light that other clouds let through to a cloud.

use glam::{Vec2, Vec3};
use std::sync::Arc;

/// What other clouds take of the directional light, on a grid across it, over the cloud as it is now; linear between nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct Shade {
    /// Axes of the grid, unit, and from the scene to the light.
    pub axes: [Vec3; 2],
    /// See [`Shade::axes`].
    pub direction: Vec3,
    /// Where the first node stands along the axes, metres from the cloud's origin.
    pub low: Vec2,
    /// Nodes a metre along each.
    pub nodes_a_metre: Vec2,
    /// Nodes along each, two at least.
    pub size: [u32; 2],
    /// How much of it is seen, 0 to 1.
    pub share: f32,
    /// At each node, the first axis first.
    pub nodes: Arc<[ShadeNode]>,
}

/// All that stands along the light over a node: its optical depth, and that times how far along the light it stands, metres
/// from the cloud's origin, and times half of how deep it is.
pub type ShadeNode = [f32; 3];

impl Shade {
    /// What is left of the light, e^(−τ/10) from 0 to 1, at a point that counts from the cloud's origin; beyond the grid as at
    /// its edge.
    #[inline]
    pub fn at(&self, point: Vec3) -> f32 {
        let [columns, rows] = self.size;
        let last = Vec2::new((columns - 1) as f32, (rows - 1) as f32);
        let along = Vec2::new(point.dot(self.axes[0]), point.dot(self.axes[1]));
        let place = ((along - self.low) * self.nodes_a_metre).clamp(Vec2::ZERO, last);
        // Not beyond the last but one, so that there is a next.
        let first = place.floor().min(last - 1.0);
        let share = place - first;
        let at = (first.y as u32 * columns + first.x as u32) as usize;
        let mix = |i: usize| {
            let pair = |at: usize| self.nodes[at][i] + (self.nodes[at + 1][i] - self.nodes[at][i]) * share.x;
            let (low, high) = (pair(at), pair(at + columns as usize));
            low + (high - low) * share.y
        };
        let [depth, stands, half] = [mix(0), mix(1), mix(2)];
        if depth <= 0.0 {
            return 1.0;
        }
        // As much of it as lies from the point towards the light.
        let before = (0.5 + 0.5 * (stands - point.dot(self.direction) * depth) / half.max(1e-6)).clamp(0.0, 1.0);
        1.0 - self.share * (1.0 - crate::math::exp(-crate::baked::FALLOFF * depth * before))
    }
}
