//! Speeds instead of times: how fast a leg is flown, and the keys that fly it at another speed.
//!
//! A leg's speed is the length of its curve, not of its chord, over its duration. Another duration bends the curve a
//! little, so the duration that fits a speed is found in a few rounds of measuring and timing.

use super::PathCurve;
use crate::scene::{CameraPath, PathKey};

/// Rounds of measuring a leg; each brings the speed nearer by an order of magnitude.
const ROUNDS: usize = 12;
/// Pieces that a leg is measured in. Even.
const PIECES: u32 = 64;

/// Mean speed on the leg after the key at `index`, m/s; none if no leg begins there.
pub fn leg_speed_mps(keys: &[PathKey], index: usize) -> Option<f64> {
    Some(leg_length_m(keys, index)? / leg_duration_s(keys, index)?)
}

/// The keys with that leg flown at the mean speed `speed_mps`. Later keys move in time and keep their own legs'
/// durations. All is left as it is if no leg begins there, if it has no length, or if the speed isn't above 0.
#[must_use]
pub fn with_speed_from(keys: &[PathKey], index: usize, speed_mps: f64) -> Vec<PathKey> {
    let mut timed = keys.to_vec();
    for _ in 0..ROUNDS {
        let Some((length, duration)) = leg_length_m(&timed, index).zip(leg_duration_s(&timed, index)) else { break };
        if !(speed_mps > 0.0 && speed_mps.is_finite() && length > 0.0) {
            break;
        }
        let wanted = (length / speed_mps).max(super::SHORTEST_LEG_S);
        for key in &mut timed[index + 1..] {
            key.time_s += wanted - duration;
        }
    }
    timed
}

fn leg_duration_s(keys: &[PathKey], index: usize) -> Option<f64> {
    let duration = keys.get(index.checked_add(1)?)?.time_s - keys.get(index)?.time_s;
    (duration > 0.0).then_some(duration)
}

/// By Simpson's rule over the speed.
fn leg_length_m(keys: &[PathKey], index: usize) -> Option<f64> {
    let duration = leg_duration_s(keys, index)?;
    let from = keys.get(index)?.time_s - keys.first()?.time_s;
    let curve = PathCurve::new(&CameraPath::free(keys.to_vec()));
    let step = duration / f64::from(PIECES);
    let sum: f64 = (0..=PIECES)
        .map(|i| {
            let weight = if i == 0 || i == PIECES { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
            weight * curve.velocity_on_curve(from + step * f64::from(i)).length()
        })
        .sum();
    Some(sum * step / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn key(time_s: f64, x: f64, z: f64) -> PathKey {
        PathKey { time_s, position: DVec3::new(x, 500.0, z), heading_deg: 0.0, pitch_deg: 0.0, roll_deg: 0.0 }
    }

    fn winding() -> Vec<PathKey> {
        vec![key(2.0, 0.0, 0.0), key(5.0, 300.0, -100.0), key(9.0, 500.0, -700.0), key(20.0, -100.0, -900.0)]
    }

    #[test]
    fn the_leg_gets_the_speed_and_the_others_keep_their_durations() {
        let keys = winding();
        for index in 0..3 {
            for speed in [5.0, 80.0, 900.0] {
                let timed = with_speed_from(&keys, index, speed);
                let got = leg_speed_mps(&timed, index).expect("a leg");
                assert!((got / speed - 1.0).abs() < 1e-3, "{got} for {speed} m/s on leg {index}");
                for other in (0..3).filter(|other| *other != index) {
                    let [before, after] = [&keys, &timed].map(|keys| leg_duration_s(keys, other).expect("a leg"));
                    assert!((before - after).abs() < 1e-9, "leg {other}");
                }
                assert!(timed.iter().zip(&keys).all(|(new, old)| new.position == old.position));
                assert_eq!(timed[..=index], keys[..=index]);
            }
        }
    }

    #[test]
    fn a_straight_leg_in_closed_form() {
        let keys = [key(0.0, 0.0, 0.0), key(10.0, 300.0, -400.0)];
        assert!((leg_speed_mps(&keys, 0).expect("a leg") - 50.0).abs() < 1e-9);
        assert!((with_speed_from(&keys, 0, 100.0)[1].time_s - 5.0).abs() < 1e-9);
    }

    #[test]
    fn what_makes_no_sense_changes_nothing() {
        let mut keys = winding();
        for (index, speed) in
            [(3, 50.0), (99, 50.0), (usize::MAX, 50.0), (0, 0.0), (0, -5.0), (0, f64::NAN), (0, f64::INFINITY)]
        {
            assert_eq!(with_speed_from(&keys, index, speed), keys);
        }
        assert_eq!((leg_speed_mps(&keys, 3), leg_speed_mps(&[], 0)), (None, None));
        keys[1].position = keys[0].position;
        assert_eq!(with_speed_from(&keys, 0, 50.0), keys, "no way, no speed");
        assert_eq!(leg_speed_mps(&keys, 0), Some(0.0));
    }
}
