//! Keys that are copied, and pasted at another time.

use super::{KeyPlace, Rekeyed, marked, order::to_step, touched};
use crate::document::{Edit, ListEdit};
use crate::property::Target;
use crate::scene::{List, Scene, Track, TrackId, TrackKey};
use std::collections::{BTreeMap, BTreeSet};

/// The tracks of the chosen keys, with those keys alone, to be pasted.
pub fn copied(scene: &Scene, chosen: &BTreeSet<KeyPlace>) -> List<Track> {
    let of_track = |track: &Track| {
        let keys = marked(track, chosen).into_iter().filter(|(chosen, _)| *chosen);
        Track { keys: keys.map(|(_, key)| key).collect(), ..track.clone() }
    };
    touched(&scene.tracks, chosen).map(of_track).filter(|track| !track.keys.is_empty()).collect()
}

/// Keys that were copied, the first of them at `at_s`: in the tracks of the same properties, which are made if they have
/// gone. Keys of one property alone go into the tracks `onto` in its place, if any has as many parts.
pub fn pasted(scene: &Scene, copied: &List<Track>, at_s: f64, onto: &BTreeSet<TrackId>) -> Rekeyed {
    let mut rekeyed = Rekeyed::default();
    let times_s = copied.iter().flat_map(|track| &track.keys).map(|key| key.time_s);
    let Some(start_s) = times_s.reduce(f64::min) else { return rekeyed };
    let later = |key: &TrackKey| TrackKey { time_s: to_step(key.time_s + at_s - start_s), ..key.clone() };
    let parts = |property: &str| property.parse::<Target>().ok().map(|target| target.parts());
    if let [alone] = copied.as_slice() {
        let fits = |track: &&Track| onto.contains(&track.id) && parts(&track.property) == parts(&alone.property);
        let tracks: Vec<&Track> = scene.tracks.iter().filter(fits).collect();
        for track in &tracks {
            add(&mut rekeyed, track, alone.keys.iter().map(later));
        }
        if !tracks.is_empty() {
            return rekeyed;
        }
    }
    let tracks: BTreeMap<&str, &Track> = scene.tracks.iter().map(|track| (track.property.as_str(), track)).collect();
    let mut next_id = scene.next_id;
    for Track { property, keys, .. } in copied {
        match tracks.get(property.as_str()) {
            Some(track) => add(&mut rekeyed, track, keys.iter().map(later)),
            None if property.parse::<Target>().is_ok_and(|target| target.owner.is_in(scene)) => {
                let id = TrackId::new(&mut next_id);
                rekeyed.chosen.extend((0..keys.len()).map(|index| (id, index)));
                let value = Track::new(id, property.clone(), keys.iter().map(later).collect());
                rekeyed.edits.push(Edit::Track(ListEdit::Insert { at: usize::MAX, value }));
            }
            None => {}
        }
    }
    if next_id != scene.next_id {
        rekeyed.edits.insert(0, Edit::NextId(next_id));
    }
    rekeyed
}

/// Copies of the chosen keys, `by_s` later.
pub fn duplicated<'t>(tracks: impl IntoIterator<Item = &'t Track>, chosen: &BTreeSet<KeyPlace>, by_s: f64) -> Rekeyed {
    let mut rekeyed = Rekeyed::default();
    for track in touched(tracks, chosen) {
        let copies = marked(track, chosen).into_iter().filter(|(chosen, _)| *chosen);
        let later = copies.map(|(_, key)| TrackKey { time_s: to_step(key.time_s + by_s), ..key });
        add(&mut rekeyed, track, later);
    }
    rekeyed
}

fn add(rekeyed: &mut Rekeyed, track: &Track, new: impl Iterator<Item = TrackKey>) {
    let old = track.keys.iter().cloned().map(|key| (false, key));
    rekeyed.replace(track, old.chain(new.map(|key| (true, key))).collect());
}
