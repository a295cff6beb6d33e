//! The last run, to be had with other values instead: one undo point takes the place of the other, as long as nothing
//! else was changed since. (As Blender's panel for the last operation does.)

use super::Run;
use crate::editor::Editor;
use crate::panel;
use cloudwright_core::document::SavedMark;
use cloudwright_scripts::{Outcome, ScriptError};

/// A run that became an undo point.
pub(super) struct LastRun {
    run: Run,
    /// The state that the scene was left in.
    after: SavedMark,
}

impl LastRun {
    pub(super) fn new(run: Run, after: SavedMark) -> Self {
        Self { run, after }
    }
}

impl Editor {
    pub(in crate::editor) fn show_last_run(&mut self, context: &egui::Context) {
        let document = self.session.document();
        let is_present = |last: &LastRun| document.mark() == last.after && !document.is_open();
        // Undone, it waits for a redo; while something is asked or dragged, it is not in the way.
        if self.is_asking() || !self.plugins.last.as_ref().is_some_and(is_present) {
            return;
        }
        let Some(mut last) = self.plugins.last.take() else { return };
        let title = self.title_of(&last.run);
        let mut values = std::mem::take(&mut last.run.values);
        let stays =
            panel::show_last_run(context, &last.run.form(&title, None, self.disk.settings().units), &mut values);
        last.run.values = values;
        if let Some(ended) = last.run.keep_up(context) {
            self.replace_last(&mut last, ended);
        }
        if stays {
            self.plugins.last = Some(last);
        }
    }

    /// Puts what a run came to in the place of the run before. If that is nothing, the run before stays.
    fn replace_last(&mut self, last: &mut LastRun, ended: Result<Outcome, ScriptError>) {
        let outcome = match ended {
            Ok(outcome) => outcome,
            Err(error) => return last.run.failed(&error),
        };
        let had_changed = last.after != last.run.before;
        if had_changed {
            self.session.undo();
        }
        match self.session.edit(&last.run.plugin.description.name, outcome.edits) {
            Ok(()) => {
                last.run.error = None;
                last.run.printed = outcome.printed;
                last.after = self.session.document().mark();
                self.remember_run(&last.run);
                self.view.timeline.forget_changes();
                self.select_after(&last.run);
            }
            Err(error) => {
                if had_changed {
                    self.session.redo();
                }
                last.run.failed(&error);
            }
        }
    }
}
