//! A camera path between its keys: smooth, and never beyond them.
//!
//! Each coordinate and each angle is a [`super::spline`] of its own over time. So the camera passes each key at its
//! time, its velocity has no jumps, and between two keys it stays within the box that they span: it hits nothing that
//! the artist flew around. Angles are unwrapped first, so that from 350° to 10° it turns by 20°.

use super::spline::{Piece, slopes};
use crate::scene::{Camera, CameraPath, PathKey};
use glam::{DQuat, DVec3};

/// Keys follow each other by no less, seconds.
pub const SHORTEST_LEG_S: f64 = 0.001;

/// A path ready to be flown: any instant can be asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct PathCurve {
    field_of_view_deg: f64,
    /// Seconds since the first key, rising.
    times: Vec<f64>,
    /// East, up, south, heading, pitch, roll of each key; angles in degrees and unwrapped.
    values: Vec<[f64; 6]>,
    /// Their derivatives, per second. None for a single key.
    slopes: Vec<[f64; 6]>,
}

/// Where something on a path is, and how it is turned.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PathPoint {
    /// Metres in the world.
    pub position: DVec3,
    /// 0 to 360, clockwise from north, seen from above.
    pub heading_deg: f64,
    /// −90 to 90, up is positive.
    pub pitch_deg: f64,
    /// −180 to 180, right wing down is positive.
    pub roll_deg: f64,
}

impl PathCurve {
    /// The curve through the path's keys. Keys that don't come [`SHORTEST_LEG_S`] after the one before them, which the
    /// checks refuse, are passed over; without any, it stands at the origin.
    pub fn new(path: &CameraPath) -> Self {
        let mut keys: Vec<&PathKey> = Vec::new();
        for key in &path.keys {
            if keys.last().is_none_or(|last| key.time_s >= last.time_s + SHORTEST_LEG_S) {
                keys.push(key);
            }
        }
        let start_s = keys.first().map_or(0.0, |key| key.time_s);
        let times: Vec<f64> = keys.iter().map(|key| key.time_s - start_s).collect();
        let mut values: Vec<[f64; 6]> = Vec::new();
        for key in keys {
            let PathKey { position: DVec3 { x, y, z }, heading_deg, pitch_deg, roll_deg, .. } = *key;
            let near = |angle: f64, which: usize| values.last().map_or(angle, |before| unwrapped(angle, before[which]));
            values.push([x, y, z, near(heading_deg, 3), pitch_deg, near(roll_deg, 5)]);
        }
        let mut curve = Self { field_of_view_deg: path.field_of_view_deg, slopes: Vec::new(), times, values };
        if curve.times.len() > 1 {
            let of = |which| {
                let values: Vec<f64> = curve.values.iter().map(|value: &[f64; 6]| value[which]).collect();
                slopes(&curve.times, &values)
            };
            let columns: [Vec<f64>; 6] = std::array::from_fn(of);
            curve.slopes = (0..curve.times.len()).map(|i| std::array::from_fn(|which| columns[which][i])).collect();
        }
        curve
    }

    /// From the first key to the last, seconds; 0 for a path that stands still.
    pub fn duration_s(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// Where it is `t_s` seconds after the first key; at its ends before and after them.
    pub fn at(&self, t_s: f64) -> PathPoint {
        let each = match self.leg(t_s) {
            Some((leg, u)) => std::array::from_fn(|which| self.piece(leg, which).at(u)),
            None => self.values.first().copied().unwrap_or_default(),
        };
        let [x, y, z, heading_deg, pitch_deg, roll_deg] = each;
        PathPoint {
            position: DVec3::new(x, y, z),
            heading_deg: heading_deg.rem_euclid(360.0),
            pitch_deg,
            roll_deg: (roll_deg + 180.0).rem_euclid(360.0) - 180.0,
        }
    }

    /// How fast it flies there, metres a second; nothing before its start and after its end.
    pub fn velocity_at(&self, t_s: f64) -> DVec3 {
        if (0.0..=self.duration_s()).contains(&t_s) { self.velocity_on_curve(t_s) } else { DVec3::ZERO }
    }

    /// What a camera on the path sees with there.
    pub fn camera_at(&self, t_s: f64) -> Camera {
        let PathPoint { position, heading_deg, pitch_deg, roll_deg } = self.at(t_s);
        let field_of_view_deg = self.field_of_view_deg;
        Camera { heading_deg, pitch_deg, roll_deg, field_of_view_deg, ..Camera::free(position) }
    }

    /// As [`PathCurve::velocity_at`], and beyond the ends that at the end.
    pub(super) fn velocity_on_curve(&self, t_s: f64) -> DVec3 {
        match self.leg(t_s) {
            Some((leg, u)) => DVec3::from_array(std::array::from_fn(|which| self.piece(leg, which).slope_at(u))),
            None => DVec3::ZERO,
        }
    }

    /// The leg that is flown at `t_s`, and which share of it has passed; none for a path that stands still.
    fn leg(&self, t_s: f64) -> Option<(usize, f64)> {
        let last = self.slopes.len().checked_sub(2)?;
        let leg = self.times.partition_point(|time| *time <= t_s).saturating_sub(1).min(last);
        let u = (t_s - self.times[leg]) / (self.times[leg + 1] - self.times[leg]);
        // What is no number is the start.
        Some((leg, if u > 0.0 { u.min(1.0) } else { 0.0 }))
    }

    fn piece(&self, leg: usize, which: usize) -> Piece {
        let ends = [leg, leg + 1];
        Piece {
            values: ends.map(|i| self.values[i][which]),
            slopes: ends.map(|i| self.slopes[i][which]),
            length: self.times[leg + 1] - self.times[leg],
        }
    }
}

impl PathPoint {
    /// The turn that takes a thing with its nose along −z and its top along +y to how it is here.
    pub fn turn(&self) -> DQuat {
        let about = |axis: DVec3, deg: f64| {
            let half = deg.to_radians() * 0.5;
            let axis = axis * libm::sin(half);
            DQuat::from_xyzw(axis.x, axis.y, axis.z, libm::cos(half))
        };
        about(DVec3::NEG_Y, self.heading_deg) * about(DVec3::X, self.pitch_deg) * about(DVec3::NEG_Z, self.roll_deg)
    }
}

/// The angle that is the same as `angle` and nearest to `near`, degrees.
fn unwrapped(angle: f64, near: f64) -> f64 {
    angle + 360.0 * libm::round((near - angle) / 360.0)
}

#[cfg(test)]
mod tests;
