//! Arguments that can't be used, and places that can't be written.

use crate::Place;
use serde_json::json;

/// Arguments, exit code, words on stderr.
const CASES: &[(&str, i32, &[&str])] = &[
    ("render", 2, &["SCENE", "--help"]),
    ("render good.cloudscene", 2, &["--output"]),
    ("render good.cloudscene -o out.jpg", 2, &["out.jpg", ".png"]),
    ("render good.cloudscene -o out", 2, &["out", ".png"]),
    ("render good.cloudscene -o out.png --samples 0", 2, &["--samples", "square number"]),
    ("render good.cloudscene -o out.png --samples 5", 2, &["--samples", "square number"]),
    ("render good.cloudscene -o out.png --tolerance -1", 2, &["--tolerance", "from 0 to 1"]),
    ("render good.cloudscene -o out.png --tolerance NaN", 2, &["--tolerance", "from 0 to 1"]),
    ("render good.cloudscene -o out.png --truth --tolerance 0.1", 2, &["--truth", "--tolerance"]),
    ("render good.cloudscene -o out.png --samples 81", 2, &["--samples", "square number"]),
    ("render good.cloudscene -o out.png --size 0x10", 2, &["--size", "1280x720"]),
    ("render good.cloudscene -o out.png --size 16385x1", 2, &["--size", "16384"]),
    ("render good.cloudscene -o out.png --size 1280", 2, &["--size", "1280x720"]),
    ("render good.cloudscene -o out.png --size 16384x16384", 2, &["--size", "lower"]),
    ("render good.cloudscene -o out.png --size 4096x4096 --samples 64", 2, &["--samples", "lower"]),
    ("render good.cloudscene -o out.png --truth --size 16384x16384", 2, &["--size", "lower"]),
    ("render good.cloudscene -o out.png --truth --renderer gpu", 2, &["--truth", "CPU"]),
    ("render good.cloudscene -o out.png --method turth", 2, &["--method", "did you mean `truth`?"]),
    ("render good.cloudscene -o out.png --method half --truth", 2, &["--method", "--truth"]),
    ("render good.cloudscene -o out.png --method half --renderer gpu", 2, &["--method half", "CPU"]),
    ("render good.cloudscene -o out.png --method gpu --renderer cpu", 2, &["--method gpu", "GPU"]),
    ("render good.cloudscene -o out.png --renderer fast", 2, &["--renderer", "auto"]),
    ("render good.cloudscene -o out.png --time 24:00", 2, &["--time", "23:59"]),
    ("render good.cloudscene -o out.png --time noon", 2, &["--time", "18:30"]),
    ("render good.cloudscene -o out.png --camera tail", 2, &["good.cloudscene", "“tail”", "main, above"]),
    ("render good.cloudscene -o none/out.png", 3, &["none/out.png", "make the folder"]),
    ("render good.cloudscene -o good.cloudscene/out.png", 3, &["out.png", "choose a folder"]),
    ("render good.cloudscene -o folder.png", 3, &["folder.png", "it is a folder"]),
    ("render good.cloudscene -o guarded.png", 3, &["guarded.png", "write-protected"]),
    ("export good.cloudscene -o out.obj", 2, &["out.obj", ".json, .csv, .glb, .usda", "--format"]),
    ("export good.cloudscene -o out", 2, &["out", ".json, .csv, .glb, .usda"]),
    ("export good.cloudscene -o out.json --time 10:00", 2, &["--shaded"]),
    ("export good.cloudscene -o out.json --camera main", 2, &["--shaded"]),
    ("export good.cloudscene -o out.json --shaded --camera tail", 2, &["“tail”", "main, above"]),
    ("export good.cloudscene -o out.json --format jsn", 2, &["“jsn”", "did you mean `json`?"]),
    ("export good.cloudscene -o out.json --set voxel=3", 2, &["--set", "“voxel”", "has no options"]),
    ("export good.cloudscene -o out.json --set voxel", 2, &["--set voxel", "there is no ="]),
    ("export good.cloudscene -o out.json --cloud wets", 2, &["“wets”", "did you mean `west`?"]),
    ("export good.cloudscene -o none/out.csv", 3, &["none/out.csv", "make the folder"]),
    ("new", 2, &["OUT", "--help"]),
    ("new sky", 2, &["sky", ".cloudscene"]),
    ("new sky.png", 2, &["sky.png", ".cloudscene"]),
    ("new sky.cloudscene --preset pink", 2, &["pink", "starter"]),
    ("new none/sky.cloudscene", 3, &["none/sky.cloudscene", "make the folder"]),
    ("new good.cloudscene/sky.cloudscene", 3, &["sky.cloudscene", "choose a folder"]),
    ("check", 2, &["SCENE"]),
    ("info", 2, &["SCENE"]),
    ("info good.cloudscene --yaml", 2, &["--yaml"]),
    ("good.cloudscene", 3, &["no display", "cloudwright render"]),
    ("", 3, &["no display", "cloudwright render"]),
    ("fly good.cloudscene", 2, &["--path", "--output", "--help"]),
    ("fly good.cloudscene --path a -o out --method turth", 2, &["--method", "did you mean `truth`?"]),
    ("fly good.cloudscene --path a -o out --method half --sorting crossfade", 2, &["--method", "--sorting"]),
    ("fly good.cloudscene --path a -o out --truth --renderer gpu", 2, &["--truth", "CPU"]),
    ("rendr", 2, &["“rendr”", "no scene of that name", "did you mean `render`?"]),
    ("rendr good.cloudscene -o out.png", 2, &["did you mean `render`?", "new, render, fly, chart"]),
    ("nw out.cloudscene", 2, &["did you mean `new`?"]),
    ("flyy good.cloudscene --path west -o out", 2, &["did you mean `fly`?"]),
    ("chrat good.cloudscene -o out", 2, &["did you mean `chart`?"]),
    ("Check good.cloudscene", 2, &["did you mean `check`?"]),
    ("inof good.cloudscene", 2, &["did you mean `info`?"]),
    ("exprot good.cloudscene -o out.json", 2, &["did you mean `export`?"]),
    ("thn good.cloudscene -o out.cloudscene", 2, &["did you mean `thin`?"]),
    ("sky good.cloudscene", 2, &["good.cloudscene", "--help"]),
    ("good.cloudscene good.cloudscene", 2, &["good.cloudscene", "--help"]),
    ("chekc", 3, &["no display"]),
    ("new sky.cloudscene --preset startr", 2, &["did you mean `starter`?"]),
    ("render good.cloudscene -o out.png --camera abov", 2, &["did you mean `above`? the cameras are main, above"]),
];

#[test]
fn what_cannot_be_done_is_said() {
    let place = Place::new();
    std::fs::create_dir(place.path("folder.png")).expect("writable");
    place.put("guarded.png", b"old");
    place.put("chekc", crate::scenes::good().as_bytes());
    let mut guarded = std::fs::metadata(place.path("guarded.png")).expect("there").permissions();
    guarded.set_readonly(true);
    std::fs::set_permissions(place.path("guarded.png"), guarded).expect("allowed");
    for (words, code, wanted) in CASES {
        place.refuses(words, *code, wanted);
    }
    assert_eq!(place.read("guarded.png"), b"old");
}

#[cfg(unix)]
#[test]
fn an_unwritable_folder() {
    use std::os::unix::fs::PermissionsExt;
    let place = Place::new();
    let locked = place.path("locked");
    std::fs::create_dir(&locked).expect("writable");
    std::fs::set_permissions(&locked, std::fs::Permissions::from_mode(0o555)).expect("allowed");
    // A system administrator may write everywhere; then there is nothing to see.
    if std::fs::write(locked.join("probe"), b"").is_err() {
        place.refuses("render good.cloudscene -o locked/out.png", 3, &["locked/out.png", "permission denied"]);
    }
}

#[test]
fn every_subcommand_has_examples() {
    let place = Place::new();
    for words in ["--help", "render --help", "check --help", "info --help", "export --help", "new --help"] {
        let ran = place.run(words);
        assert_eq!((ran.code, ran.stderr.as_str()), (0, ""), "{words}");
        assert!(ran.stdout.contains("Examples:\n  cloudwright "), "{words}");
    }
}

/// Known before anything is drawn, and no folder is left that was made for it.
#[test]
fn names_that_are_too_long() {
    let place = Place::new();
    let flown = crate::scenes::changed(|scene| {
        crate::scenes::aircraft(scene, "none.glb");
        let mut end = scene["paths"][0]["keys"][0].clone();
        (end["time_s"], scene["aircraft"]) = (json!(1), json!([]));
        scene["paths"][0]["keys"].as_array_mut().expect("keys").push(end);
        scene["paths"][0]["name"] = json!("west".repeat(70));
    });
    place.put("flown.cloudscene", &flown);
    let long = "x".repeat(260);
    let path = "west".repeat(70);
    for words in [
        format!("render good.cloudscene -o {long}.png"),
        format!("export good.cloudscene -o {long}.json"),
        format!("thin good.cloudscene -o {long}.cloudscene"),
        format!("new {long}.cloudscene"),
        format!("chart flown.cloudscene -o out/{long}"),
        format!("fly flown.cloudscene --path {path} -o new/out"),
        format!("fly flown.cloudscene --path {path} -o out.mp4"),
        format!("fly flown.cloudscene --path {path} -o new/{long}"),
    ] {
        place.refuses(&words, 3, &["can't be written: its name is too long", "choose a shorter name"]);
    }
    place.refuses(&format!("check {long}"), 2, &["can't be read", "too long", "check the name"]);
}
