//! The curve of a track: a value at any time, from keys alone.
//!
//! On the edit clock each stretch between two keys becomes a cubic of the share of the stretch that is over; one value is
//! then a search among the keys and one cubic. A smooth stretch takes its slopes from Fritsch and Carlson (*Monotone
//! Piecewise Cubic Interpolation*, 1980; the harmonic mean of Fritsch and Butland, 1984): it rises where its keys do, is
//! flat where neighbours are equal, and never overshoots. A track that repeats goes on through its seam without a kink.

mod stretch;

use crate::property::Target;
use crate::scene::{Beyond, Track, TrackKey};
use stretch::{Stretch, stretches};

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

impl Curve {
    /// Of `track`, whose keys are sound; `turns`: its values are angles in degrees.
    pub fn new(track: &Track, turns: bool) -> Self {
        Self::cyclic(track, turns, turns.then_some(360.0))
    }

    /// Of `track`, whose keys are sound and fit `target`.
    pub fn of(track: &Track, target: &Target) -> Self {
        Self::cyclic(track, target.turns(), target.property.cycle)
    }

    /// Values that lie a whole number of cycles apart are the same, and meet at the seam of what repeats.
    fn cyclic(track: &Track, turns: bool, cycle: Option<f64>) -> Self {
        let keys = &track.keys;
        let count = keys.iter().map(|key| key.value.parts().len()).min().unwrap_or(0);
        let times: Vec<f64> = keys.iter().map(|key| key.time_s).collect();
        let repeats = [track.before, track.after].contains(&Beyond::Repeat);
        let values_of = |part: usize| -> Vec<f64> {
            if turns { unwound(keys, part) } else { keys.iter().map(|key| key.value.parts()[part]).collect() }
        };
        let values: Vec<Vec<f64>> = (0..count).map(values_of).collect();
        let stretches_of =
            |(part, values): (usize, &Vec<f64>)| stretches(keys, values, part, repeats && meets(values, cycle));
        let parts = values.iter().enumerate().map(stretches_of).collect();
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

    /// How often its keys are listed again, before its first key and after its last: some 3,000 keys in all, but one round
    /// at least.
    pub(super) fn most_rounds(&self) -> f64 {
        (3_000 / self.times.len().max(1)).max(1) as f64
    }

    /// Between which times it is a blur among `from_s` to `to_s`: it comes round so often there that listing its keys each
    /// time would have no end. The times at which it meets a key otherwise go to `breaks`, in no order.
    pub(super) fn breaks_s(&self, [from_s, to_s]: [f64; 2], breaks: &mut Vec<f64>) -> Vec<[f64; 2]> {
        let [first, last] = self.ends_s();
        let span = last - first;
        let mut add_round = |round: f64, beyond: Beyond| {
            let start = first + round * span;
            let backwards = beyond == Beyond::Swing && round.rem_euclid(2.0) == 1.0;
            let there = |time: &f64| if backwards { start + (last - time) } else { start + (time - first) };
            breaks.extend(self.times.iter().map(there).filter(|time| *time > from_s && *time < to_s));
        };
        add_round(0.0, Beyond::Hold);
        let mut blurs = Vec::new();
        for (beyond, from_s, to_s) in [(self.before, from_s, to_s.min(first)), (self.after, from_s.max(last), to_s)] {
            if beyond == Beyond::Hold || !(span > 0.0 && from_s < to_s) {
                continue;
            }
            let [begin, end] = [libm::floor((from_s - first) / span), libm::ceil((to_s - first) / span)];
            let listed = (end - begin).min(self.most_rounds());
            (0..listed as u32).for_each(|round| add_round(begin + f64::from(round), beyond));
            let blurs_from_s = (first + (begin + listed) * span).max(from_s);
            if blurs_from_s < to_s {
                blurs.push([blurs_from_s, to_s]);
            }
        }
        blurs
    }
}

/// The values of a part of keys that are angles, degrees, so that each follows from the one before by its turn. Each is
/// its key's own but for whole turns, so that none is rounded on the way.
fn unwound(keys: &[TrackKey], part: usize) -> Vec<f64> {
    let mut turns = 0.0;
    let mut values: Vec<f64> = Vec::with_capacity(keys.len());
    for (i, key) in keys.iter().enumerate() {
        let value = key.value.parts()[part];
        if let Some(before) = i.checked_sub(1).map(|i| &keys[i]) {
            turns += match before.turns {
                Some(turns) => f64::from(turns),
                // To within half a turn; just half a one goes clockwise.
                None => libm::floor((180.0 - (value - before.value.parts()[part])) / 360.0),
            };
        }
        values.push(value + 360.0 * turns);
    }
    values
}

/// Whether the last value is the first one again.
fn meets(values: &[f64], cycle: Option<f64>) -> bool {
    let (Some(first), Some(last)) = (values.first(), values.last()) else { return false };
    let apart = last - first;
    let apart = cycle.map_or(apart, |cycle| apart - cycle * libm::round(apart / cycle));
    apart.abs() <= 1e-9 * (1.0 + first.abs())
}
