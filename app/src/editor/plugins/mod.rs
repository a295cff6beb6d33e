//! Plugins in the window: which there are, the question what is to be chosen of one, and its last run to be had again.
//!
//! A run goes on off the frame ([`tried`]); what it asks for is shown as an open gesture, which becomes one undo point
//! or nothing ([`asked`]). The values of the last run can be changed as long as nothing else was ([`last`]).

mod asked;
mod export;
mod last;
mod script_run;
mod shelf;
mod tried;

use super::Editor;
use crate::panel::{PluginForm, Said};
use crate::plugins::{self, Library, Origin, ReadError};
use crate::state::{Item, Selection};
use crate::storage::{self, Folders};
use asked::Asked;
use cloudwright_core::document::SavedMark;
use cloudwright_core::problem::Problem;
use cloudwright_core::scene::{Cloud, Scene};
use cloudwright_scripts::{Outcome, Plugin, PluginKind, ScriptError, Values};
use last::LastRun;
pub(super) use script_run::ScriptRun;
use shelf::Shelf;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use tried::{Runs, Tried};

/// Of all plugins, and of the one that is being asked about or was run last.
pub(super) struct Plugins {
    shelf: Shelf,
    asked: Option<Asked>,
    last: Option<LastRun>,
    /// Which one was run last.
    again: Option<Origin>,
    /// What was chosen of each, by its name too, until the window is closed: what is written as a script may become another.
    chosen: BTreeMap<(Origin, String), Values>,
}

/// A plugin at work on a scene.
struct Run {
    origin: Origin,
    plugin: Arc<Plugin>,
    values: Values,
    trial: Runs,
    /// The scene that all runs begin with.
    scene: Arc<Scene>,
    /// What was selected before, and is what the plugin sees as selected.
    selection: Selection,
    /// The state that the scene was in.
    before: SavedMark,
    /// Why the last run came to nothing.
    error: Option<String>,
    printed: Vec<String>,
}

impl Plugins {
    pub(super) fn new(context: &egui::Context, folder: Option<PathBuf>) -> Self {
        Self { shelf: Shelf::new(context, folder), asked: None, last: None, again: None, chosen: BTreeMap::new() }
    }

    pub(super) fn library(&self) -> &Library {
        self.shelf.library()
    }

    /// Whether what is to be chosen of a plugin is being asked.
    pub(super) fn is_asking(&self) -> bool {
        self.asked.is_some()
    }

    /// Whether there is a last one, and it is still there.
    pub(super) fn can_run_again(&self) -> bool {
        self.again.as_ref().is_some_and(|origin| self.library().from(origin).is_some())
    }
}

impl Run {
    /// What is shown of it.
    fn form<'a>(&'a self, title: &'a str, notice: Option<&'a str>, units: crate::units::Units) -> PluginForm<'a> {
        let said = Said { error: self.error.as_deref(), printed: &self.printed, runs: self.trial.takes_long(), notice };
        PluginForm { plugin: &self.plugin, title, origin: &self.origin, scene: &self.scene, units, said }
    }

    /// Once a frame: sees that it is run with the values that are chosen, and hands over what a run has come to.
    fn keep_up(&mut self, context: &egui::Context) -> Option<Result<Outcome, ScriptError>> {
        self.trial.keep_up(&Tried::new(&self.plugin, &self.values), context)
    }

    /// Whether what the last run came to is what the chosen values come to.
    fn has_run(&self) -> bool {
        self.trial.is_of(&Tried::new(&self.plugin, &self.values))
    }

    /// Remembers why a run came to nothing.
    fn failed(&mut self, why: &impl ToString) {
        self.error = Some(why.to_string());
        self.printed.clear();
    }
}

impl Editor {
    /// At the end of each frame.
    pub(super) fn keep_plugins(&mut self, context: &egui::Context) {
        self.plugins.shelf.keep_up(context.input(|input| input.focused));
    }

    /// Asks what is to be chosen of the plugin from there; of a broken one, tells what is wrong.
    pub(super) fn ask_plugin(&mut self, origin: &Origin, context: &egui::Context) {
        let plugin = match self.plugins.library().from(origin).map(|entry| &entry.read) {
            Some(Ok(plugin)) => Arc::clone(plugin),
            Some(Err(error)) => {
                let problem = problem_of(error);
                return self.dialogs.list(std::path::Path::new(&origin.to_string()), vec![problem]);
            }
            None => return self.tell_error(format!("The plugin is gone: {origin}")),
        };
        if let Some(run) = self.run_of(origin, plugin, context) {
            self.plugins.asked = Some(Asked::new(run));
            context.request_repaint();
        }
    }

    /// A run of `plugin` on the scene as it is, with the values that were chosen last. None if it can't be, which is told.
    fn run_of(&mut self, origin: &Origin, plugin: Arc<Plugin>, context: &egui::Context) -> Option<Run> {
        if let Err(error) = self.session.commit() {
            self.tell_error(error.to_string());
            return None;
        }
        let scene = Arc::new(self.session.scene().clone());
        let trial = match tried::runs(Arc::clone(&scene), self.view.selection.items(), context) {
            Ok(trial) => trial,
            Err(error) => {
                self.tell_error(format!("The system gives no thread: {error}"));
                return None;
            }
        };
        self.plugins.last = None;
        let chosen = self.plugins.chosen.get(&(origin.clone(), plugin.description.name.clone()));
        Some(Run {
            values: chosen.map_or_else(|| plugin.values(), |chosen| plugins::carried_over(chosen, &plugin)),
            origin: origin.clone(),
            plugin,
            trial,
            scene,
            selection: self.view.selection.clone(),
            before: self.session.document().mark(),
            error: None,
            printed: Vec::new(),
        })
    }

    /// Another document has come: what was run on the one before is over.
    pub(super) fn leave_runs(&mut self) {
        self.plugins.asked = None;
        self.plugins.last = None;
        self.weather.leave();
        self.writing.run = None;
        self.writing.script.runs = false;
    }

    /// Asks for the last one again.
    pub(super) fn run_again(&mut self, context: &egui::Context) {
        if let Some(origin) = self.plugins.again.clone() {
            self.ask_plugin(&origin, context);
        }
    }

    pub(super) fn open_plugin_folder(&mut self) {
        let Some(folder) = self.disk.folders().map(Folders::plugins) else { return };
        self.disk.file_jobs.ask(move || super::done::Done::FolderShown(storage::show_folder(&folder)));
    }

    /// What it is called on screen.
    fn title_of(&self, run: &Run) -> String {
        self.plugins.library().label(&run.origin, &run.plugin)
    }

    /// Remembers what was chosen, and of which.
    fn remember_run(&mut self, run: &Run) {
        let which = (run.origin.clone(), run.plugin.description.name.clone());
        self.plugins.chosen.insert(which, run.values.clone());
        self.plugins.again = Some(run.origin.clone());
    }

    /// Selects the clouds that a generator made; else what was selected before, as far as it is still there.
    fn select_after(&mut self, run: &Run) {
        let first_new = run.scene.next_id.0;
        let is_new = |cloud: &&Cloud| cloud.id.0 >= first_new;
        let generates = run.plugin.description.kind == PluginKind::Generator;
        let made = self.session.scene().clouds.iter().filter(is_new).map(|cloud| Item::Cloud(cloud.id));
        let made = if generates { Selection::of(made) } else { Selection::default() };
        self.select(if made.is_empty() { run.selection.clone() } else { made });
    }
}

/// With line and column as the place.
fn problem_of(error: &ReadError) -> Problem {
    match error {
        ReadError::Script(ScriptError { place, message, hint, .. }) => {
            let place = place.map(|place| format!("line {}, column {}", place.line, place.column));
            Problem::error(place.unwrap_or_default(), message.clone(), hint.clone())
        }
        other => Problem::error("", other.to_string(), ""),
    }
}
