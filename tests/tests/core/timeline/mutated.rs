//! Tracks of a scene file with anything in them: refused in words, or moved by at any clock; never a panic.

use super::dice::Dice;
use super::rich;
use cloudwright_core::derived::Derived;
use cloudwright_core::formats::scene_file;
use cloudwright_core::problem::Severity;
use cloudwright_core::scene::{KeyValue, Scene, Track, TrackId, TrackKey};
use cloudwright_core::weather::{Moment, SceneNow, WeatherRules};
use serde_json::{Value, json};

/// Six tracks, of numbers, angles, points and colours.
fn keyed() -> Value {
    let mut scene = rich();
    scene.weather.wind_speed_mps = 8.0;
    let (cloud, model) = (scene.clouds[0].id, scene.models[0].id);
    for (property, three) in [
        ("weather/wind_speed_mps".to_owned(), false),
        ("weather/wind_from_deg".into(), false),
        (format!("cloud/{cloud}/position"), true),
        (format!("cloud/{cloud}/wind_share"), false),
        (format!("model/{model}/color_levels/1/color"), true),
        ("time_of_day_h".into(), false),
    ] {
        let value = |number: f64| if three { KeyValue::Three([number; 3]) } else { KeyValue::One(number) };
        let keys =
            vec![TrackKey::new(0.0, value(0.25)), TrackKey::new(7.0, value(0.75)), TrackKey::new(9.5, value(0.5))];
        let id = TrackId::new(&mut scene.next_id);
        scene.tracks.push(Track::new(id, property, keys));
    }
    serde_json::from_str(&scene_file::write(&scene).expect("sound")).expect("JSON")
}

/// Something that may stand anywhere in a track.
fn anything(dice: &mut Dice, addresses: &[String]) -> Value {
    let number = dice.one_of(&[0.0, 1.0, -1.0, 0.3, 7.0, 360.0, 1e-300, 1e7, 1e8, -1e8, 1e9, 1e308, -1e308]);
    match dice.below(9) {
        0 => json!(dice.one_of(&["hold", "repeat", "swing", "step", "linear", "smooth", "", "é", "cloud/1"])),
        1 => json!(addresses[dice.below(addresses.len())]),
        2 => json!([number, number, number]),
        3 => json!([number]),
        4 => json!({ "arrives": number, "leaves": -number }),
        5 => json!({ "arrives": [number, 0, 1], "leaves": [1, 2, number] }),
        6 => json!(number as i64),
        7 => Value::Null,
        _ => json!(number),
    }
}

/// Of the kind that belongs there, though the number may be any.
fn mutate_soundly(scene: &mut Value, dice: &mut Dice) {
    let tracks = scene["scene"]["tracks"].as_array_mut().expect("a list");
    let at = dice.below(tracks.len());
    let track = &mut tracks[at];
    track[dice.one_of(&["before", "after"])] = json!(dice.one_of(&["hold", "repeat", "swing"]));
    let keys = track["keys"].as_array_mut().expect("a list");
    let (at, slope) = (dice.below(keys.len()), dice.one_of(&[0.0, 0.1, -3.0, 1e9, -1e300, 1e308]));
    let key = &mut keys[at];
    let shaped = |number: f64| if key["value"].is_array() { json!([number, -number, 0.5]) } else { json!(number) };
    let (handles, value) = (json!({ "arrives": shaped(-slope), "leaves": shaped(slope) }), shaped(dice.share()));
    match dice.below(5) {
        0 => key["handles"] = handles,
        1 => key["leaves"] = json!(dice.one_of(&["step", "linear", "smooth"])),
        2 => key["turns"] = json!(dice.one_of(&[0, 1, -7, i32::MAX, i32::MIN])),
        3 => key["time_s"] = json!(key["time_s"].as_f64().unwrap_or(0.0) + dice.one_of(&[1e-9, 0.4, -0.4, -1e-300])),
        _ => key["value"] = value,
    }
}

fn mutate(scene: &mut Value, dice: &mut Dice, addresses: &[String]) {
    let new = anything(dice, addresses);
    let tracks = scene["scene"]["tracks"].as_array_mut().expect("a list");
    let at = dice.below(tracks.len());
    let track = &mut tracks[at];
    let count = track["keys"].as_array().map_or(0, Vec::len);
    if count == 0 || dice.share() < 0.3 {
        track[dice.one_of(&["property", "before", "after", "keys", "id", "kyes"])] = new;
        return;
    }
    let key = dice.below(count);
    match dice.below(8) {
        doubled @ (0 | 1) => {
            let keys = track["keys"].as_array_mut().expect("there is a key");
            let taken = keys.remove(key);
            keys.extend((0..2 * doubled).map(|_| taken.clone()));
        }
        2 => track["keys"][key] = new,
        _ if !track["keys"][key].is_object() => {}
        _ => {
            let field = dice.one_of(&["time_s", "value", "value", "leaves", "turns", "handles", "handles"]);
            track["keys"][key][field] = new;
        }
    }
}

fn evaluate(scene: &Scene, dice: &mut Dice) {
    let derived = Derived::new(scene);
    let timeline = derived.timeline();
    for clock_s in [0.0, dice.within([-20.0, 20.0]), dice.one_of(&[1e7, -1e7, 1e12]), f64::NAN, f64::INFINITY] {
        let now = timeline.scene_at(scene, clock_s);
        assert!(now.weather.wind_speed_mps.is_finite() && (0.0..24.0).contains(&now.time_of_day_h));
        assert!(now.clouds.iter().all(|cloud| cloud.position.is_finite()));
        if let Some(wind) = timeline.wind() {
            assert!(wind.way_m(clock_s).is_finite() && wind.lean(clock_s).middle.is_finite());
        }
        if clock_s.abs() < 1e9 {
            let rules = WeatherRules::default();
            let now = SceneNow::new(scene, (derived.clouds(), timeline), Moment::at(clock_s), rules);
            assert!(now.clouds.iter().all(|cloud| cloud.displacement.is_finite()), "at {clock_s} s");
        }
    }
}

#[test]
fn tracks_with_anything_in_them_are_refused_or_move() {
    let (sound, rich) = (keyed(), rich());
    let addresses: Vec<String> = super::targets(&rich).iter().map(ToString::to_string).collect();
    let (mut read, mut refused) = (0, 0);
    for case in 0..600 {
        let (mut dice, mut scene) = (Dice::new(case), sound.clone());
        (0..dice.below(6)).for_each(|_| mutate_soundly(&mut scene, &mut dice));
        if case % 2 == 0 {
            (0..1 + dice.below(3)).for_each(|_| mutate(&mut scene, &mut dice, &addresses));
        }
        match scene_file::read(scene.to_string().as_bytes()) {
            Ok(scene) => {
                read += 1;
                evaluate(&scene, &mut dice);
            }
            Err(problems) => {
                refused += 1;
                for problem in &problems {
                    assert_eq!(problem.severity, Severity::Error);
                    assert!([&problem.place, &problem.message, &problem.hint].iter().all(|text| !text.is_empty()));
                }
            }
        }
    }
    assert!(read > 100 && refused > 100, "{read} read, {refused} refused");
}
