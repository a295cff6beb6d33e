//! What a killed run leaves beside its files goes with the next run; one that may not write on leaves nothing.

#![cfg(unix)]

use crate::{Place, fly};
use std::process::{Command, Stdio};

/// A run is killed again, later in its work, until it leaves something: that many times at the most.
const TRIES: u32 = 200;

impl Place {
    /// Temporary files in one of its folders.
    fn strays(&self, folder: &str) -> usize {
        let entries = std::fs::read_dir(self.path(folder)).into_iter().flatten();
        entries.filter(|entry| entry.as_ref().is_ok_and(|e| e.file_name().to_string_lossy().ends_with(".tmp"))).count()
    }

    /// Kills a run as soon as it writes into `folder`. True if that leaves a temporary file.
    fn kill_in_a_write(&self, words: &str, folder: &str) -> bool {
        let mut child = Command::new(env!("CARGO_BIN_EXE_cloudwright"))
            .args(words.split_whitespace())
            .current_dir(self.folder.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the binary runs");
        while child.try_wait().expect("it is ours").is_none() {
            if self.strays(folder) > 0 {
                child.kill().expect("it is ours");
                break;
            }
        }
        child.wait().expect("it is ours");
        self.strays(folder) > 0
    }
}

#[test]
fn what_a_killed_run_leaves_goes_with_the_next() {
    for (words, folder) in [
        ("render flown.cloudscene -o sky.png --size 320x180 --renderer cpu", "."),
        ("export flown.cloudscene -o sprites.json --shaded", "."),
        ("fly flown.cloudscene --path west -o frames --size 64x36 --renderer cpu", "frames"),
        ("chart flown.cloudscene -o chart --methods fast --size 64x36 --repeat 1", "chart"),
    ] {
        let place = fly::place();
        assert!((0..TRIES).any(|_| place.kill_in_a_write(words, folder)), "{words}: no run was killed in a write");
        let ran = place.run(words);
        assert_eq!(ran.code, 0, "{words}: {}", ran.stderr);
        assert_eq!(place.strays(folder), 0, "{words}");
    }
}

#[test]
fn a_limit_of_size_is_an_error_and_leaves_nothing() {
    let place = Place::new();
    let before = place.files();
    // Two blocks are a kilobyte at the most; the sprites take more.
    let words =
        format!("ulimit -f 2; exec {} export good.cloudscene -o sprites.json", env!("CARGO_BIN_EXE_cloudwright"));
    let ran = Command::new("sh").args(["-c", &words]).current_dir(place.folder.path()).output().expect("a shell");
    let said = String::from_utf8_lossy(&ran.stderr);
    assert_eq!(ran.status.code(), Some(3), "{said}");
    assert!(said.contains("sprites.json: can't be written") && said.contains("too large"), "{said}");
    assert_eq!(place.files(), before);
}
