//! Work that a crash would lose: where it is kept meanwhile, and how it is found again.
//!
//! Each editor with unsaved changes has a slot, two files of one name in the user's state folder: a rescue that holds
//! scene, original path and time, written whole or not at all; and a lock. The system lets go of the lock however the
//! editor ends, so a slot that can be locked is an orphan. Whoever finds it holds it, and no second editor offers the
//! same.

use super::{Folders, Stamp, StorageError, leftover, read, write_atomic};
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

const FORMAT: &str = "cloudwright-rescue";
const VERSION: u64 = 1;
/// A scene and what is around it; its quotes are escaped.
const MAX_BYTES: usize = 600 << 20;

/// What is kept of a scene with unsaved changes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rescue {
    format: String,
    version: u64,
    /// The scene's file, if it has one.
    pub path: Option<PathBuf>,
    /// The file as the editor knew it. If it is another one now, it was changed by another program.
    #[serde(default)]
    pub known: Option<Stamp>,
    /// When it was kept, milliseconds since 1970.
    saved_at_ms: u64,
    /// As a scene file says it.
    pub scene: String,
    /// What can be undone, as [`Past`](cloudwright_core::document::Past) says it.
    #[serde(default)]
    pub past: String,
}

/// The place of one editor.
#[derive(Debug)]
pub struct RecoverySlot {
    rescue: PathBuf,
    /// Locked as long as it is open.
    _lock: File,
}

/// A slot whose editor is gone.
#[derive(Debug)]
pub struct Orphan {
    /// Held while it is offered.
    pub slot: RecoverySlot,
    /// What is in it, or why that can't be read.
    pub rescue: Result<Rescue, String>,
}

impl Rescue {
    /// Of a scene, now. A path that JSON can't say is left out; the scene matters more.
    pub fn new(path: Option<&Path>, known: Option<Stamp>, scene: String, past: String) -> Self {
        let path = path.and_then(|path| std::path::absolute(path).ok()).filter(|path| path.to_str().is_some());
        let since_1970 = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
        let saved_at_ms = u64::try_from(since_1970.as_millis()).unwrap_or(u64::MAX);
        let known = known.filter(Stamp::can_be_said);
        Self { format: FORMAT.into(), version: VERSION, path, known, saved_at_ms, scene, past }
    }

    /// When it was kept, to a millisecond.
    pub fn saved_at(&self) -> SystemTime {
        let limit = Duration::from_secs(u64::from(u32::MAX));
        SystemTime::UNIX_EPOCH + Duration::from_millis(self.saved_at_ms).min(limit)
    }

    /// Puts it into the slot whose rescue lies at `file`.
    ///
    /// # Errors
    /// If it can't be written; the one before is then still there.
    pub fn write(&self, file: &Path) -> Result<(), StorageError> {
        let text =
            serde_json::to_string(self).map_err(|error| StorageError::write(file, &std::io::Error::other(error)))?;
        write_atomic(file, text.as_bytes())
    }

    pub(super) fn read(file: &Path) -> Result<Self, String> {
        let bytes = read(file, MAX_BYTES).map_err(|error| error.to_string())?;
        let rescue: Self = serde_json::from_slice(&bytes).map_err(|error| error.to_string())?;
        if rescue.format == FORMAT && rescue.version == VERSION {
            Ok(rescue)
        } else {
            Err(format!("another version of Cloudwright kept it ({} {})", rescue.format, rescue.version))
        }
    }
}

impl RecoverySlot {
    /// A new slot for this editor.
    ///
    /// # Errors
    /// If the folder can't be written.
    pub fn claim(folders: &Folders) -> Result<Self, StorageError> {
        let folder = folder(folders);
        fs::create_dir_all(&folder).map_err(|error| StorageError::write(&folder, &error))?;
        loop {
            let now_ns = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default().as_nanos();
            let rescue = folder.join(format!("{}-{now_ns}.rescue", std::process::id()));
            let lock_path = rescue.with_extension("lock");
            let lock = File::create_new(&lock_path).map_err(|error| StorageError::write(&lock_path, &error))?;
            if leftover::hold(&lock, &lock_path) {
                return Ok(Self { rescue, _lock: lock });
            }
        }
    }

    /// Where its rescue is to be written.
    pub fn file(&self) -> &Path {
        &self.rescue
    }

    /// There is nothing to rescue any more.
    pub fn clear(self) {
        let _ = fs::remove_file(&self.rescue);
        let _ = fs::remove_file(self.rescue.with_extension("lock"));
    }
}

/// What editors left that ended without saving, the latest first. Slots without a rescue are cleared away.
pub fn orphans(folders: &Folders) -> Vec<Orphan> {
    let folder = folder(folders);
    leftover::sweep(&folder);
    let Ok(entries) = fs::read_dir(&folder) else { return Vec::new() };
    let locks =
        entries.flatten().map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|e| e == "lock"));
    let mut found: Vec<Orphan> = locks.filter_map(|lock| orphan(&lock)).collect();
    found.sort_by_key(|orphan| std::cmp::Reverse(orphan.rescue.as_ref().map_or(0, |rescue| rescue.saved_at_ms)));
    found
}

fn orphan(lock_path: &Path) -> Option<Orphan> {
    let lock = leftover::claim(lock_path)?;
    let slot = RecoverySlot { rescue: lock_path.with_extension("rescue"), _lock: lock };
    if !slot.rescue.exists() {
        slot.clear();
        return None;
    }
    let rescue = Rescue::read(&slot.rescue);
    Some(Orphan { slot, rescue })
}

fn folder(folders: &Folders) -> PathBuf {
    folders.state.join("recovery")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_nobody_holds_is_an_orphan() {
        let home = tempfile::tempdir().expect("a folder");
        let folders = Folders::within(home.path());
        assert!(orphans(&folders).is_empty());
        let (first, second) =
            (RecoverySlot::claim(&folders).expect("writable"), RecoverySlot::claim(&folders).expect("writable"));
        let rescue = Rescue::new(Some(Path::new("/a.cloudscene")), None, "{}".into(), String::new());
        for slot in [&first, &second] {
            rescue.write(slot.file()).expect("writable");
        }
        assert!(orphans(&folders).is_empty(), "both editors run");
        drop(first);
        let found = orphans(&folders);
        assert_eq!(found.iter().map(|o| o.rescue.clone()).collect::<Vec<_>>(), [Ok(rescue)]);
        assert!(orphans(&folders).is_empty(), "it is being offered");
        fs::write(found[0].slot.file(), "{").expect("writable");
        drop(found);
        let mut found = orphans(&folders);
        assert!(found[0].rescue.is_err(), "a broken one is offered too, to be thrown away");
        found.remove(0).slot.clear();
        second.clear();
        let left = fs::read_dir(home.path().join("state/recovery")).expect("there").count();
        assert_eq!(left, 0);
        drop(RecoverySlot::claim(&folders).expect("writable"));
        assert!(orphans(&folders).is_empty(), "nothing was ever kept in it");
    }
}
