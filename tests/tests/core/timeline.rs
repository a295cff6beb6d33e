//! What tracks make of a scene at a time.

mod curves;
pub(crate) mod dice;
mod mutated;

use cloudwright_core::property::{Address, Target, Value, addresses, tables, value};
use cloudwright_core::scene::{
    Beyond, Camera, CameraId, HowFarFormed, KeyValue, Leaves, Scene, Track, TrackId, TrackKey,
};
use cloudwright_core::weather::Timeline;
use cloudwright_tests::small_scenes::everything;
use dice::Dice;
use glam::DVec3;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// With all that a track can move, and no track yet.
fn rich() -> Scene {
    let mut scene = everything();
    scene.tracks.clear();
    scene.clouds[0].formed = Some(HowFarFormed::default());
    let id = CameraId::new(&mut scene.next_id);
    scene.cameras.push(Camera::new(id, "second", DVec3::new(1.0, 2.0, 3.0)));
    scene
}

/// What of `scene` can be keyed, each whole property once.
fn targets(scene: &Scene) -> Vec<Target> {
    let mut targets: Vec<Target> = Vec::new();
    for Address { owner, property, .. } in addresses(scene).into_iter().filter(|address| address.property.keyed) {
        let target = Target { owner, property };
        if targets.last().is_none_or(|last| last.to_string() != target.to_string()) {
            targets.push(target);
        }
    }
    targets
}

fn values(scene: &Scene) -> BTreeMap<String, Value> {
    let value_of = |address: Address| Some((address.to_string(), value(scene, address)?));
    addresses(scene).into_iter().filter_map(value_of).collect()
}

/// Of two keys, a line from one to the other.
fn line(scene: &mut Scene, target: Target, values: [KeyValue; 2]) {
    let key = |(time_s, value)| TrackKey { leaves: Leaves::Linear, ..TrackKey::new(time_s, value) };
    let id = TrackId::new(&mut scene.next_id);
    scene.tracks.push(Track::new(id, target.to_string(), [0.0, 8.0].into_iter().zip(values).map(key).collect()));
}

/// Numbers that `target` may have, in steps of a 1,024th part of its range from its lower end.
fn rolled(dice: &mut Dice, target: Target) -> KeyValue {
    let number = target.property.kind.number().expect("what can be keyed is a number");
    let (low, high) = (number.min.max(-1000.0), number.max.min(1000.0));
    let mut roll = || low + (high - low) * dice.below(1024) as f64 / 1024.0;
    if target.parts() == 1 { KeyValue::One(roll()) } else { KeyValue::Three([roll(), roll(), roll()]) }
}

fn part_of(target: Target, part: usize) -> Address {
    Address { owner: target.owner, property: target.property, part }
}

/// Alone, half-way and at its end; and nothing else is changed, or copied, but for what it belongs to.
#[test]
fn each_property_that_can_be_keyed_is_set_and_no_other() {
    let scene = rich();
    let targets = targets(&scene);
    let kinds: Vec<(String, &str)> = targets.iter().map(|target| (kind_of(target), target.property.path)).collect();
    for table in tables() {
        for property in (table.properties)().into_iter().filter(|property| property.keyed) {
            let tried = (table.pattern.replace("/N", ""), property.path);
            assert!(kinds.contains(&tried), "{tried:?} is not tried");
        }
    }
    for (i, target) in targets.into_iter().enumerate() {
        let mut keyed = scene.clone();
        let mut dice = Dice::new(i as u64);
        let [mut from, mut to] = [rolled(&mut dice, target), rolled(&mut dice, target)];
        if target.property.path == "height" {
            // Out of order they would be lifted.
            let at = number_of(&scene, part_of(target, 0));
            [from, to] = [KeyValue::One(at), KeyValue::One(at)];
        }
        line(&mut keyed, target, [from, to]);
        let timeline = Timeline::new(&keyed);
        for clock_s in [0.0, 4.0, 8.0] {
            let now = timeline.scene_at(&keyed, clock_s).into_owned();
            let mut wanted = values(&keyed);
            for part in 0..target.parts() {
                let [from, to] = [from.parts()[part], to.parts()[part]];
                let number = from + clock_s / 8.0 * if target.turns() { short_way(from, to) } else { to - from };
                wanted.insert(part_of(target, part).to_string(), Value::Number(target.bring_within(number)));
            }
            let found = values(&now);
            for (address, wanted) in &wanted {
                let same = match (&found[address], wanted) {
                    (Value::Number(found), Value::Number(wanted)) => (found - wanted).abs() <= 1e-12 * wanted.abs(),
                    (found, wanted) => found == wanted,
                };
                assert!(same, "{target} at {clock_s} s: {address} is {}, want {wanted}", found[address]);
            }
            assert_eq!(found.len(), wanted.len());
            assert!(copied(&keyed, &now) <= 1, "{target}: only its own thing is copied");
        }
    }
}

/// Its owner's address without ids.
fn kind_of(target: &Target) -> String {
    let address = target.owner.to_string();
    let words: Vec<&str> = address.split('/').filter(|part| part.parse::<u64>().is_err()).collect();
    words.join("/")
}

/// From one angle to another, by at most half a turn.
fn short_way(from: f64, to: f64) -> f64 {
    let apart = (to - from).rem_euclid(360.0);
    if apart > 180.0 { apart - 360.0 } else { apart }
}

fn number_of(scene: &Scene, address: Address) -> f64 {
    match value(scene, address) {
        Some(Value::Number(number)) => number,
        other => panic!("{address}: {other:?}"),
    }
}

/// How many things of lists two scenes don't share.
fn copied(a: &Scene, b: &Scene) -> usize {
    fn of<T>(a: &[std::sync::Arc<T>], b: &[std::sync::Arc<T>]) -> usize {
        assert_eq!(a.len(), b.len());
        a.iter().zip(b).filter(|(a, b)| !std::sync::Arc::ptr_eq(a, b)).count()
    }
    of(a.cameras.as_slice(), b.cameras.as_slice())
        + of(a.models.as_slice(), b.models.as_slice())
        + of(a.clouds.as_slice(), b.clouds.as_slice())
        + of(a.paths.as_slice(), b.paths.as_slice())
        + of(a.aircraft.as_slice(), b.aircraft.as_slice())
        + of(a.tracks.as_slice(), b.tracks.as_slice())
}

#[test]
fn all_properties_move_at_once() {
    let mut scene = rich();
    let (targets, mut dice) = (targets(&scene), Dice::new(7));
    for target in &targets {
        let value = rolled(&mut dice, *target);
        line(&mut scene, *target, [value, value]);
    }
    let now = Timeline::new(&scene).scene_at(&scene, 3.0).into_owned();
    for (target, track) in targets.iter().zip(&scene.tracks) {
        for (part, wanted) in track.keys[0].value.parts().iter().enumerate() {
            let found = number_of(&now, part_of(*target, part));
            let lifted = target.property.path == "height" && found > *wanted;
            assert!(lifted || found == target.bring_within(*wanted), "{target}: {found}, want {wanted}");
        }
    }
    for model in &now.models {
        let levels = &model.color_levels;
        assert!(levels.windows(2).all(|pair| pair[0].height <= pair[1].height), "levels stand in order");
    }
}

fn one(scene: &Scene, property: &str, values: &[f64]) -> Scene {
    let mut scene = scene.clone();
    let times: Vec<f64> = (0..values.len()).map(|i| i as f64).collect();
    let track =
        Track { property: property.into(), id: TrackId::new(&mut scene.next_id), ..dice::track(&times, values) };
    scene.tracks.push(track);
    scene
}

/// Of two tracks of a property the first counts; what is not there, can't be keyed, or has keys that the checks refuse
/// is passed over.
#[test]
fn what_can_not_move_moves_nothing() {
    let scene = rich();
    let twice = one(&one(&scene, "sky/exposure_ev", &[1.0]), "sky/exposure_ev", &[2.0]);
    assert_eq!(Timeline::new(&twice).scene_at(&twice, 0.0).sky.exposure_ev, 1.0);
    for property in
        ["cloud/999/opacity", "cloud/999", "model/999/color_levels/2/height", "path/1/key/0/time_s", "", "é/✈"]
    {
        let keyed = one(&scene, property, &[0.25, 0.5]);
        let now = Timeline::new(&keyed).scene_at(&keyed, 0.5).into_owned();
        assert_eq!(now, keyed, "{property}");
    }
    let three = KeyValue::Three([0.0; 3]);
    for keys in [
        vec![],
        vec![TrackKey::new(0.0, three)],
        vec![TrackKey::new(0.0, KeyValue::One(1.0)), TrackKey::new(0.0, KeyValue::One(2.0))],
        vec![TrackKey::new(1.0, KeyValue::One(1.0)), TrackKey::new(0.0, KeyValue::One(2.0))],
        vec![TrackKey::new(f64::NAN, KeyValue::One(1.0))],
        vec![TrackKey::new(0.0, KeyValue::One(f64::NAN))],
    ] {
        let mut keyed = one(&scene, "sky/exposure_ev", &[1.0]);
        keyed.tracks[0].keys = keys;
        let timeline = Timeline::new(&keyed);
        assert!(!timeline.moves() && matches!(timeline.scene_at(&keyed, 1.0), Cow::Borrowed(_)));
    }
}

#[test]
fn levels_out_of_order_are_lifted() {
    let scene = rich();
    let address = format!("model/{}/color_levels/2/height", scene.models[0].id);
    let [high, low] = [0.9, 0.0].map(|height| {
        let keyed = one(&scene, &address, &[height]);
        let timeline = Timeline::new(&keyed);
        let now = timeline.scene_at(&keyed, 0.0).models[0].color_levels;
        let looks = timeline.model_at(keyed.models[0].id, 0.0).expect("it has a track").color_levels;
        assert_eq!(now, looks);
        now.map(|level| level.height)
    });
    let rest = scene.models[0].color_levels.map(|level| level.height);
    assert_eq!(high, [rest[0], rest[1], 0.9, rest[3].max(0.9), rest[4].max(0.9)]);
    assert_eq!(low, [rest[0], rest[1], rest[1], rest[3], rest[4]]);
}

/// What is asked for one by one is what stands in the whole scene; handles may have numbers leave their ranges, and are
/// brought back.
#[test]
fn parts_are_those_of_the_whole() {
    let mut keyed = rich();
    let (targets, mut dice) = (targets(&keyed), Dice::new(3));
    for target in &targets {
        let [from, to] = [rolled(&mut dice, *target), rolled(&mut dice, *target)];
        line(&mut keyed, *target, [from, to]);
        let track = keyed.tracks.last_mut().expect("just made");
        track.after = dice.one_of(&[Beyond::Hold, Beyond::Repeat, Beyond::Swing]);
        track.keys[0].leaves = Leaves::Smooth;
        let steep = if target.parts() == 1 { KeyValue::One(1e4) } else { KeyValue::Three([1e4, -1e4, 1e308]) };
        track.keys[0].handles = Some(cloudwright_core::scene::Handles { arrives: steep, leaves: steep });
    }
    let timeline = Timeline::new(&keyed);
    for clock_s in [-1.0, 0.0, 0.7, 5.5, 8.0, 1e7, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let now = timeline.scene_at(&keyed, clock_s);
        assert_eq!(timeline.weather_at(clock_s), now.weather);
        assert_eq!(timeline.time_of_day_h(&keyed, clock_s), now.time_of_day_h);
        for (rest, now) in keyed.clouds.iter().zip(&now.clouds) {
            assert_eq!(timeline.cloud_at(rest, clock_s).as_ref().unwrap_or(rest), now);
        }
        for (rest, now) in keyed.models.iter().zip(&now.models) {
            let looks = timeline.model_at(rest.id, clock_s);
            assert_eq!(looks.as_ref().unwrap_or(rest), now);
        }
        for (rest, now) in keyed.cameras.iter().zip(&now.cameras) {
            assert_eq!(timeline.camera_at(rest, clock_s), *now);
        }
        let around = timeline.surroundings_at(&keyed, clock_s);
        assert_eq!((&around.sky, &around.ground, &around.sun), (&now.sky, &now.ground, &now.sun));
        assert_eq!(around.aircraft, now.aircraft);
        for target in &targets {
            let range = target.property.kind.number().expect("a number");
            for part in 0..target.parts() {
                let number = number_of(&now, part_of(*target, part));
                assert!(range.allows(number), "{target} is {number} at {clock_s} s");
            }
        }
    }
}

/// Unless its hours are keyed, a day runs with the clock, as fast as the weather says.
#[test]
fn a_day_runs_by_the_clock() {
    let mut scene = Scene { time_of_day_h: 22.0, ..rich() };
    for (day_speed, clock_s, wanted) in [
        (0.0, 1e7, 22.0),
        (1.0, 3600.0, 23.0),
        (1440.0, 10.0, 2.0),
        (1440.0, -60.0, 22.0),
        (1e6, f64::NAN, 22.0),
        (1e6, f64::INFINITY, 22.0),
        (1e6, f64::MAX, 22.0),
    ] {
        scene.weather.day_speed = day_speed;
        let found = Timeline::new(&scene).time_of_day_h(&scene, clock_s);
        assert!((found - wanted).abs() < 1e-9, "{found} at {clock_s} s, {day_speed} times as fast");
        let keyed = one(&scene, "time_of_day_h", &[25.5]);
        assert_eq!(Timeline::new(&keyed).time_of_day_h(&keyed, clock_s), 1.5, "keys are in its place");
    }
}
