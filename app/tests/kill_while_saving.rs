//! Two hundred programs are killed in the middle of a save; none leaves a lost or broken scene.
//!
//! A child saves one version of a scene after the other, as the editor does, and says after each that it is saved. It
//! is killed at a moment that differs from round to round. What then lies under the name must be, whole, a version
//! that the child had begun, and no older than the last one it called saved. What it left beside goes with the next
//! child's first save.

#![cfg(unix)]
#![allow(clippy::panic, reason = "a failing test says what it found")]

use cloudwright::storage::Over;
use cloudwright::{opening, saving};
use cloudwright_core::scene::{BoxId, Category, CloudBox, CloudModel, ModelId, Scene};
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

const KILLS: u64 = 200;
/// Where the child is told what to save; unset in the parent.
const CHILD_PATH: &str = "CLOUDWRIGHT_TEST_SAVES_HERE";
const CHILD_START: &str = "CLOUDWRIGHT_TEST_FIRST_VERSION";

/// Versions differ in length, so that a cut or mixed file can't pass for one.
fn version(n: u64) -> Scene {
    let mut scene = Scene { name: format!("version {n}"), ..Scene::default() };
    let mut model = CloudModel::new(ModelId::new(&mut scene.next_id), "m", Category::Stratus);
    for _ in 0..40 + n % 60 {
        model.boxes.push(CloudBox::new(BoxId::new(&mut scene.next_id), glam::DVec3::splat(n as f64)));
    }
    scene.models.push(model);
    scene
}

/// Not a test of its own: what the killed program does.
#[test]
fn child() {
    let Some(path) = std::env::var_os(CHILD_PATH) else { return };
    let first: u64 = std::env::var(CHILD_START).expect("set").parse().expect("a number");
    for n in first.. {
        saving::save(&version(n), None, Path::new(&path), Over::Anything).expect("writable");
        let mut out = std::io::stdout();
        writeln!(out, "saved {n}").and_then(|()| out.flush()).expect("the parent listens");
    }
}

fn strays(folder: &Path) -> usize {
    std::fs::read_dir(folder).expect("there").count() - 1
}

#[test]
fn a_killed_save_leaves_a_whole_scene() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sky.cloudscene");
    saving::save(&version(0), None, &path, Over::Nothing).expect("writable");
    let (mut next, mut left_beside) = (1, 0);
    for round in 0..KILLS {
        let mut child = Command::new(std::env::current_exe().expect("this test"))
            .args(["--exact", "child", "--nocapture", "--test-threads=1"])
            .envs([(CHILD_PATH, path.as_os_str()), (CHILD_START, next.to_string().as_ref())])
            .stdout(Stdio::piped())
            .spawn()
            .expect("it starts");
        let mut lines = BufReader::new(child.stdout.take().expect("piped")).lines().map_while(Result::ok);
        let saved = |line: &String| line.rsplit_once("saved ").and_then(|(_, n)| n.parse::<u64>().ok());
        let first = lines.by_ref().find_map(|line| saved(&line));
        assert_eq!(first, Some(next), "the child saves");
        assert!(strays(folder.path()) <= 1, "what the last child left is gone");
        std::thread::sleep(Duration::from_micros(round * 97 % 9_000));
        child.kill().expect("it lives");
        child.wait().expect("it is dead");
        let last_saved = lines.filter_map(|line| saved(&line)).last().unwrap_or(next);
        left_beside += strays(folder.path());
        let scene = opening::open_scene(&path).unwrap_or_else(|error| panic!("round {round}: {error}"));
        let n: u64 = scene.name.trim_start_matches("version ").parse().expect("a version");
        assert!((last_saved..=last_saved + 1).contains(&n), "round {round}: {n} after {last_saved}");
        assert!(scene == version(n), "round {round}: it is not what was saved");
        next = n + 1;
    }
    assert!(left_beside > 0, "no child was killed in the middle of a save");
    saving::save(&version(next), None, &path, Over::Anything).expect("writable");
    assert_eq!(strays(folder.path()), 0);
}
