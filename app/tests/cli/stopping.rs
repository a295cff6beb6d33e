//! Ctrl-C in the middle of long work: it ends, says so, and leaves nothing behind.
#![cfg(target_os = "linux")]

use crate::Place;
use crate::scenes::{good_scene, text};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const SIGINT: u32 = 2;

/// Tries so many sprites that no machine is done with them before it is stopped.
fn large() -> String {
    let mut scene = good_scene();
    for each in &mut scene.models[0].boxes {
        each.sprite_count = 500_000;
    }
    scene.models[0].cull_radius = cloudwright_core::scene::CullRadius::Metres(0.0);
    text(&scene)
}

#[test]
fn ctrl_c_leaves_nothing() {
    let place = Place::new();
    place.put("large.cloudscene", large().as_bytes());
    let before = place.files();
    for (words, writes) in [
        ("export large.cloudscene -o out.json --shaded", false),
        ("export large.cloudscene -o out.json --shaded", true),
        ("export large.cloudscene -o out.csv", true),
        ("thin large.cloudscene -o light.cloudscene", false),
    ] {
        let run = Command::new(env!("CARGO_BIN_EXE_cloudwright"))
            .args(words.split_whitespace())
            .current_dir(place.path(""))
            .stderr(Stdio::piped())
            .spawn()
            .expect("the binary runs");
        let begun = Instant::now();
        while !(listens(run.id()) && (!writes || grows(&place))) {
            assert!(begun.elapsed() < Duration::from_secs(120), "{words}: nothing happens");
            std::thread::sleep(Duration::from_millis(10));
        }
        let told = Command::new("kill").args(["-INT", &run.id().to_string()]).status().expect("kill");
        assert!(told.success(), "{words}: it was done already");
        let stopped = Instant::now();
        let output = run.wait_with_output().expect("it ends");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!((output.status.code(), said.trim()), (Some(3), "stopped (nothing is written)"), "{words}");
        assert!(stopped.elapsed() < Duration::from_secs(20), "{words}: {:?}", stopped.elapsed());
        assert_eq!(place.files(), before, "{words}");
    }
}

/// Whether a program has said that it wants to be told of Ctrl-C.
fn listens(program: u32) -> bool {
    let status = std::fs::read_to_string(format!("/proc/{program}/status")).unwrap_or_default();
    let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
    let caught = caught.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    caught >> (SIGINT - 1) & 1 == 1
}

/// Whether a file is being written.
fn grows(place: &Place) -> bool {
    let entries = std::fs::read_dir(place.path("")).expect("readable").flatten();
    let mut parts = entries.filter(|entry| entry.file_name().to_string_lossy().starts_with(".cloudwright-"));
    parts.any(|entry| entry.metadata().is_ok_and(|about| about.len() > 0))
}
