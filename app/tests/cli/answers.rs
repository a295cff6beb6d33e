//! What `check`, `info` and `export` say about sound scenes.

use crate::Place;
use crate::scenes::changed;
use serde_json::{Value, json};

fn as_json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error} in {text}"))
}

#[test]
fn check_of_a_sound_scene_has_nothing_to_say() {
    let place = Place::new();
    let ran = place.run("check good.cloudscene");
    // A box of 30 sprites is a group of at most 30: no note.
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{}", ran.stderr);
    assert_eq!(as_json(&place.run("check --json good.cloudscene").stdout), json!([]));
}

#[test]
fn check_marks_notes() {
    let place = Place::new();
    place.put("crowd.cloudscene", &changed(|s| s["models"][0]["boxes"][0]["sprite_count"] = json!(300)));
    let ran = place.run("check crowd.cloudscene");
    assert_eq!(ran.code, 1);
    assert!(ran.stdout.starts_with("crowd.cloudscene: clouds[0]: note: shading group"), "{}", ran.stdout);
    let ran = place.run("check --json crowd.cloudscene good.cloudscene");
    let problems = as_json(&ran.stdout);
    assert_eq!(
        (ran.code, &problems[0]["severity"], &problems[0]["file"]),
        (1, &json!("note"), &json!("crowd.cloudscene"))
    );
    for key in ["place", "message", "hint"] {
        assert!(problems[0][key].as_str().is_some_and(|text| !text.is_empty()), "{key}");
    }
}

#[test]
fn info_counts() {
    let place = Place::new();
    let ran = place.run("info --json good.cloudscene");
    assert_eq!((ran.code, ran.stderr.as_str()), (0, ""));
    let counts = as_json(&ran.stdout);
    assert_eq!((&counts["models"], &counts["boxes"], &counts["total"]["clouds"]), (&json!(1), &json!(2), &json!(2)));
    assert_eq!(counts["total"]["sprites_tried"], json!(120), "two boxes of 30, placed twice");
    let clouds = counts["clouds"].as_array().expect("a list");
    let kept: u64 = clouds.iter().filter_map(|cloud| cloud["sprites"].as_u64()).sum();
    assert!(kept > 0 && kept < 120, "culling takes some");
    assert_eq!(counts["total"]["sprites"], json!(kept));
    let low = |which: &Value| which["bounds"]["low"][0].as_f64().expect("a number");
    assert_eq!(low(&counts["total"]), low(&clouds[0]), "the western cloud bounds the west");
    let text = place.run("info good.cloudscene").stdout;
    for word in ["good: 1 model, 2 boxes, 2 clouds\n", "main, above", "west", "east", "total", "bounds"] {
        assert!(text.contains(word), "no {word} in {text}");
    }
}

#[test]
fn info_tells_of_what_folders_hide() {
    let place = Place::new();
    let hidden = |on: bool| {
        changed(|s| {
            s["folders"] = json!([{ "id": 900, "name": "put by", "hidden": on }]);
            s["clouds"][0]["folder"] = json!(900);
            s["next_id"] = json!(1000);
        })
    };
    for (on, clouds) in [(true, 1), (false, 2)] {
        place.put("folder.cloudscene", &hidden(on));
        let counts = as_json(&place.run("info --json folder.cloudscene").stdout);
        assert_eq!((&counts["hidden_clouds"], &counts["total"]["clouds"]), (&json!(2 - clouds), &json!(clouds)));
        let text = place.run("info folder.cloudscene").stdout;
        assert_eq!(text.contains("hidden: 1 cloud in hidden folders"), on, "{text}");
    }
}

#[test]
fn info_lists_paths_and_who_flies_along_them() {
    let place = Place::new();
    let key = |time_s: f64| json!({ "time_s": time_s, "position": [time_s, 900, 0], "heading_deg": 0, "pitch_deg": 0 });
    let path =
        |id: u64, name: &str, keys: Value| json!({ "id": id, "name": name, "field_of_view_deg": 60, "keys": keys });
    let flight = changed(|s| {
        let through = path(90, "through", json!([key(2.0), key(5.0), key(9.5)]));
        s["paths"] = json!([through, path(91, "post", json!([key(1.0)]))]);
        let aircraft = |id: u64, name: &str| json!({ "id": id, "name": name, "path": 90 });
        s["aircraft"] = json!([aircraft(92, "trainer"), aircraft(93, "wingman")]);
        s["next_id"] = json!(94);
    });
    place.put("flight.cloudscene", &flight);
    assert_eq!(
        as_json(&place.run("info --json flight.cloudscene").stdout)["paths"],
        json!([
            { "name": "through", "duration_s": 7.5, "keys": 3, "aircraft": ["trainer", "wingman"] },
            { "name": "post", "duration_s": 0.0, "keys": 1, "aircraft": [] },
        ])
    );
    let text = place.run("info flight.cloudscene").stdout;
    let words = |name: &str| {
        let line = text.lines().find(|line| line.starts_with(name)).unwrap_or_else(|| panic!("no {name} in {text}"));
        line.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    assert_eq!(words("path "), "path seconds keys aircraft");
    assert_eq!(words("through"), "through 7.5 3 trainer, wingman");
    assert_eq!(words("post"), "post 0.0 1 none");
}

#[test]
fn export_writes_each_kept_sprite() {
    let place = Place::new();
    let counts = as_json(&place.run("info --json good.cloudscene").stdout);
    let kept = counts["total"]["sprites"].as_u64().expect("a number") as usize;
    for words in ["", " --shaded", " --shaded --time 18:30 --camera above"] {
        for ending in ["json", "csv"] {
            let words = format!("export good.cloudscene -o out.{ending}{words}");
            let ran = place.run(&words);
            assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{words}");
            assert!(
                ran.stderr.starts_with("not carried: ") && ran.stderr.contains("cameras"),
                "{words}: {}",
                ran.stderr
            );
        }
        let json = as_json(&String::from_utf8_lossy(&place.read("out.json")));
        let of = |cloud: &Value| cloud["sprites"].as_array().map_or(0, Vec::len);
        assert_eq!(json["clouds"].as_array().expect("a list").iter().map(of).sum::<usize>(), kept);
        assert_eq!(json["clouds"][0]["sprites"][0]["corners"].is_array(), !words.is_empty());
        let csv = String::from_utf8(place.read("out.csv")).expect("text");
        assert_eq!(csv.lines().count(), kept + 1, "a line each, and one of heads");
    }
    let shaded_at = |time: &str| {
        place.run(&format!("export good.cloudscene -o out.csv --shaded --time {time}"));
        place.read("out.csv")
    };
    assert_ne!(shaded_at("12:00"), shaded_at("18:30"));
}

#[test]
fn an_export_says_in_json_what_it_wrote_and_what_not() {
    let place = Place::new();
    let ran = place.run("export good.cloudscene -o out.csv --json --cloud west");
    assert_eq!((ran.code, ran.stderr.as_str()), (0, ""));
    let answer = as_json(&ran.stdout);
    assert_eq!((&answer["format"], &answer["files"]), (&json!("csv"), &json!(["out.csv"])));
    assert_eq!(answer["notes"][0]["kind"], "left_out");
    let only = String::from_utf8(place.read("out.csv")).expect("text");
    assert!(only.lines().skip(1).all(|line| line.split(',').nth(1) == Some("west")) && only.lines().count() > 1);
}

#[test]
fn formats_are_listed_with_what_they_carry() {
    let place = Place::new();
    let listed = as_json(&place.run("formats --json").stdout);
    let text = place.run("formats").stdout;
    for row in listed.as_array().expect("a list") {
        let name = row["name"].as_str().expect("a name");
        assert!(text.lines().any(|line| line.starts_with(name)), "{name} is not in: {text}");
        assert!(row["written"] == true || row["read"] == true, "{name}");
        assert!(!row["carries"].as_array().expect("a list").is_empty(), "{name}");
    }
}

#[test]
fn an_export_never_replaces_the_scene_it_is_made_from() {
    let place = Place::new();
    place.put("scene.json", place.read("good.cloudscene").as_slice());
    place.refuses("export scene.json -o scene.json", 2, &["scene.json", "the scene itself", "another name"]);
    assert_eq!(place.read("scene.json"), place.read("good.cloudscene"));
}

#[cfg(unix)]
#[test]
fn a_link_to_nowhere_is_not_replaced() {
    let place = Place::new();
    std::os::unix::fs::symlink("nowhere.csv", place.path("link.csv")).expect("allowed");
    place.refuses("export good.cloudscene -o link.csv", 3, &["link.csv", "leads nowhere"]);
}

#[test]
fn a_missing_file_is_in_the_list_too() {
    let ran = Place::new().run("check --json good.cloudscene missing.cloudscene");
    let list = as_json(&ran.stdout);
    assert_eq!((ran.code, &list[0]["file"], &list[0]["place"]), (2, &json!("missing.cloudscene"), &json!("file")));
}
