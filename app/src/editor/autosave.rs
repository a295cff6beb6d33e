//! Unsaved work is kept for the case of a crash, and offered at the next start.
//!
//! While the document is modified, it is written to the editor's recovery slot a few seconds after the last change,
//! and every half minute while changes don't stop; never within a gesture. A save, or an end on purpose, clears it.

use super::Editor;
use super::dialogs::Dialog;
use super::done::Done;
use crate::opening::problem_lines;
use crate::state::Session;
use crate::storage::{self, Folders, Orphan, Rescue, Stamp};
use cloudwright_core::formats::scene_file;
use cloudwright_core::problem::Problem;
use cloudwright_core::version::Version;
use std::path::PathBuf;
use std::time::Duration;

/// After the last change.
const REST_S: f64 = 3.0;
/// While changes don't stop.
const AT_LATEST_S: f64 = 30.0;

/// When to write next. Times are the window's, seconds.
#[derive(Debug, Default)]
pub(super) struct AutosaveClock {
    /// The newest state, and since when it is there.
    newest: Option<(Version, f64)>,
    written: Option<Version>,
    /// Since when there is something that is not written.
    unwritten_since_s: Option<f64>,
}

impl AutosaveClock {
    /// In how long the state `version` should be written; none if it is.
    fn due_in_s(&mut self, version: Version, now_s: f64) -> Option<f64> {
        if self.written == Some(version) {
            return None;
        }
        let since_s = *self.unwritten_since_s.get_or_insert(now_s);
        let changed_s = match self.newest {
            Some((newest, changed_s)) if newest == version => changed_s,
            _ => now_s,
        };
        self.newest = Some((version, changed_s));
        Some(((changed_s + REST_S).min(since_s + AT_LATEST_S) - now_s).max(0.0))
    }

    fn wrote(&mut self, version: Version) {
        self.written = Some(version);
        self.unwritten_since_s = None;
    }
}

impl Editor {
    /// Keeps what is unsaved when it is time, and wakes the window for it.
    pub(super) fn autosave(&mut self, context: &egui::Context) {
        let Some(folders) = self.desk.folders().cloned() else { return };
        let document = self.session.document();
        if !document.is_modified() {
            self.drop_rescue();
            return;
        }
        if document.is_open() {
            return;
        }
        let version = self.session.revision();
        let now_s = context.input(|input| input.time);
        match self.desk.autosave_clock.due_in_s(version, now_s) {
            None => {}
            Some(wait_s) if wait_s > 0.0 => context.request_repaint_after(Duration::from_secs_f64(wait_s)),
            Some(_) => {
                self.desk.autosave_clock.wrote(version);
                self.keep_rescue(&folders);
            }
        }
    }

    fn keep_rescue(&mut self, folders: &Folders) {
        let file = match self.desk.slot(folders) {
            Ok(slot) => slot.file().to_path_buf(),
            Err(error) => return self.tell_error(format!("The work can't be kept for a crash: {error}")),
        };
        let (scene, path) = (self.session.scene().clone(), self.session.path().map(PathBuf::from));
        self.desk.clerk.ask(move || {
            // Numbers that JSON can't say are refused by every edit.
            let Ok(text) = scene_file::write(&scene) else { return Done::Rescued(Ok(())) };
            Done::Rescued(Rescue::new(path.as_deref(), text).write(&file))
        });
    }

    /// Nothing is unsaved any more.
    pub(super) fn drop_rescue(&mut self) {
        self.desk.autosave_clock = AutosaveClock::default();
        if let Some(slot) = self.desk.slot.take() {
            // After the rescues that may still be written.
            self.desk.clerk.ask(move || {
                slot.clear();
                Done::Rescued(Ok(()))
            });
        }
    }

    /// Offers what other editors left when they ended without saving.
    pub(super) fn offer_recovery(&mut self) {
        let orphans = self.desk.folders().map(storage::orphans).unwrap_or_default();
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
        let known = path.as_deref().and_then(Stamp::of).filter(|stamp| !stamp.is_after(rescue.saved_at()));
        let mut session = Session::new(scene, path);
        session.mark_unsaved();
        let problems = session.load_beside();
        // One of this editor's own goes; the work is where it always was.
        self.drop_rescue();
        self.desk.slot = Some(orphan.slot);
        self.replace(session, known);
        self.desk.autosave_clock.wrote(self.session.revision());
        self.dialogs.list(&name, problems);
        self.tell(format!("Recovered {}; it is not saved yet", self.display_name()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn writes_after_a_rest_and_at_the_latest_after_half_a_minute() {
        let mut clock = AutosaveClock::default();
        let first = Version::fresh();
        assert_eq!(clock.due_in_s(first, 10.0), Some(3.0));
        assert_eq!(clock.due_in_s(first, 12.0), Some(1.0));
        let second = Version::fresh();
        assert_eq!(clock.due_in_s(second, 12.0), Some(3.0), "it changed again");
        assert_eq!(clock.due_in_s(second, 15.0), Some(0.0));
        clock.wrote(second);
        assert_eq!(clock.due_in_s(second, 99.0), None);
        let waits: Vec<_> = (0..=30).map(|s| clock.due_in_s(Version::fresh(), 100.0 + f64::from(s))).collect();
        assert_eq!((waits[0], waits[28], waits[30]), (Some(3.0), Some(2.0), Some(0.0)));
    }
}
