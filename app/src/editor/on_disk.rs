//! The document's file, changed by another program.
//!
//! It is watched while the window has the focus. An unmodified document follows; a modified one is asked about.

use super::Editor;
use super::dialogs::Dialog;
use crate::opening::{self, OpenError};
use crate::state::Session;
use crate::storage::{Sighting, Stamp};
use std::path::{Path, PathBuf};

impl Editor {
    /// Looks after the file, and after what was seen of it.
    pub(super) fn watch_file(&mut self, context: &egui::Context) {
        let focused = context.input(|input| input.focused);
        let Some(watcher) = &self.disk.watcher else { return };
        // While it is being saved here, what is there changes on purpose.
        let watched = self.session.path().filter(|_| focused && !self.disk.saving);
        watcher.watch(watched.map(|path| (path, self.disk.known.as_ref())));
        if let Some(Sighting { path, stamp }) = watcher.news()
            && watched == Some(&path)
        {
            self.changed_on_disk(&path, stamp);
        }
    }

    fn changed_on_disk(&mut self, path: &Path, stamp: Option<Stamp>) {
        self.disk.known = stamp;
        if stamp.is_none() {
            self.session.mark_unsaved();
            self.tell_error(format!("{} is gone; save to write it again", path.display()));
        } else if self.session.document().is_modified() {
            self.dialogs.open(Dialog::ChangedOnDisk);
        } else {
            self.load_theirs();
        }
    }

    /// Reads the document's file again, and goes on looking as before. One that can't be read leaves the document.
    pub(super) fn load_theirs(&mut self) {
        let Some(path) = self.session.path().map(PathBuf::from) else { return };
        let stamp = Stamp::of(&path);
        match opening::open_scene(&path) {
            Ok(scene) => {
                let mut session = Session::new(scene, Some(path.clone()));
                let problems = session.load_beside();
                self.session = session;
                self.leave_runs();
                self.disk.known = stamp;
                self.view.keep_what_is_in(self.session.scene());
                self.tell(format!("{} was changed by another program and is loaded anew", self.display_name()));
                self.dialogs.list(&path, problems);
            }
            Err(error) => {
                self.session.mark_unsaved();
                match error {
                    OpenError::Problems { problems, .. } => self.dialogs.list(&path, problems),
                    OpenError::Storage(error) => self.dialogs.fail("The changed file can't be read", &error),
                }
            }
        }
    }
}
