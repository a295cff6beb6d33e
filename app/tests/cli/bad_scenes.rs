//! Scene files with every kind of fault: each subcommand says where and what to do, and leaves nothing behind.

use crate::Place;
use crate::scenes::{aircraft, changed, good, replaced};
use serde_json::json;

/// What is wrong, the file, the place named, a word of the hint.
type Case = (&'static str, Vec<u8>, &'static str, &'static str);

fn cases() -> Vec<Case> {
    let text = good();
    vec![
        ("empty", Vec::new(), "line 1", "empty"),
        ("binary", vec![0xff, 0xfe, 0, 1, 2, 0x80], "line 1", "not text"),
        ("zeros", vec![0; 64], "line 1", "mend the JSON"),
        ("another format", b"<xml/>".to_vec(), "line 1, column 1", "mend the JSON"),
        ("no head", b"{}".to_vec(), "line 1", "begins"),
        ("a list", b"[1, 2]".to_vec(), "line 1", "begins"),
        ("cut off in the middle", text.as_bytes()[..text.len() / 2].to_vec(), "line ", "cut off"),
        ("cut off at the end", text.as_bytes()[..text.trim_end().len() - 1].to_vec(), "line ", "cut off"),
        ("something behind", [text.as_bytes(), b"{}"].concat(), "line ", "mend the JSON"),
        ("other program's", replaced("cloudwright-scene", "other-scene"), "format", "cloudwright-scene"),
        ("a newer version", replaced("\"version\": 1", "\"version\": 7"), "version", "newer"),
        (
            "text for a number",
            replaced("\"time_of_day_h\": 12", "\"time_of_day_h\": \"noon\""),
            "time_of_day_h",
            "schema",
        ),
        (
            "1e999",
            replaced("\"time_of_day_h\": 12", "\"time_of_day_h\": 1e999"),
            "time_of_day_h",
            "number out of range",
        ),
        ("24 h", changed(|s| s["time_of_day_h"] = json!(24)), "time_of_day_h", "0 to 23.999"),
        (
            "a negative size",
            changed(|s| s["models"][0]["boxes"][0]["size"][1] = json!(-5)),
            "models[0].boxes[0].size.y",
            "use 0 to",
        ),
        (
            "a negative count",
            changed(|s| s["models"][0]["boxes"][0]["sprite_count"] = json!(-5)),
            "sprite_count",
            "schema",
        ),
        (
            "10^9 sprites",
            changed(|s| s["models"][0]["boxes"][0]["sprite_count"] = json!(1_000_000_000)),
            "models[0].boxes[0].sprite_count",
            "use 0 to",
        ),
        ("5 million sprites together", changed(many_sprites), "clouds", "lower sprite_count"),
        ("one id twice", changed(|s| s["clouds"][1]["id"] = s["clouds"][0]["id"].clone()), "clouds[1].id", ""),
        (
            "4 colour levels",
            changed(|s| drop(s["models"][0]["color_levels"].as_array_mut().map(Vec::pop))),
            "color_levels",
            "exactly five",
        ),
        ("6 colour levels", changed(six_levels), "models[0].color_levels", "exactly five"),
        ("an empty table", changed(|s| s["sky"]["ambient"] = json!([])), "sky.ambient", "at least one key"),
        (
            "two keys at one time",
            changed(|s| s["sky"]["ambient"][1]["hour"] = s["sky"]["ambient"][0]["hour"].clone()),
            "sky.ambient[1].hour",
            "take one away",
        ),
        (
            "keys out of order",
            changed(|s| s["sky"]["directional"][2]["hour"] = json!(23)),
            "sky.directional[3].hour",
            "rising order",
        ),
        (
            "a model that is missing",
            changed(|s| s["clouds"][0]["model"] = json!(777)),
            "clouds[0].model",
            "the models are",
        ),
        ("a name misspelt", replaced("\"exposure_ev\"", "\"exposure_eV\""), "sky", "did you mean `exposure_ev`"),
        (
            "an unknown category",
            replaced("cumulus_humilis", "cumulus_humulis"),
            "category",
            "did you mean `cumulus_humilis`",
        ),
        ("a missing part", changed(|s| drop(s.as_object_mut().map(|o| o.remove("sky")))), "sky", "add it"),
        ("an atlas that is missing", changed(|s| s["atlas"] = json!("none.png")), "atlas", "beside the scene file"),
        ("an atlas elsewhere", changed(|s| s["atlas"] = json!("../secret.png")), "atlas", "beside the scene file"),
        (
            "an atlas by its whole path",
            changed(|s| s["atlas"] = json!("/etc/hostname")),
            "atlas",
            "beside the scene file",
        ),
        ("an atlas that is no PNG", changed(|s| s["atlas"] = json!("notes.txt")), "atlas", "512 × 512"),
        ("a model that is missing", changed(|s| aircraft(s, "none.glb")), "aircraft[0].model", "beside the scene file"),
        ("a model elsewhere", changed(|s| aircraft(s, "../secret.glb")), "aircraft[0].model", "copy it there"),
        ("a model that is none", changed(|s| aircraft(s, "notes.txt")), "aircraft[0].model", "built-in aircraft"),
    ]
}

fn many_sprites(scene: &mut serde_json::Value) {
    for each in 0..2 {
        scene["models"][0]["boxes"][each]["sprite_count"] = json!(1_000_000);
    }
    for id in 900..902 {
        let mut cloud = scene["clouds"][0].clone();
        cloud["id"] = json!(id);
        scene["clouds"].as_array_mut().expect("a list").push(cloud);
    }
    scene["next_id"] = json!(1000);
}

fn six_levels(scene: &mut serde_json::Value) {
    let levels = scene["models"][0]["color_levels"].as_array_mut().expect("a list");
    levels.push(levels[4].clone());
}

/// A place with the case's file in it.
fn place_with(bytes: &[u8]) -> Place {
    let place = Place::new();
    place.put("notes.txt", b"not a picture");
    place.put("bad.cloudscene", bytes);
    place
}

#[test]
fn check_names_place_and_way_out() {
    for (name, bytes, wanted_place, hint) in cases() {
        let ran = place_with(&bytes).run("check bad.cloudscene");
        assert_eq!(ran.code, 1, "{name}: {}{}", ran.stdout, ran.stderr);
        assert_eq!(ran.stderr, "", "{name}");
        let line = ran.stdout.lines().find(|line| line.contains(wanted_place) && line.contains(hint));
        let line = line.unwrap_or_else(|| panic!("{name}: no {wanted_place} with “{hint}” in: {}", ran.stdout));
        assert!(
            line.starts_with("bad.cloudscene: ") && line.contains(": error: ") && line.ends_with(')'),
            "{name}: {line}"
        );
    }
}

#[test]
fn render_refuses_and_leaves_nothing() {
    for (_, bytes, wanted_place, hint) in cases() {
        place_with(&bytes).refuses(
            "render bad.cloudscene -o out.png --size 8x8",
            2,
            &["bad.cloudscene", wanted_place, hint],
        );
    }
}

#[test]
fn info_and_export_refuse_too() {
    // What lies beside the scene is no business of theirs.
    let is_beside = |place| place == "atlas" || place == "aircraft[0].model";
    for (_, bytes, wanted_place, hint) in cases().into_iter().filter(|(.., place, _)| !is_beside(*place)) {
        let place = place_with(&bytes);
        place.refuses("info bad.cloudscene", 2, &["bad.cloudscene", wanted_place, hint]);
        place.refuses("export bad.cloudscene -o out.json", 2, &["bad.cloudscene", wanted_place, hint]);
    }
}

#[test]
fn files_that_cannot_be_read() {
    let place = Place::new();
    for command in ["check {}", "info {}", "render {} -o out.png", "export {} -o out.csv"] {
        place.refuses(&command.replace("{}", "none.cloudscene"), 2, &["none.cloudscene", "check the name"]);
        place.refuses(&command.replace("{}", "."), 2, &["folder", "give a file"]);
        place.refuses(&command.replace("{}", "good.cloudscene/x"), 2, &["good.cloudscene/x", "check the name"]);
    }
}

#[test]
fn one_unreadable_file_does_not_hide_the_others() {
    let place = place_with(b"");
    let ran = place.run("check none.cloudscene bad.cloudscene good.cloudscene");
    assert_eq!(ran.code, 2);
    assert!(ran.stderr.contains("none.cloudscene"), "{}", ran.stderr);
    assert!(ran.stdout.starts_with("bad.cloudscene: line 1: error: the file is empty"), "{}", ran.stdout);
}
