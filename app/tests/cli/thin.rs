//! A scene with fewer sprites, through the command line.

use crate::Place;

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
