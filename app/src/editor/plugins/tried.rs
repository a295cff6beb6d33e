//! What a try of a plugin is of, and who runs it.

use crate::editor::trial::{Trial, Try};
use crate::scripting::{self, Request};
use crate::state::Item;
use crate::worker::Latest;
use cloudwright_core::scene::Scene;
use cloudwright_scripts::{Fault, Outcome, Patience, Plugin, ScriptError, Values};
use std::sync::Arc;

/// Runs of one plugin on one scene.
pub(super) type Runs = Trial<Tried, Result<Outcome, ScriptError>>;

/// A plugin with what was chosen.
#[derive(Clone)]
pub(super) struct Tried {
    plugin: Arc<Plugin>,
    values: Values,
}

impl PartialEq for Tried {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.plugin, &other.plugin) && self.values == other.values
    }
}

impl Tried {
    pub(super) fn new(plugin: &Arc<Plugin>, values: &Values) -> Self {
        Self { plugin: Arc::clone(plugin), values: values.clone() }
    }
}

/// Runs on `scene`, in which those things are selected.
///
/// # Errors
/// If the system gives no thread.
pub(super) fn runs(scene: Arc<Scene>, selected: &[Item], context: &egui::Context) -> std::io::Result<Runs> {
    let wake = context.clone();
    let selected: Arc<[Item]> = selected.into();
    let work = move |Try { wanted: Tried { plugin, values }, cancelled }: Try<Tried>| {
        // It counts from when the run begins.
        let patience = Patience { cancelled, ..Patience::usual() };
        let request = Request { plugin: &plugin, scene: &scene, selected: &selected, values: &values };
        let ended = scripting::run(request, &patience);
        (!matches!(&ended, Err(error) if error.fault == Fault::Cancelled)).then_some(ended)
    };
    Latest::start("plugin", work, move || wake.request_repaint()).map(Trial::by)
}
