//! Which file a name leads to.

use std::fs;
use std::path::Path;

/// Tells one file from another, by whatever name: links of either kind, `./`, and small and large letters on a disk that
/// takes them for the same. Elsewhere than on Unix, two hard links count as two files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileId(Inner);

/// The disk and the file's number on it.
#[cfg(unix)]
type Inner = (u64, u64);
#[cfg(not(unix))]
type Inner = std::path::PathBuf;

impl FileId {
    /// Of what is at `path`; none if nothing is.
    #[cfg(unix)]
    pub fn of(path: &Path) -> Option<Self> {
        use std::os::unix::fs::MetadataExt;
        fs::metadata(path).ok().map(|about| Self((about.dev(), about.ino())))
    }

    /// Of what is at `path`; none if nothing is.
    #[cfg(not(unix))]
    pub fn of(path: &Path) -> Option<Self> {
        fs::canonicalize(path).ok().map(Self)
    }
}
