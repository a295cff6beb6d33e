//! Unsaved work is kept for the case of a crash, and offered at the next start.
//!
//! As soon as the document is modified, and with each undo point from then on (or, if the user prefers, only after some
//! seconds), the scene goes to the thread that keeps
//! it in the editor's recovery slot ([`RescueWriter`]). What a gesture does is kept when the
//! gesture ends. A save, or an end on purpose, clears the slot.

use super::Editor;
use super::dialogs::Dialog;
use super::done::unkept;
use crate::opening::problem_lines;
use crate::state::Session;
use crate::storage::{self, Orphan, RescueWriter, Unsaved};
use cloudwright_core::document::Past;
use cloudwright_core::formats::scene_file;
use cloudwright_core::problem::Problem;
use std::path::PathBuf;
use std::time::{Duration, Instant};

impl Editor {
    /// Has what is unsaved kept, if it is not what was asked for last.
    pub(super) fn autosave(&mut self, context: &egui::Context) {
        let Some(writer) = &self.disk.rescue_writer else { return };
        if !self.session.document().is_modified() {
            return self.drop_rescue();
        }
        let Some(scene) = self.session.settled() else { return };
        let (path, known) = (self.session.path(), self.disk.known);
        if self.disk.kept.as_ref().is_some_and(|kept| kept.is_of(&scene, path, known)) {
            return;
        }
        let pause = Duration::from_secs(self.disk.settings().keep_work_every_s().into());
        let rest = self.disk.kept_at.map_or(Duration::ZERO, |at| pause.saturating_sub(at.elapsed()));
        if !rest.is_zero() {
            return context.request_repaint_after(rest);
        }
        self.disk.kept_at = Some(Instant::now());
        let (path, past) = (path.map(PathBuf::from), self.session.document().past());
        let unsaved = Unsaved { scene, path, known, past };
        writer.keep(unsaved.clone());
        self.disk.kept = Some(unsaved);
    }

    /// What must be done last in a program that is told to end, lest work be lost; none if nothing is kept at all.
    pub(super) fn last_call(&self) -> Option<impl Fn() + Send + use<>> {
        self.disk.rescue_writer.as_ref().map(RescueWriter::last_call)
    }

    /// Nothing is unsaved any more.
    pub(super) fn drop_rescue(&mut self) {
        self.disk.kept_at = None;
        if let (Some(_), Some(writer)) = (self.disk.kept.take(), &self.disk.rescue_writer) {
            writer.clear();
        }
    }

    /// Says that the work can't be kept, and when it can again.
    pub(super) fn tell_whether_work_is_kept(&mut self) {
        while let Some(kept) = self.disk.rescue_writer.as_ref().and_then(|writer| writer.news()) {
            match kept {
                Ok(()) => {
                    self.toasts.forget_errors();
                    self.tell("Unsaved work is kept again");
                }
                Err(error) => self.tell_error(unkept(&error.to_string())),
            }
        }
    }

    /// Offers what other editors left when they ended without saving.
    pub(super) fn offer_recovery(&mut self) {
        let orphans = self.disk.folders().map(storage::orphans).unwrap_or_default();
        if !orphans.is_empty() {
            self.dialogs.open(Dialog::Recovery(orphans));
        }
    }

    /// Goes on with what another editor left, in its slot: until it is saved here, it stays there.
    pub(super) fn recover(&mut self, orphan: Orphan) {
        let name = orphan.slot.file().to_path_buf();
        let place = |message: String| Problem::error("recovery", message, "the file is kept; look into it by hand");
        let rescue = match orphan.rescue {
            Ok(rescue) => rescue,
            Err(why) => return self.dialogs.list(&name, vec![place(why)]),
        };
        let scene = match scene_file::read(rescue.scene.as_bytes()) {
            Ok(scene) => scene,
            Err(problems) => return self.dialogs.list(&name, vec![place(problem_lines(&name, &problems).join("\n"))]),
        };
        let path = rescue.path.clone();
        let mut session = Session::resume(scene, path, &Past::read(&rescue.past));
        let problems = session.load_beside();
        // One of this editor's own goes; the work is where it always was.
        if let Some(writer) = &self.disk.rescue_writer {
            writer.take_over(orphan.slot);
        }
        self.replace(session, rescue.known);
        self.dialogs.list(&name, problems);
        self.tell(format!("Recovered {}; it is not saved yet", self.display_name()));
    }
}
