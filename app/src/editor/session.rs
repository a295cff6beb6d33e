//! The open document with all that hangs on it: derived clouds, atlas, file.
//!
//! Every change goes through here, so that what is derived follows at once. While a gesture holds the scene in a
//! state with errors (too many sprites, say), the clouds stay as they last were.

use crate::opening::{self, SceneAtlas};
use cloudwright_core::derived::Derived;
use cloudwright_core::document::{Change, Document, Edit, EditError};
use cloudwright_core::problem::{self, Problem, Severity};
use cloudwright_core::scene::{CloudId, Scene};
use cloudwright_core::sprites::PlacedCloud;
use cloudwright_core::version::Version;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A document, its file and what is computed from it.
#[derive(Debug)]
pub struct Session {
    document: Document,
    path: Option<PathBuf>,
    atlas: SceneAtlas,
    derived: Arc<Derived>,
    /// The scene as it is drawn: the worker draws from it while the document goes on.
    shown: Arc<Scene>,
    /// Changed, but not derived yet; or might have to be derived back.
    touched: Change,
    revision: Version,
}

impl Session {
    /// A scene that is as it was saved at `path`, or new.
    pub(crate) fn new(scene: Scene, path: Option<PathBuf>, atlas: SceneAtlas) -> Self {
        Self {
            derived: Arc::new(Derived::new(&scene)),
            shown: Arc::new(scene.clone()),
            document: Document::new(scene),
            path,
            atlas,
            touched: Change::default(),
            revision: Version::fresh(),
        }
    }

    /// The document, to read.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The scene, open gesture included.
    pub fn scene(&self) -> &Scene {
        self.document.scene()
    }

    /// What is computed from the scene.
    pub fn derived(&self) -> &Derived {
        &self.derived
    }

    /// A cloud's sprites, if its model is there.
    pub(crate) fn placed(&self, id: CloudId) -> Option<&PlacedCloud> {
        self.derived.clouds().iter().find(|cloud| cloud.id == id)
    }

    /// The file, if it has one.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Another one after each change that may show.
    pub(crate) fn revision(&self) -> Version {
        self.revision
    }

    /// Scene, clouds and atlas to draw from, shared.
    pub(crate) fn to_draw(&self) -> (Arc<Scene>, Arc<Derived>, SceneAtlas) {
        (Arc::clone(&self.shown), Arc::clone(&self.derived), self.atlas.clone())
    }

    /// One undo point from beginning to end.
    pub(crate) fn edit(&mut self, name: &str, edits: Vec<Edit>) -> Result<(), EditError> {
        self.commit()?;
        let change = self.document.edit(name, edits)?;
        self.follow(change);
        self.touched = Change::default();
        Ok(())
    }

    /// A step of a gesture that [`Session::commit`] or [`Session::cancel`] ends.
    pub(crate) fn drag(&mut self, name: &str, edits: Vec<Edit>) -> Result<(), EditError> {
        self.document.begin(name);
        let mut change = Change::default();
        let done = edits.into_iter().try_for_each(|edit| {
            change.join(self.document.apply(edit)?);
            Ok(())
        });
        self.follow(change);
        done
    }

    /// Ends a gesture as one undo point. What is refused is taken back.
    pub(crate) fn commit(&mut self) -> Result<(), EditError> {
        let done = self.document.commit();
        if done.is_err() {
            self.follow(Change::default());
        }
        self.touched = Change::default();
        done
    }

    /// Takes a gesture back.
    pub(crate) fn cancel(&mut self) {
        let change = self.document.cancel();
        self.follow(change);
        self.touched = Change::default();
    }

    pub(crate) fn undo(&mut self) {
        if let Some(change) = self.document.undo() {
            self.follow(change);
            self.touched = Change::default();
        }
    }

    pub(crate) fn redo(&mut self) {
        if let Some(change) = self.document.redo() {
            self.follow(change);
            self.touched = Change::default();
        }
    }

    /// Undoes or redoes until `count` points are done.
    pub(crate) fn jump_to(&mut self, count: usize) {
        if let Some(change) = self.document.jump_to(count) {
            self.follow(change);
            self.touched = Change::default();
        }
    }

    /// The scene lies at `path` as it is. Its atlas is looked for there.
    pub(crate) fn saved_as(&mut self, path: PathBuf) -> Option<Problem> {
        self.document.mark_saved();
        let moved = self.path.as_deref() != Some(&path);
        self.path = Some(path);
        if moved { self.load_atlas() } else { None }
    }

    /// Reads the atlas that the scene names; the built-in one stands in for one with a problem.
    pub(crate) fn load_atlas(&mut self) -> Option<Problem> {
        let found = opening::atlas_of(self.scene(), self.path());
        self.revision = Version::fresh();
        match found {
            Ok(atlas) => {
                self.atlas = atlas;
                None
            }
            Err(problem) => {
                self.atlas = None;
                Some(problem)
            }
        }
    }

    fn follow(&mut self, change: Change) {
        if change.touches_atlas() {
            self.load_atlas();
        }
        self.touched.join(change);
        if problem::check(self.document.scene()).iter().any(|problem| problem.severity == Severity::Error) {
            return;
        }
        Arc::make_mut(&mut self.derived).update(self.document.scene(), &self.touched);
        self.shown = Arc::new(self.document.scene().clone());
        self.revision = Version::fresh();
    }
}
