//! The open document with all that hangs on it: derived clouds, the file and what lies beside it.
//!
//! Every change goes through here, so that what is derived follows: at once if that is little work, else off the frame
//! by [`Regeneration`], while the last good clouds are shown. While a gesture holds the scene in a state with errors
//! (too many sprites, say), the clouds stay as they last were.
//!
//! `stale` is whatever may differ between the scene and what is derived. It grows with every change, and is emptied
//! only when the clouds are those of the scene as it is; so nothing is lost, whatever happens on the way.

use super::baking::Baking;
use super::regeneration::{Regeneration, Request};
use crate::opening::{Beside, Elsewhere};
use cloudwright_core::derived::Derived;
use cloudwright_core::document::{Change, Document, Edit, EditError, ListEdit, Past, SavedMark};
use cloudwright_core::problem::{self, Problem};
use cloudwright_core::scene::{CloudId, Scene, Track};
use cloudwright_core::sprites::PlacedCloud;
use cloudwright_core::version::Version;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// A scene that strews no more than this is opened with its clouds: they come in a blink.
const AT_ONCE_WHEN_OPENED: u64 = 100_000;

/// A document, its file and what is computed from it.
#[derive(Debug)]
pub struct Session {
    document: Document,
    path: Option<PathBuf>,
    beside: Beside,
    /// Where models lie that were pasted and are not beside the file.
    elsewhere: Elsewhere,
    derived: Arc<Derived>,
    /// The scene as it is drawn, and last was without errors: workers read it while the document goes on.
    shown: Arc<Scene>,
    /// The same with all of its tracks.
    whole: Arc<Scene>,
    /// The addresses of what is shown as the scene has it and not its track: a hand has changed it since it was keyed.
    muted: BTreeSet<String>,
    /// Whether `shown` is the document's scene.
    is_sound: bool,
    stale: Change,
    /// How far the history has moved since the clouds were last those of the scene; back counts as negative.
    steps: isize,
    /// Whether the open gesture changes values, which the history then tells.
    tells: bool,
    regeneration: Regeneration,
    baking: Baking,
    revision: Version,
}

/// Work that the clouds wait for.
#[derive(Debug, Clone, PartialEq)]
pub struct Pending {
    /// When it was first asked for.
    pub since: Instant,
    /// 0 to 1.
    pub done: f32,
    /// What it does, for people.
    pub what: String,
    /// Whether there is a change to take back.
    pub can_cancel: bool,
}

impl Session {
    /// A scene that is as it was saved at `path`, or new.
    pub(crate) fn new(scene: Scene, path: Option<PathBuf>) -> Self {
        Self::of(Document::new(scene), path)
    }

    /// A scene that was not saved, with what can be undone of it; its file, if it has one, lies at `path`.
    pub(crate) fn resume(scene: Scene, path: Option<PathBuf>, past: &Past) -> Self {
        Self::of(Document::resume(scene, past), path)
    }

    fn of(document: Document, path: Option<PathBuf>) -> Self {
        let scene = document.scene();
        let mut session = Self {
            derived: Arc::new(Derived::default()),
            shown: Arc::new(scene.clone()),
            whole: Arc::new(scene.clone()),
            muted: BTreeSet::new(),
            is_sound: true,
            document,
            path,
            beside: Beside::default(),
            elsewhere: Elsewhere::new(),
            stale: Change::everything(),
            steps: 0,
            tells: false,
            regeneration: Regeneration::default(),
            baking: Baking::default(),
            revision: Version::fresh(),
        };
        session.catch_up(AT_ONCE_WHEN_OPENED);
        session
    }

    /// The document, to read.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// From now on, what can be undone takes about so many megabytes at most; 0 for no bound.
    pub(crate) fn keep_past_within(&mut self, megabytes: u32) {
        let most = if megabytes == 0 { u64::MAX } else { u64::from(megabytes) << 20 };
        self.document.keep_past_within(most);
    }

    /// The scene, open gesture included.
    pub fn scene(&self) -> &Scene {
        self.document.scene()
    }

    /// What is computed from the scene; as it last was while anything is [pending](Self::pending).
    pub fn derived(&self) -> &Derived {
        &self.derived
    }

    /// A cloud's sprites, if its model is there.
    pub(crate) fn placed(&self, id: CloudId) -> Option<&PlacedCloud> {
        self.derived.cloud(id)
    }

    /// Work off the frame that the clouds wait for.
    pub fn pending(&self) -> Option<Pending> {
        let (since, done) = self.regeneration.pending()?;
        let mut touched = self.scene().models.iter().filter(|model| self.stale.touches_model(model.id));
        let what = match (touched.next(), touched.next()) {
            (Some(model), None) => format!("Regenerating {}", model.name),
            _ => "Regenerating clouds".into(),
        };
        Some(Pending { since, done, what, can_cancel: self.steps != 0 || self.document.is_open() })
    }

    /// The file, if it has one.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Another one after each change that may show.
    pub(crate) fn revision(&self) -> Version {
        self.revision
    }

    /// What lies beside the scene's file.
    pub(crate) fn beside(&self) -> &Beside {
        &self.beside
    }

    /// Where pasted models lie until the scene is saved, which copies them.
    pub(crate) fn elsewhere(&self) -> &Elsewhere {
        &self.elsewhere
    }

    /// Models that are pasted lie there.
    pub(crate) fn expect_elsewhere(&mut self, models: Elsewhere) {
        self.elsewhere.extend(models);
    }

    /// Scene, clouds and what lies beside them to draw from, shared.
    pub(crate) fn to_draw(&self) -> (Arc<Scene>, Arc<Derived>, Beside) {
        (Arc::clone(&self.shown), Arc::clone(&self.derived), self.beside.clone())
    }

    /// The scene as the last undo point left it, shared; none while a gesture is open.
    pub(crate) fn settled(&self) -> Option<Arc<Scene>> {
        (self.is_sound && !self.document.is_open()).then(|| Arc::clone(&self.whole))
    }

    /// One undo point from beginning to end.
    pub(crate) fn edit(&mut self, name: &str, edits: Vec<Edit>) -> Result<(), EditError> {
        self.commit()?;
        let change = self.document.edit(name, edits)?;
        self.follow(change);
        self.count_point();
        Ok(())
    }

    /// A step of a gesture that [`Session::commit`] or [`Session::cancel`] ends.
    pub(crate) fn drag(&mut self, name: &str, edits: Vec<Edit>) -> Result<(), EditError> {
        self.tells &= self.document.is_open();
        self.document.begin(name);
        let mut change = Change::default();
        let done = edits.into_iter().try_for_each(|edit| {
            change.join(self.document.apply(edit)?);
            Ok(())
        });
        self.follow(change);
        done
    }

    /// The same of values: the history tells what became of them, if it is one, instead of the name.
    pub(crate) fn drag_values(&mut self, name: &str, edits: Vec<Edit>) -> Result<(), EditError> {
        let begins = !self.document.is_open();
        let done = self.drag(name, edits);
        self.tells |= begins;
        done
    }

    /// From now on, tracks of properties with those addresses don't show; the document stays.
    pub(crate) fn mute(&mut self, properties: BTreeSet<String>) {
        if properties == self.muted {
            return;
        }
        let other = |track: &&Track| properties.contains(&track.property) != self.muted.contains(&track.property);
        let mut change = Change::default();
        for track in self.scene().tracks.iter().filter(other) {
            change.join(Edit::Track(ListEdit::Replace(track.clone())).change());
        }
        self.muted = properties;
        self.follow(change);
    }

    /// Ends a gesture as one undo point. What is refused is taken back.
    pub(crate) fn commit(&mut self) -> Result<(), EditError> {
        let was_open = self.document.is_open();
        let tells = std::mem::take(&mut self.tells);
        let done = if tells { self.document.commit_told() } else { self.document.commit() };
        match &done {
            Err(EditError::Problems { taken_back, .. }) => self.follow(taken_back.clone()),
            Err(_) => {}
            Ok(()) if was_open => self.count_point(),
            Ok(()) => {}
        }
        done
    }

    /// Takes a gesture back.
    pub(crate) fn cancel(&mut self) {
        if self.document.is_open() {
            let change = self.document.cancel();
            self.follow(change);
        }
    }

    /// One point back, or the open gesture. False if there is none.
    pub(crate) fn undo(&mut self) -> bool {
        let was_open = self.document.is_open();
        let Some(change) = self.document.undo() else { return false };
        self.follow(change);
        if !was_open && self.is_behind() {
            self.steps -= 1;
        }
        true
    }

    /// One point forward. False if there is none.
    pub(crate) fn redo(&mut self) -> bool {
        let Some(change) = self.document.redo() else { return false };
        self.follow(change);
        if self.is_behind() {
            self.steps += 1;
        }
        true
    }

    /// Takes back what asked for the pending work: the open gesture, and the steps through the history since the
    /// clouds were last whole. Undo and redo lead there again. A scene that was opened so has nothing to take back.
    pub(crate) fn cancel_pending(&mut self) {
        if self.regeneration.pending().is_some() {
            self.cancel();
        }
        while self.regeneration.pending().is_some() {
            let moved = match self.steps.signum() {
                1 => self.undo(),
                -1 => self.redo(),
                _ => false,
            };
            if !moved {
                break;
            }
        }
    }

    /// Once a frame: takes up what was computed meanwhile, and sees that what is wanted gets done.
    pub(crate) fn keep_up(&mut self, context: &egui::Context) {
        if let Some(derived) = self.regeneration.answer() {
            self.derived = Arc::new(derived);
            self.revision = Version::fresh();
            self.catch_up(0);
            context.request_repaint();
        }
        let Self { regeneration, shown, derived, stale, .. } = self;
        let request = || Request { scene: Arc::clone(shown), before: Arc::clone(derived), change: stale.clone() };
        regeneration.keep_up(request, context);
        if self.baking.keep_up(&self.derived, context) {
            self.revision = Version::fresh();
            context.request_repaint();
        }
    }

    /// Undoes or redoes until `count` points are done.
    pub(crate) fn jump_to(&mut self, count: usize) {
        let before = self.document.history().done_count();
        let Some(change) = self.document.jump_to(count) else { return };
        self.follow(change);
        if self.is_behind() {
            self.steps += self.document.history().done_count() as isize - before as isize;
        }
    }

    /// The scene lies at `path` as it was at `mark`. What it names is looked for there.
    pub(crate) fn saved_as(&mut self, path: PathBuf, mark: SavedMark) -> Vec<Problem> {
        self.document.mark_saved(mark);
        let moved = self.path.as_deref() != Some(&path);
        self.path = Some(path);
        if moved { self.load_beside() } else { Vec::new() }
    }

    /// No file holds the scene as it is.
    pub(crate) fn mark_unsaved(&mut self) {
        self.document.mark_unsaved();
    }

    /// Reads the files that the scene names; what is built in stands in for one with a problem.
    pub(crate) fn load_beside(&mut self) -> Vec<Problem> {
        let (beside, problems) = Beside::read_with(self.scene(), self.path(), &self.elsewhere);
        self.beside = beside;
        self.revision = Version::fresh();
        problems
    }

    fn follow(&mut self, change: Change) {
        if !self.beside.is_of(self.scene()) {
            self.load_beside();
        }
        let touches_derived = change.touches_derived();
        // What was wrong before may lie anywhere.
        let touched = if self.is_sound { &change } else { &Change::everything() };
        self.is_sound = problem::stays_sound(self.scene(), touched);
        self.stale.join(change);
        if !self.is_sound {
            return;
        }
        self.whole = Arc::new(self.scene().clone());
        self.shown = Arc::clone(&self.whole);
        if !self.muted.is_empty() {
            Arc::make_mut(&mut self.shown).tracks.retain(|track| !self.muted.contains(&track.property));
        }
        self.revision = Version::fresh();
        // Light and cameras don't overtake the work on sprites.
        if touches_derived || self.regeneration.pending().is_none() {
            self.catch_up(0);
        }
    }

    /// Derives what is stale at once, if it is little or strews no more than `at_once` sprites; else has it done.
    fn catch_up(&mut self, at_once: u64) {
        if !self.is_behind() {
            return;
        }
        let plan = self.derived.plan(&self.shown, &self.stale);
        if !plan.is_little() && plan.sprites() > at_once {
            return self.regeneration.want();
        }
        if let Some(derived) = plan.place(&cloudwright_core::watch::Watch::default()) {
            self.derived = Arc::new(derived);
        }
        self.regeneration.abandon();
        if self.is_sound {
            self.stale = Change::default();
            self.steps = 0;
        }
    }

    fn is_behind(&self) -> bool {
        self.stale.touches_derived()
    }

    /// A new point ends what could be redone.
    fn count_point(&mut self) {
        if self.is_behind() {
            self.steps = self.steps.max(0) + 1;
        }
    }
}

#[cfg(test)]
mod tests;
