//! The command line from outside: the real binary on good and bad input.
//!
//! Each case is a row: arguments, and what must come of them. [`cloudwright`] runs the binary in a folder of its own;
//! [`Case`] holds exit code, words on stdout and stderr, and what files may be left.

#![allow(clippy::panic, reason = "a failing test says what it found")]

mod answers;
mod arguments;
mod bad_scenes;
mod chart;
mod exchange;
mod fit_light;
mod fly;
mod frames;
mod gpu;
mod inputs;
mod killed;
mod new;
mod pictures;
mod plugins;
mod reports;
mod scenes;
mod schemas;
mod special_files;
mod stopping;
mod terminal;
mod thin;
mod weather;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// What one run of the binary did.
struct Ran {
    code: i32,
    stdout: String,
    stderr: String,
}

/// A folder for one test, with a sound scene in it.
struct Place {
    folder: tempfile::TempDir,
}

impl Place {
    fn new() -> Self {
        let place = Self { folder: tempfile::tempdir().expect("a folder") };
        place.put("good.cloudscene", scenes::good().as_bytes());
        place
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn put(&self, name: &str, bytes: &[u8]) {
        std::fs::write(self.path(name), bytes).expect("writable");
    }

    fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Names of all files in it.
    fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.folder.path()).expect("readable");
        let mut names: Vec<String> =
            entries.map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    /// Runs `cloudwright` here; `words` are split at spaces.
    fn run(&self, words: &str) -> Ran {
        self.run_with(&[], words)
    }

    /// As [`Place::run`], on so many threads.
    fn run_on(&self, threads: &str, words: &str) -> Ran {
        self.run_with(&[("RAYON_NUM_THREADS", threads)], words)
    }

    /// As [`Place::run`], with these variables set.
    fn run_with(&self, variables: &[(&str, &str)], words: &str) -> Ran {
        cloudwright(self.folder.path(), words.split_whitespace(), variables)
    }

    /// As [`Place::run`], with words that may hold anything.
    fn run_words(&self, words: &[&str]) -> Ran {
        cloudwright(self.folder.path(), words.iter().copied(), &[])
    }

    /// As [`Place::run`], and the run must end with `code` and say each of `wanted` on stderr, and leave no file that
    /// was not there.
    fn refuses(&self, words: &str, code: i32, wanted: &[&str]) {
        let before = self.files();
        let ran = self.run(words);
        assert_eq!(ran.code, code, "cloudwright {words}\nstderr: {}", ran.stderr);
        for word in wanted {
            assert!(ran.stderr.contains(word), "cloudwright {words}\nno “{word}” in: {}", ran.stderr);
        }
        assert_eq!(ran.stdout, "", "cloudwright {words}: an answer beside an error");
        assert_eq!(self.files(), before, "cloudwright {words}: files were left");
    }
}

fn cloudwright<'a>(folder: &Path, words: impl Iterator<Item = &'a str>, variables: &[(&str, &str)]) -> Ran {
    let Output { status, stdout, stderr } = Command::new(env!("CARGO_BIN_EXE_cloudwright"))
        .args(words)
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .envs(variables.iter().copied())
        .output()
        .expect("the binary runs");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    Ran { code: status.code().expect("no signal"), stdout: text(stdout), stderr: text(stderr) }
}
