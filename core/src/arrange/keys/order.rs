//! Keys in order of time, no two at one time.

use crate::scene::TrackKey;

/// Keys nearer to one another are at one time, seconds.
pub const SAME_S: f64 = 5e-4;
/// Keys lie within so many seconds of 0.
pub const MOST_S: f64 = 1e8;
/// Of times that hands and arithmetic give, parts of a second.
const PARTS: f64 = 1e6;

/// A time as keys have it: to the microsecond, and within bounds. NaN is 0.
pub fn to_step(time_s: f64) -> f64 {
    let step = (time_s * PARTS).round() / PARTS;
    if step.is_nan() { 0.0 } else { step.clamp(-MOST_S, MOST_S) }
}

/// In order; of several at one time a chosen one stays. With the indices of the chosen ones.
pub(super) fn in_order(mut keys: Vec<(bool, TrackKey)>) -> (Vec<TrackKey>, Vec<usize>) {
    // The chosen one comes last of those at one time, and takes the others' place.
    keys.sort_by(|(chosen, key), (other_chosen, other)| {
        key.time_s.total_cmp(&other.time_s).then(chosen.cmp(other_chosen))
    });
    keys.dedup_by(|(later_chosen, later), (chosen, key)| {
        let same = later.time_s - key.time_s < SAME_S;
        if same && (*later_chosen || !*chosen) {
            std::mem::swap(later, key);
            *chosen = *later_chosen;
        }
        same
    });
    let chosen = keys.iter().enumerate().filter(|(_, (chosen, _))| *chosen).map(|(index, _)| index).collect();
    (keys.into_iter().map(|(_, key)| key).collect(), chosen)
}
