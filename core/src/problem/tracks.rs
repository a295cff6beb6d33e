//! Tracks must move something, one each, and their keys must be numbers in order of time.
//!
//! A track of a thing that is not there moves nothing, and is only mentioned: the thing was deleted, and may come back.

use super::Problem;
use super::scope::Scope;
use crate::property::Target;
use crate::scene::{Beyond, Scene, Track, TrackKey};
use rustc_hash::FxHashMap;
use std::fmt::Arguments;

/// Of one track.
pub const MAX_KEYS: usize = 100_000;
/// Clocks and keys lie within so many seconds of 0: some three years.
const MAX_TIME_S: f64 = 1e8;
/// Angles and hours may be of so many rounds.
const MAX_ROUNDS: f64 = 1e6;

pub(super) fn check(scope: Scope<'_>, problems: &mut Vec<Problem>) {
    for (i, track) in scope.all::<Track>() {
        check_track(format_args!("tracks[{i}]"), track, scope.scene, problems);
    }
    // Which others there are, and whether things have gone, shows where lists changed.
    if scope.change.touches_lists() || scope.all::<Track>().next().is_some() {
        check_doubles(scope.scene, problems);
    }
}

fn check_track(place: Arguments<'_>, track: &Track, scene: &Scene, problems: &mut Vec<Problem>) {
    let target = match track.property.parse::<Target>() {
        Ok(target) => target,
        Err(error) => {
            let message = format!("“{}” is no property that can be keyed", track.property);
            problems.push(Problem::error(format!("{place}.property"), message, error.hint));
            return;
        }
    };
    if !target.owner.is_in(scene) {
        problems.push(Problem::note(
            format!("{place}.property"),
            format!("there is no {target}, so the track moves nothing"),
            "delete the track, or name what there is",
        ));
    }
    let count = track.keys.len();
    if count == 0 || count > MAX_KEYS {
        let hint = format!("give it 1 to {MAX_KEYS} keys, or delete it");
        problems.push(Problem::error(format!("{place}.keys"), format!("it has {count} keys"), hint));
        return;
    }
    for (i, key) in track.keys.iter().enumerate() {
        check_key(format_args!("{place}.keys[{i}]"), key, &target, problems);
    }
    for (i, pair) in track.keys.windows(2).enumerate() {
        let [before_s, time_s] = [pair[0].time_s, pair[1].time_s];
        let message = if time_s == before_s {
            format!("two keys at {time_s} s")
        } else if time_s < before_s {
            format!("{time_s} s is before the key before it, at {before_s} s")
        } else {
            continue;
        };
        problems.push(Problem::error(
            format!("{place}.keys[{}].time_s", i + 1),
            message,
            "keys stand in order of time",
        ));
    }
    check_seam(place, track, &target, problems);
}

fn check_key(place: Arguments<'_>, key: &TrackKey, target: &Target, problems: &mut Vec<Problem>) {
    // NaN is within nothing.
    if !(-MAX_TIME_S..=MAX_TIME_S).contains(&key.time_s) {
        let message = format!("{} is no time", key.time_s);
        problems.push(Problem::error(
            format!("{place}.time_s"),
            message,
            format!("use -{MAX_TIME_S} to {MAX_TIME_S} s"),
        ));
    }
    let (parts, wanted) = (key.value.parts(), target.parts());
    if parts.len() != wanted {
        let message = format!("{} numbers, where {target} has {wanted}", parts.len());
        let hint = if wanted == 1 { "write one number" } else { "write a list of three numbers" };
        problems.push(Problem::error(format!("{place}.value"), message, hint));
        return;
    }
    let Some(number) = target.property.kind.number() else { return };
    let [min, max] = match target.property.cycle {
        Some(cycle) => [-cycle * MAX_ROUNDS, cycle * MAX_ROUNDS],
        None => [number.min, number.max],
    };
    for part in parts.iter().filter(|part| !(min..=max).contains(*part)) {
        let message = format!("{part} is out of range");
        let hint = format!("use {min} to {max} {}. {}", number.unit, number.doc).replace(" .", ".");
        problems.push(Problem::error(format!("{place}.value"), message, hint));
    }
    let Some(handles) = &key.handles else { return };
    for (name, slope) in [("arrives", &handles.arrives), ("leaves", &handles.leaves)] {
        if slope.parts().len() != wanted || slope.parts().iter().any(|slope| !slope.is_finite()) {
            let hint = "a handle has a slope, a number, for each of the value's numbers";
            problems.push(Problem::error(format!("{place}.handles.{name}"), "it does not fit the value", hint));
        }
    }
}

/// What repeats should end as it begins.
fn check_seam(place: Arguments<'_>, track: &Track, target: &Target, problems: &mut Vec<Problem>) {
    let repeats = [track.before, track.after].contains(&Beyond::Repeat);
    let (Some(first), Some(last)) = (track.keys.first(), track.keys.last()) else { return };
    let jumps = |(a, b): (&f64, &f64)| match target.property.cycle {
        Some(cycle) => {
            let apart = (a - b).rem_euclid(cycle);
            apart.min(cycle - apart) > 1e-9 * cycle
        }
        None => a != b,
    };
    if repeats && first.value.parts().iter().zip(last.value.parts()).any(jumps) {
        problems.push(Problem::note(
            format!("{place}.keys"),
            "it repeats, but does not end as it begins: it jumps at the seam",
            "give the last key the first one's value, or let it swing",
        ));
    }
}

fn check_doubles(scene: &Scene, problems: &mut Vec<Problem>) {
    let mut seen: FxHashMap<&str, usize> = FxHashMap::default();
    for (i, track) in scene.tracks.iter().enumerate() {
        if let Some(first) = seen.insert(&track.property, i) {
            problems.push(Problem::error(
                format!("tracks[{i}].property"),
                format!("tracks[{first}] moves {} too", track.property),
                "join the two tracks, or delete one",
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Severity, assert_found, check, sound_scene};
    use super::*;
    use crate::scene::{Handles, KeyValue, Scene, TrackId};

    fn keyed(property: &str, keys: Vec<TrackKey>) -> Scene {
        let mut scene = sound_scene();
        let id = TrackId::new(&mut scene.next_id);
        scene.tracks.push(Track::new(id, property, keys));
        scene
    }

    fn keys(values: &[(f64, f64)]) -> Vec<TrackKey> {
        values.iter().map(|(time_s, value)| TrackKey::new(*time_s, KeyValue::One(*value))).collect()
    }

    #[test]
    fn refuses() {
        let cloud = format!("cloud/{}/opacity", sound_scene().clouds[0].id);
        let heading = format!("cloud/{}/heading_deg", sound_scene().clouds[0].id);
        let good = keys(&[(0.0, 0.0), (10.0, 1.0)]);
        assert_eq!(check(&keyed(&cloud, good.clone())), []);
        assert_eq!(check(&keyed(&heading, keys(&[(0.0, 0.0), (10.0, 7200.0)]))), [], "an angle may go round");
        let mut bent = good.clone();
        bent[0].handles = Some(Handles { arrives: KeyValue::One(0.0), leaves: KeyValue::One(f64::NAN) });
        for (property, keys, place, words) in [
            ("cloud/7", good.clone(), "tracks[0].property", "no property"),
            ("cloud/99/opacity", good.clone(), "tracks[0].property", "moves nothing"),
            (&cloud, vec![], "tracks[0].keys", "0 keys"),
            (&cloud, vec![good[0].clone(); 1_000_000], "tracks[0].keys", "1000000 keys"),
            (&cloud, keys(&[(0.0, 0.0), (0.0, 1.0)]), "tracks[0].keys[1].time_s", "two keys at 0 s"),
            (&cloud, keys(&[(1.0, 0.0), (0.0, 1.0)]), "tracks[0].keys[1].time_s", "before the key before it"),
            (&cloud, keys(&[(f64::NAN, 0.0)]), "tracks[0].keys[0].time_s", "NaN"),
            (&cloud, keys(&[(f64::INFINITY, 0.0)]), "tracks[0].keys[0].time_s", "inf"),
            (&cloud, keys(&[(0.0, f64::NAN)]), "tracks[0].keys[0].value", "out of range"),
            (&cloud, keys(&[(0.0, 1.5)]), "tracks[0].keys[0].value", "out of range"),
            (&heading, keys(&[(0.0, f64::INFINITY)]), "tracks[0].keys[0].value", "out of range"),
            (&cloud, vec![TrackKey::new(0.0, KeyValue::Three([0.0; 3]))], "tracks[0].keys[0].value", "3 numbers"),
            (&cloud, bent, "tracks[0].keys[0].handles.leaves", "does not fit"),
        ] {
            assert_found(&keyed(property, keys), place, words);
        }
    }

    #[test]
    fn what_is_gone_or_jumps_is_only_mentioned() {
        let mut scene = keyed("cloud/99/opacity", keys(&[(0.0, 0.0), (10.0, 1.0)]));
        scene.tracks[0].after = Beyond::Repeat;
        let problems = check(&scene);
        assert_eq!(problems.len(), 2, "{problems:?}");
        assert!(problems.iter().all(|problem| problem.severity == Severity::Note));
    }

    #[test]
    fn one_property_has_one_track() {
        let mut scene = keyed("sky/exposure_ev", keys(&[(0.0, 0.0)]));
        let id = TrackId::new(&mut scene.next_id);
        scene.tracks.push(Track::new(id, "sky/exposure_ev", keys(&[(0.0, 0.0)])));
        assert_found(&scene, "tracks[1].property", "tracks[0] moves sky/exposure_ev too");
    }
}
