//! A scene with fewer sprites, through the command line.

use crate::Place;
use crate::scenes::{aircraft, changed};
use serde_json::json;

#[test]
fn a_lighter_scene_that_looks_alike() {
    let place = Place::new();
    let ran = place.run("thin good.cloudscene --tolerance 0.05 -o light.cloudscene");
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{}", ran.stderr);
    for wanted in ["sprites: ", " are left", "error: mean FLIP 0.0"] {
        assert!(ran.stderr.contains(wanted), "no “{wanted}” in: {}", ran.stderr);
    }
    assert_eq!(place.run("check light.cloudscene").code, 0);
    let sprites = |scene: &str| -> u64 {
        let answer: serde_json::Value =
            serde_json::from_str(&place.run(&format!("info --json {scene}")).stdout).expect("JSON");
        answer["total"]["sprites"].as_u64().expect("a number")
    };
    assert!(sprites("light.cloudscene") < sprites("good.cloudscene"));
}

#[test]
fn refusals_leave_nothing() {
    let place = Place::new();
    place.refuses("thin good.cloudscene -o good.cloudscene --force", 2, &["that is the scene itself"]);
    place.refuses("thin good.cloudscene -o light.json", 2, &[".cloudscene"]);
    place.refuses("thin good.cloudscene -o light.cloudscene --tolerance 0", 2, &["--tolerance", "such as 0.01"]);
    place.refuses("thin good.cloudscene -o light.cloudscene --tolerance 1e-9", 3, &["raise the tolerance"]);
    place.refuses("thin good.cloudscene -o none/light.cloudscene", 3, &["none"]);
    place.put("light.cloudscene", b"precious");
    place.refuses("thin good.cloudscene -o light.cloudscene --tolerance 0.05", 2, &["--force"]);
    assert_eq!(place.read("light.cloudscene"), b"precious");
}

#[test]
fn into_another_folder_it_takes_its_files_along() {
    let place = Place::new();
    let (atlas, model) =
        (include_bytes!("../../../assets/atlas/clouds.png"), include_bytes!("../../../assets/models/aircraft.glb"));
    std::fs::create_dir(place.path("sheets")).expect("writable");
    std::fs::create_dir(place.path("light")).expect("writable");
    let scene = changed(|scene| {
        aircraft(scene, "leader.glb");
        scene["atlas"] = json!("sheets/own.png");
    });
    let files = [("own.cloudscene", &scene[..]), ("sheets/own.png", atlas), ("leader.glb", model)];
    files.iter().for_each(|(name, bytes)| place.put(name, bytes));
    let thin = "thin own.cloudscene --tolerance 0.05 -o light/own.cloudscene";
    let ran = place.run(thin);
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(ran.stderr.contains("copied beside it: sheets/own.png, leader.glb\n"), "{}", ran.stderr);
    assert!(place.read("light/sheets/own.png") == atlas && place.read("light/leader.glb") == model);
    let ran = place.run("check light/own.cloudscene");
    assert!(!ran.stdout.contains("error") && ran.stderr.is_empty(), "{}{}", ran.stdout, ran.stderr);
    // What is there already and the same need not be copied; what differs is not replaced.
    let ran = place.run(&format!("{thin} --force"));
    assert!(ran.code == 0 && !ran.stderr.contains("copied"), "{}", ran.stderr);
    place.put("light/sheets/own.png", b"precious");
    let before = place.read("light/own.cloudscene");
    place.refuses(&format!("{thin} --force"), 2, &["light/sheets/own.png", "another file than the scene's atlas"]);
    assert!(place.read("light/sheets/own.png") == b"precious" && place.read("light/own.cloudscene") == before);
    // Nothing is half there: the scene can't be written, so its files are not copied.
    std::fs::create_dir_all(place.path("full/own.cloudscene")).expect("writable");
    place.refuses("thin own.cloudscene --tolerance 0.05 -o full/own.cloudscene --force", 3, &["it is a folder"]);
    assert_eq!(std::fs::read_dir(place.path("full")).expect("there").count(), 1);
}
