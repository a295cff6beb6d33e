//! New, open, revert, quit: what may need a question first, and a file name.
//!
//! What would lose changes is an [`Intent`]: it is carried out at once when nothing is unsaved, else after the user
//! has saved or said not to. A scene that can't be opened leaves the present document alone.

use super::Editor;
use super::dialogs::Dialog;
use super::files::{Ask, Reply, Waiting};
use super::intent::{Intent, Then};
use crate::opening::{self, OpenError};
use crate::panel::Panel;
use crate::state::{Session, ViewState};
use crate::storage::Stamp;
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::Scene;
use std::path::{Path, PathBuf};

impl Editor {
    /// The file's name, or the scene's.
    pub(super) fn display_name(&self) -> String {
        match self.session.path().and_then(Path::file_name) {
            Some(name) => name.to_string_lossy().into_owned(),
            None => self.session.scene().name.clone(),
        }
    }

    /// Carries `intent` out, after a save that is under way, and after a question if there are unsaved changes.
    pub(super) fn want(&mut self, intent: Intent, context: &egui::Context) {
        if self.disk.saving {
            self.after_save = Some(intent);
        } else if self.session.document().is_modified() {
            self.dialogs.open(Dialog::Unsaved(intent));
        } else {
            self.go(intent, context);
        }
    }

    /// Carries `intent` out, whatever is lost.
    pub(super) fn go(&mut self, intent: Intent, context: &egui::Context) {
        match intent {
            Intent::Begin(template) => match template.scene() {
                Ok(scene) => {
                    let mut session = Session::new(scene, None);
                    let problems = session.load_beside();
                    self.replace(session, None);
                    self.dialogs.list(Path::new(template.label()), problems);
                    self.toasts.forget_errors();
                }
                Err(problems) => self.dialogs.list(Path::new(template.label()), problems),
            },
            Intent::OpenFile(path) => self.open_path(&path),
            Intent::Take(scene) => {
                let mut session = Session::new(Scene::clone(&scene), None);
                session.mark_unsaved();
                self.replace(session, None);
            }
            Intent::Quit if self.writing.script.is_modified() => self.dialogs.open(Dialog::UnsavedScript(Then::Quit)),
            Intent::Quit => {
                self.quitting = true;
                context.send_viewport_cmd(egui::ViewportCommand::Close);
            }
        }
    }

    /// Opens the scene at `path` in place of the present one; if that can't be done, says why and changes nothing.
    pub fn open_path(&mut self, path: &Path) {
        // Looked at before it is read: what is changed in between is noticed later.
        let stamp = Stamp::of(path);
        let scene = match opening::open_scene(path) {
            Ok(scene) => scene,
            Err(OpenError::Problems { problems, .. }) => return self.dialogs.list(path, problems),
            Err(OpenError::Storage(error)) => return self.dialogs.fail("The scene can't be opened", &error),
        };
        let mut session = Session::new(scene, Some(path.into()));
        // A scene whose atlas is gone can still be edited; the built-in one stands in.
        self.dialogs.list(path, session.load_beside());
        self.replace(session, stamp);
        self.tell(format!("Opened {}", path.display()));
        let path = path.to_path_buf();
        self.disk.remember(move |settings| settings.remember_scene(&path));
    }

    /// Reads the document's file again, whatever is lost.
    pub(super) fn revert(&mut self) {
        if let Some(path) = self.session.path().map(PathBuf::from) {
            self.open_path(&path);
        }
    }

    /// Another document in place of the present one; `known` is its file as it is on disk.
    pub(super) fn replace(&mut self, session: Session, known: Option<Stamp>) {
        self.viewport.see(&session);
        if !session.scene().tracks.is_empty() {
            self.layout.offer(Panel::Timeline);
        }
        self.session = session;
        self.leave_runs();
        self.disk.known = known;
        self.time_play.leave();
        self.clock.begin_anew();
        self.recording = None;
        self.charting.forget();
        let ViewState { tool, snap, keep_fill, sorting, .. } = self.view;
        self.view = ViewState { tool, snap, keep_fill, sorting, ..ViewState::default() };
    }

    /// The file that a dialog begins beside: the scene's, or of one without a file, the one that was open last.
    pub(super) fn beside_what(&self) -> PathBuf {
        let last = || self.disk.settings().recent().first().cloned();
        self.session.path().map(PathBuf::from).or_else(last).unwrap_or_default()
    }

    /// Asks for a file name.
    pub(super) fn ask(&mut self, ask: Ask, context: &egui::Context) {
        self.waiting = Some(Waiting::start(self.file_dialogs.as_mut(), ask, context));
        context.request_repaint();
    }

    pub(super) fn answer_file_dialogs(&mut self, context: &egui::Context) {
        let Some((ask, reply)) = self.waiting.as_ref().and_then(|w| Some((w.ask.clone(), w.answered()?))) else {
            return;
        };
        self.waiting = None;
        match reply {
            Reply::Path(path) => self.use_path(&ask, path, true, context),
            Reply::Cancelled => self.give_up_what_follows(),
            Reply::NoDialog => self.dialogs.ask_path(ask),
        }
    }

    pub(super) fn use_path(&mut self, ask: &Ask, path: PathBuf, asked_already: bool, context: &egui::Context) {
        match ask {
            // Something may have been changed while the dialog was open, so the question comes after it.
            Ask::Open(_) => self.want(Intent::OpenFile(path), context),
            Ask::Save(_) => self.save_under(&path, asked_already, context),
            Ask::SaveScript(_) => self.save_script_under(&path, asked_already),
            Ask::Export(_) => self.export_to(&path, asked_already),
            Ask::Leave(_) => self.leave_to(&path, asked_already, context),
            Ask::Picture(_) => self.render_to(&path, asked_already, context),
            Ask::Video(_) => self.film_to(&path, asked_already, context),
            // A folder is no file that might be lost; what lies in it is heeded.
            Ask::Frames(_) => self.film_to(&path, true, context),
            Ask::Arrive(_) => self.ask_arriving(&path),
            Ask::Report(_) => self.report_to(&path, asked_already),
            Ask::Append(_) => self.ask_appending(&path),
            Ask::Model(item, _) => self.use_model(*item, &path),
        }
    }

    /// A scene dropped on the window is opened.
    pub(super) fn take_dropped_files(&mut self, context: &egui::Context) {
        let files = context.input_mut(|input| std::mem::take(&mut input.raw.dropped_files));
        let [file] = files.as_slice() else {
            if !files.is_empty() {
                self.tell_error("One scene at a time: several files were dropped");
            }
            return;
        };
        let path = file.path();
        self.dialogs.leave_start_page();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if !path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(scene_file::EXTENSION)) {
            self.tell_error(format!("{name} is no scene: drop a .{} file", scene_file::EXTENSION));
        } else if self.dialogs.is_open() {
            self.tell_error(format!("{name} was not opened: answer the question first"));
        } else {
            self.want(Intent::OpenFile(path.into()), context);
        }
    }

    /// The window's own button: closing waits until files are written and the question is answered.
    pub(super) fn answer_close_request(&mut self, context: &egui::Context) {
        let asked = context.input(|input| input.viewport().close_requested());
        let is_modified = self.session.document().is_modified() || self.writing.script.is_modified();
        if asked && !self.quitting && (self.disk.saving || is_modified) {
            context.send_viewport_cmd(egui::ViewportCommand::CancelClose);
            self.want(Intent::Quit, context);
        }
    }
}
