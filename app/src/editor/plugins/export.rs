//! What an exporter made is written into a file that the user names.

use crate::editor::done::Done;
use crate::editor::{Ask, Editor};
use crate::saving::{self, SaveError};
use crate::storage::Over;
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl Editor {
    /// Asks for the file's name; first offered is the scene's, with the exporter's ending.
    pub(super) fn ask_export(&mut self, ending: &str, context: &egui::Context) {
        let name = || PathBuf::from(&self.session.scene().name);
        let start = self.session.path().map_or_else(name, PathBuf::from).with_extension(ending);
        self.ask(Ask::Export(start), context);
    }

    /// Has it written under the name that was given, and leaves the exporter.
    pub(in crate::editor) fn export_to(&mut self, given: &Path, asked_already: bool) {
        let Some(mut asked) = self.plugins.asked.take() else { return };
        let Some(text) = asked.text.take() else { return self.plugins.asked = Some(asked) };
        let ending = &asked.run.plugin.description.ending;
        let path = if given.extension().is_some() { given.to_path_buf() } else { given.with_extension(ending) };
        // Who chose the name in a native dialog was asked there about a file that has it.
        let over = if asked_already && path == given { Over::Anything } else { Over::Nothing };
        let scene = Arc::clone(&asked.run.scene);
        let file = self.session.path().map(PathBuf::from);
        self.disk.file_jobs.ask(move || {
            let outcome = saving::export(&text, &scene, file.as_deref(), &path, over);
            Done::Exported { path, lines: text.lines().count(), outcome }
        });
        self.remember_run(&asked.run);
    }

    pub(in crate::editor) fn exported(&mut self, path: &Path, lines: usize, outcome: Result<(), SaveError>) {
        match outcome {
            Ok(()) => {
                let lines = if lines == 1 { "1 line".into() } else { format!("{lines} lines") };
                self.tell(format!("Exported {}: {lines}", path.display()));
            }
            Err(error) => self.dialogs.fail("Nothing was exported", &error),
        }
    }
}
