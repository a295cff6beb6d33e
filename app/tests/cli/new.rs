//! `cloudwright new`.

use crate::Place;

#[test]
fn writes_a_scene_that_opens() {
    let place = Place::new();
    for words in ["new sky.cloudscene", "new other.cloudscene --preset starter"] {
        let ran = place.run(words);
        assert_eq!((ran.code, ran.stdout.as_str(), ran.stderr.as_str()), (0, "", ""), "{words}");
    }
    assert_eq!(place.read("sky.cloudscene"), place.read("other.cloudscene"));
    let ran = place.run("check sky.cloudscene");
    assert_eq!(ran.code, 0, "{}", ran.stdout);
}

#[test]
fn replaces_nothing_unless_told_to() {
    let place = Place::new();
    let before = place.read("good.cloudscene");
    place.refuses("new good.cloudscene", 2, &["good.cloudscene", "already", "--force"]);
    assert_eq!(place.read("good.cloudscene"), before);
    assert_eq!(place.run("new good.cloudscene --force").code, 0);
    assert_ne!(place.read("good.cloudscene"), before);
}

#[test]
fn lists_its_presets() {
    let ran = Place::new().run("new --help");
    assert!(ran.stdout.contains("Presets:\n  starter "), "{}", ran.stdout);
}

/// A disk without space, played by a limit on the size of files; the system's signal for it is ignored, as it is for
/// a full disk.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_takes_nothing_away() {
    let place = Place::new();
    let before = place.read("good.cloudscene");
    let line = "trap '' XFSZ; ulimit -f 1; exec \"$0\" new good.cloudscene --force";
    let output = std::process::Command::new("sh")
        .args(["-c", line, env!("CARGO_BIN_EXE_cloudwright")])
        .current_dir(place.path(""))
        .output()
        .expect("a shell");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(3), "{said}");
    assert!(said.contains("good.cloudscene: can't be written"), "{said}");
    assert_eq!((place.read("good.cloudscene"), place.files()), (before, vec!["good.cloudscene".into()]));
}
