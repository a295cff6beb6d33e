//! What the wind has done by a time, against sums and steps that know nothing of closed forms.

use crate::timeline::dice::{BEYOND, Dice, track, value};
use cloudwright_core::scene::{Beyond, Handles, KeyValue, Leaves, Scene, Track, TrackId};
use cloudwright_core::weather::{Curve, Lean, MOST_LEAN, Timeline, Wind, WindTracks};
use glam::{DVec2, DVec4};
use std::ops::{Add, Mul};
use std::sync::Arc;
use std::time::Instant;

/// Ten of Gauss's and Legendre's nodes and weights on [−1, 1], those above 0.
const GAUSS: [[f64; 2]; 5] = [
    [0.148_874_338_981_631_2, 0.295_524_224_714_752_87],
    [0.433_395_394_129_247_2, 0.269_266_719_309_996_35],
    [0.679_409_568_299_024_4, 0.219_086_362_515_982_04],
    [0.865_063_366_688_984_5, 0.149_451_349_150_580_6],
    [0.973_906_528_517_171_7, 0.066_671_344_308_688_14],
];

/// ∫ f over [from, to], by ten nodes on each of `panels`: exact up to degree 19.
fn gauss<T: Add<Output = T> + Mul<f64, Output = T> + Default>(
    f: impl Fn(f64) -> T,
    [from, to]: [f64; 2],
    panels: u32,
) -> T {
    let half = 0.5 * (to - from) / f64::from(panels);
    let mut sum = T::default();
    for panel in 0..panels {
        let middle = from + half * f64::from(2 * panel + 1);
        for [node, weight] in GAUSS {
            sum = sum + (f(middle - half * node) + f(middle + half * node)) * (half * weight);
        }
    }
    sum
}

/// Direction, speed, shear, and a cloud's share of the wind.
struct Blowing {
    tracks: WindTracks,
    share: Arc<Curve>,
    /// What the curves came from.
    keys: [Track; 4],
}

impl Blowing {
    /// Of tracks of direction, speed, shear and share, in this order.
    fn new(keys: [Track; 4]) -> Self {
        let curve = |i: usize| Arc::new(Curve::new(&keys[i], i == 0));
        let tracks = WindTracks { from_deg: curve(0), speed_mps: curve(1), shear: curve(2) };
        Self { tracks, share: curve(3), keys }
    }

    fn wind(&self, lag_s: f64) -> Wind {
        Wind::new(self.tracks.clone(), lag_s).expect("it blows")
    }

    /// When any curve may have a kink or jump from second `from` to `to`, in order, with both.
    fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        let mut breaks = vec![from, to];
        for track in &self.keys {
            let times: Vec<f64> = track.keys.iter().map(|key| key.time_s).collect();
            let (first, last) = (times[0], times[times.len() - 1]);
            let span = last - first;
            let mut round = if span > 0.0 { ((from - first) / span).floor() - 1.0 } else { 0.0 };
            loop {
                for time in &times {
                    // Backwards too: one kink too many does no harm.
                    for there in [first + round * span + (time - first), first + round * span + (last - time)] {
                        breaks.extend((there > from && there < to).then_some(there));
                    }
                }
                round += 1.0;
                if !(span > 0.0 && first + round * span < to) {
                    break;
                }
            }
        }
        breaks.sort_by(f64::total_cmp);
        breaks
    }

    /// ∫ f from one time to another, on fine stretches.
    fn integral<T: Add<Output = T> + Mul<f64, Output = T> + Default>(
        &self,
        f: impl Fn(f64) -> T,
        [from, to]: [f64; 2],
        panels: u32,
    ) -> T {
        let breaks = self.breaks(from, to);
        breaks.windows(2).fold(T::default(), |sum, pair| sum + gauss(&f, [pair[0], pair[1]], panels))
    }

    /// East, south, by whichever way, and the shared way: what the wind carries in a second.
    fn velocity(&self, time_s: f64) -> [DVec4; 1] {
        let velocity = self.tracks.velocity_mps(time_s);
        [DVec4::new(velocity.x, velocity.y, velocity.length(), self.share.at(time_s, 0))]
    }
}

/// 2 to 5 keys, the first and last alike if `meets`, `span_s` from one to the other.
fn keys(dice: &mut Dice, range: [f64; 2], [start_s, span_s]: [f64; 2], leaves: &[Leaves]) -> Track {
    let count = 2 + dice.below(4);
    let at = |i: usize, off: f64| start_s + span_s * (i as f64 + off) / (count - 1) as f64;
    let inner = |i: usize| i > 0 && i < count - 1;
    let times: Vec<f64> = (0..count).map(|i| at(i, if inner(i) { dice.within([-0.3, 0.3]) } else { 0.0 })).collect();
    let mut values: Vec<f64> = (0..count).map(|_| dice.within(range)).collect();
    if dice.share() < 0.5 {
        values[count - 1] = values[0];
    }
    let mut track = track(&times, &values);
    track.keys.iter_mut().for_each(|key| key.leaves = dice.one_of(leaves));
    track
}

const ALL: [Leaves; 3] = [Leaves::Step, Leaves::Linear, Leaves::Smooth];

/// Winds of many kinds: that hold, repeat or swing, by periods that fit into one another or not, with steps and turns;
/// and up to when those that never fit are not begun anew.
fn winds() -> Vec<(String, Blowing, f64)> {
    let mut winds = Vec::new();
    for case in 0..40 {
        let mut dice = Dice::new(case);
        // Periods that fit within a few rounds, within hundreds, and never.
        let spans = dice.one_of(&[[60.0, 30.0, 20.0, 60.0], [60.0, 37.0, 41.0, 12.0], [60.0, 37.123_456_7, 29.0, 7.1]]);
        // Of one sign: at 0 the most lean has a kink that sums on fine stretches would have to know of.
        let shear = dice.one_of(&[[0.0, 2.0], [-1.0, 0.0]]);
        let mut make = |i: usize, range: [f64; 2]| {
            let start_s = dice.one_of(&[0.0, -25.0, 10.0, 12.5]);
            let mut track = keys(&mut dice, range, [start_s, spans[i]], &ALL);
            [track.before, track.after] = [dice.one_of(&BEYOND), dice.one_of(&BEYOND)];
            track
        };
        let mut tracks = [make(0, [-300.0, 300.0]), make(1, [10.0, 40.0]), make(2, shear), make(3, [0.0, 1.0])];
        for key in &mut tracks[0].keys {
            key.turns = dice.one_of(&[None, None, Some(1), Some(-2)]);
        }
        if case % 5 == 0 {
            // A cubic leaves its keys' range by at most 4/27 of a slope times its length: the wind stays above 0.
            let steep = Handles { arrives: KeyValue::One(1.0), leaves: KeyValue::One(-1.0) };
            tracks[1].keys[0].handles = Some(steep);
        }
        let exact_until_s = if spans.contains(&7.1) { 400.0 } else { 2_000.0 };
        winds.push((format!("wind {case}, spans {spans:?}"), Blowing::new(tracks), exact_until_s));
    }
    winds
}

/// The pieces are within 10⁻¹¹ of the fastest wind, here 40 m/s.
#[test]
fn ways_are_the_integrals() {
    for (name, blowing, exact_until_s) in winds() {
        let (wind, shared) = (blowing.wind(20.0), blowing.wind(20.0).shared(&blowing.share));
        let (mut sums, mut from) = ([DVec4::ZERO; 2], 0.0);
        for to in [3.0, 17.0, 40.0, 60.5, 95.0, 180.0, 399.0, 2_000.0].into_iter().filter(|to| *to <= exact_until_s) {
            let both = |time_s: f64| {
                let [all] = blowing.velocity(time_s);
                Two([all, DVec4::new(all.x, all.y, 0.0, 0.0) * all.w.clamp(0.0, 1.0)])
            };
            let Two(more) = blowing.integral(both, [from, to], 12);
            sums = [sums[0] + more[0], sums[1] + more[1]];
            from = to;
            let range = 1e-9 * 40.0 * to;
            let (way, blown, part) = (wind.way_m(to), wind.blown_m(to), shared.at(to));
            for (found, wanted) in
                [(way.x, sums[0].x), (way.y, sums[0].y), (blown, sums[0].z), (part[0], sums[1].x), (part[1], sums[1].y)]
            {
                assert!((found - wanted).abs() <= range, "{name} at {to} s: {found} m, want {wanted}");
            }
        }
    }
}

#[derive(Clone, Copy, Default)]
struct Two([DVec4; 2]);

impl Add for Two {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self([self.0[0] + other.0[0], self.0[1] + other.0[1]])
    }
}

impl Mul<f64> for Two {
    type Output = Self;
    fn mul(self, by: f64) -> Self {
        Self(self.0.map(|each| each * by))
    }
}

/// What all curves have in common comes again and again, so a hundred days are one round many times.
#[test]
fn far_times_are_rounds() {
    for case in 0..20 {
        let mut dice = Dice::new(case);
        let mut make = |range, span_s| {
            let mut track = keys(&mut dice, range, [0.0, span_s], &ALL);
            track.after = dice.one_of(&[Beyond::Repeat, Beyond::Swing]);
            track
        };
        let tracks = [make([0.0, 360.0], 60.0), make([0.0, 30.0], 40.0), make([0.0, 1.0], 24.0), make([1.0, 1.0], 1.0)];
        let blowing = Blowing::new(tracks);
        // Swinging, 120, 80 and 48 s begin anew together every 240 s.
        let wind = blowing.wind(20.0);
        let all = |time_s| blowing.velocity(time_s)[0];
        let round = blowing.integral(all, [0.0, 240.0], 12);
        for (rounds, rest) in [(41_666.0, 160.0), (41_666.0, 3.25), (4_166.0, 239.0)] {
            let wanted = round * rounds + blowing.integral(all, [0.0, rest], 12);
            let time_s = 240.0 * rounds + rest;
            let found = wind.way_m(time_s).extend(wind.blown_m(time_s));
            let off = (found - wanted.truncate()).abs().max_element();
            assert!(off <= 1e-9 * 30.0 * time_s, "{case} at {time_s} s: off by {off} m");
        }
    }
}

/// Periods that never fit are begun anew together after thousands of seconds: from there on the wind is as strong as
/// before on the whole, and goes the same way.
#[test]
fn periods_that_never_fit_go_on_as_they_began() {
    for (name, blowing, _) in winds() {
        let wind = blowing.wind(20.0);
        let mean = |from: f64, to: f64| {
            let way = wind.way_m(to).extend(wind.blown_m(to)) - wind.way_m(from).extend(wind.blown_m(from));
            way / (to - from)
        };
        // 30 to 60 rounds of the longest period, which may end within one: within a fifteenth of twice 40 m/s.
        let off = (mean(200.0, 3_800.0) - mean(200.0, 1e7)).abs().max_element();
        assert!(off < 80.0 / 15.0, "{name}: off by {off} m/s");
    }
}

/// d' = (u − d)/τ in exact steps, each small beside τ and between kinks: d e^(−h/τ) + ∫ u e^(−(h − s)/τ) ds/τ. What
/// was more than 45 τ ago counts for e⁻⁴⁵.
fn stepped(blowing: &Blowing, time_s: f64, lag_s: f64) -> DVec4 {
    let striven = |time_s: f64| {
        let Lean { middle, shear } = blowing.tracks.striven_for(time_s);
        DVec4::new(middle.x, middle.y, shear.x, shear.y)
    };
    let from = (time_s - 45.0 * lag_s).max(0.0);
    let mut lean = striven(from);
    for pair in blowing.breaks(from, time_s).windows(2) {
        let steps = ((pair[1] - pair[0]) / (0.5 * lag_s)).ceil().clamp(8.0, 1e6);
        let step_s = (pair[1] - pair[0]) / steps;
        for i in 0..steps as u32 {
            let start = pair[0] + f64::from(i) * step_s;
            let followed = |s: f64| striven(start + s) * ((s - step_s) / lag_s).exp() * (1.0 / lag_s);
            lean = lean * (-step_s / lag_s).exp() + gauss(followed, [0.0, step_s], 1);
        }
    }
    lean
}

fn lean_of(wind: &Wind, time_s: f64) -> DVec4 {
    let Lean { middle, shear } = wind.lean(time_s);
    DVec4::new(middle.x, middle.y, shear.x, shear.y)
}

/// With lags of a millisecond to an hour, within 10⁻⁹ of the most that edges lean; and at no time further than that, at a
/// cloud's top or bottom.
#[test]
fn edges_follow_with_their_lag() {
    for (name, blowing, exact_until_s) in winds() {
        for lag_s in [1e-3, 0.4, 20.0, 3600.0] {
            let wind = blowing.wind(lag_s);
            let times = [0.0, 0.01, 12.5, 12.5001, 47.0, 61.0, 390.0, 600.0, 1999.0];
            for time_s in times.into_iter().filter(|time_s| *time_s <= exact_until_s) {
                let (found, wanted) = (lean_of(&wind, time_s), stepped(&blowing, time_s, lag_s));
                let off = (found - wanted).abs().max_element();
                assert!(off <= 1e-9 * MOST_LEAN, "{name}, lag {lag_s} s, at {time_s} s: {found}, want {wanted}");
            }
            for i in 0..500 {
                let time_s = 1.37_f64.powi(i % 50) - 1.0 + f64::from(i);
                let Lean { middle, shear } = wind.lean(time_s);
                for end in [middle - 0.5 * shear, middle + 0.5 * shear] {
                    assert!(end.length() <= MOST_LEAN * (1.0 + 1e-9), "{name}, {lag_s} s, at {time_s} s: {end}");
                }
            }
        }
    }
}

fn blowing(speed: Track) -> Blowing {
    let constant = |value| track(&[0.0], &[value]);
    Blowing::new([constant(270.0), speed, constant(0.5), constant(1.0)])
}

/// A wind that jumps from calm to a storm and back, each ten seconds, with a lag of a millisecond: before and after the
/// jump, in the middle of it, and after ten minutes in which nobody asked.
#[test]
fn a_jump_is_followed_at_any_lag() {
    let mut gusts = track(&[0.0, 10.0, 20.0], &[0.0, 60.0, 0.0]);
    gusts.keys.iter_mut().for_each(|key| key.leaves = Leaves::Step);
    gusts.after = Beyond::Repeat;
    let blowing = blowing(gusts);
    for lag_s in [1e-3, 1.0, 600.0] {
        let wind = blowing.wind(lag_s);
        for time_s in [9.999_999, 10.0, 10.000_1, 10.001, 10.01, 20.0, 20.000_5, 619.0, 630.5] {
            let (found, wanted) = (lean_of(&wind, time_s), stepped(&blowing, time_s, lag_s));
            let off = (found - wanted).abs().max_element();
            // Seconds near 600 are rounded by 10⁻¹³, a ten-thousand-millionth of the shortest lag.
            assert!(off <= 1e-9 * MOST_LEAN, "lag {lag_s} s, at {time_s} s: {found}, want {wanted}");
        }
        // Rounds of 20 s, far out: seconds there are rounded by 10⁻⁹, a millionth of a millisecond.
        let far = (lean_of(&wind, 1e7 + 13.0) - stepped(&blowing, 1e7 + 13.0, lag_s)).abs().max_element();
        assert!(far <= 1e-5, "lag {lag_s} s, far out: off by {far}");
    }
}

#[test]
fn any_order_of_times_gives_the_same_bits() {
    for (name, blowing, _) in winds().into_iter().take(12) {
        let wind = blowing.wind(20.0);
        let times: Vec<f64> = (0..200).map(|i| f64::from(i) * 7.31 - 20.0).collect();
        let all = |time_s: f64| {
            let (lean, way) = (lean_of(&wind, time_s), wind.way_m(time_s));
            [lean.x, lean.y, lean.z, lean.w, way.x, way.y, wind.blown_m(time_s)].map(f64::to_bits)
        };
        let in_order: Vec<_> = times.iter().map(|time_s| all(*time_s)).collect();
        for i in 0..times.len() {
            let at = i * 77 % times.len();
            assert_eq!(all(times[at]), in_order[at], "{name} at {} s", times[at]);
        }
    }
}

#[test]
fn any_clock_gives_a_number() {
    for (name, blowing, _) in winds() {
        let wind = blowing.wind(20.0);
        for time_s in [-1e7, -0.0, 1e7, 1e300, f64::MAX, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            let (lean, way) = (lean_of(&wind, time_s), wind.way_m(time_s));
            assert!(lean.is_finite() && way.is_finite() && wind.blown_m(time_s).is_finite(), "{name} at {time_s} s");
        }
        assert_eq!(wind.way_m(-5.0), DVec2::ZERO);
    }
}

/// Steep handles have speed and shear leave their ranges: the wind stays within them.
#[test]
fn handles_do_not_have_the_wind_leave_its_range() {
    let steep = |at: f64, slope: f64| {
        let mut track = track(&[0.0, 10.0], &[at, at]);
        let handles = Handles { arrives: KeyValue::One(-slope), leaves: KeyValue::One(slope) };
        track.keys.iter_mut().for_each(|key| key.handles = Some(handles.clone()));
        track.after = Beyond::Swing;
        track
    };
    for slope in [-1e308, -1e4, 1e4, 1e308] {
        let tracks = [steep(20.0, slope), steep(20.0, slope), steep(0.5, slope), steep(0.5, slope)];
        let blowing = Blowing::new(tracks);
        let wind = blowing.wind(1.0);
        let shared = wind.shared(&blowing.share);
        for i in 0..200 {
            let time_s = f64::from(i) * 0.31;
            let Lean { middle, shear } = wind.lean(time_s);
            assert!((middle + 0.5 * shear).length().max((middle - 0.5 * shear).length()) <= MOST_LEAN * (1.0 + 1e-6));
            assert!(wind.blown_m(time_s) <= 150.0 * time_s + 1e-6, "{slope}: {}", wind.blown_m(time_s));
            assert!(DVec2::from(shared.at(time_s)).length() <= wind.blown_m(time_s) + 1e-6);
        }
    }
    let range = |path: &str| {
        let target: cloudwright_core::property::Target = path.parse().expect("it can be keyed");
        target.property.kind.number().map(|number| [number.min, number.max])
    };
    assert_eq!(range("weather/wind_speed_mps"), Some([0.0, 150.0]), "as the wind has it");
    assert_eq!(range("weather/wind_shear"), Some([-4.0, 4.0]), "as the wind has it");
}

/// Gusts of five seconds beside a wind that veers over a day: some 100,000 kinks, most of which are a blur. The way is
/// the mean speed's; the gusts' mean over a veer of half a turn a day is right to 5/86,400.
#[test]
fn what_comes_too_often_counts_by_its_mean() {
    let mut gusts = track(&[0.0, 1.0, 2.0, 3.0, 4.5, 5.0], &[4.0, 12.0, 6.0, 17.0, 5.0, 4.0]);
    gusts.after = Beyond::Repeat;
    let blowing =
        Blowing::new([track(&[0.0, 86_400.0], &[180.0, 330.0]), gusts, track(&[0.0], &[0.5]), track(&[0.0], &[1.0])]);
    let wind = blowing.wind(20.0);
    for time_s in [500.0, 10_000.0, 86_400.0, 100_000.0] {
        let all = blowing.integral(|time_s| blowing.velocity(time_s)[0], [0.0, time_s], 1);
        let found = wind.way_m(time_s).extend(wind.blown_m(time_s));
        let off = (found - all.truncate()).length();
        assert!(off <= 1e-4 * all.z, "at {time_s} s: {found}, want {all}");
    }
}

/// Within seconds, and with no more pieces than memory has room for.
#[test]
fn no_track_is_too_quick_or_too_long() {
    let quick = |beyond: [Beyond; 2], start_s: f64| {
        let mut track = track(&[start_s, start_s + 4e-4, start_s + 1e-3], &[0.0, 30.0, 0.0]);
        track.keys[1].leaves = Leaves::Step;
        [track.before, track.after] = beyond;
        track
    };
    let late = |at: f64| track(&[0.0, at], &[0.0, 300.0]);
    let many: Vec<f64> = (0..100_000).map(|i| f64::from(i) * 0.5).collect();
    let mut long = track(&many, &many.iter().map(|time_s| 10.0 + 8.0 * time_s.sin()).collect::<Vec<_>>());
    long.after = Beyond::Repeat;
    let one = |value: f64| track(&[0.0], &[value]);
    for (name, tracks) in [
        ("each millisecond", [late(1e8), quick([Beyond::Hold, Beyond::Repeat], 0.0), one(0.5), one(1.0)]),
        ("before all keys", [late(10.0), quick([Beyond::Swing, Beyond::Hold], 1e8 - 1.0), one(0.5), one(1.0)]),
        ("from long ago", [late(1e8), quick([Beyond::Hold, Beyond::Swing], -1e8), one(0.5), one(1.0)]),
        ("100,000 keys", [late(60.0), long.clone(), one(0.5), one(1.0)]),
        ("100,000 keys and quick ones", [quick([Beyond::Repeat; 2], 3.0), long, late(1e8), one(1.0)]),
        ("many turns", {
            let mut turning = late(3600.0);
            turning.keys[0].turns = Some(i32::MAX);
            turning.after = Beyond::Repeat;
            [turning, one(10.0), one(0.5), one(1.0)]
        }),
    ] {
        let began = Instant::now();
        let wind = Blowing::new(tracks.clone()).wind(20.0);
        // A hundred times what it takes.
        assert!(began.elapsed().as_secs() < 60, "{name}: {:?}", began.elapsed());
        let fastest = tracks[1].keys.iter().map(value).fold(0.0, f64::max);
        for time_s in [0.0, 1e-3, 5.0, 1e4, 1e6, 1e8, 1e9] {
            let Lean { middle, shear } = wind.lean(time_s);
            let ends = (middle + 0.5 * shear).length().max((middle - 0.5 * shear).length());
            assert!(ends <= MOST_LEAN * (1.0 + 1e-4), "{name} at {time_s} s: {ends}");
            let way = wind.way_m(time_s).length().max(wind.blown_m(time_s));
            assert!(way <= fastest * time_s * (1.0 + 1e-4), "{name} at {time_s} s: {way} m");
        }
    }
}

/// The share of a cloud that is keyed, through the door that clouds take.
#[test]
fn a_keyed_share_is_the_clouds_own_way() {
    let mut scene: Scene = cloudwright_tests::small_scenes::heap(3);
    scene.weather.wind_speed_mps = 12.0;
    let cloud = scene.clouds[0].id;
    let address = format!("cloud/{cloud}/wind_share");
    let ramp = track(&[0.0, 10.0], &[0.0, 1.0]);
    let mut keyed = Track { id: TrackId::new(&mut scene.next_id), property: address, ..ramp };
    keyed.keys[0].leaves = Leaves::Linear;
    scene.tracks.push(keyed);
    let timeline = Timeline::new(&scene);
    // From the west, so eastwards: 12 ∫ t/10 dt up to 10 s, and 12 m/s from there on.
    for (clock_s, east_m) in [(0.0, 0.0), (5.0, 15.0), (10.0, 60.0), (20.0, 180.0)] {
        let way = timeline.way_m(cloud, clock_s).expect("its share is keyed");
        assert!((way - DVec2::new(east_m, 0.0)).length() < 1e-9, "at {clock_s} s: {way}");
    }
}
