//! Whether a file is still the one that was read or written.

use serde::{Deserialize, Serialize};
use std::fs::{self, Metadata};
use std::path::Path;
use std::time::SystemTime;

/// When a file was last changed and how long it is: two files that differ hardly ever agree in both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Stamp {
    /// None where the system keeps no such time.
    modified: Option<SystemTime>,
    bytes: u64,
}

impl Stamp {
    /// Of the file at `path`; none if there is none.
    pub fn of(path: &Path) -> Option<Self> {
        fs::metadata(path).ok().map(|about| Self::from_metadata(&about))
    }

    /// Whether it can be written down: a time before 1970 can't.
    pub(super) fn can_be_said(&self) -> bool {
        self.modified.is_none_or(|modified| modified >= SystemTime::UNIX_EPOCH)
    }

    pub(super) fn from_metadata(about: &Metadata) -> Self {
        Self { modified: about.modified().ok(), bytes: about.len() }
    }
}
