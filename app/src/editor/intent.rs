//! What is to come after the present document.

use crate::starter::Template;
use crate::state::ScriptChange;
use cloudwright_core::scene::Scene;
use std::path::PathBuf;
use std::sync::Arc;

/// Something that leaves the present document.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Intent {
    /// That sky, as a scene that has no file yet.
    Begin(Template),
    OpenFile(PathBuf),
    /// A scene that has no file yet.
    Take(Arc<Scene>),
    Quit,
}

/// What would lose text of the script that is being written.
#[derive(Debug, Clone)]
pub(crate) enum Then {
    Change(ScriptChange),
    Quit,
}
