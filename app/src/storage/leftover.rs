//! Telling a file that is in use from one that a killed program left.
//!
//! Who makes such a file locks it until it is done with; the system lets go of a lock however a program ends. Who takes
//! leftovers away removes a file only while he himself has its lock. So no file in use is ever taken away:
//!
//! 1. From its lock on, nobody else gets that until the file is done with, and then its name is gone: it was renamed or
//!    removed. Who had opened the file before finds nothing to remove.
//! 2. Before its lock, it may be taken away. Its maker, who waits for the lock, then finds the name gone, and makes
//!    another file under another name. No name is made twice, so one that is there leads to the file it was made for.
//!
//! On a disk without locks nothing is taken for a leftover, and nothing is removed.

use super::ordinary;
use std::fs::{self, File, OpenOptions};
use std::path::Path;

/// Begins the name of a temporary file.
pub(super) const PREFIX: &str = ".cloudwright-";
/// Ends it.
pub(super) const SUFFIX: &str = ".tmp";
/// Random letters between the two.
pub(super) const LETTERS: usize = 6;

/// Locks a file that was just made at `path`. False if it was taken for a leftover before: make one of another name.
pub(super) fn hold(file: &File, path: &Path) -> bool {
    let _ = file.lock();
    path.exists()
}

/// The file at `path`, locked, if nobody uses it.
pub(super) fn claim(path: &Path) -> Option<File> {
    // Some network disks lock only what may be written.
    let open = |options: &mut OpenOptions| ordinary::open(path, options);
    let (file, _) = open(File::options().write(true)).or_else(|_| open(File::options().read(true))).ok()?;
    file.try_lock().ok()?;
    Some(file)
}

/// Removes the temporary files that killed writers left in `folder`.
pub(super) fn sweep(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten().filter(|entry| is_temporary_name(&entry.file_name().to_string_lossy())) {
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        if let Some(_claimed) = is_file.then(|| claim(&entry.path())).flatten() {
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn is_temporary_name(name: &str) -> bool {
    let letters = name.strip_prefix(PREFIX).and_then(|rest| rest.strip_suffix(SUFFIX));
    letters.is_some_and(|l| l.len() == LETTERS && l.bytes().all(|b| b.is_ascii_alphanumeric()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leftovers_go_and_all_else_stays() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        for name in [".cloudwright-a1B2c3.tmp", ".cloudwright-notes", ".cloudwright-a1B2c3d.tmp", "a.tmp"] {
            fs::write(path(name), b"x").expect("writable");
        }
        let in_use = File::create(path(".cloudwright-b1B2c3.tmp")).expect("writable");
        assert!(hold(&in_use, &path(".cloudwright-b1B2c3.tmp")));
        sweep(folder.path());
        let left = || {
            let entries = fs::read_dir(folder.path()).expect("readable");
            let mut left: Vec<_> = entries.map(|entry| entry.expect("readable").file_name()).collect();
            left.sort();
            left
        };
        assert_eq!(left(), [".cloudwright-a1B2c3d.tmp", ".cloudwright-b1B2c3.tmp", ".cloudwright-notes", "a.tmp"]);
        drop(in_use);
        sweep(folder.path());
        assert_eq!(left(), [".cloudwright-a1B2c3d.tmp", ".cloudwright-notes", "a.tmp"]);
    }

    /// Opening it would wait for somebody at its other end.
    #[cfg(unix)]
    #[test]
    fn a_pipe_is_no_leftover() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("1-1.lock");
        let made = std::process::Command::new("mkfifo").arg(&path).status().expect("mkfifo runs");
        assert!(made.success() && claim(&path).is_none());
    }

    #[test]
    fn what_was_taken_before_its_lock_is_not_held() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join(".cloudwright-a1B2c3.tmp");
        let made = File::create(&path).expect("writable");
        sweep(folder.path());
        assert!(!hold(&made, &path));
    }
}
