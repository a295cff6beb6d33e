//! Chosen keys moved, scaled and mirrored in time, changed one by one, and deleted.

use super::order::to_step;
use super::{KeyPlace, Rekeyed, marked, touched};
use crate::property::Target;
use crate::scene::{Handles, KeyValue, Track, TrackKey};
use std::collections::BTreeSet;

/// Angles and hours may be of so many rounds.
const MOST_ROUNDS: f64 = 1e6;

/// The chosen keys of `tracks` as `change` makes them. Times and values stay within their bounds.
pub fn reshaped<'t>(
    tracks: impl IntoIterator<Item = &'t Track>,
    chosen: &BTreeSet<KeyPlace>,
    mut change: impl FnMut(KeyPlace, &mut TrackKey),
) -> Rekeyed {
    let mut rekeyed = Rekeyed::default();
    for track in touched(tracks, chosen) {
        let target: Option<Target> = track.property.parse().ok();
        let mut keys = marked(track, chosen);
        for (index, (_, key)) in keys.iter_mut().enumerate().filter(|(_, (chosen, _))| *chosen) {
            change((track.id, index), key);
            key.time_s = to_step(key.time_s);
            if let Some(target) = &target {
                key.value.parts_mut().iter_mut().for_each(|part| *part = within(target, *part));
            }
        }
        rekeyed.replace(track, keys);
    }
    rekeyed
}

/// All chosen keys by `by_s` later.
pub fn moved<'t>(tracks: impl IntoIterator<Item = &'t Track>, chosen: &BTreeSet<KeyPlace>, by_s: f64) -> Rekeyed {
    reshaped(tracks, chosen, |_, key| key.time_s += by_s)
}

/// Their distances from `about_s` multiplied with `by`, more than 0: 2 is twice as slow.
pub fn scaled<'t>(
    tracks: impl IntoIterator<Item = &'t Track>,
    chosen: &BTreeSet<KeyPlace>,
    about_s: f64,
    by: f64,
) -> Rekeyed {
    let by = if by.is_finite() && by > 0.0 { by } else { 1.0 };
    reshaped(tracks, chosen, |_, key| {
        key.time_s = about_s + (key.time_s - about_s) * by;
        if let Some(handles) = &mut key.handles {
            *handles = Handles { arrives: times(handles.arrives, 1.0 / by), leaves: times(handles.leaves, 1.0 / by) };
        }
    })
}

/// The chosen keys the other way round about `about_s`. How a stretch goes stays with the stretch.
pub fn mirrored<'t>(tracks: impl IntoIterator<Item = &'t Track>, chosen: &BTreeSet<KeyPlace>, about_s: f64) -> Rekeyed {
    let mut rekeyed = Rekeyed::default();
    for track in touched(tracks, chosen) {
        let mut keys = marked(track, chosen);
        // A key goes on as the chosen one before it did, whose stretch now follows.
        let mut before: Option<(_, Option<i32>)> = None;
        for (_, key) in keys.iter_mut().filter(|(chosen, _)| *chosen) {
            let own = (key.leaves, key.turns);
            if let Some((leaves, turns)) = before.replace(own) {
                (key.leaves, key.turns) = (leaves, turns.map(i32::wrapping_neg));
            }
            key.time_s = to_step(2.0 * about_s - key.time_s);
            if let Some(handles) = &mut key.handles {
                *handles = Handles { arrives: times(handles.leaves, -1.0), leaves: times(handles.arrives, -1.0) };
            }
        }
        rekeyed.replace(track, keys);
    }
    rekeyed
}

/// Without the chosen keys. A track without any goes too.
pub fn deleted<'t>(tracks: impl IntoIterator<Item = &'t Track>, chosen: &BTreeSet<KeyPlace>) -> Rekeyed {
    let mut rekeyed = Rekeyed::default();
    for track in touched(tracks, chosen) {
        let mut keys = marked(track, chosen);
        keys.retain(|(chosen, _)| !chosen);
        rekeyed.replace(track, keys);
    }
    rekeyed
}

/// A number as a key of `target` may have it: of any round if it is cyclic.
pub(super) fn within(target: &Target, number: f64) -> f64 {
    let Some(range) = target.property.kind.number() else { return number };
    let [min, max] = match target.property.cycle {
        Some(cycle) => [-cycle * MOST_ROUNDS, cycle * MOST_ROUNDS],
        None => [range.min, range.max],
    };
    if number.is_nan() { range.min.max(0.0).min(range.max) } else { number.clamp(min, max) }
}

fn times(mut value: KeyValue, by: f64) -> KeyValue {
    value.parts_mut().iter_mut().for_each(|part| *part *= by);
    value
}
