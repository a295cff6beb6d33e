//! Keys moved with all that comes after them, so that time is put in or cut out.

use super::order::MOST_S;
use super::reshape::reshaped;
use super::{KeyPlace, Rekeyed, touched};
use crate::scene::{Track, TrackKey};
use std::collections::BTreeSet;

/// Between the keys that stay and those that come along, at least, seconds.
const LEFT_S: f64 = 1e-3;

/// The chosen keys, and all later ones of their tracks.
pub fn with_later<'t>(tracks: impl IntoIterator<Item = &'t Track>, chosen: &BTreeSet<KeyPlace>) -> BTreeSet<KeyPlace> {
    let tracks: Vec<&Track> = touched(tracks, chosen).collect();
    let from_s = first_s(&tracks, chosen);
    let of_track = |track: &&Track| {
        let id = track.id;
        let keys = track.keys.iter().enumerate().filter(move |(_, key)| key.time_s >= from_s);
        keys.map(move |(index, _)| (id, index)).collect::<Vec<_>>()
    };
    tracks.iter().flat_map(of_track).collect()
}

/// All keys from the first chosen one on, in every track that a chosen one is of, by `by_s` later; the chosen ones as
/// `change` makes them besides. None gets past a key that stays: more time than there is can't be cut out. So all keep
/// their order, and the chosen ones their places.
pub fn rippled<'t>(
    tracks: impl IntoIterator<Item = &'t Track>,
    chosen: &BTreeSet<KeyPlace>,
    by_s: f64,
    mut change: impl FnMut(KeyPlace, &mut TrackKey),
) -> Rekeyed {
    let tracks: Vec<&Track> = touched(tracks, chosen).collect();
    let from_s = first_s(&tracks, chosen);
    let [mut least_s, mut most_s] = [f64::NEG_INFINITY, f64::INFINITY];
    for track in &tracks {
        let first = track.keys.partition_point(|key| key.time_s < from_s);
        if let (Some(stays), Some(moves)) = (first.checked_sub(1).map(|at| &track.keys[at]), track.keys.get(first)) {
            least_s = least_s.max(stays.time_s + LEFT_S - moves.time_s);
        }
        most_s = track.keys.last().map_or(most_s, |last| most_s.min(MOST_S - last.time_s));
    }
    let by_s = if by_s.is_nan() { 0.0 } else { by_s.max(least_s.min(0.0)).min(most_s.max(0.0)) };
    let later = with_later(tracks.iter().copied(), chosen);
    let mut rekeyed = reshaped(tracks, &later, |place, key| {
        let time_s = key.time_s + by_s;
        if chosen.contains(&place) {
            change(place, key);
        }
        key.time_s = time_s;
    });
    rekeyed.chosen.retain(|place| chosen.contains(place));
    rekeyed
}

fn first_s(tracks: &[&Track], chosen: &BTreeSet<KeyPlace>) -> f64 {
    let keys = tracks.iter().flat_map(|track| track.keys.iter().enumerate().map(|(at, key)| ((track.id, at), key)));
    keys.filter(|(place, _)| chosen.contains(place)).map(|(_, key)| key.time_s).fold(f64::INFINITY, f64::min)
}
