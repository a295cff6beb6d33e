//! Plugins run: the one door through which window and command line have a script do something.

use cloudwright_core::scene::{Scene, Thing};
use cloudwright_scripts::{Outcome, Patience, Plugin, ScriptError, Values};

/// What a run starts from.
#[derive(Debug, Clone, Copy)]
pub struct Request<'a> {
    /// Whose run.
    pub plugin: &'a Plugin,
    /// The scene as it is.
    pub scene: &'a Scene,
    /// What is selected in it.
    pub selected: &'a [Thing],
    /// What was chosen.
    pub values: &'a Values,
}

/// Has the plugin say what is to be done; blocks until it has, or `patience` ends.
///
/// # Errors
/// As [`Plugin::run`].
pub fn run(request: Request<'_>, patience: &Patience) -> Result<Outcome, ScriptError> {
    let Request { plugin, scene, selected, values } = request;
    plugin.run_on(scene, selected, values, patience)
}
