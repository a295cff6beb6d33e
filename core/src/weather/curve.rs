//! The curve of a track: a value at any time, from keys alone.
//!
//! On the edit clock each stretch between two keys becomes a cubic of the share of the stretch that is over; one value is
//! then a search among the keys and one cubic. A smooth stretch takes its slopes from Fritsch and Carlson (*Monotone
//! Piecewise Cubic Interpolation*, 1980; the harmonic mean of Fritsch and Butland, 1984): it rises where its keys do, is
//! flat where neighbours are equal, and never overshoots. A track that repeats goes on through its seam without a kink.

use crate::scene::{Beyond, Handles, KeyValue, Leaves, Track, TrackKey};

/// A track's values over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    times: Vec<f64>,
    /// Of each part, the stretches between the times.
    parts: Vec<Vec<Stretch>>,
    /// Of each part, the last key's value.
    last: Vec<f64>,
    before: Beyond,
    after: Beyond,
}

/// One number between two keys.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stretch {
    /// Of the powers of the share that is over.
    powers: [f64; 4],
    /// What it stays within; beyond all bounds where handles shape it.
    within: [f64; 2],
}

impl Curve {
    /// Of `track`, whose keys are sound; `turns`: its values are angles in degrees.
    pub fn new(track: &Track, turns: bool) -> Self {
        let keys = &track.keys;
        let count = keys.iter().map(|key| key.value.parts().len()).min().unwrap_or(0);
        let times: Vec<f64> = keys.iter().map(|key| key.time_s).collect();
        let loops = [track.before, track.after].contains(&Beyond::Repeat);
        let values_of = |part: usize| -> Vec<f64> {
            if turns { unwound(keys, part) } else { keys.iter().map(|key| key.value.parts()[part]).collect() }
        };
        let values: Vec<Vec<f64>> = (0..count).map(values_of).collect();
        let parts =
            values.iter().enumerate().map(|(part, values)| stretches(keys, values, part, loops, turns)).collect();
        let last = values.iter().map(|values| values.last().copied().unwrap_or(0.0)).collect();
        Self { times, parts, last, before: track.before, after: track.after }
    }

    /// A constant.
    pub fn constant(value: f64) -> Self {
        let (before, after) = (Beyond::Hold, Beyond::Hold);
        Self { times: vec![0.0], parts: vec![Vec::new()], last: vec![value], before, after }
    }

    /// Whether it is 0 at all times.
    pub fn is_zero(&self) -> bool {
        self.parts.iter().flatten().all(|stretch| stretch.powers == [0.0; 4])
            && self.last.iter().all(|last| *last == 0.0)
    }

    /// A part of the value at `time_s`; any number is a time, and NaN is as the first key.
    pub fn at(&self, time_s: f64, part: usize) -> f64 {
        let (stretch, share) = self.stretch_at(time_s);
        self.parts[part].get(stretch).map_or(self.last[part], |stretch| stretch.at(share))
    }

    /// The first numbers of the value at `time_s`, as many as it has.
    pub fn all_at(&self, time_s: f64) -> [f64; 3] {
        let (at, share) = self.stretch_at(time_s);
        std::array::from_fn(|part| match (self.parts.get(part).and_then(|part| part.get(at)), self.last.get(part)) {
            (Some(stretch), _) => stretch.at(share),
            (None, Some(last)) => *last,
            (None, None) => 0.0,
        })
    }

    /// Which stretch `time_s` lies in, and how much of it is over.
    fn stretch_at(&self, time_s: f64) -> (usize, f64) {
        let time_s = self.wrapped(time_s);
        let after = self.times.partition_point(|time| *time <= time_s);
        let at = after.saturating_sub(1);
        let Some(next) = self.times.get(at + 1) else { return (at, 0.0) };
        let share = (time_s - self.times[at]) / (next - self.times[at]);
        (at, if share > 0.0 { share } else { 0.0 })
    }

    /// The time between first and last key that shows what `time_s` shows.
    fn wrapped(&self, time_s: f64) -> f64 {
        let (Some(&first), Some(&last)) = (self.times.first(), self.times.last()) else { return 0.0 };
        let span = last - first;
        let beyond = if time_s < first {
            self.before
        } else if time_s > last {
            self.after
        } else {
            Beyond::Hold
        };
        match beyond {
            Beyond::Repeat if span > 0.0 && time_s.is_finite() => first + (time_s - first).rem_euclid(span),
            Beyond::Swing if span > 0.0 && time_s.is_finite() => {
                let over = (time_s - first).rem_euclid(2.0 * span);
                first + if over > span { 2.0 * span - over } else { over }
            }
            _ => time_s.max(first).min(last),
        }
    }

    /// First and last key, seconds.
    pub fn ends_s(&self) -> [f64; 2] {
        [self.times.first(), self.times.last()].map(|time| time.copied().unwrap_or(0.0))
    }

    /// The keys' times, seconds, in order.
    pub fn times_s(&self) -> &[f64] {
        &self.times
    }

    /// After how many seconds what comes after the last key comes again; none if it holds.
    pub fn period_s(&self) -> Option<f64> {
        let [first, last] = self.ends_s();
        let span = last - first;
        match self.after {
            Beyond::Repeat if span > 0.0 => Some(span),
            Beyond::Swing if span > 0.0 => Some(2.0 * span),
            _ => None,
        }
    }

    /// The times between `from_s` and `to_s`, seconds, at which a key is met, again and again where it comes round; not in
    /// order. No more than some ten thousand: what is quicker than that is a blur.
    pub fn breaks_s(&self, [from_s, to_s]: [f64; 2]) -> Vec<f64> {
        const MOST: usize = 10_000;
        let [first, last] = self.ends_s();
        let span = last - first;
        let mut breaks = Vec::new();
        // Rounds are counted from the first key on, before it too.
        let mut round = |start: f64, beyond: Beyond, is_odd: bool| {
            let backwards = beyond == Beyond::Swing && is_odd;
            let there = |time: &f64| if backwards { start + (last - time) } else { start + (time - first) };
            breaks.extend(self.times.iter().map(there).filter(|time| *time > from_s && *time < to_s));
            breaks.len() < MOST
        };
        round(first, Beyond::Hold, false);
        if span > 0.0 && self.after != Beyond::Hold {
            let mut rounds = 1.0_f64;
            while first + rounds * span < to_s && round(first + rounds * span, self.after, rounds % 2.0 == 1.0) {
                rounds += 1.0;
            }
        }
        if span > 0.0 && self.before != Beyond::Hold && from_s < first {
            let mut rounds = 1.0_f64;
            while first - (rounds - 1.0) * span > from_s
                && round(first - rounds * span, self.before, rounds % 2.0 == 1.0)
            {
                rounds += 1.0;
            }
        }
        breaks
    }
}

impl Stretch {
    fn at(&self, share: f64) -> f64 {
        let [a, b, c, d] = self.powers;
        let value = a + share * (b + share * (c + share * d));
        // What is rounded may overshoot in its last digit.
        value.max(self.within[0]).min(self.within[1])
    }
}

/// The values of a part of keys that are angles, degrees, so that each follows from the one before by its turn.
fn unwound(keys: &[TrackKey], part: usize) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::with_capacity(keys.len());
    for (i, key) in keys.iter().enumerate() {
        let value = key.value.parts()[part];
        let Some((before, sum)) = i.checked_sub(1).map(|i| (&keys[i], values[i])) else {
            values.push(value);
            continue;
        };
        let difference = value - before.value.parts()[part];
        let turn = match before.turns {
            Some(turns) => difference + 360.0 * f64::from(turns),
            // Half a turn goes clockwise.
            None => 180.0 - (180.0 - difference).rem_euclid(360.0),
        };
        values.push(sum + turn);
    }
    values
}

fn stretches(keys: &[TrackKey], values: &[f64], part: usize, loops: bool, turns: bool) -> Vec<Stretch> {
    let widths: Vec<f64> = keys.windows(2).map(|pair| pair[1].time_s - pair[0].time_s).collect();
    let rises: Vec<f64> = values.windows(2).zip(&widths).map(|(pair, width)| (pair[1] - pair[0]) / width).collect();
    let slopes = smooth_slopes(&widths, &rises, loops && meets(values, turns));
    let handle = |key: usize, of: fn(&Handles) -> &KeyValue| {
        keys[key].handles.as_ref().and_then(|handles| of(handles).parts().get(part)).copied()
    };
    let stretch = |i: usize| {
        let [from, to] = [values[i], values[i + 1]];
        let plain = [from.min(to), from.max(to)];
        match keys[i].leaves {
            Leaves::Step => Stretch { powers: [from, 0.0, 0.0, 0.0], within: [from, from] },
            Leaves::Linear => Stretch { powers: [from, to - from, 0.0, 0.0], within: plain },
            Leaves::Smooth => {
                let by_hand = [handle(i, |handles| &handles.leaves), handle(i + 1, |handles| &handles.arrives)];
                let [leaves, arrives] = [by_hand[0].unwrap_or(slopes[i]), by_hand[1].unwrap_or(slopes[i + 1])];
                let [leaves, arrives, rise] = [leaves * widths[i], arrives * widths[i], to - from];
                let powers = [from, leaves, 3.0 * rise - 2.0 * leaves - arrives, leaves + arrives - 2.0 * rise];
                let is_free = by_hand.iter().any(Option::is_some);
                Stretch { powers, within: if is_free { [f64::NEG_INFINITY, f64::INFINITY] } else { plain } }
            }
        }
    };
    (0..widths.len()).map(stretch).collect()
}

/// Whether the last value is the first one again.
fn meets(values: &[f64], turns: bool) -> bool {
    let (Some(first), Some(last)) = (values.first(), values.last()) else { return false };
    let apart = (last - first).abs();
    let apart = if turns { apart.rem_euclid(360.0).min(360.0 - apart.rem_euclid(360.0)) } else { apart };
    apart <= 1e-9 * (1.0 + first.abs())
}

/// Slopes at the keys. At the ends of what loops, that of its other end is a neighbour.
fn smooth_slopes(widths: &[f64], rises: &[f64], loops: bool) -> Vec<f64> {
    let Some(last) = rises.len().checked_sub(1) else { return vec![0.0] };
    let mut slopes = Vec::with_capacity(last + 2);
    let seam = if loops { between([widths[last], widths[0]], [rises[last], rises[0]]) } else { 0.0 };
    slopes.push(seam);
    slopes.extend((0..last).map(|i| between([widths[i], widths[i + 1]], [rises[i], rises[i + 1]])));
    slopes.push(seam);
    slopes
}

/// The slope between two stretches: a harmonic mean of theirs, flat at peaks and where either is flat.
fn between([before_s, after_s]: [f64; 2], [before, after]: [f64; 2]) -> f64 {
    if before * after <= 0.0 {
        return 0.0;
    }
    let [near, far] = [before_s + 2.0 * after_s, 2.0 * before_s + after_s];
    (near + far) / (far / before + near / after)
}
