//! What the wind has done by a time: how far it has carried, and how far edges lean after it.
//!
//! Both are integrals over all that has blown since second 0: [`Sums`] and [`Lagged`], made on the edit clock from the
//! curves of direction, speed and shear.

mod smooth;

use super::Curve;
use super::lag::Lagged;
use super::pieces::Pieces;
use super::sums::Sums;
use glam::DVec2;
use smooth::Smooth;
use std::sync::Arc;

/// The wind at which edges lean as far as they reach, m/s.
pub const FULL_LEAN_MPS: f64 = 10.0;
/// No edge leans further than this, in its reach.
pub const MOST_LEAN: f64 = 1.5;
/// No wind is faster, m/s, and none shears more: as in the table of properties. Handles may have curves overshoot.
const FASTEST_MPS: f64 = 150.0;
const MOST_SHEAR: f64 = 4.0;

/// Direction, speed and shear over time.
#[derive(Debug, Clone)]
pub struct WindTracks {
    /// Where it comes from, degrees clockwise from north.
    pub from_deg: Arc<Curve>,
    /// m/s.
    pub speed_mps: Arc<Curve>,
    /// How much faster at the top than in the middle, as a share.
    pub shear: Arc<Curve>,
}

/// The wind over all time.
#[derive(Debug, Clone)]
pub struct Wind {
    tracks: WindTracks,
    /// East and south, and by whichever way; metres.
    way: Sums<3>,
    lean: Lagged<4>,
}

/// How far edges lean, in their reach, east and south.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Lean {
    /// At half the cloud's height.
    pub middle: DVec2,
    /// How much more of it there is at the top than at the bottom.
    pub shear: DVec2,
}

impl WindTracks {
    /// East and south, m/s.
    pub fn velocity_mps(&self, time_s: f64) -> DVec2 {
        velocity([self.from_deg.at(time_s, 0), self.speed_mps.at(time_s, 0)])
    }

    /// What edges strive for: to lean with the wind, and more so above than below if it shears.
    pub fn striven_for(&self, time_s: f64) -> Lean {
        striven([self.from_deg.at(time_s, 0), self.speed_mps.at(time_s, 0), self.shear.at(time_s, 0)])
    }
}

/// East and south, m/s.
fn velocity([from_deg, speed_mps]: [f64; 2]) -> DVec2 {
    let (sin, cos) = libm::sincos(from_deg.to_radians());
    DVec2::new(-sin, cos) * speed_mps.clamp(0.0, FASTEST_MPS)
}

fn striven([from_deg, speed_mps, shear]: [f64; 3]) -> Lean {
    let wind = velocity([from_deg, speed_mps]) / FULL_LEAN_MPS;
    let shear = shear.clamp(-MOST_SHEAR, MOST_SHEAR);
    // Within the most lean at top and bottom too; smoothly, so that pieces fit it.
    let most = MOST_LEAN / (1.0 + 0.5 * shear.abs());
    let share = wind.length_squared() / (most * most);
    let middle = wind / (1.0 + share * share).sqrt().sqrt();
    Lean { middle, shear: middle * shear }
}

impl Wind {
    /// None if there is never any. `lag_s`: how long edges take to follow.
    pub fn new(tracks: WindTracks, lag_s: f64) -> Option<Self> {
        if tracks.speed_mps.is_zero() {
            return None;
        }
        let WindTracks { from_deg, speed_mps, shear } = &tracks;
        let of_way = Smooth::of([from_deg, speed_mps]);
        let of_lean = Smooth::of([from_deg, speed_mps, shear]);
        let way = |values| {
            let velocity = velocity(values);
            [velocity.x, velocity.y, velocity.length()]
        };
        let lean = |values| {
            let Lean { middle, shear } = striven(values);
            [middle.x, middle.y, shear.x, shear.y]
        };
        let way = Pieces::fit(|time_s| of_way.at(time_s, way), &of_way.breaks, of_way.loops_from_s);
        let lean = Pieces::fit(|time_s| of_lean.at(time_s, lean), &of_lean.breaks, of_lean.loops_from_s);
        Some(Self { tracks, way: Sums::new(way), lean: Lagged::new(lean, lag_s) })
    }

    /// How far it has carried by `time_s`, metres east and south.
    pub fn way_m(&self, time_s: f64) -> DVec2 {
        let [x, z, _] = self.way.at(time_s);
        DVec2::new(x, z)
    }

    /// How many metres of it have blown by, whichever way.
    pub fn blown_m(&self, time_s: f64) -> f64 {
        self.way.at(time_s)[2]
    }

    /// How far edges lean.
    pub fn lean(&self, time_s: f64) -> Lean {
        let [x, z, shear_x, shear_z] = self.lean.at(time_s);
        Lean { middle: DVec2::new(x, z), shear: DVec2::new(shear_x, shear_z) }
    }

    /// What it is made of.
    pub fn tracks(&self) -> &WindTracks {
        &self.tracks
    }

    /// The way of what goes along with it by a `share` that changes.
    pub fn shared(&self, share: &Curve) -> Sums<2> {
        let smooth = Smooth::of([&self.tracks.from_deg, &self.tracks.speed_mps, share]);
        let way = |[from_deg, speed_mps, share]: [f64; 3]| {
            (velocity([from_deg, speed_mps]) * share.clamp(0.0, 1.0)).to_array()
        };
        Sums::new(Pieces::fit(|time_s| smooth.at(time_s, way), &smooth.breaks, smooth.loops_from_s))
    }
}
