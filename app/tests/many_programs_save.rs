//! Many programs save into one folder at the same time; none of them fails, and nothing but their scenes is left.
//!
//! Each child saves its own scene again and again, as the editor does, which also takes away what killed programs left.
//! What one child is just making must not look like that to another, at whatever moment it looks.

#![cfg(unix)]

use cloudwright::storage::Over;
use cloudwright::{opening, saving};
use cloudwright_core::scene::Scene;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// More than there are cores, so that they are stopped at any place.
const PROGRAMS: usize = 16;
const SAVES: usize = 200;
/// Where the child is told what to save; unset in the parent.
const CHILD_PATH: &str = "CLOUDWRIGHT_TEST_SAVES_HERE";

/// Not a test of its own: what each program does.
#[test]
fn child() {
    let Some(path) = std::env::var_os(CHILD_PATH) else { return };
    let scene = Scene { name: "shared".into(), ..Scene::default() };
    let failures = (0..SAVES).filter_map(|_| saving::save(&scene, None, Path::new(&path), Over::Anything).err());
    let failures: Vec<String> = failures.map(|error| error.to_string()).collect();
    assert!(failures.is_empty(), "{} of {SAVES} failed: {}", failures.len(), failures[0]);
}

#[test]
fn no_save_fails_because_others_save_beside_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let paths: Vec<PathBuf> = (0..PROGRAMS).map(|n| folder.path().join(format!("{n}.cloudscene"))).collect();
    let start = |path: &PathBuf| {
        Command::new(std::env::current_exe().expect("this test"))
            .args(["--exact", "child", "--nocapture", "--test-threads=1"])
            .env(CHILD_PATH, path)
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("it starts")
    };
    let children: Vec<_> = paths.iter().map(start).collect();
    let ends = children.into_iter().map(|child| child.wait_with_output().expect("it ends"));
    let failures: Vec<String> =
        ends.filter(|end| !end.status.success()).map(|end| String::from_utf8_lossy(&end.stderr).into_owned()).collect();
    assert!(failures.is_empty(), "{}", failures.concat());
    for path in &paths {
        opening::open_scene(path).expect("a whole scene");
    }
    assert_eq!(
        std::fs::read_dir(folder.path()).expect("there").count(),
        PROGRAMS,
        "something is left beside the scenes"
    );
}
