//! What stands behind the clouds: sky, sun, ground, and the haze between.
//!
//! The sky is Hosek and Wilkie's (*An Analytic Model for Full Spectral Sky-Dome Radiance*, SIGGRAPH 2012); crate
//! hw-skymodel supplies its coefficients. Their model ends at sunset: below, its last sky is dimmed and cooled.
//! The twin in WGSL is render/src/pass/sky/sky.wgsl.

mod dome;
mod ground;

pub use dome::{Dome, DomeTables, HORIZON_SINE, SUN_DISC_COSINES};
pub use ground::{GROUND_CELLS_M, GROUND_PERIOD_M, GroundLook};

use crate::color::Rgb;
use glam::Vec3;

/// Everything behind the clouds, and the haze before it, at one moment.
#[derive(Debug, Clone, PartialEq)]
pub struct Background {
    /// Sky and sun.
    pub dome: Dome,
    /// The ground, if the eye is above one.
    pub ground: Option<GroundLook>,
    /// Metres over which 1 − 1/e of a colour turns to the horizon's.
    pub haze_length_m: f32,
}

impl Background {
    /// What is seen along `ray` (any length) where no cloud is; `footprint` is a pixel's angle, radians.
    pub fn color(&self, ray: Vec3, footprint: f32) -> Rgb {
        let direction = ray.normalize();
        let Some((ground, distance)) = self.ground.as_ref().and_then(|g| Some((g, g.distance(direction)?))) else {
            return self.dome.radiance(direction);
        };
        let pixel_m = distance * footprint / direction.y.abs().max(1e-6);
        let color = ground.color(direction * distance, pixel_m);
        color.mix(self.dome.horizon(direction), haze_share(distance, self.haze_length_m))
    }

    /// The colour that a thing in `direction` (any length) hazes to, and how far it has, at `distance` metres.
    pub fn haze(&self, direction: Vec3, distance: f32) -> (Rgb, f32) {
        (self.dome.horizon(direction), haze_share(distance, self.haze_length_m))
    }
}

/// 1 − e^(−distance / length), 0 to 1.
pub fn haze_share(distance: f32, length: f32) -> f32 {
    1.0 - libm::expf(-distance / length)
}
