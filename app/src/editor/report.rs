//! What there is to tell about this program, and a file of it for whoever looks into a problem.

use super::Editor;
use super::dialogs::{Dialog, Report};
use super::done::Done;
use super::files::{Ask, over};
use crate::storage::{self, StorageError};
use cloudwright_core::formats::scene_file;
use std::fmt::Write;
use std::path::{Path, PathBuf};

impl Editor {
    /// Names and values, for *About* and reports.
    pub(super) fn facts(&self) -> Vec<(&'static str, String)> {
        let build = if cfg!(debug_assertions) { " (debug build)" } else { "" };
        vec![
            ("Version", format!("{}{build}", env!("CARGO_PKG_VERSION"))),
            ("Drawn by", self.viewport.renderer_name()),
            ("Window", self.viewport.driver().unwrap_or_else(|| "without a device".into())),
            ("System", format!("{} on {}", std::env::consts::OS, std::env::consts::ARCH)),
        ]
    }

    pub(super) fn ask_report(&mut self) {
        self.dialogs.open(Dialog::Report(Report::default()));
    }

    /// All that is told but what the user says and the scene.
    pub(super) fn report_facts(&self) -> String {
        let mut text = String::new();
        for (name, value) in self.facts() {
            let _ = writeln!(text, "{name}: {value}");
        }
        let scene = self.session.scene();
        let clouds = self.session.derived().clouds();
        let sprites: usize = clouds.iter().map(|cloud| cloud.sprites.len()).sum();
        let (models, clouds, tracks) = (scene.models.len(), clouds.len(), scene.tracks.len());
        let _ = writeln!(text, "Scene: {models} models, {clouds} clouds, {sprites} sprites, {tracks} tracks");
        let _ = writeln!(text, "\nThe last messages, the newest last:");
        for line in self.toasts.said() {
            let _ = writeln!(text, "- {line}");
        }
        let _ = writeln!(text, "\nThe last changes, the newest last:");
        let history = self.session.document().history();
        let names: Vec<&str> = history.names().take(history.done_count()).collect();
        for name in &names[names.len().saturating_sub(CHANGES)..] {
            let _ = writeln!(text, "- {name}");
        }
        let _ = writeln!(text, "\nSettings:\n{}", self.disk.settings().to_text());
        text
    }

    /// Asks for the name of the file that `report` goes into.
    pub(super) fn save_report(&mut self, report: &Report, context: &egui::Context) {
        let facts = self.report_facts();
        let mut text = format!("Cloudwright: report of a problem\n\n{}\n\n{facts}", report.said.trim());
        if report.with_scene {
            match scene_file::write(self.session.scene()) {
                Ok(scene) => drop(write!(text, "\nScene file:\n{scene}")),
                Err(error) => drop(write!(text, "\nThe scene can't be written: {error}")),
            }
        }
        let folder = self.session.path().and_then(Path::parent).map(PathBuf::from).unwrap_or_default();
        self.report_text = Some(text);
        self.ask(Ask::Report(folder.join("cloudwright-report.txt")), context);
    }

    /// Has it written under the name that was given.
    pub(super) fn report_to(&mut self, given: &Path, asked_already: bool) {
        let Some(text) = self.report_text.take() else { return };
        let path = if given.extension().is_some() { given.to_path_buf() } else { given.with_extension("txt") };
        let over = over(given, &path, asked_already);
        self.disk.file_jobs.ask(move || {
            let outcome = storage::write_over(&path, text.as_bytes(), over).map(drop);
            Done::Reported { path, outcome }
        });
    }

    pub(super) fn reported(&mut self, path: &Path, outcome: Result<(), StorageError>) {
        match outcome {
            Ok(()) => self.tell(format!("The report is in {}", path.display())),
            Err(error) => self.dialogs.fail("The report was not written", &error),
        }
    }
}

/// The most that are told of.
const CHANGES: usize = 20;
