//! How an aircraft on a path is turned: its nose along the way, banked as in a coordinated turn.
//!
//! In such a turn, wings and weight balance: tan(bank) = lateral acceleration / g. The acceleration is the change of
//! velocity over two seconds around the instant, since that at the instant itself jumps at the keys, and an aircraft
//! takes its time to roll.

use super::{PathCurve, PathPoint};
use glam::DVec3;

/// An aircraft banks no farther.
pub const MAX_BANK_DEG: f64 = 60.0;
/// Below this speed, m/s, an aircraft's nose turns from its way to where the camera's keys look.
pub const STANDSTILL_MPS: f64 = 5.0;

const GRAVITY_MPS2: f64 = 9.80665;
const HALF_SPAN_S: f64 = 1.0;

impl PathCurve {
    /// Where an aircraft is `t_s` seconds after the first key, and how it is turned; at the path's ends before and after
    /// them, as it came or will go.
    ///
    /// It turns without jumps but in two cases: straight up or down, where a heading means nothing, and where it sets
    /// off against the way that the camera looks.
    pub fn attitude_at(&self, t_s: f64) -> PathPoint {
        let here = self.at(t_s);
        let velocity = self.velocity_on_curve(t_s);
        let look = here.turn() * DVec3::NEG_Z;
        let nose = velocity + look * (STANDSTILL_MPS - velocity.length()).max(0.0);
        let level = libm::hypot(nose.x, nose.z);
        let heading = if level > 0.0 { libm::atan2(nose.x, -nose.z) } else { here.heading_deg.to_radians() };
        let right = DVec3::new(libm::cos(heading), 0.0, libm::sin(heading));
        let bank_deg = libm::atan(self.acceleration_around(t_s).dot(right) / GRAVITY_MPS2).to_degrees();
        PathPoint {
            position: here.position,
            heading_deg: heading.to_degrees().rem_euclid(360.0),
            pitch_deg: libm::atan2(nose.y, level).to_degrees(),
            roll_deg: bank_deg.clamp(-MAX_BANK_DEG, MAX_BANK_DEG),
        }
    }

    fn acceleration_around(&self, t_s: f64) -> DVec3 {
        let within = |t: f64| t.max(0.0).min(self.duration_s());
        let (from, to) = (within(t_s - HALF_SPAN_S), within(t_s + HALF_SPAN_S));
        if to > from { (self.velocity_on_curve(to) - self.velocity_on_curve(from)) / (to - from) } else { DVec3::ZERO }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{CameraPath, PathKey};

    fn key(time_s: f64, position: DVec3) -> PathKey {
        PathKey { time_s, position, heading_deg: 123.0, pitch_deg: 45.0, roll_deg: 6.0 }
    }

    fn curve(keys: Vec<PathKey>) -> PathCurve {
        PathCurve::new(&CameraPath::free(keys))
    }

    /// A full circle of `radius_m` flown at `speed_mps`, clockwise from above, with a key every 5°.
    fn circle(radius_m: f64, speed_mps: f64) -> PathCurve {
        let around_s = std::f64::consts::TAU * radius_m / speed_mps;
        let at = |i: i32| {
            let angle = f64::from(i) / 72.0 * std::f64::consts::TAU;
            key(f64::from(i) / 72.0 * around_s, DVec3::new(-angle.cos(), 0.0, -angle.sin()) * radius_m)
        };
        curve((0..=72).map(at).collect())
    }

    #[test]
    fn the_nose_points_along_the_way() {
        let climb = curve(vec![key(0.0, DVec3::ZERO), key(10.0, DVec3::new(300.0, 400.0, 0.0))]);
        let at = climb.attitude_at(5.0);
        assert_eq!(at.position, DVec3::new(150.0, 200.0, 0.0));
        for (got, want) in [(at.heading_deg, 90.0), (at.pitch_deg, 53.130_102_354), (at.roll_deg, 0.0)] {
            assert!((got - want).abs() < 1e-8, "{got} for {want}");
        }
    }

    #[test]
    fn banks_into_turns() {
        // The acceleration is v²/r. The curve's velocity differs from the circle's where a coordinate turns: a key from
        // there, one chord is three times the other, and their harmonic mean is three quarters of the slope, which is
        // a·v for keys an angle a apart. So each end of the two seconds is off by up to a·v/4, and the acceleration too.
        for (radius, speed) in [(1500.0, 80.0), (600.0, 80.0), (900.0, 40.0)] {
            let curve = circle(radius, speed);
            let most = 5.0_f64.to_radians() * speed / 4.0;
            for i in 3..=57 {
                let t = f64::from(i) / 60.0 * curve.duration_s();
                let lateral = curve.attitude_at(t).roll_deg.to_radians().tan() * GRAVITY_MPS2;
                assert!((lateral - speed * speed / radius).abs() < most, "{lateral} m/s² at {t} s, {radius} m");
            }
        }
        let tight = circle(100.0, 90.0);
        assert_eq!(tight.attitude_at(3.0).roll_deg, MAX_BANK_DEG);
    }

    #[test]
    fn never_jumps() {
        // From a standstill through turns, to a standstill.
        let places =
            [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 10.0, -300.0], [200.0, 30.0, -700.0], [700.0, 0.0, -700.0]];
        let keys = places.iter().enumerate().map(|(i, place)| key(10.0 * i as f64, DVec3::from_array(*place)));
        let mut keys: Vec<_> = keys.collect();
        keys.push(PathKey { time_s: 50.0, ..keys[4] });
        let curve = curve(keys);
        // From rest, the first 300 m take 10 s: it sets off with 6·300/10² = 18 m/s². Where it looks and where it goes
        // are 111° apart, so the mean of both is at least cos(55°) long: the nose turns by up to 2·18/(5·0.57) = 13 rad/s
        // there, 0.073° in 10⁻⁴ s, and the bank, whose tangent is at most 18/g, by up to twice that.
        let points: Vec<_> = (-10_000..=510_000).map(|i| curve.attitude_at(f64::from(i) * 1e-4)).collect();
        for pair in points.windows(2) {
            let turned = pair[0].turn().angle_between(pair[1].turn()).to_degrees();
            assert!(turned < 0.22, "{turned}° from {:?} to {:?}", pair[0], pair[1]);
        }
        let still = curve.attitude_at(5.0);
        assert!((still.heading_deg - 123.0).abs() < 1e-9 && (still.pitch_deg - 45.0).abs() < 1e-9, "{still:?}");
    }
}
