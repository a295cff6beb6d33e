//! The sun, or at night the moon, as a light of other tools.

use crate::weather::SceneNow;
use glam::{DQuat, DVec3};

/// A light that shines along its own −z.
pub(super) struct Sun {
    /// Linear, its largest part 1.
    pub(super) color: [f32; 3],
    /// On a face that looks at it: such that a white, matt one is as bright as our directional light. 0 of one that is down.
    pub(super) light: f64,
    /// Its turn.
    pub(super) turn: DQuat,
}

impl Sun {
    pub(super) fn of(now: &SceneNow<'_>) -> Self {
        let color = now.light.directional_max.to_array();
        let most = color.into_iter().fold(0.0, f32::max);
        Self {
            color: color.map(|part| if most > 0.0 { part / most } else { 1.0 }),
            light: f64::from(most * now.exposure) * std::f64::consts::PI,
            turn: DQuat::from_rotation_arc(DVec3::NEG_Z, -now.light.direction.as_dvec3().normalize()),
        }
    }
}
