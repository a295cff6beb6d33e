//! What stands behind the clouds: sky, sun, moon and stars, ground, and the haze between.
//!
//! The sky is Hosek and Wilkie's (*An Analytic Model for Full Spectral Sky-Dome Radiance*, SIGGRAPH 2012); crate
//! hw-skymodel supplies its coefficients. Low suns are graded, and below its range the last sky is dimmed and cooled
//! (dome.rs says why).
//! The twins in WGSL are those in render/src/pass/sky/ and render/src/shader/dome.wgsl.

mod dome;
mod ground;
mod night;
mod rows;
mod stars;

pub use dome::{Dome, DomeTables, GLOW_FROM_COSINE, GLOW_KEPT, HORIZON_SINE, SUN_DISC_COSINES};
pub use ground::{GROUND_CELLS_M, GROUND_PERIOD_M, GroundLook, GroundShadow};
pub use night::{MOON_RADIUS, NightSky};
pub use rows::BackgroundRows;

use crate::color::Rgb;
use crate::draw_list::Hidden;
use crate::math::exp;
use glam::Vec3;

/// The haze length of air without any, metres: no scene is so wide that its share would be more than nothing.
const CLEAR_M: f32 = 1e20;

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
    /// What is left of it where some is hidden.
    pub(crate) fn without(self, hidden: &Hidden) -> Self {
        let haze_length_m = if hidden.haze { CLEAR_M } else { self.haze_length_m };
        Self { ground: self.ground.filter(|_| !hidden.ground), haze_length_m, ..self }
    }

    /// What is seen along `ray` (any length) where no cloud is; `footprint` is a pixel's angle, radians.
    pub fn color(&self, ray: Vec3, footprint: f32) -> Rgb {
        let direction = ray.normalize();
        let Some((ground, distance)) = self.ground.as_ref().and_then(|g| Some((g, g.distance(direction)?))) else {
            let lights = self.dome.night.map(|night| night.lights(direction, footprint));
            return self.dome.radiance(direction) + lights.unwrap_or(Rgb::BLACK);
        };
        let color = ground.color(direction * distance, ground.pixel_m(direction, distance, footprint));
        color.mix(self.dome.horizon(direction), haze_share(distance, self.haze_length_m))
    }
}

/// 1 − e^(−distance / length), 0 to 1.
#[inline(always)]
pub fn haze_share(distance: f32, length: f32) -> f32 {
    1.0 - exp(-distance / length)
}
