//! What the wind has done by a time: how far it has carried, and how far edges lean after it.
//!
//! Both are integrals over all that has blown since second 0: [`Sums`] and [`Lagged`], made on the edit clock from the
//! curves of direction, speed and shear.

use super::Curve;
use super::lag::Lagged;
use super::pieces::Pieces;
use super::sums::Sums;
use glam::DVec2;
use std::sync::Arc;

/// The wind at which edges lean as far as they reach, m/s.
pub const FULL_LEAN_MPS: f64 = 10.0;
/// No edge leans further than this, in its reach.
pub const MOST_LEAN: f64 = 1.5;

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
        let (sin, cos) = libm::sincos(self.from_deg.at(time_s, 0).to_radians());
        DVec2::new(-sin, cos) * self.speed_mps.at(time_s, 0).max(0.0)
    }

    /// What edges strive for: to lean with the wind, and more so above than below if it shears.
    pub fn striven_for(&self, time_s: f64) -> Lean {
        let (wind, shear) = (self.velocity_mps(time_s) / FULL_LEAN_MPS, self.shear.at(time_s, 0));
        // Within the most lean at top and bottom too; smoothly, so that pieces fit it.
        let most = MOST_LEAN / (1.0 + 0.5 * shear.abs());
        let share = wind.length_squared() / (most * most);
        let middle = wind / (1.0 + share * share).sqrt().sqrt();
        Lean { middle, shear: middle * shear }
    }

    fn curves(&self) -> [&Curve; 3] {
        [&self.from_deg, &self.speed_mps, &self.shear]
    }
}

impl Wind {
    /// None if there is never any. `lag_s`: how long edges take to follow.
    pub fn new(tracks: WindTracks, lag_s: f64) -> Option<Self> {
        if tracks.speed_mps.is_zero() {
            return None;
        }
        let (breaks, loops_from_s) = breaks_s(&tracks.curves());
        let way = |time_s| {
            let velocity = tracks.velocity_mps(time_s);
            [velocity.x, velocity.y, velocity.length()]
        };
        let lean = |time_s| {
            let Lean { middle, shear } = tracks.striven_for(time_s);
            [middle.x, middle.y, shear.x, shear.y]
        };
        let (way, lean) = (Pieces::fit(way, &breaks, loops_from_s), Pieces::fit(lean, &breaks, loops_from_s));
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
        let [from_deg, speed_mps, _] = self.tracks.curves();
        let (breaks, loops_from_s) = breaks_s(&[from_deg, speed_mps, share]);
        let way = |time_s| (self.tracks.velocity_mps(time_s) * share.at(time_s, 0)).to_array();
        Sums::new(Pieces::fit(way, &breaks, loops_from_s))
    }
}

/// Between which times all `curves` are smooth, from second 0 to where they hold; or, if any comes again and again, to
/// where all do, with where that begins. Of periods that don't fit into one another the longest counts.
fn breaks_s(curves: &[&Curve]) -> (Vec<f64>, Option<f64>) {
    let end_s = curves.iter().map(|curve| curve.ends_s()[1]).fold(0.0, f64::max);
    let periods: Vec<f64> = curves.iter().filter_map(|curve| curve.period_s()).collect();
    let loops_from_s = (!periods.is_empty()).then_some(end_s);
    let last_s = end_s + common_period_s(&periods);
    let mut breaks: Vec<f64> = curves.iter().flat_map(|curve| curve.breaks_s([0.0, last_s])).collect();
    breaks.extend([0.0, end_s, last_s]);
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    (breaks, loops_from_s)
}

/// The least time after which all of `periods_s` begin anew, if that is within a dozen of the longest; 0 of none.
fn common_period_s(periods_s: &[f64]) -> f64 {
    let longest = periods_s.iter().copied().fold(0.0, f64::max);
    let fits = |whole: &f64| {
        periods_s.iter().all(|period| {
            let rounds = whole / period;
            (rounds - libm::round(rounds)).abs() < 1e-9 * rounds
        })
    };
    (1..=12).map(|times| longest * f64::from(times)).find(fits).unwrap_or(longest)
}
