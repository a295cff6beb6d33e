//! Curves of many random tracks.

use super::dice::{BEYOND, Dice, track, value};
use cloudwright_core::scene::{Beyond, Handles, KeyValue, Leaves, Track};
use cloudwright_core::weather::Curve;

const CASES: u64 = 400;
const ALL: [Leaves; 3] = [Leaves::Step, Leaves::Linear, Leaves::Smooth];

/// Shows `f` each stretch of `track` with times in it, a hundred and both ends, close to which they lie closely.
fn each_stretch(track: &Track, mut f: impl FnMut(usize, &[f64])) {
    for (i, pair) in track.keys.windows(2).enumerate() {
        let [from, to] = [pair[0].time_s, pair[1].time_s];
        let share = |k: i32| 0.5 - 0.5 * (std::f64::consts::PI * f64::from(k) / 101.0).cos();
        let mut times: Vec<f64> = (1..=100).map(|k| from + (to - from) * share(k)).collect();
        times.insert(0, from);
        times.push(to);
        f(i, &times);
    }
}

/// What a cubic between two values may be off by: its coefficients are at most the first value and 24 times the rise,
/// and each of six operations rounds.
fn rounding(from: f64, to: f64) -> f64 {
    6.0 * f64::EPSILON * (from.abs() + 24.0 * (to - from).abs())
}

#[test]
fn monotone_keys_give_monotone_values() {
    for case in 0..CASES {
        let mut dice = Dice::new(case);
        let mut track = dice.track([-5.0, 5.0], &ALL);
        let mut values: Vec<f64> = track.keys.iter().map(value).collect();
        values.sort_by(f64::total_cmp);
        track.keys.iter_mut().zip(&values).for_each(|(key, value)| key.value = KeyValue::One(*value));
        let curve = Curve::new(&track, false);
        each_stretch(&track, |i, times| {
            let allowed = rounding(values[i], values[i + 1]);
            for pair in times.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|time_s| curve.at(time_s, 0));
                assert!(b >= a - allowed, "{case}: {a} at {} s, then {b} at {}", pair[0], pair[1]);
            }
        });
    }
}

#[test]
fn no_stretch_leaves_the_range_of_its_keys() {
    for case in 0..CASES {
        let track = Dice::new(case).track([-1e3, 1e3], &ALL);
        let curve = Curve::new(&track, false);
        each_stretch(&track, |i, times| {
            let [from, to] = [value(&track.keys[i]), value(&track.keys[i + 1])];
            // The last time is the next stretch's.
            for time_s in &times[..times.len() - 1] {
                let at = curve.at(*time_s, 0);
                assert!((from.min(to)..=from.max(to)).contains(&at), "{case}: {at} between {from} and {to}");
            }
            assert_eq!(curve.at(times[0], 0), from, "{case}: at the key itself");
        });
    }
}

#[test]
fn steps_and_lines_are_exact() {
    for case in 0..CASES {
        let track = Dice::new(case).track([-9.0, 9.0], &[Leaves::Step, Leaves::Linear]);
        let curve = Curve::new(&track, false);
        each_stretch(&track, |i, times| {
            let [from, to] = [&track.keys[i], &track.keys[i + 1]];
            for time_s in &times[..times.len() - 1] {
                let (at, share) = (curve.at(*time_s, 0), (time_s - from.time_s) / (to.time_s - from.time_s));
                let [before, after] = [value(from), value(to)];
                match from.leaves {
                    Leaves::Step => assert_eq!(at, before, "{case}"),
                    _ => assert!((at - (before + share * (after - before))).abs() <= rounding(before, after), "{case}"),
                }
            }
        });
    }
}

/// The slope on one side of `time_s`, by a small step.
fn slope(curve: &Curve, time_s: f64, step_s: f64) -> f64 {
    (curve.at(time_s + step_s, 0) - curve.at(time_s, 0)) / step_s
}

/// On a stretch of one second, by steps of 10⁻⁷: the cubic's second derivative is at most 6 rises and 4 slopes and 2, so
/// these slopes are off by some 10⁻⁷ · 40, and by the rounding of values of some 4, 10⁻¹⁵, through the step: 10⁻⁸.
#[test]
fn handles_are_the_slopes() {
    for case in 0..CASES {
        let mut dice = Dice::new(case);
        let mut roll = || dice.within([-4.0, 4.0]);
        let mut track = track(&[0.0, 1.0, 2.0], &[roll(), roll(), roll()]);
        let [arrives, leaves] = [roll(), roll()];
        track.keys[1].handles = Some(Handles { arrives: KeyValue::One(arrives), leaves: KeyValue::One(leaves) });
        let curve = Curve::new(&track, false);
        for (step_s, wanted) in [(-1e-7, arrives), (1e-7, leaves)] {
            let found = slope(&curve, 1.0, step_s);
            assert!((found - wanted).abs() < 1e-5, "{case}: {found}, want {wanted}");
        }
        assert_eq!(curve.at(1.0, 0), value(&track.keys[1]));
    }
}

/// Fritsch's and Butland's slope at a key between a short and a long stretch is mostly the short one's: of 1 and 4 a
/// second over 1 and 9 seconds, (1 + 2·9) and (2·1 + 9) weigh their inverses, 30/(19/1 + 11/4).
#[test]
fn the_nearer_neighbour_counts_more() {
    let curve = Curve::new(&track(&[-1.0, 0.0, 9.0], &[-1.0, 0.0, 36.0]), false);
    for step_s in [-1e-7, 1e-7] {
        let found = slope(&curve, 0.0, step_s);
        assert!((found - 30.0 / 21.75).abs() < 1e-5, "{found}");
    }
}

#[test]
fn angles_go_the_short_way_unless_told_to_turn() {
    for case in 0..CASES {
        let mut dice = Dice::new(case);
        let mut track = dice.track([-360.0, 360.0], &ALL);
        for key in &mut track.keys {
            key.turns = dice.one_of(&[None, None, Some(0), Some(3), Some(-2)]);
        }
        let curve = Curve::new(&track, true);
        let at_key = |i: usize| curve.at(track.keys[i].time_s, 0);
        for (i, key) in track.keys.iter().enumerate() {
            let rounds = (at_key(i) - value(key)) / 360.0;
            assert_eq!(at_key(i), value(key) + 360.0 * rounds.round(), "{case}: the key's own angle");
        }
        for i in 1..track.keys.len() {
            let [before, after] = [&track.keys[i - 1], &track.keys[i]];
            let (turned, apart) = (at_key(i) - at_key(i - 1), value(after) - value(before));
            match before.turns {
                Some(turns) => assert!((turned - apart - 360.0 * f64::from(turns)).abs() < 1e-9, "{case}: {turned}"),
                None => assert!(turned > -180.0 - 1e-9 && turned <= 180.0 + 1e-9, "{case}: {turned}"),
            }
        }
    }
    let half = |from, to| Curve::new(&track(&[0.0, 1.0], &[from, to]), true).at(0.5, 0);
    for (from, to, wanted) in
        [(350.0, 10.0, 360.0), (10.0, 350.0, 0.0), (0.0, 180.0, 90.0), (180.0, 0.0, 270.0), (-170.0, 170.0, -180.0)]
    {
        assert_eq!(half(from, to), wanted, "from {from} to {to}");
    }
}

/// A value's jump over `2 step_s` around `time_s`, by its cycle, and how the slopes on both sides differ.
fn seam(curve: &Curve, time_s: f64, step_s: f64, cycle: Option<f64>) -> [f64; 2] {
    let near = |apart: f64| cycle.map_or(apart, |cycle| apart - cycle * (apart / cycle).round()).abs();
    let at = |steps: f64| curve.at(time_s + steps * step_s, 0);
    let [before, after] = [at(-1.0) - at(-2.0), at(2.0) - at(1.0)];
    [near(at(1.0) - at(-1.0)), (near(before) - near(after)).abs() / step_s]
}

/// Keys a second or more apart and values within 10 have slopes of at most 30, and second derivatives below 300: by steps
/// of 10⁻⁵ s values across a seam without a jump differ by less than 10⁻³, slopes by less than 10⁻².
#[test]
fn what_repeats_and_meets_itself_goes_on_through_its_seam() {
    for case in 0..CASES {
        let mut dice = Dice::new(case);
        let count = 3 + dice.below(5);
        let times: Vec<f64> = (0..count).map(|i| 1.5 * i as f64 + dice.within([0.0, 0.4])).collect();
        let mut values: Vec<f64> = (0..count).map(|_| dice.within([0.0, 10.0])).collect();
        let address = dice.one_of(&["sky/exposure_ev", "weather/wind_from_deg", "time_of_day_h"]);
        let target = address.parse().expect("it can be keyed");
        let cycle = match address {
            "weather/wind_from_deg" => Some(360.0),
            "time_of_day_h" => Some(24.0),
            _ => None,
        };
        values[count - 1] = values[0];
        let mut track = track(&times, &values);
        if address == "time_of_day_h" {
            // A day runs on into the next.
            let hours = |i: usize| 24.0 * (times[i] - times[0]) / (times[count - 1] - times[0]);
            (0..count).for_each(|i| track.keys[i].value = KeyValue::One(values[0] + hours(i)));
        }
        [track.before, track.after] = [dice.one_of(&BEYOND[1..]); 2];
        let (curve, span) = (Curve::of(&track, &target), times[count - 1] - times[0]);
        for round in [-3.0, 0.0, 1.0, 2.0, 7.0] {
            let [jump, kink] = seam(&curve, times[0] + round * span, 1e-5, cycle);
            assert!(jump < 1e-3, "{case}, {address}: it jumps by {jump} at round {round}");
            assert!(kink < 1e-2, "{case}, {address}: its slope by {kink} at round {round}");
        }
        let days_go_on = address != "time_of_day_h" || track.after != Beyond::Repeat || {
            let kept = seam(&curve, times[0] + span, 1e-5, cycle);
            slope(&curve, times[0] + span + 1e-6, 1e-5) > 0.5 && kept[0] < 1e-3
        };
        assert!(days_go_on, "{case}: a day that repeats stands still at its seam");
    }
}

#[test]
fn what_swings_runs_back_as_it_came() {
    for case in 0..CASES {
        let mut dice = Dice::new(case);
        let mut track = dice.track([-1.0, 1.0], &[Leaves::Linear, Leaves::Smooth]);
        [track.before, track.after] = [Beyond::Swing; 2];
        let curve = Curve::new(&track, false);
        let [first, last] = curve.ends_s();
        let span = last - first;
        for _ in 0..20 {
            let over = dice.within([0.0, 1.0]) * span;
            for (time_s, same_as) in
                [(last + over, last - over), (first - over, first + over), (last + 2.0 * span + over, last - over)]
            {
                // Times of up to a thousand seconds round by 10⁻¹³, slopes of keys 10⁻² apart are below 600.
                let [found, wanted] = [time_s, same_as].map(|time_s| curve.at(time_s, 0));
                assert!((found - wanted).abs() < 1e-9, "{case}: {found} at {time_s} s, {wanted} at {same_as} s");
            }
        }
    }
}

#[test]
fn what_holds_holds_and_one_key_is_a_constant() {
    for case in 0..CASES {
        let mut dice = Dice::new(case);
        let mut track = dice.track([-1.0, 1.0], &ALL);
        if dice.share() < 0.3 {
            track.keys.truncate(1);
        } else {
            [track.before, track.after] = [Beyond::Hold; 2];
        }
        let curve = Curve::new(&track, false);
        let [first, last] = [track.keys.first(), track.keys.last()].map(|key| key.expect("one at least"));
        for over in [1e-9, 1.0, 1e7, f64::INFINITY] {
            assert_eq!(curve.at(first.time_s - over, 0), value(first), "{case}");
            assert_eq!(curve.at(last.time_s + over, 0), value(last), "{case}");
        }
    }
}

#[test]
fn any_clock_gives_a_number() {
    let clocks = [0.0, 1e7, 1e8, 1e12, 1e300, f64::MAX, f64::INFINITY, f64::MIN_POSITIVE];
    for case in 0..CASES {
        let mut dice = Dice::new(case);
        let mut track = dice.track([-1e9, 1e9], &ALL);
        for key in &mut track.keys {
            let slope = dice.one_of(&[0.0, 1.0, -1e300, 1e308, f64::MAX, f64::MIN]);
            let handles = Handles { arrives: KeyValue::One(-slope), leaves: KeyValue::One(slope) };
            key.handles = (dice.share() < 0.3).then_some(handles);
        }
        for turns in [false, true] {
            let curve = Curve::new(&track, turns);
            let ends = curve.ends_s();
            let odd = [f64::NAN, 0.5 * (ends[0] + ends[1])];
            for clock_s in clocks.into_iter().flat_map(|clock_s| [clock_s, -clock_s]).chain(odd) {
                assert!(curve.at(clock_s, 0).is_finite(), "{case}: at {clock_s} s");
                assert_eq!(curve.all_at(clock_s)[0], curve.at(clock_s, 0));
            }
        }
    }
}
