//! The only file access.
//!
//! Reading has a limit, so that a wrong path can't fill the memory. Writing is atomic: the bytes go into a temporary
//! file in the same folder, reach the disk, and only then take the name. Whoever looks sees the old file or the new
//! one, whole; a failed or stopped program leaves nothing under the name.

use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// A file that can't be read or written, and a way out.
#[derive(Debug, thiserror::Error)]
pub enum StorageError {
    /// It can't be read.
    #[error("{}: can't be read: {reason} ({hint})", path.display())]
    Read {
        /// Which file.
        path: PathBuf,
        /// What the system says.
        reason: String,
        /// What to do about it.
        hint: String,
    },
    /// It can't be written.
    #[error("{}: can't be written: {reason} ({hint})", path.display())]
    Write {
        /// Which file.
        path: PathBuf,
        /// What the system says.
        reason: String,
        /// What to do about it.
        hint: String,
    },
}

/// The bytes of a file of at most `limit` bytes.
///
/// # Errors
/// If it can't be read, is a folder, or is larger.
pub fn read(path: &Path, limit: usize) -> Result<Vec<u8>, StorageError> {
    let fail = |error: &io::Error| StorageError::Read {
        path: path.into(),
        reason: reason(error),
        hint: read_hint(error).into(),
    };
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|error| fail(&error))?;
    file.take(limit as u64 + 1).read_to_end(&mut bytes).map_err(|error| fail(&error))?;
    if bytes.len() > limit {
        return Err(StorageError::Read {
            path: path.into(),
            reason: format!("it is larger than {} MB", limit >> 20),
            hint: "is it the right file?".into(),
        });
    }
    Ok(bytes)
}

/// Puts `bytes` under the name `path`, all or nothing. A file that was there keeps its permissions, and a link still
/// leads to it.
///
/// # Errors
/// If there is no such folder, no permission or no space; what was there before is then untouched.
pub fn write_atomic(path: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    let fail = |error: &io::Error| write_error(path, error);
    // A link is written through, not replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.into());
    let mut file = temporary_beside(path, &target)?;
    file.write_all(bytes).map_err(|error| fail(&error))?;
    if let Ok(before) = fs::metadata(&target) {
        file.as_file().set_permissions(before.permissions()).map_err(|error| fail(&error))?;
    }
    file.as_file().sync_all().map_err(|error| fail(&error))?;
    file.persist(&target).map_err(|error| fail(&error.error))?;
    // The name itself reaches the disk with its folder. A system that can't do that has written the file all the same.
    if let Ok(folder) = File::open(folder_of(&target)) {
        let _ = folder.sync_all();
    }
    Ok(())
}

/// Whether [`write_atomic`] could write there: asked before work that takes long. Leaves nothing behind.
///
/// # Errors
/// As [`write_atomic`], but for a full disk.
pub fn check_writable(path: &Path) -> Result<(), StorageError> {
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.into());
    temporary_beside(path, &target).map(drop)
}

/// Whether both names lead to one file that is there.
pub fn is_same_file(a: &Path, b: &Path) -> bool {
    matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b)
}

fn temporary_beside(path: &Path, target: &Path) -> Result<NamedTempFile, StorageError> {
    if let Ok(before) = fs::metadata(target) {
        let refusal = if before.is_dir() {
            Some(("it is a folder", "give a file name in it"))
        } else if !before.is_file() {
            Some((
                "it is no ordinary file",
                "a device or a pipe can't be written whole or not at all; give a file name",
            ))
        } else if before.permissions().readonly() {
            Some(("it is write-protected", "choose another name, or take the protection off"))
        } else {
            None
        };
        if let Some((reason, hint)) = refusal {
            return Err(StorageError::Write { path: path.into(), reason: reason.into(), hint: hint.into() });
        }
    }
    if fs::symlink_metadata(target).is_ok_and(|link| link.is_symlink()) {
        let (reason, hint) = ("it is a link that leads nowhere", "remove the link, or make what it leads to");
        return Err(StorageError::Write { path: path.into(), reason: reason.into(), hint: hint.into() });
    }
    let mut builder = tempfile::Builder::new();
    builder.prefix(".cloudwright-");
    // Temporary files are private by default; this one becomes a file like any other, as the user's mask says.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder_of(target)).map_err(|error| write_error(path, &error))
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

fn write_error(path: &Path, error: &io::Error) -> StorageError {
    let hint = match error.kind() {
        io::ErrorKind::NotFound => "make the folder first, or choose another",
        io::ErrorKind::NotADirectory => "a part of the path is a file; choose a folder",
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => "choose a folder that you may write to",
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "make space, or choose another disk",
        _ => "choose another place",
    };
    StorageError::Write { path: path.into(), reason: reason(error), hint: hint.into() }
}

fn read_hint(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => "check the name",
        io::ErrorKind::IsADirectory => "give a file in it",
        io::ErrorKind::PermissionDenied => "you may not read it; change its permissions",
        _ => "try a copy of it",
    }
}

/// The system's words without its number.
fn reason(error: &io::Error) -> String {
    let text = match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".into(),
        io::ErrorKind::IsADirectory => "it is a folder".into(),
        io::ErrorKind::NotADirectory => "a part of its path is not a folder".into(),
        io::ErrorKind::PermissionDenied => "permission denied".into(),
        // tempfile adds the path it tried; only the cause matters here.
        _ => error.to_string(),
    };
    text.split(" (os error").next().unwrap_or_default().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn writes_all_or_nothing() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.txt");
        write_atomic(&path, b"one").expect("writable");
        write_atomic(&path, b"two").expect("writable");
        assert_eq!(read(&path, 3).expect("readable"), b"two");
        assert!(read(&path, 2).is_err(), "larger than the limit");
        assert!(write_atomic(&path.join("b.txt"), b"x").is_err(), "a file is no folder");
        assert!(write_atomic(folder.path(), b"x").is_err(), "a folder is no file");
        assert!(write_atomic(&folder.path().join("none/b.txt"), b"x").is_err());
        assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 1, "nothing is left behind");
    }

    #[cfg(unix)]
    #[test]
    fn keeps_permissions_and_links() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().expect("a folder");
        let (path, link) = (folder.path().join("a.txt"), folder.path().join("link.txt"));
        write_atomic(&path, b"one").expect("writable");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).expect("allowed");
        std::os::unix::fs::symlink(&path, &link).expect("allowed");
        write_atomic(&link, b"two").expect("writable");
        assert_eq!(read(&path, 9).expect("readable"), b"two");
        assert_eq!(fs::metadata(&path).expect("there").permissions().mode() & 0o777, 0o640);
        assert!(fs::symlink_metadata(&link).expect("there").file_type().is_symlink());
        fs::set_permissions(&path, fs::Permissions::from_mode(0o440)).expect("allowed");
        assert!(write_atomic(&path, b"three").is_err(), "write-protected");
    }

    #[test]
    fn no_other_file_of_this_package_touches_files() {
        let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
        let mut seen = 0;
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).expect("readable") {
                let path = entry.expect("readable").path();
                if path.is_dir() {
                    folders.push(path);
                    continue;
                }
                let text = fs::read_to_string(&path).expect("text");
                let touches = ["std::fs", "File::", "OpenOptions"].iter().any(|word| text.contains(word));
                assert!(!touches || path.ends_with("storage.rs"), "{}", path.display());
                seen += 1;
            }
        }
        assert!(seen > 20, "the sources are where they are looked for");
    }
}
