//! From what was flown to a path that an artist can edit: a few keys instead of sixty a second.
//!
//! As Douglas and Peucker (1973) thin lines, from the top down: begin with first and last sample, and make the sample
//! that the curve misses by most a key, until it misses none by more than the tolerance. Judged is the curve that will
//! be flown, not the chords between its keys. A new key bends the curve no farther than two keys away, so only these
//! legs are looked at again.

use super::{PathCurve, SHORTEST_LEG_S};
use crate::scene::{CameraPath, PathKey};

/// Some of `samples`, as few as the search finds, such that the curve through them passes each sample within
/// `tolerance_m` metres and each of its angles within `tolerance_deg`. Samples that don't come [`SHORTEST_LEG_S`] after
/// the one before are passed over.
pub fn keys_from_samples(samples: &[PathKey], tolerance_m: f64, tolerance_deg: f64) -> Vec<PathKey> {
    let mut flown: Vec<PathKey> = Vec::new();
    for sample in samples {
        if flown.last().is_none_or(|last| sample.time_s >= last.time_s + SHORTEST_LEG_S) {
            flown.push(*sample);
        }
    }
    let Some(last) = flown.len().checked_sub(1).filter(|last| *last > 0) else { return flown };
    let start_s = flown[0].time_s;
    let miss = |curve: &PathCurve, sample: &PathKey| {
        let at = curve.at(sample.time_s - start_s);
        let apart = at.position.distance(sample.position) / tolerance_m.max(f64::MIN_POSITIVE);
        let angles =
            [(at.heading_deg, sample.heading_deg), (at.pitch_deg, sample.pitch_deg), (at.roll_deg, sample.roll_deg)];
        let turned = angles.into_iter().map(|(a, b)| turned(a, b)).fold(0.0, f64::max);
        apart.max(turned / tolerance_deg.max(f64::MIN_POSITIVE))
    };
    // Which samples are keys; and of each leg the sample that is missed by most, and by how many tolerances.
    let mut chosen = vec![0, last];
    let mut worst = vec![(0, 0.0)];
    let mut stale = 0..1;
    loop {
        let keys: Vec<PathKey> = chosen.iter().map(|i| flown[*i]).collect();
        let curve = PathCurve::new(&CameraPath::free(keys.clone()));
        for leg in stale {
            let within = chosen[leg] + 1..chosen[leg + 1];
            let misses = within.map(|i| (i, miss(&curve, &flown[i])));
            worst[leg] = misses.fold((0, 0.0), |worst, each| if each.1 > worst.1 { each } else { worst });
        }
        let most = worst.iter().enumerate().max_by(|a, b| a.1.1.total_cmp(&b.1.1));
        let Some((leg, (sample, _))) = most.filter(|(_, (_, miss))| *miss > 1.0) else { return keys };
        chosen.insert(leg + 1, *sample);
        worst.insert(leg + 1, (0, 0.0));
        stale = leg.saturating_sub(2)..(leg + 4).min(worst.len());
    }
}

/// Degrees between two directions, 0 to 180.
fn turned(from: f64, to: f64) -> f64 {
    let turn = (to - from).rem_euclid(360.0);
    turn.min(360.0 - turn)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{draw, unit};
    use glam::DVec3;

    fn helix(seconds: f64, shake_m: f64) -> Vec<PathKey> {
        let sample = |i: u32| {
            let t = f64::from(i) / 60.0;
            let angle = 0.2 * t;
            let shake = draw(3, 0, i, 0).map(|bits| (unit(bits) - 0.5) * 2.0 * shake_m);
            PathKey {
                time_s: 5.0 + t,
                position: DVec3::new(
                    400.0 * angle.sin() + shake[0],
                    900.0 + 3.0 * t + shake[1],
                    -400.0 * angle.cos() + shake[2],
                ),
                heading_deg: (angle.to_degrees() + 90.0) % 360.0,
                pitch_deg: 2.0,
                roll_deg: 30.0,
            }
        };
        (0..(seconds * 60.0) as u32).map(sample).collect()
    }

    fn check(samples: &[PathKey], tolerance_m: f64, tolerance_deg: f64, most: usize) {
        let keys = keys_from_samples(samples, tolerance_m, tolerance_deg);
        assert_eq!((keys.first(), keys.last()), (samples.first(), samples.last()));
        let curve = PathCurve::new(&CameraPath::free(keys.clone()));
        for sample in samples {
            let at = curve.at(sample.time_s - samples[0].time_s);
            let apart = at.position.distance(sample.position);
            assert!(apart <= tolerance_m, "{apart} m at {}", sample.time_s);
            assert!(turned(at.heading_deg, sample.heading_deg) <= tolerance_deg);
        }
        assert!(keys.len() <= most, "{} keys of {} samples", keys.len(), samples.len());
    }

    #[test]
    fn few_keys_for_a_smooth_flight() {
        // Two minutes, nearly four turns. Worst is a leg of angle a with its middle where a coordinate turns: it is flat
        // there and misses by r·a²/8. So a key each 8.1° keeps 1 m for sure, each 25.6° 10 m: 170 and 54 keys.
        check(&helix(120.0, 0.0), 1.0, 0.5, 170);
        check(&helix(120.0, 0.0), 10.0, 5.0, 54);
    }

    #[test]
    fn a_straight_line_needs_its_ends() {
        let line: Vec<_> = (0..600)
            .map(|i| PathKey {
                time_s: f64::from(i),
                position: DVec3::X * f64::from(i),
                heading_deg: 90.0,
                pitch_deg: 0.0,
                roll_deg: 0.0,
            })
            .collect();
        check(&line, 0.01, 0.01, 2);
        check(&line[..1], 0.01, 0.01, 1);
        check(&[line[0], line[0], line[1]], 0.01, 0.01, 2);
        assert_eq!(keys_from_samples(&[], 1.0, 1.0), []);
    }

    #[test]
    fn noise_within_the_tolerance_costs_little_and_beyond_it_is_kept() {
        let noisy = helix(60.0, 0.2);
        // Keys and samples are each off by up to 0.2·√3 m, so 0.3 m are left for the curve: a key each 4.4°.
        check(&noisy, 1.0, 0.5, 156);
        check(&noisy, 0.05, 0.5, noisy.len());
        check(&noisy, 0.0, 0.0, noisy.len());
    }
}
