//! The only file access.
//!
//! Reading has a limit, so that a wrong path can't fill the memory. Writing is `atomic`; what a killed program left of it
//! is a `leftover`. What the program remembers
//! for a user lies in his [`Folders`]: `settings`, and what `recovery` needs after a crash. A [`Stamp`] tells
//! whether a file is still the one that was read or written; a [`Watcher`] looks at one every now and then.

mod atomic;
mod error;
mod folders;
mod leftover;
mod recovery;
mod settings;
mod stamp;
mod watcher;

pub use atomic::{Over, check_writable, write_atomic, write_one_of_many, write_over};
pub use error::StorageError;
pub use folders::Folders;
pub use recovery::{Orphan, RecoverySlot, Rescue, orphans};
pub use settings::{Settings, ThemeChoice};
pub use stamp::Stamp;
pub use watcher::{Sighting, Watcher};

use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

/// The bytes of a file of at most `limit` bytes.
///
/// # Errors
/// If it can't be read, is a folder, or is larger.
pub fn read(path: &Path, limit: usize) -> Result<Vec<u8>, StorageError> {
    let fail = |error| StorageError::read(path, &error);
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(fail)?;
    file.take(limit as u64 + 1).read_to_end(&mut bytes).map_err(fail)?;
    if bytes.len() > limit {
        return Err(StorageError::Read {
            path: path.into(),
            reason: format!("it is larger than {} MB", limit >> 20),
            hint: "is it the right file?".into(),
        });
    }
    Ok(bytes)
}

/// Makes the folder, and those that it lies in, if they are not there.
///
/// # Errors
/// If one of them is a file, or can't be made.
pub fn make_folder(path: &Path) -> Result<(), StorageError> {
    if path.exists() && !path.is_dir() {
        let (reason, hint) = ("it is a file", "give a folder, or the name of a new one");
        return Err(StorageError::Write { path: path.into(), reason: reason.into(), hint: hint.into() });
    }
    fs::create_dir_all(path).map_err(|error| StorageError::write(path, &error))
}

/// Gives the file `from` the name `to`, in place of what has it.
///
/// # Errors
/// If `to` is a folder, lies on another disk, or in a folder that can't be written.
pub fn rename(from: &Path, to: &Path) -> Result<(), StorageError> {
    fs::rename(from, to).map_err(|error| StorageError::write(to, &error))
}

/// Takes a file away. One that can't be is left.
pub fn remove_if_there(path: &Path) {
    let _ = fs::remove_file(path);
}

/// Whether both names lead to one file that is there.
pub fn is_same_file(a: &Path, b: &Path) -> bool {
    matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b)
}

/// Whether a file is there.
pub fn is_there(path: &Path) -> bool {
    path.is_file()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_other_file_of_this_package_touches_files() {
        let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
        let mut seen = 0;
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).expect("readable") {
                let path = entry.expect("readable").path();
                if path.is_dir() {
                    if !path.ends_with("storage") {
                        folders.push(path);
                    }
                    continue;
                }
                let text = fs::read_to_string(&path).expect("text");
                let touches = ["std::fs", "File::", "OpenOptions"].iter().any(|word| text.contains(word));
                assert!(!touches, "{}", path.display());
                seen += 1;
            }
        }
        assert!(seen > 20, "the sources are where they are looked for");
    }
}
