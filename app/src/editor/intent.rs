//! What is to come after the present document.

use std::path::PathBuf;

/// Something that leaves the present document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Intent {
    New,
    OpenFile(PathBuf),
    Quit,
}
