//! What is to be chosen of a plugin is being asked; the scene shows what would come of it, as an open gesture.

use super::Run;
use crate::editor::Editor;
use crate::panel::{self, Answer};
use crate::plugins::{Origin, carried_over};
use cloudwright_scripts::{Outcome, PluginKind, ScriptError};
use std::sync::Arc;

/// Said of a plugin whose file has changed while it is asked about.
const READ_AGAIN: &str = "Its file has changed and was read again.";

/// A plugin whose values are being chosen.
pub(super) struct Asked {
    pub(super) run: Run,
    /// The scene shows a run.
    shows: bool,
    /// It was said to be done; the run that it waits for goes on.
    confirmed: bool,
    /// What has become of its file.
    notice: Option<String>,
    /// What an exporter made, for a file whose name is being asked.
    pub(super) text: Option<String>,
}

impl Asked {
    pub(super) fn new(run: Run) -> Self {
        Self { run, shows: false, confirmed: false, notice: None, text: None }
    }

    pub(super) fn exports(&self) -> bool {
        self.run.plugin.description.kind == PluginKind::Exporter
    }
}

impl Editor {
    pub(in crate::editor) fn show_plugin(&mut self, context: &egui::Context) {
        let Some(mut asked) = self.plugins.asked.take() else { return };
        // Whatever ended the gesture meanwhile (a save, an undo) has answered.
        if asked.shows && !self.session.document().is_open() {
            self.view.keep_what_is_in(self.session.scene());
            return;
        }
        self.follow_file(&mut asked);
        let mut values = std::mem::take(&mut asked.run.values);
        let title = self.title_of(&asked.run);
        let form = asked.run.form(&title, asked.notice.as_deref(), self.disk.settings().units);
        let answer = panel::ask_plugin(context, &form, &mut values);
        asked.run.values = values;
        match answer {
            Some(Answer::Cancel) => return self.take_back(&asked),
            Some(Answer::Do) => asked.confirmed = true,
            None => {}
        }
        // An exporter changes nothing that could be shown: it runs when it is to.
        let may_run = !asked.exports() || asked.confirmed;
        if may_run && let Some(ended) = asked.run.keep_up(context) {
            self.show_outcome(&mut asked, ended, context);
        }
        let is_done = asked.confirmed && asked.run.has_run();
        if is_done && !asked.exports() {
            return self.keep_run(asked);
        }
        self.plugins.asked = Some(asked);
    }

    /// The file of a plugin may change while its dialog is open: it is read again, and what was chosen stays. While it is
    /// gone or broken, what was read before goes on.
    fn follow_file(&self, asked: &mut Asked) {
        let Origin::File(_) = &asked.run.origin else { return };
        match self.plugins.library().from(&asked.run.origin).map(|entry| &entry.read) {
            Some(Ok(plugin)) if Arc::ptr_eq(plugin, &asked.run.plugin) => {}
            // The folder was read again, and this one is as it was: it may have been gone or broken meanwhile.
            Some(Ok(plugin)) if *plugin == asked.run.plugin => {
                asked.notice = asked.notice.take().filter(|notice| notice == READ_AGAIN);
            }
            Some(Ok(plugin)) => {
                asked.run.values = carried_over(&asked.run.values, plugin);
                asked.run.plugin = Arc::clone(plugin);
                asked.confirmed = false;
                asked.notice = Some(READ_AGAIN.into());
            }
            Some(Err(error)) => {
                asked.notice =
                    Some(format!("Its file has changed and can't be read: {error}. The one before goes on."));
            }
            None => asked.notice = Some("Its file is gone; what was read of it goes on.".into()),
        }
    }

    /// Brings the scene to what a run came to; to what it was before if that is nothing.
    fn show_outcome(&mut self, asked: &mut Asked, ended: Result<Outcome, ScriptError>, context: &egui::Context) {
        self.session.cancel();
        self.view.selection = asked.run.selection.clone();
        asked.shows = false;
        let outcome = match ended {
            Ok(outcome) => outcome,
            Err(error) => {
                asked.confirmed = false;
                return asked.run.failed(&error);
            }
        };
        asked.run.error = None;
        asked.run.printed = outcome.printed;
        if asked.exports() {
            // It is run anew when it is asked for anew.
            asked.run.trial.forget();
            asked.confirmed = false;
            asked.text = outcome.text;
            return self.ask_export(&asked.run.plugin.description.ending, context);
        }
        match self.session.drag(&asked.run.plugin.description.name, outcome.edits) {
            Ok(()) => asked.shows = true,
            Err(error) => {
                self.session.cancel();
                asked.confirmed = false;
                asked.run.failed(&error);
            }
        }
        self.view.keep_what_is_in(self.session.scene());
    }

    /// Leaves the scene as it was.
    fn take_back(&mut self, asked: &Asked) {
        self.session.cancel();
        self.select(asked.run.selection.clone());
    }

    /// What the scene shows becomes an undo point.
    fn keep_run(&mut self, asked: Asked) {
        let done = self.session.commit();
        if done.is_ok() {
            self.ran(asked.run);
        }
        self.report(done);
    }
}
