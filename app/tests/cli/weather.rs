//! What subcommands make of tracks and wind: at any time, in any order.

use crate::Place;
use crate::scenes::changed;
use serde_json::{Value, json};

fn key(time_s: f64, value: impl Into<Value>) -> Value {
    json!({ "time_s": time_s, "value": value.into() })
}

fn track(id: u64, property: &str, keys: &Value) -> Value {
    json!({ "id": id, "property": property, "keys": keys })
}

/// The sound scene with these tracks, and a wind from the west of so many metres a second.
fn moved(wind_speed_mps: f64, tracks: &Value) -> Vec<u8> {
    changed(|scene| {
        scene["next_id"] = json!(1000);
        scene["weather"] = json!({ "wind_speed_mps": wind_speed_mps });
        scene["tracks"] = tracks.clone();
    })
}

/// Ids of the sound scene: its first camera, and its western cloud.
fn ids() -> [u64; 2] {
    let scene: Value = serde_json::from_str(&crate::scenes::good()).expect("JSON");
    ["cameras", "clouds"].map(|list| scene["scene"][list][0]["id"].as_u64().expect("an id"))
}

fn turning_camera() -> Value {
    let [camera, _] = ids();
    track(901, &format!("camera/{camera}/heading_deg"), &json!([key(0.0, 0.0), key(2.0, 40.0)]))
}

fn picture(place: &Place, scene: &str, clock_s: f64) -> Vec<u8> {
    let words = format!("render {scene} -o out.png --size 96x54 --renderer cpu --at {clock_s}");
    let ran = place.run(&words);
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{words}: {}", ran.stderr);
    place.read("out.png")
}

/// By the wind, a cloud's track, the sky's, the camera's and the day's, each alone.
#[test]
fn pictures_follow_the_clock_in_any_order() {
    let place = Place::new();
    let [_, cloud] = ids();
    let sky = track(901, "sky/exposure_ev", &json!([key(0.0, 0.0), key(60.0, 2.0)]));
    let carried =
        track(901, &format!("cloud/{cloud}/position"), &json!([key(0.0, [-900, 900, 0]), key(60.0, [0, 900, 0])]));
    let day = track(901, "time_of_day_h", &json!([key(0.0, 8.0), key(60.0, 17.0)]));
    for (name, wind_speed_mps, tracks) in [
        ("wind", 12.0, json!([])),
        ("sky", 0.0, json!([sky])),
        ("cloud", 0.0, json!([carried])),
        ("day", 0.0, json!([day])),
        ("camera", 0.0, json!([turning_camera()])),
    ] {
        place.put("moved.cloudscene", &moved(wind_speed_mps, &tracks));
        let times = [0.0, 0.7, 1.3, 40.0];
        let in_order = times.map(|clock_s| picture(&place, "moved.cloudscene", clock_s));
        for (at, clock_s) in [(2, 1.3), (0, 0.0), (3, 40.0), (1, 0.7), (1, 0.7)] {
            assert!(picture(&place, "moved.cloudscene", clock_s) == in_order[at], "{name}: {clock_s} s once more");
        }
        assert!(in_order[0] != in_order[3], "{name}: nothing has moved");
        // In air that stands still all is as if there were no clock.
        let same = in_order[0] == picture(&place, "good.cloudscene", 7.0);
        assert_eq!(same, name == "cloud" || name == "camera" || name == "sky", "{name}: at second 0");
    }
}

#[test]
fn an_export_says_where_sprites_have_got_to() {
    let place = Place::new();
    place.put("moved.cloudscene", &moved(15.0, &json!([])));
    let xs = |clock_s: f64| -> Vec<f64> {
        let ran = place.run(&format!("export moved.cloudscene -o out.json --at {clock_s}"));
        assert_eq!(ran.code, 0, "{}", ran.stderr);
        let json: Value = serde_json::from_slice(&place.read("out.json")).expect("JSON");
        let clouds = json["clouds"].as_array().expect("a list").iter();
        let sprites = clouds.flat_map(|cloud| cloud["sprites"].as_array().expect("a list"));
        sprites.map(|sprite| sprite["position"][0].as_f64().expect("a number")).collect()
    };
    let (rest, later) = (xs(0.0), xs(20.0));
    assert_eq!(rest.len(), later.len());
    let (way, count) = (rest.iter().zip(&later).map(|(a, b)| b - a), rest.len() as f64);
    // The wind is steady, and edges lean from second 0 on as they do later. Positions are written to the centimetre.
    let mean = way.sum::<f64>() / count;
    assert!((mean - 300.0).abs() < 0.1, "15 m/s for 20 s: {mean} m");
}

fn fly(place: &Place, words: &str) -> String {
    let ran = place.run(&format!("fly moved.cloudscene --size 64x36 --renderer cpu {words}"));
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{words}: {}", ran.stderr);
    ran.stderr
}

#[test]
fn weather_is_filmed_from_a_camera() {
    let place = Place::new();
    place.put("moved.cloudscene", &moved(12.0, &json!([turning_camera()])));
    // The last key is at 2 s: frames 0 to 8.
    assert!(fly(&place, "--still main -o all --fps 4").contains("9 drawn, 0 kept"));
    fly(&place, "--still main -o some --fps 4 --frames 5..7");
    fly(&place, "--still above -o above --seconds 1 --fps 2");
    let count = |folder: &str| std::fs::read_dir(place.path(folder)).expect("made").count();
    assert_eq!([count("all"), count("some"), count("above")], [9, 2, 3]);
    let frame = |folder: &str, name: &str, number: u32| place.read(&format!("{folder}/still_{name}_{number:05}.png"));
    for number in [5, 6] {
        assert!(frame("all", "main", number) == frame("some", "main", number), "alone or in a sequence: {number}");
    }
    // It is what render draws at that time.
    let rendered = |camera: &str, clock_s: f64| {
        let words =
            format!("render moved.cloudscene -o out.png --size 64x36 --renderer cpu --camera {camera} --at {clock_s}");
        assert_eq!(place.run(&words).code, 0, "{words}");
        place.read("out.png")
    };
    assert!(frame("all", "main", 6) == rendered("main", 1.5));
    assert!(frame("above", "above", 2) == rendered("above", 1.0));
    assert!(frame("above", "above", 0) != frame("above", "above", 2), "the wind goes on");
}

#[test]
fn what_cannot_be_filmed_is_said_before_drawing() {
    let place = Place::new();
    place.put("moved.cloudscene", &moved(12.0, &json!([turning_camera()])));
    let fly = "fly moved.cloudscene --size 64x36 --renderer cpu -o out";
    for (words, wanted) in [
        ("--still nowhere", &["moved.cloudscene", "“nowhere”", "main, above"][..]),
        ("--still mian", &["did you mean `main`?"]),
        ("--still main --seconds NaN", &["--seconds", "write seconds, 0 to 1000000"]),
        ("--still main --seconds=-1", &["--seconds", "write seconds"]),
        ("--still main --path west", &["--path"]),
        ("--still main --sorting crossfade", &["--sorting"]),
        ("--seconds 3", &["--still"]),
        ("", &["--path"]),
        ("--still main --frames 0..70", &["--frames 0..70", "there are 61 frames", "0..61"]),
        ("--still main --seconds 0 --frames 1..2", &["there is 1 frame", "0..1"]),
    ] {
        place.refuses(&format!("{fly} {words}"), 2, wanted);
    }
    place.refuses(
        "fly good.cloudscene --still main -o out",
        2,
        &["good.cloudscene", "none has a key after second 0", "--seconds 20"],
    );
    for at in ["NaN", "inf", "1e7"] {
        place.refuses(&format!("render good.cloudscene -o out.png --at {at}"), 2, &["--at", "write seconds"]);
        place.refuses(&format!("chart good.cloudscene -o out --at {at}"), 2, &["--at", "write seconds"]);
    }
    place.refuses("chart good.cloudscene -o out --at 3 --path west", 2, &["--at", "--path"]);
}

#[test]
fn a_chart_is_of_a_moment() {
    let place = Place::new();
    place.put("moved.cloudscene", &moved(12.0, &json!([turning_camera()])));
    let chart = |words: &str| {
        let words =
            format!("chart moved.cloudscene -o out --size 48x27 --repeat 1 --methods truth,half --json {words}");
        let ran = place.run(&words);
        assert_eq!(ran.code, 0, "{words}: {}", ran.stderr);
        let report: Value = serde_json::from_str(&ran.stdout).expect("JSON");
        (report["methods"][1]["error"]["flip_mean"].as_f64().expect("a number"), ran.stderr)
    };
    let (rest, _) = chart("--camera main");
    let (later, said) = chart("--camera main --at 1.5");
    assert!(rest != later, "{rest}: the camera has turned");
    assert!(said.contains("of something else"), "what was measured of another moment is not kept: {said}");
    assert_eq!(chart("--camera main --at 1.5").0, later);
}

#[test]
fn info_lists_tracks() {
    let place = Place::new();
    let [camera, cloud] = ids();
    let mut swings =
        track(902, &format!("cloud/{cloud}/opacity"), &json!([key(-2.0, 0.0), key(3.5, 1.0), key(60.0, 0.0)]));
    (swings["before"], swings["after"]) = (json!("swing"), json!("repeat"));
    place.put("moved.cloudscene", &moved(0.0, &json!([turning_camera(), swings])));
    let ran = place.run("info --json moved.cloudscene");
    let counts: Value = serde_json::from_str(&ran.stdout).expect("JSON");
    let [heading, opacity] = [format!("camera/{camera}/heading_deg"), format!("cloud/{cloud}/opacity")];
    assert_eq!(
        counts["tracks"],
        json!([
            { "property": heading, "keys": 2, "from_s": 0.0, "to_s": 2.0, "before": "hold", "after": "hold" },
            { "property": opacity, "keys": 3, "from_s": -2.0, "to_s": 60.0, "before": "swing", "after": "repeat" },
        ])
    );
    let text = place.run("info moved.cloudscene").stdout;
    let words = |name: &str| {
        let line = text.lines().find(|line| line.starts_with(name)).unwrap_or_else(|| panic!("no {name} in {text}"));
        line.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    assert_eq!(words("track "), "track keys from, s to, s before after");
    assert_eq!(words(&heading), format!("{heading} 2 0.0 2.0 holds holds"));
    assert_eq!(words(&opacity), format!("{opacity} 3 -2.0 60.0 swings repeats"));
    assert!(!place.run("info good.cloudscene").stdout.contains("track"), "a scene without tracks says nothing of them");
}

#[test]
fn check_knows_broken_tracks() {
    let place = Place::new();
    let [_, cloud] = ids();
    let opacity = format!("cloud/{cloud}/opacity");
    let of = |property: &str, keys: Value| json!([track(901, property, &keys)]);
    for (tracks, wanted) in [
        (
            of("cloud/7", json!([key(0.0, 1.0)])),
            "tracks[0].property: error: “cloud/7” is no property that can be keyed",
        ),
        (of(&format!("cloud/{cloud}/opacty"), json!([key(0.0, 1.0)])), "(did you mean "),
        (of("cloud/99999/opacity", json!([key(0.0, 1.0)])), "note: there is no cloud/99999/opacity"),
        (of(&opacity, json!([])), "tracks[0].keys: error: it has 0 keys"),
        (of(&opacity, json!([key(0.0, 2.0)])), "tracks[0].keys[0].value: error: 2 is out of range"),
        (of(&opacity, json!([key(1.0, 0.0), key(1.0, 1.0)])), "tracks[0].keys[1].time_s: error: two keys at 1 s"),
        (of(&opacity, json!([key(1.0, 0.0), key(0.5, 1.0)])), "is before the key before it, at 1 s"),
        (of(&opacity, json!([key(1e300, 0.0)])), "is no time"),
        (of(&opacity, json!([key(0.0, [1, 1, 1])])), "tracks[0].keys[0].value: error: 3 numbers, where"),
        (
            json!([track(901, &opacity, &json!([key(0.0, 1.0)])), track(902, &opacity, &json!([key(0.0, 0.0)]))]),
            "tracks[1].property: error: tracks[0] moves",
        ),
    ] {
        place.put("broken.cloudscene", &moved(0.0, &tracks));
        let ran = place.run("check broken.cloudscene");
        assert_eq!(ran.code, 1, "{wanted}: {} {}", ran.stdout, ran.stderr);
        assert!(
            ran.stdout.starts_with("broken.cloudscene: ") && ran.stdout.contains(wanted),
            "{wanted}: {}",
            ran.stdout
        );
        let is_note = wanted.starts_with("note");
        let draws = place.run("render broken.cloudscene -o out.png --size 16x9 --renderer cpu").code;
        assert_eq!(draws, if is_note { 0 } else { 2 }, "{wanted}: a scene with errors can't be used");
    }
}
