//! The script that is being written, run on the open scene: one undo point at once, and its values to be changed after.

use super::{LastRun, Run};
use crate::editor::Editor;
use crate::plugins::Origin;
use cloudwright_scripts::{Outcome, Plugin, PluginKind};
use std::sync::Arc;

/// So many lines of what an exporter makes are shown.
const LINES: usize = 50;

/// A run of it that goes on.
pub(in crate::editor) struct ScriptRun(Run);

impl Editor {
    pub(in crate::editor) fn begin_script(&mut self, origin: &Origin, plugin: Arc<Plugin>, context: &egui::Context) {
        let Some(run) = self.run_of(origin, plugin, context) else { return };
        let script = &mut self.writing.script;
        script.fault = None;
        script.output.clear();
        script.runs = true;
        self.writing.run = Some(ScriptRun(run));
    }

    /// Once a frame: takes up what it has come to.
    pub(in crate::editor) fn keep_script_run(&mut self, context: &egui::Context) {
        let Some(ScriptRun(mut run)) = self.writing.run.take() else { return };
        let Some(ended) = run.keep_up(context) else {
            self.writing.run = Some(ScriptRun(run));
            return;
        };
        self.writing.script.runs = false;
        match ended {
            Ok(outcome) => self.script_has_run(run, outcome),
            Err(error) => self.writing.script.fault = Some(error),
        }
    }

    fn script_has_run(&mut self, mut run: Run, outcome: Outcome) {
        let Outcome { edits, printed, text } = outcome;
        run.printed.clone_from(&printed);
        let output = &mut self.writing.script.output;
        output.extend(printed);
        if run.plugin.description.kind == PluginKind::Exporter {
            let text = text.unwrap_or_default();
            output.extend(text.lines().take(LINES).map(String::from));
            let more = text.lines().count().saturating_sub(LINES);
            if more > 0 {
                output.push(format!("and {more} more"));
            }
            return;
        }
        let document = self.session.document();
        if document.is_open() || document.mark() != run.before {
            return output.push("The scene has changed meanwhile: run it again.".into());
        }
        let count = edits.len();
        output.push(if count == 1 { "1 edit".into() } else { format!("{count} edits") });
        let done = self.session.edit(&run.plugin.description.name, edits);
        if done.is_ok() {
            self.ran(run);
        }
        self.report(done);
    }

    /// A run has become an undo point, unless it changed nothing.
    pub(super) fn ran(&mut self, run: Run) {
        let mark = self.session.document().mark();
        self.remember_run(&run);
        self.select_after(&run);
        if mark == run.before {
            self.tell(format!("{} has changed nothing", run.plugin.description.name));
        }
        self.plugins.last = Some(LastRun::new(run, mark));
    }
}
