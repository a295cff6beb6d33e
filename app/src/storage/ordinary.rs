//! Opening a file that is there: an ordinary one, and nothing else.
//!
//! A pipe that nobody writes to waits for ever, and a device need not end. So what a name leads to is looked at before
//! it is opened, for opening a device may already do something; and again when it is open, for it may have been
//! exchanged in between. Links to ordinary files are followed.

use super::StorageError;
use std::fs::{self, File, Metadata, OpenOptions};
use std::path::Path;

const HINT: &str = "only files are read; save what comes from there as one first";

/// The ordinary file at `path`, open as `options` say, and what is known about it.
///
/// # Errors
/// If it can't be opened, or is a folder, a pipe, a socket or a device. None of them is waited for.
pub(super) fn open(path: &Path, options: &mut OpenOptions) -> Result<(File, Metadata), StorageError> {
    let fail = |error| StorageError::read(path, &error);
    check(path, &fs::metadata(path).map_err(fail)?)?;
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(options, libc::O_NONBLOCK);
    let file = options.open(path).map_err(fail)?;
    let about = file.metadata().map_err(fail)?;
    check(path, &about)?;
    Ok((file, about))
}

fn check(path: &Path, about: &Metadata) -> Result<(), StorageError> {
    if about.is_file() {
        return Ok(());
    }
    if about.is_dir() {
        return Err(StorageError::read(path, &std::io::ErrorKind::IsADirectory.into()));
    }
    Err(StorageError::Read { path: path.into(), reason: kind(about).into(), hint: HINT.into() })
}

#[cfg(unix)]
fn kind(about: &Metadata) -> &'static str {
    use std::os::unix::fs::FileTypeExt;
    let kind = about.file_type();
    if kind.is_fifo() {
        "it is a pipe, not a file"
    } else if kind.is_socket() {
        "it is a socket, not a file"
    } else {
        "it is a device, not a file"
    }
}

#[cfg(not(unix))]
fn kind(_: &Metadata) -> &'static str {
    "it is no ordinary file"
}
