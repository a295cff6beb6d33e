//! What becomes of work on files, which is done off the frame.

use crate::saving::{SaveError, Saved};
use crate::storage::StorageError;
use cloudwright_core::document::SavedMark;
use std::path::PathBuf;

/// Work on files that was done.
pub(super) enum Done {
    Saved {
        path: PathBuf,
        mark: SavedMark,
        outcome: Result<Saved, SaveError>,
    },
    Rescued(Result<(), StorageError>),
    Remembered(Result<(), StorageError>),
    /// The last scenes, and whether each is still there.
    Recent(Vec<(PathBuf, bool)>),
}
