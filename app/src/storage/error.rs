//! Why a file can't be read or written, in words for people, with a way out.

use std::io;
use std::path::{Path, PathBuf};

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
    /// A file is there that the writer doesn't know.
    #[error("{}: {reason}", path.display())]
    InTheWay {
        /// Which file.
        path: PathBuf,
        /// How it came there.
        reason: String,
    },
}

impl StorageError {
    pub(super) fn read(path: &Path, error: &io::Error) -> Self {
        Self::Read { path: path.into(), reason: reason(error), hint: read_hint(error).into() }
    }

    pub(super) fn write(path: &Path, error: &io::Error) -> Self {
        Self::Write { path: path.into(), reason: reason(error), hint: write_hint(error).into() }
    }

    /// What stands against it, without path and hint.
    pub fn reason(&self) -> &str {
        match self {
            Self::Read { reason, .. } | Self::Write { reason, .. } | Self::InTheWay { reason, .. } => reason,
        }
    }
}

fn write_hint(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::NotFound => "make the folder first, or choose another",
        io::ErrorKind::NotADirectory => "a part of the path is a file; choose a folder",
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => "choose a folder that you may write to",
        io::ErrorKind::InvalidFilename => "choose a shorter name, of ordinary letters",
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "make space, or choose another disk",
        io::ErrorKind::FileTooLarge => "raise the limit of a file's size, or choose another disk",
        _ => "choose another place",
    }
}

fn read_hint(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory | io::ErrorKind::InvalidFilename => "check the name",
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
        io::ErrorKind::InvalidFilename => "its name is too long, or not allowed here".into(),
        // tempfile adds the path it tried; only the cause matters here.
        _ => error.to_string(),
    };
    text.split(" (os error").next().unwrap_or_default().to_owned()
}
