//! Keys of properties at a time: set, taken out, looked for.

use super::order::{SAME_S, to_step};
use super::reshape::within;
use super::{KeyPlace, Rekeyed};
use crate::document::{Edit, ListEdit};
use crate::property::Target;
use crate::scene::{KeyValue, Leaves, Scene, Track, TrackId, TrackKey};
use std::collections::BTreeMap;

/// Each property gets that value at `time_s`: by a key that stands there, or a new one. A property without a track gets
/// one. Values of another number of parts are passed over.
pub fn keyed(scene: &Scene, values: &[(Target, KeyValue)], time_s: f64) -> Rekeyed {
    let time_s = to_step(time_s);
    let tracks = by_property(scene);
    let mut rekeyed = Rekeyed::default();
    let mut next_id = scene.next_id;
    for (target, value) in values.iter().filter(|(target, value)| value.parts().len() == target.parts()) {
        let mut value = *value;
        value.parts_mut().iter_mut().for_each(|part| *part = within(target, *part));
        let address = target.to_string();
        let Some(track) = tracks.get(address.as_str()) else {
            let id = TrackId::new(&mut next_id);
            let track = Track::new(id, address, vec![TrackKey::new(time_s, value)]);
            rekeyed.edits.push(Edit::Track(ListEdit::Insert { at: usize::MAX, value: track }));
            rekeyed.chosen.insert((id, 0));
            continue;
        };
        let mut keys: Vec<(bool, TrackKey)> = track.keys.iter().map(|key| (false, key.clone())).collect();
        match key_at(track, time_s).and_then(|index| keys.get_mut(index)) {
            Some((chosen, key)) => (*chosen, key.value) = (true, value),
            None => {
                let before = track.keys.iter().rfind(|key| key.time_s < time_s).or(track.keys.first());
                let leaves = before.map_or(Leaves::Smooth, |key| key.leaves);
                keys.push((true, TrackKey { leaves, ..TrackKey::new(time_s, value) }));
            }
        }
        rekeyed.replace(track, keys);
    }
    if next_id != scene.next_id {
        rekeyed.edits.insert(0, Edit::NextId(next_id));
    }
    rekeyed
}

/// The keys of those properties at `time_s` are taken out.
pub fn removed(scene: &Scene, targets: &[Target], time_s: f64) -> Rekeyed {
    let tracks = by_property(scene);
    let tracks = targets.iter().filter_map(|target| tracks.get(target.to_string().as_str()).copied());
    let there: Vec<(&Track, KeyPlace)> =
        tracks.filter_map(|track| Some((track, (track.id, key_at(track, time_s)?)))).collect();
    let chosen = there.iter().map(|(_, place)| *place).collect();
    super::deleted(there.into_iter().map(|(track, _)| track), &chosen)
}

/// All keys of those properties are taken out.
pub fn cleared(scene: &Scene, targets: &[Target]) -> Rekeyed {
    let tracks = by_property(scene);
    let tracks = targets.iter().filter_map(|target| tracks.get(target.to_string().as_str()));
    let edits = tracks.map(|track| Edit::Track(ListEdit::Remove(track.id))).collect();
    Rekeyed { edits, ..Rekeyed::default() }
}

/// When the next key of `tracks` comes after `time_s`, or came before it.
pub fn next_key_s<'t>(tracks: impl IntoIterator<Item = &'t Track>, time_s: f64, onwards: bool) -> Option<f64> {
    let next = |track: &Track| {
        let keys = &track.keys;
        let at = if onwards {
            keys.partition_point(|key| key.time_s <= time_s + SAME_S)
        } else {
            keys.partition_point(|key| key.time_s < time_s - SAME_S).checked_sub(1)?
        };
        keys.get(at).map(|key| key.time_s)
    };
    let all = tracks.into_iter().filter_map(next);
    if onwards { all.reduce(f64::min) } else { all.reduce(f64::max) }
}

/// The key that stands at `time_s`.
fn key_at(track: &Track, time_s: f64) -> Option<usize> {
    let near = track.keys.iter().enumerate().filter(|(_, key)| (key.time_s - time_s).abs() < SAME_S);
    let apart = |key: &TrackKey| (key.time_s - time_s).abs();
    near.min_by(|(_, a), (_, b)| apart(a).total_cmp(&apart(b))).map(|(index, _)| index)
}

/// The track of each property: of two, the first.
fn by_property(scene: &Scene) -> BTreeMap<&str, &Track> {
    let mut tracks = BTreeMap::new();
    for track in &scene.tracks {
        tracks.entry(track.property.as_str()).or_insert(track);
    }
    tracks
}
