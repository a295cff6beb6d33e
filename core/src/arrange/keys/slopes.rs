//! How chosen keys are left and reached: by step, straight, smoothly, flat, or by handles of their own.

use super::{KeyPlace, Rekeyed, reshaped};
use crate::property::Target;
use crate::scene::{Handles, KeyValue, Leaves, Track};
use crate::weather::Curve;
use std::collections::{BTreeMap, BTreeSet};

/// How keys are left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ease {
    /// As a curve of the keys alone.
    Plain(Leaves),
    /// Smooth, and level at the key.
    Flat,
    /// Smooth, with handles to be dragged, where the curve has its slopes now.
    Free,
}

/// The chosen keys with another way to be left.
pub fn eased<'t>(tracks: impl IntoIterator<Item = &'t Track>, chosen: &BTreeSet<KeyPlace>, ease: Ease) -> Rekeyed {
    let tracks: Vec<&Track> = super::touched(tracks, chosen).collect();
    let curves = tracks.iter().map(|track| (track.id, (*track, curve_of(track))));
    let curves: BTreeMap<_, _> = curves.filter(|_| ease == Ease::Free).collect();
    reshaped(tracks, chosen, |(id, index), key| {
        (key.leaves, key.handles) = match ease {
            Ease::Plain(leaves) => (leaves, None),
            Ease::Flat => {
                let level = key.value.with(|_| 0.0);
                (Leaves::Smooth, Some(Handles { arrives: level, leaves: level }))
            }
            Ease::Free => {
                let handles = curves.get(&id).and_then(|(track, curve)| slopes_at(track, curve, index));
                (Leaves::Smooth, handles.or(key.handles.take()))
            }
        };
    })
}

/// The slopes of `track`, whose curve that is, before and after its key of that index.
pub fn slopes_at(track: &Track, curve: &Curve, index: usize) -> Option<Handles> {
    let key = track.keys.get(index)?;
    let time = |index: Option<usize>| Some(track.keys.get(index?)?.time_s);
    let before = time(index.checked_sub(1)).map(|from| (from, key.time_s));
    let after = time(index.checked_add(1)).map(|to| (key.time_s, to));
    let slope = |stretch: Option<(f64, f64)>, at_start: bool, part: usize| {
        stretch.map_or(0.0, |(from, to)| slope_of_cubic(curve, part, [from, to], at_start))
    };
    let mut handles = Handles { arrives: key.value, leaves: key.value };
    for part in 0..key.value.parts().len() {
        handles.arrives.parts_mut()[part] = slope(before, false, part);
        handles.leaves.parts_mut()[part] = slope(after, true, part);
    }
    Some(handles)
}

/// The slope at an end of a stretch, a second: exact for a cubic, which four of its values determine. The ends themselves
/// are approached from within, as a curve may jump there.
fn slope_of_cubic(curve: &Curve, part: usize, [from, to]: [f64; 2], at_start: bool) -> f64 {
    let step = (to - from) / 5.0;
    let value = |count: f64| curve.at(from + step * count, part);
    // At 1, 2, 3 and 4 steps: the derivative of Lagrange's cubic through them at 0, or at 5 mirrored.
    let [a, b, c, d] =
        if at_start { [1.0, 2.0, 3.0, 4.0].map(value) } else { [4.0, 3.0, 2.0, 1.0].map(|count| -value(count)) };
    (-26.0 * a + 57.0 * b - 42.0 * c + 11.0 * d) / (6.0 * step)
}

fn curve_of(track: &Track) -> Curve {
    match track.property.parse::<Target>() {
        Ok(target) => Curve::of(track, &target),
        Err(_) => Curve::new(track, false),
    }
}

impl KeyValue {
    /// With each of its numbers as `change` makes it.
    #[must_use]
    pub fn with(mut self, change: impl Fn(f64) -> f64) -> Self {
        self.parts_mut().iter_mut().for_each(|part| *part = change(*part));
        self
    }
}
