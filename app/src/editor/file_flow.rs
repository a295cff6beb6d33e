//! New, open, save, quit: what may need a question first, and a file name.
//!
//! What would lose changes is an [`Intent`]: it is carried out at once when nothing is unsaved, else after the user
//! has saved or said not to. A scene that can't be opened leaves the present document alone.

use super::files::{self, Ask, Reply, Waiting};
use super::{Editor, Session, ViewState, starter};
use crate::opening::{self, OpenError};
use crate::storage;
use cloudwright_core::formats::scene_file;
use std::path::{Path, PathBuf};

/// Something that leaves the present document.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Intent {
    New,
    Open,
    Quit,
}

impl Editor {
    /// The file's name, or the scene's.
    pub(super) fn display_name(&self) -> String {
        match self.session.path().and_then(Path::file_name) {
            Some(name) => name.to_string_lossy().into_owned(),
            None => self.session.scene().name.clone(),
        }
    }

    /// Carries `intent` out, after a question if there are unsaved changes.
    pub(super) fn want(&mut self, intent: Intent, context: &egui::Context) {
        if self.session.document().is_modified() {
            self.dialogs.unsaved = Some(intent);
        } else {
            self.go(intent, context);
        }
    }

    /// Carries `intent` out, whatever is lost.
    pub(super) fn go(&mut self, intent: Intent, context: &egui::Context) {
        match intent {
            Intent::New => {
                self.replace(Session::new(starter::scene(), None, None));
                self.notice = None;
            }
            Intent::Open => self.ask(Ask::Open, context),
            Intent::Quit => {
                self.quitting = true;
                context.send_viewport_cmd(egui::ViewportCommand::Close);
            }
        }
    }

    /// Opens the scene at `path` in place of the present one; if that can't be done, says why and changes nothing.
    pub fn open_path(&mut self, path: &Path) {
        let scene = match opening::open_scene(path) {
            Ok(scene) => scene,
            Err(OpenError::Problems { problems, .. }) => return self.dialogs.list(path, problems),
            Err(OpenError::Storage(error)) => return self.dialogs.fail("The scene can't be opened", &error),
        };
        let mut session = Session::new(scene, Some(path.into()), None);
        // A scene whose atlas is gone can still be edited; the built-in one stands in.
        if let Some(problem) = session.load_atlas() {
            self.dialogs.list(path, vec![problem]);
        }
        self.replace(session);
        self.tell(format!("Opened {}", path.display()));
    }

    fn replace(&mut self, session: Session) {
        self.viewport.see(&session);
        self.session = session;
        self.time_play.drop_hour();
        self.view = ViewState { tool: self.view.tool, snap: self.view.snap, ..ViewState::default() };
    }

    pub(super) fn save(&mut self, context: &egui::Context) {
        match self.session.path().map(PathBuf::from) {
            Some(path) => self.save_to(&path, context),
            None => self.save_as(context),
        }
    }

    pub(super) fn save_as(&mut self, context: &egui::Context) {
        let name = || PathBuf::from(format!("{}.{}", self.session.scene().name, scene_file::EXTENSION));
        let start = self.session.path().map_or_else(name, PathBuf::from);
        self.ask(Ask::Save(start), context);
    }

    /// Writes the scene to `path`, which becomes its file.
    pub fn save_to(&mut self, path: &Path, context: &egui::Context) {
        // Whatever fails below also ends what was to follow.
        let intent = self.after_save.take();
        if let Err(error) = self.session.commit() {
            return self.tell_error(error.to_string());
        }
        let text = match scene_file::write(self.session.scene()) {
            Ok(text) => text,
            Err(error) => return self.dialogs.fail("The scene can't be saved", &error),
        };
        if let Err(error) = storage::write_atomic(path, text.as_bytes()) {
            return self.dialogs.fail("The scene can't be saved", &error);
        }
        if let Some(problem) = self.session.saved_as(path.into()) {
            self.dialogs.list(path, vec![problem]);
        }
        self.tell(format!("Saved {}", path.display()));
        if let Some(intent) = intent {
            self.go(intent, context);
        }
    }

    /// Saves first, then carries `intent` out.
    pub(super) fn save_and_go(&mut self, intent: Intent, context: &egui::Context) {
        self.after_save = Some(intent);
        self.save(context);
    }

    fn ask(&mut self, ask: Ask, context: &egui::Context) {
        self.waiting = Some(Waiting::start(self.file_dialogs.as_mut(), ask, context));
        context.request_repaint();
    }

    pub(super) fn answer_file_dialogs(&mut self, context: &egui::Context) {
        let Some((ask, reply)) = self.waiting.as_ref().and_then(|w| Some((w.ask.clone(), w.answered()?))) else {
            return;
        };
        self.waiting = None;
        match reply {
            Reply::Path(path) => self.use_path(&ask, path, context),
            Reply::Cancelled => self.after_save = None,
            Reply::NoDialog => self.dialogs.ask_path(ask),
        }
    }

    pub(super) fn use_path(&mut self, ask: &Ask, path: PathBuf, context: &egui::Context) {
        match ask {
            Ask::Open => self.open_path(&path),
            Ask::Save(_) => self.save_to(&files::with_extension(path), context),
        }
    }

    /// The window's own button: closing waits until the question is answered.
    pub(super) fn answer_close_request(&mut self, context: &egui::Context) {
        let asked = context.input(|input| input.viewport().close_requested());
        if asked && !self.quitting && self.session.document().is_modified() {
            context.send_viewport_cmd(egui::ViewportCommand::CancelClose);
            self.dialogs.unsaved = Some(Intent::Quit);
        }
    }
}
