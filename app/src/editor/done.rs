//! What becomes of work on files, which is done off the frame.

use crate::plugins::ReadError;
use crate::saving::{SaveError, Saved};
use crate::storage::{Stamp, StorageError};
use cloudwright_core::document::SavedMark;
use std::path::PathBuf;

/// Work on files that was done.
pub(super) enum Done {
    Saved {
        path: PathBuf,
        mark: SavedMark,
        outcome: Result<Saved, SaveError>,
    },
    Remembered(Result<(), StorageError>),
    /// What an exporter made was written, or was not.
    Exported {
        path: PathBuf,
        lines: usize,
        outcome: Result<(), SaveError>,
    },
    /// A script was read, or could not be.
    ScriptRead {
        path: PathBuf,
        stamp: Option<Stamp>,
        outcome: Result<String, ReadError>,
    },
    /// A script was written with that text, or was not.
    ScriptSaved {
        path: PathBuf,
        text: String,
        outcome: Result<Stamp, StorageError>,
    },
    /// A report of a problem was written, or was not.
    Reported {
        path: PathBuf,
        outcome: Result<(), StorageError>,
    },
    /// A folder was shown in the file manager, or could not be.
    FolderShown(Result<(), StorageError>),
    /// The last scenes, those that are still there.
    StillThere(Vec<PathBuf>),
    /// The last scenes, and whether each is still there.
    Recent(Vec<(PathBuf, bool)>),
}

/// What a user is told at once of unsaved work that can't be kept.
pub(super) fn unkept(why: &str) -> String {
    format!("The work can't be kept for a crash: {why}")
}
