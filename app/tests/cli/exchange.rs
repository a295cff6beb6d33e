//! Scenes to other tools and back by the command line.

use crate::Place;
use serde_json::{Value, json};

impl Place {
    fn does(&self, words: &str) -> String {
        let ran = self.run(words);
        assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "cloudwright {words}: {}", ran.stderr);
        ran.stderr
    }
}

#[test]
fn clouds_leave_as_cld_and_come_back() {
    let place = Place::new();
    let said = place.does("export good.cloudscene -o out.cld");
    assert!(said.contains("2 clouds: each has a file of its own, the last is out_2.cld"), "{said}");
    assert_eq!(place.files(), ["good.cloudscene", "out.cld", "out_2.cld"]);
    let said = place.does("import out.cld -o first.cloudscene");
    assert!(said.starts_with("1 model, 1 cloud\n"), "{said}");
    let said = place.does("import out_2.cld first.cloudscene -o both.cloudscene --at 5000,900,-20");
    assert!(said.contains("a length of 1 is 1 m"), "{said}");
    let count = |scene: &str| -> Value {
        serde_json::from_str(&place.run(&format!("info --json {scene}")).stdout).expect("JSON")
    };
    assert_eq!(count("both.cloudscene")["total"]["sprites"], count("good.cloudscene")["total"]["sprites"]);
    assert_eq!(place.run("check both.cloudscene").code, 0);
}

#[test]
fn one_cloud_leaves_alone() {
    let place = Place::new();
    let ran = place.run("export good.cloudscene -o out.cld --cloud east --set unit_m=0.1 --json");
    let answer: Value = serde_json::from_str(&ran.stdout).expect("JSON");
    assert_eq!((ran.code, &answer["format"], &answer["files"]), (0, &json!("cld"), &json!(["out.cld"])));
    assert_eq!(place.files(), ["good.cloudscene", "out.cld"]);
}

#[test]
fn a_page_begins_as_it_was_asked_to() {
    let place = Place::new();
    place.does("export good.cloudscene -o index.html --time 18:30 --at 4 --camera above");
    let page = String::from_utf8(place.read("index.html")).expect("text");
    assert!(page.contains(r#""start":{"camera":1,"clock_s":4.0,"time_h":18.5}"#));
    assert_eq!(place.files(), ["good.cloudscene", "index.html"]);
}

#[test]
fn a_file_beside_the_one_asked_for_is_no_input_either() {
    let place = Place::new();
    place.put("sky_2.cld", &place.read("good.cloudscene"));
    place.refuses("export sky_2.cld -o sky.cld", 2, &["sky_2.cld", "the scene itself", "another name"]);
}

/// The text and the sheet beside it come together, or neither does.
#[test]
fn a_stage_comes_with_its_sheet() {
    let place = Place::new();
    place.does("export good.cloudscene -o sky.usda");
    assert_eq!(place.files(), ["good.cloudscene", "sky.usda", "sky_atlas.png"]);
    place.does("export good.cloudscene -o sky.usdz");
    let place = Place::new();
    std::fs::create_dir(place.path("sky_atlas.png")).expect("a folder");
    place.refuses("export good.cloudscene -o sky.usda", 3, &["sky_atlas.png", "it is a folder"]);
}

#[test]
fn a_model_from_elsewhere_stands_or_flies_and_lies_beside_the_scene() {
    let place = Place::new();
    std::fs::create_dir(place.path("models")).expect("a folder");
    place.put("models/jet.glb", include_bytes!("../../../assets/models/aircraft.glb"));
    let said = place.does("import models/jet.glb good.cloudscene -o stands.cloudscene --at 10,0,-300");
    assert!(said.contains("a prop of ") && said.contains("copied beside it: jet.glb"), "{said}");
    let scene: Value = serde_json::from_slice(&place.read("stands.cloudscene")).expect("JSON");
    let prop = &scene["scene"]["props"][0];
    assert_eq!((&prop["model"], &prop["position"]), (&"jet.glb".into(), &serde_json::json!([10, 0, -300])));
    assert!(place.run("info stands.cloudscene").stdout.contains("props: jet (jet.glb)"));
    std::fs::remove_file(place.path("jet.glb")).expect("there");
    let ran = place.run("check stands.cloudscene");
    assert!(ran.code == 1 && ran.stdout.contains("props[0].model: error: “jet.glb”"), "{}", ran.stdout);
    let said = place.does("import models/jet.glb good.cloudscene -o flown.cloudscene --set flies=yes");
    assert!(said.contains("an aircraft of ") && said.contains("copied beside it: jet.glb"), "{said}");
    assert_eq!(place.read("jet.glb"), place.read("models/jet.glb"));
    assert_eq!(place.run("check flown.cloudscene").code, 0);
    let scene: Value = serde_json::from_slice(&place.read("flown.cloudscene")).expect("JSON");
    assert_eq!(scene["scene"]["aircraft"][0]["model"], "jet.glb");
    // Beside the scene already: nothing is copied, and once more it is another aircraft.
    let said = place.does("import jet.glb flown.cloudscene -o two.cloudscene --set flies=yes");
    assert!(!said.contains("copied"), "{said}");
    // Another file of that name is not replaced, nor is anything written.
    place.put("models/jet.glb", &[&place.read("jet.glb")[..], b" "].concat());
    place.refuses(
        "import models/jet.glb -o three.cloudscene",
        2,
        &["jet.glb", "another file", "choose another folder"],
    );
    place.put("bad.glb", b"glTF\x02\0\0\0\x1c\0\0\0\x02\0\0\0JSON{}\0\0\0\0BIN\0");
    place.refuses("import bad.glb -o three.cloudscene", 2, &["bad.glb: its model: it is broken", "read as glb"]);
}

const PRESETS: [(&str, &[u8], std::ops::RangeInclusive<f64>); 3] = [
    ("Fog.WPR", include_bytes!("../../../tests/wpr/Fog.WPR"), 7.0..=8.0),
    ("Soaring.WPR", include_bytes!("../../../tests/wpr/Soaring-Ridge.WPR"), 2.2..=4.2),
    ("Windy.WPR", include_bytes!("../../../tests/wpr/Windy.WPR"), 0.0..=0.0),
];

/// As much of the sky is covered as the preset says, by the same measure as `info`'s but for where one stands.
#[test]
fn weather_presets_become_skies() {
    let place = Place::new();
    for (name, bytes, oktas) in PRESETS {
        place.put(name, bytes);
        let said = place.does(&format!("import {name} -o sky.cloudscene --force"));
        let asked = said.lines().find_map(|line| line.split_once(" oktas where ").map(|(before, _)| before));
        let measured = asked.and_then(|before| before.rsplit(' ').next()?.parse::<f64>().ok()).unwrap_or_default();
        assert!(oktas.contains(&measured), "{name}: {said}");
        assert_eq!(place.run("check sky.cloudscene").code, 0, "{name}");
    }
    let said = place.does("import Windy.WPR good.cloudscene -o windy.cloudscene --keep-clouds");
    assert!(said.contains("the preset has no clouds"), "{said}");
    let windy: Value = serde_json::from_slice(&place.read("windy.cloudscene")).expect("JSON");
    assert_eq!(windy["scene"]["weather"]["wind_from_deg"], 225.0);
    let said = place.does("export windy.cloudscene -o out.WPR");
    assert!(said.contains("pressure: 1013.25 hPa") && said.contains("not carried: sprites"), "{said}");
    place.does("import out.WPR -o again.cloudscene");
    let again: Value = serde_json::from_slice(&place.read("again.cloudscene")).expect("JSON");
    let speed = |scene: &Value| scene["scene"]["weather"]["wind_speed_mps"].as_f64().expect("a number");
    assert!((speed(&windy) - speed(&again)).abs() < 1e-3);
}

#[test]
fn what_cannot_come_in_is_said() {
    let place = Place::new();
    place.put("broken.cld", b"\x8C\x23\0\0\x09\0\0\0x\0\0\0\0\0");
    place.put("swapped.cld", b"\0\0\x23\x8C");
    place.put("sky.txt", b"");
    for (words, wanted) in [
        ("import broken.cld -o out.cloudscene", &["broken.cld", "byte 14", "9 sprites", "Flight Simulator 2004"][..]),
        ("import swapped.cld -o out.cloudscene", &["byte 0", "another kind of machine"]),
        ("import sky.txt -o out.cloudscene", &["the ending names no format", ".cld"]),
        ("import sky.txt -o out.cloudscene --format json", &["Sprites as JSON is written, not read"]),
        ("import sky.txt -o out.cloudscene --format cdl", &["did you mean `cld`?"]),
        ("import none.cld -o out.cloudscene", &["none.cld", "no such file"]),
        ("import broken.cld -o out.cld", &["out.cld", "the ending is not a scene's"]),
        ("import broken.cld good.cloudscene -o good.cloudscene --force", &["the scene itself"]),
        ("import broken.cld -o out.cloudscene --at 1,2", &["--at", "2000,1200,-500"]),
        ("import broken.cld -o out.cloudscene --set unit_m=0", &["unit_m: “0” is not a number from"]),
    ] {
        place.refuses(words, 2, wanted);
    }
}
