//! Shadows that clouds cast on one another, on the ground and on what flies and stands (MODEL §10).
//!
//! On the camera clock, since clouds and sun move: nothing of it can be shared by the placements of a model, as what is
//! baked of it is. Clouds shade one another by few balls each ([`between`]), on a small grid over each. On
//! the ground falls the shadow of every sprite, by a map across the light ([`map`]), which each renderer draws for itself
//! from the one [`ShadowPlane`].

pub mod between;
mod kept;
pub mod map;
mod plane;

pub use kept::KeptShadows;
pub use map::ShadowMap;
pub use plane::{MOST_TEXELS, SUN_RADIUS, ShadowPlane, Spot, spots};

use super::CloudNow;
use glam::{DVec3, Vec3};

/// Of light that has been scattered, e^(−.1 τ), and of what comes straight, e^(−.8 τ): what reaches a ground under a cloud
/// that passes it, chosen by eye. Less is scattered down to it than within the cloud.
pub const UNDER_A_CLOUD: [f32; 2] = [0.45, 0.55];
/// The directional light's elevation, as a sine, below which it casts none: it would graze.
const LOWEST_LIGHT: f32 = 0.01;
/// The share of an optical depth that e is raised to the negative of.
pub const FALLOFF: f32 = crate::baked::FALLOFF;

/// All clouds' shadows at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shadows {
    /// From the scene to the light that casts them, unit.
    pub direction: Vec3,
    /// How much of them is seen, 0 to 1.
    pub share: f32,
    /// What opacity is multiplied with.
    pub opacity: f32,
    /// What the ground's are drawn on; none without a ground or without clouds.
    pub plane: Option<ShadowPlane>,
}

impl Shadows {
    /// None where the light is too low to cast any, or none is to be seen.
    pub(super) fn new(direction: Vec3, share: f32, opacity: f32) -> Option<Self> {
        let is_cast = share > 0.0 && opacity > 0.0 && direction.y >= LOWEST_LIGHT;
        is_cast.then_some(Self { direction, share: share.min(1.0), opacity, plane: None })
    }

    /// Axes across the light: a level one, and one that looks up.
    pub fn axes(&self) -> [Vec3; 2] {
        let (level, upwards) = plane::axes_across(self.direction);
        [level, upwards]
    }

    /// Of the directional light, what reaches a ground where so much is `left`, 0 to 1.
    #[inline(always)]
    pub fn reaches_ground(&self, left: f32) -> f32 {
        let left_4 = (left * left) * (left * left);
        1.0 - self.share * (1.0 - (UNDER_A_CLOUD[0] * left + UNDER_A_CLOUD[1] * left_4 * left_4))
    }

    /// The same at a point of the world, by few balls of each cloud: for what is small.
    pub fn reaches(&self, clouds: &[CloudNow<'_>], point: DVec3) -> f32 {
        self.reaches_ground(between::left_at(clouds, self, point))
    }
}

/// How much of a cloud's opacity there is at a point of it at rest, but for its sprites' own.
fn formed_at(cloud: &CloudNow<'_>, point: Vec3) -> f32 {
    cloud.opacity_at(cloud.placed.radii_of(point))
}
