//! The only file access.
//!
//! Only ordinary files are read, and each kind up to a limit of its own, so that a wrong path can neither hold up the
//! program nor fill the memory. Writing is `atomic`; what a killed program left of it is a `leftover`. What the program
//! remembers for a user lies in his [`Folders`]: `settings`, and what `recovery` needs after a crash. A [`Stamp`] tells
//! whether a file is still the one that was read or written, a [`Listing`] which ones lie in a folder; a [`Watcher`] looks
//! at either every now and then.

mod atomic;
mod error;
mod file_id;
mod folder;
mod folders;
mod leftover;
mod listing;
mod ordinary;
mod pictures;
mod recovery;
mod rescue_writer;
mod settings;
mod stamp;
mod watcher;

pub use atomic::{Over, Together, check_writable, write_atomic, write_one_of_many, write_over};
pub use error::StorageError;
pub use file_id::FileId;
pub use folder::Folder;
pub use folders::Folders;
pub use listing::Listing;
pub use pictures::{FilmSettings, PictureSettings, There};
pub use recovery::{Orphan, RecoverySlot, Rescue, orphans};
pub use rescue_writer::{RescueWriter, Unsaved};
pub use settings::{Settings, ThemeChoice};
pub use stamp::Stamp;
pub use watcher::{Sighting, Watcher};

use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

/// The bytes of an ordinary file of at most `limit` bytes.
///
/// # Errors
/// If it can't be read, is a folder, a pipe or a device, or is larger.
pub fn read(path: &Path, limit: usize) -> Result<Vec<u8>, StorageError> {
    let (file, about) = ordinary::open(path, File::options().read(true))?;
    let too_large = || StorageError::Read {
        path: path.into(),
        reason: format!("it is larger than {} MB", limit >> 20),
        hint: "is it the right file?".into(),
    };
    if about.len() > limit as u64 {
        return Err(too_large());
    }
    let mut bytes = Vec::new();
    // It may grow while it is read.
    let read = file.take(limit as u64 + 1).read_to_end(&mut bytes);
    read.map_err(|error| StorageError::read(path, &error))?;
    if bytes.len() > limit { Err(too_large()) } else { Ok(bytes) }
}

/// The first bytes of an ordinary file, at most `limit`.
///
/// # Errors
/// If it can't be read, or is a folder, a pipe or a device.
pub fn read_head(path: &Path, limit: usize) -> Result<Vec<u8>, StorageError> {
    let (file, _) = ordinary::open(path, File::options().read(true))?;
    let mut bytes = Vec::new();
    file.take(limit as u64).read_to_end(&mut bytes).map_err(|error| StorageError::read(path, &error))?;
    Ok(bytes)
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

/// The names of all that lies in a folder; none if it can't be looked at.
pub fn names_in(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.map(|entry| entry.file_name().into()).collect()
}

/// Shows a folder in the desktop's file manager, without waiting for it; one that is not there is made.
///
/// # Errors
/// If it can't be made, or nothing can show it.
pub fn show_folder(folder: &Path) -> Result<(), StorageError> {
    fs::create_dir_all(folder).map_err(|error| StorageError::write(folder, &error))?;
    open::that_detached(folder).map_err(|error| StorageError::Read {
        path: folder.into(),
        reason: format!("no file manager shows it: {error}"),
        hint: "go there by hand".into(),
    })
}

/// The signals that this program was started to ignore, a bit for each from 1; none where the system doesn't say.
pub(crate) fn ignored_signals() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or_default()
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
