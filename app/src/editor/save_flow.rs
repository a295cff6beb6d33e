//! Saving, off the frame.
//!
//! The scene is copied and handed to the thread that writes files, with the mark of its state; when the file is whole, that state is the
//! saved one, and what was edited meanwhile stays modified. What was to follow (closing, a new scene) waits for it. A
//! file that is not the one last known is not replaced without a question.

use super::Editor;
use super::dialogs::Dialog;
use super::done::Done;
use super::files::{self, Ask};
use super::intent::Intent;
use crate::saving::{self, SaveError, Saved};
use crate::storage::{Over, StorageError};
use cloudwright_core::document::{Edit, SavedMark};
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::Scene;
use std::path::{Path, PathBuf};

impl Editor {
    pub(super) fn save(&mut self, context: &egui::Context) {
        match self.session.path().map(PathBuf::from) {
            Some(path) => self.save_to(&path, self.over(&path), context),
            None => self.save_as(context),
        }
    }

    pub(super) fn save_as(&mut self, context: &egui::Context) {
        let name = || PathBuf::from(format!("{}.{}", self.session.scene().name, scene_file::EXTENSION));
        let start = self.session.path().map_or_else(name, PathBuf::from);
        self.ask(Ask::Save(start), context);
    }

    /// Saves under a name that the user gave. Who chose it in a native dialog was asked there about a file that has it.
    pub(super) fn save_under(&mut self, given: &Path, asked_already: bool, context: &egui::Context) {
        let path = files::with_extension(given.into());
        let over = if asked_already && path == given { Over::Anything } else { self.over(&path) };
        self.save_to(&path, over, context);
    }

    /// Saves first, then carries `intent` out.
    pub(super) fn save_and_go(&mut self, intent: Intent, context: &egui::Context) {
        self.after_save = Some(intent);
        self.save(context);
    }

    /// What may be replaced at `path` without a question.
    fn over(&self, path: &Path) -> Over {
        match self.disk.known {
            Some(stamp) if self.session.path() == Some(path) => Over::Known(stamp),
            _ => Over::Nothing,
        }
    }

    /// Has the scene written to `path`, which becomes its file.
    pub(super) fn save_to(&mut self, path: &Path, over: Over, context: &egui::Context) {
        if let Err(error) = self.session.commit() {
            self.after_save = None;
            return self.tell_error(error.to_string());
        }
        self.name_by(path);
        let (scene, path) = (self.session.scene().clone(), path.to_path_buf());
        let from = self.session.path().map(PathBuf::from);
        let elsewhere = self.session.elsewhere().clone();
        let mark = self.session.document().mark();
        self.disk.saving = true;
        self.disk.file_jobs.ask(move || {
            let outcome = saving::save_bringing(&scene, from.as_deref(), &elsewhere, &path, over);
            Done::Saved { path, mark, outcome }
        });
        context.request_repaint();
    }

    /// A scene that is saved for the first time, and that nobody gave a name, is called what its file is.
    fn name_by(&mut self, path: &Path) {
        let unnamed = self.session.path().is_none() && self.session.scene().name == Scene::default().name;
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
        if let Some(name) = stem.filter(|_| unnamed) {
            let done = self.session.edit("Name by its file", vec![Edit::Name(name)]);
            self.report(done);
        }
    }

    pub(super) fn saved(
        &mut self,
        path: PathBuf,
        mark: SavedMark,
        outcome: Result<Saved, SaveError>,
        context: &egui::Context,
    ) {
        self.disk.saving = false;
        match outcome {
            Ok(Saved { stamp, copied }) => {
                self.dialogs.list(&path, self.session.saved_as(path.clone(), mark));
                self.disk.known = Some(stamp);
                let copied = if copied.is_empty() {
                    String::new()
                } else {
                    format!("; copied beside it: {}", copied.join(", "))
                };
                self.tell(format!("Saved {}{copied}", path.display()));
                self.disk.remember(move |settings| settings.remember_scene(&path));
                if let Some(intent) = self.after_save.take() {
                    self.want(intent, context);
                }
            }
            Err(SaveError::Storage(StorageError::InTheWay { path, reason })) => {
                self.toasts.forget_errors();
                self.dialogs.open(Dialog::InTheWay { path, reason });
            }
            // Whatever failed also ends what was to follow.
            Err(error) => {
                self.after_save = None;
                self.dialogs.fail("The scene can't be saved", &error);
            }
        }
    }
}
