//! Between two keys: a cubic of the share of the stretch that is over, and the slopes that smooth ones meet with.

use crate::scene::{Handles, KeyValue, Leaves, TrackKey};

/// One number between two keys.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stretch {
    /// Of the powers of the share that is over.
    pub(super) powers: [f64; 4],
    /// What it stays within.
    within: [f64; 2],
}

/// Where handles shape a curve, it may go anywhere that is a number: slopes too steep for that end there too.
const ANYWHERE: [f64; 2] = [f64::MIN, f64::MAX];

impl Stretch {
    pub(super) fn at(&self, share: f64) -> f64 {
        let [a, b, c, d] = self.powers;
        let value = a + share * (b + share * (c + share * d));
        // What is rounded may overshoot in its last digit.
        value.max(self.within[0]).min(self.within[1])
    }
}

/// Of a part of `keys`, whose `values` are these in a row. In what `meets`, the last key is the first one again.
pub(super) fn stretches(keys: &[TrackKey], values: &[f64], part: usize, meets: bool) -> Vec<Stretch> {
    let widths: Vec<f64> = keys.windows(2).map(|pair| pair[1].time_s - pair[0].time_s).collect();
    let rises: Vec<f64> = values.windows(2).zip(&widths).map(|(pair, width)| (pair[1] - pair[0]) / width).collect();
    let slopes = smooth_slopes(&widths, &rises, meets);
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
                Stretch { powers, within: if is_free { ANYWHERE } else { plain } }
            }
        }
    };
    (0..widths.len()).map(stretch).collect()
}

/// Slopes at the keys. At the ends of what meets, that of its other end is a neighbour.
fn smooth_slopes(widths: &[f64], rises: &[f64], meets: bool) -> Vec<f64> {
    let Some(last) = rises.len().checked_sub(1) else { return vec![0.0] };
    let mut slopes = Vec::with_capacity(last + 2);
    let seam = if meets { between([widths[last], widths[0]], [rises[last], rises[0]]) } else { 0.0 };
    slopes.push(seam);
    slopes.extend((0..last).map(|i| between([widths[i], widths[i + 1]], [rises[i], rises[i + 1]])));
    slopes.push(seam);
    slopes
}

/// The slope between two stretches: a harmonic mean of theirs in which the shorter one, whose slope was taken nearer to
/// the key, counts more; flat at peaks and where either is flat. Neither weight is below a third, so the slope is at most
/// three times either: Fritsch's and Carlson's condition for a cubic that rises all along.
fn between([before_s, after_s]: [f64; 2], [before, after]: [f64; 2]) -> f64 {
    if before * after <= 0.0 {
        return 0.0;
    }
    let [of_before, of_after] = [before_s + 2.0 * after_s, 2.0 * before_s + after_s];
    (of_before + of_after) / (of_before / before + of_after / after)
}
