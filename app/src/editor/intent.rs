//! What is to come after the present document.

use crate::state::ScriptChange;
use std::path::PathBuf;

/// Something that leaves the present document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Intent {
    New,
    OpenFile(PathBuf),
    Quit,
}

/// What would lose text of the script that is being written.
#[derive(Debug, Clone)]
pub(crate) enum Then {
    Change(ScriptChange),
    Quit,
}
