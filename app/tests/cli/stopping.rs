//! Ctrl-C in the middle of long work: it ends, says so, and leaves nothing behind.
#![cfg(unix)]

use crate::Place;
use crate::scenes::{good_scene, text};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

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
    for words in ["export large.cloudscene -o out.json --shaded", "export large.cloudscene -o out.csv"] {
        for begun in [false, true] {
            let run = Command::new(env!("CARGO_BIN_EXE_cloudwright"))
                .args(words.split_whitespace())
                .current_dir(place.path(""))
                .stderr(Stdio::piped())
                .spawn()
                .expect("the binary runs");
            // A file that grows says that it writes; before, it places sprites.
            let grows = || {
                let entries = std::fs::read_dir(place.path("")).expect("readable").flatten();
                let is_part = |name: &std::ffi::OsStr| name.to_string_lossy().starts_with(".cloudwright-");
                entries
                    .filter(|entry| is_part(&entry.file_name()))
                    .any(|entry| entry.metadata().is_ok_and(|m| m.len() > 0))
            };
            let since = Instant::now();
            let patience = Duration::from_secs(if begun { 60 } else { 1 });
            while since.elapsed() < patience && !(begun && grows()) {
                std::thread::sleep(Duration::from_millis(20));
            }
            let told = Command::new("kill").args(["-INT", &run.id().to_string()]).status().expect("kill");
            assert!(told.success(), "{words}: it was done already");
            let stopped = Instant::now();
            let output = run.wait_with_output().expect("it ends");
            let said = String::from_utf8_lossy(&output.stderr);
            assert_eq!((output.status.code(), said.trim()), (Some(3), "stopped (nothing is written)"), "{words}");
            assert!(stopped.elapsed() < Duration::from_secs(10), "{words}: {:?}", stopped.elapsed());
            assert_eq!(place.files(), before, "{words}");
        }
    }
}
