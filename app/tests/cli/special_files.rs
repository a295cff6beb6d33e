//! Names that lead to no ordinary file: all are refused at once, none is waited for.

#![cfg(unix)]

use crate::Place;
use crate::scenes::{aircraft, changed};
use serde_json::json;
use std::os::unix::fs::symlink;

/// A pipe that nobody writes to.
fn pipe(place: &Place, name: &str) {
    let made = std::process::Command::new("mkfifo").arg(place.path(name)).status().expect("mkfifo runs");
    assert!(made.success());
}

#[test]
fn only_ordinary_files_are_scenes() {
    let place = Place::new();
    pipe(&place, "pipe.cloudscene");
    symlink("pipe.cloudscene", place.path("link.cloudscene")).expect("allowed");
    let _socket = std::os::unix::net::UnixListener::bind(place.path("socket.cloudscene")).expect("allowed");
    for (scene, kind) in [
        ("pipe.cloudscene", "it is a pipe"),
        ("link.cloudscene", "it is a pipe"),
        ("/dev/stdin", "not a file"),
        ("/dev/zero", "it is a device"),
        ("/dev/null", "it is a device"),
        ("socket.cloudscene", "it is a socket"),
        (".", "it is a folder"),
    ] {
        for words in ["check {}", "info {}", "render {} -o out.png", "thin {} -o out.cloudscene", "chart {} -o out"] {
            place.refuses(&words.replace("{}", scene), 2, &[scene, "can't be read", kind]);
        }
    }
    symlink("good.cloudscene", place.path("good_link.cloudscene")).expect("allowed");
    assert_eq!(place.run("check good_link.cloudscene").code, 0);
}

#[test]
fn only_ordinary_files_are_atlases_and_models() {
    let place = Place::new();
    pipe(&place, "pipe.png");
    symlink("/dev/zero", place.path("zero.png")).expect("allowed");
    place.put("atlas_pipe.cloudscene", &changed(|s| s["atlas"] = json!("pipe.png")));
    place.put("atlas_zero.cloudscene", &changed(|s| s["atlas"] = json!("zero.png")));
    place.put("model_pipe.cloudscene", &changed(|s| aircraft(s, "pipe.png")));
    for (scene, wanted) in [
        ("atlas_pipe", ["atlas: error: “pipe.png”", "it is a pipe"]),
        ("atlas_zero", ["atlas: error: “zero.png”", "it is a device"]),
        ("model_pipe", ["aircraft[0].model: error: “pipe.png”", "it is a pipe"]),
    ] {
        place.refuses(&format!("render {scene}.cloudscene -o out.png"), 2, &wanted);
        let ran = place.run(&format!("check {scene}.cloudscene"));
        assert!(ran.code == 1 && wanted.iter().all(|word| ran.stdout.contains(word)), "{}{}", ran.stdout, ran.stderr);
    }
}

/// A file of which nothing is on the disk but its length.
#[test]
fn a_huge_file_is_refused_by_its_length() {
    let place = Place::new();
    let huge = std::fs::File::create(place.path("huge.cloudscene")).expect("writable");
    if huge.set_len(50 << 30).is_err() {
        // This disk wants all of it.
        return;
    }
    place.refuses("check huge.cloudscene", 2, &["huge.cloudscene", "larger than 256 MB", "is it the right file?"]);
    place.put("heavy.cloudscene", &changed(|s| s["atlas"] = json!("huge.cloudscene")));
    place.refuses("render heavy.cloudscene -o out.png", 2, &["huge.cloudscene", "larger than 16 MB"]);
}
