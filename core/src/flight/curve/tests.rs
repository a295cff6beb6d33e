//! What a flight may count on, along paths of every kind.

use super::*;
use crate::camera::View;
use proptest::prelude::*;

fn key(time_s: f64, position: [f64; 3], angles: [f64; 3]) -> PathKey {
    let [heading_deg, pitch_deg, roll_deg] = angles;
    PathKey { time_s, position: DVec3::from_array(position), heading_deg, pitch_deg, roll_deg }
}

fn curve(keys: &[PathKey]) -> PathCurve {
    PathCurve::new(&CameraPath::free(keys.to_vec()))
}

/// Degrees from one direction to another, the short way.
fn turned(from: f64, to: f64) -> f64 {
    unwrapped(to - from, 0.0).abs()
}

/// `keys`, whose times rise: passed, not overshot, without jumps in place or velocity.
fn check(keys: &[PathKey]) {
    let curve = curve(keys);
    let start_s = keys[0].time_s;
    for key in keys {
        let at = curve.at(key.time_s - start_s);
        assert_eq!(at.position, key.position);
        // Unwrapping adds whole turns, which rounds angles of some hundred degrees.
        assert!(turned(at.heading_deg, key.heading_deg) < 1e-9 && turned(at.roll_deg, key.roll_deg) < 1e-9);
        assert_eq!(at.pitch_deg, key.pitch_deg);
        assert!((0.0..=360.0).contains(&at.heading_deg) && (-180.0..=180.0).contains(&at.roll_deg));
    }
    for pair in keys.windows(2) {
        let [from_s, to_s] = [0, 1].map(|i| pair[i].time_s - start_s);
        let (low, high) = (pair[0].position.min(pair[1].position), pair[0].position.max(pair[1].position));
        let length_s = to_s - from_s;
        let chord = (pair[1].position - pair[0].position) / length_s;
        for i in 0..=50 {
            let t = (from_s + length_s * f64::from(i) / 50.0).min(to_s);
            let at = curve.at(t);
            assert!(at.position.cmpge(low).all() && at.position.cmple(high).all(), "{at:?} leaves {pair:?}");
            let turn = turned(pair[0].heading_deg, pair[1].heading_deg);
            assert!(turned(pair[0].heading_deg, at.heading_deg) <= turn + 1e-9, "the long way round: {at:?}");
            // With both end slopes within three chords, Fritsch and Carlson's cubic never exceeds three chords either.
            let velocity = curve.velocity_at(t);
            assert!(velocity.abs().cmple(chord.abs() * (3.0 + 1e-6) + 1e-9).all(), "{velocity} where {chord} is usual");
        }
        // Both sides of the key agree: the velocity changes by the acceleration, at most 12 chords in the leg's length
        // of either side, times the step.
        let step = 1e-7 * length_s;
        let (before, after) = (curve.velocity_on_curve(to_s - step), curve.velocity_on_curve(to_s));
        assert!((before - after).abs().cmple(chord.abs() * 2e-6 + 1e-9).all(), "{before} then {after}");
    }
}

fn some_keys() -> impl Strategy<Value = Vec<PathKey>> {
    let position = prop::array::uniform3(-5000.0..5000.0_f64);
    let angles = (-360.0..360.0_f64, -90.0..90.0_f64, -360.0..360.0_f64).prop_map(|(a, b, c)| [a, b, c]);
    prop::collection::vec((0.01..30.0_f64, position, angles), 2..12).prop_map(|steps| {
        let mut time_s = 0.0;
        let key_after = |(step, position, angles)| {
            time_s += step;
            key(time_s, position, angles)
        };
        steps.into_iter().map(key_after).collect()
    })
}

proptest! {
    #[test]
    fn passes_its_keys_smoothly_without_overshoot(keys in some_keys()) {
        check(&keys);
    }

    /// What the checks refuse has an answer all the same.
    #[test]
    fn never_a_number_that_is_none(times in prop::collection::vec(prop::sample::select(vec![0.0, 1.0, 1.0 + 1e-12, 2.0, 86400.0, f64::NAN]), 0..6), t in -10.0..1e5_f64) {
        let keys: Vec<_> = times.iter().enumerate().map(|(i, t)| key(*t, [1e7 * i as f64, 0.0, 5.0], [350.0, 0.0, 0.0])).collect();
        let curve = curve(&keys);
        for t in [t, f64::NEG_INFINITY, f64::INFINITY, f64::NAN] {
            prop_assert!(curve.at(t).position.is_finite() && curve.velocity_at(t).is_finite());
            prop_assert!(curve.at(t).heading_deg.is_finite() && curve.attitude_at(t).turn().is_finite());
        }
    }
}

#[test]
fn a_circle_and_a_loop_through_itself() {
    let around = |turns: f64, rise: f64| -> Vec<PathKey> {
        (0..=24)
            .map(|i| {
                let angle = f64::from(i) / 24.0 * turns * std::f64::consts::TAU;
                let place = [800.0 * angle.sin(), 1000.0 + rise * f64::from(i), -800.0 * angle.cos()];
                key(f64::from(i), place, [(angle.to_degrees() + 90.0) % 360.0, 0.0, 0.0])
            })
            .collect()
    };
    // A circle once and three times; and an eight, which crosses itself.
    check(&around(1.0, 0.0));
    check(&around(3.0, 20.0));
    let eight = |i: i32| {
        let angle = f64::from(i) / 16.0 * std::f64::consts::TAU;
        key(f64::from(i), [900.0 * angle.sin(), 1000.0, 400.0 * (2.0 * angle).sin()], [0.0; 3])
    };
    check(&(0..=16).map(eight).collect::<Vec<_>>());
}

#[test]
fn stands_still_where_there_is_no_way() {
    let only = key(7.0, [1.0, 2.0, 3.0], [10.0, 20.0, 30.0]);
    for keys in [vec![only], vec![only; 3], vec![only, key(6.0, [9.0; 3], [0.0; 3])]] {
        let curve = curve(&keys);
        assert_eq!(curve.duration_s(), 0.0);
        for t in [-1.0, 0.0, 1.0, 7.0] {
            assert_eq!((curve.at(t).position, curve.velocity_at(t)), (only.position, DVec3::ZERO));
            assert_eq!((curve.at(t).heading_deg, curve.at(t).pitch_deg), (10.0, 20.0));
        }
    }
    assert_eq!(curve(&[]).at(1.0), PathPoint::default());
}

#[test]
fn counts_from_its_first_key_and_holds_its_ends() {
    let curve = curve(&[key(10.0, [0.0; 3], [350.0, 0.0, 0.0]), key(14.0, [400.0, 0.0, 0.0], [10.0, 0.0, 0.0])]);
    assert_eq!(curve.duration_s(), 4.0);
    assert_eq!(curve.at(1.0).position.x, 100.0, "two keys make a straight line, flown evenly");
    assert_eq!(curve.velocity_at(4.0).x, 100.0);
    for (t, x) in [(-5.0, 0.0), (9.0, 400.0)] {
        assert_eq!((curve.at(t).position.x, curve.velocity_at(t)), (x, DVec3::ZERO));
    }
    assert!(turned(curve.at(2.0).heading_deg, 0.0) < 1e-9, "through north, not through south");
}

#[test]
fn a_thing_on_it_is_turned_as_the_camera_is() {
    for angles in [[0.0, 0.0, 0.0], [33.0, -20.0, 0.0], [200.0, 45.0, 70.0], [90.0, -89.0, -120.0]] {
        let curve = curve(&[key(0.0, [0.0; 3], angles)]);
        let view = View::new(&curve.camera_at(0.0), 100, 100);
        let turn = curve.at(0.0).turn();
        for (axis, of_view) in [(DVec3::NEG_Z, view.forward), (DVec3::X, view.right), (DVec3::Y, view.up)] {
            // The view's axes are in f32.
            assert!((turn * axis).distance(of_view.as_dvec3()) < 1e-6, "{axis} at {angles:?}");
        }
    }
}
