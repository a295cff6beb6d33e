//! How a scene changes: edits in transactions, and the way back.
//!
//! A [`Document`] owns a scene and hands it out to read only. Each [`Edit`] is a named value whose application yields
//! its inverse; a transaction collects inverses and becomes one undo point, or nothing. A drag is one transaction that
//! stays open over many frames. What a transaction touched is told by its [`Change`].

mod change;
mod edit;
mod history;
mod transaction;

pub use change::Change;
pub use edit::{Edit, ListEdit};
pub use history::History;

use crate::problem::{self, Problem, Severity};
use crate::scene::Scene;
use transaction::{Transaction, UndoPoint};

/// An open scene with its history.
#[derive(Debug, Clone, Default)]
pub struct Document {
    scene: Scene,
    /// Points that can be undone, oldest first.
    done: Vec<UndoPoint>,
    /// Points that can be redone, next one last.
    undone: Vec<UndoPoint>,
    open: Option<Transaction>,
    /// How many points were done when the scene was last saved; none if that state is out of reach.
    saved_at: Option<usize>,
}

/// Why a scene was not changed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EditError {
    /// The thing to change is not in the scene.
    #[error("there is no {kind} {id} in the scene")]
    NotFound {
        /// "cloud", "model", …
        kind: &'static str,
        /// Its id.
        id: String,
    },
    /// The thing to add has the id of one that is there.
    #[error("there is a {kind} {id} in the scene already")]
    Taken {
        /// "cloud", "model", …
        kind: &'static str,
        /// Its id.
        id: String,
    },
    /// The transaction would have left the scene with faults that it did not have before.
    #[error("{}", .0.iter().map(Problem::to_string).collect::<Vec<_>>().join("; "))]
    Problems(Vec<Problem>),
}

impl Document {
    /// Opens a scene that is as it was saved.
    pub fn new(scene: Scene) -> Self {
        Self { scene, saved_at: Some(0), ..Self::default() }
    }

    /// The scene as it is now, open transaction included.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Opens a transaction under the name that the history will show, or goes on with the one that is open.
    pub fn begin(&mut self, name: &str) {
        self.open.get_or_insert_with(|| Transaction::new(name.into()));
    }

    /// Whether a transaction is open.
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Applies `edit` within the open transaction (one is opened if there is none).
    ///
    /// # Errors
    /// If the edit names something that the scene does not have; the scene is then as before.
    pub fn apply(&mut self, edit: Edit) -> Result<Change, EditError> {
        let change = edit.change();
        let inverse = edit.apply(&mut self.scene)?;
        self.open.get_or_insert_with(|| Transaction::new(inverse.name())).push(inverse);
        Ok(change)
    }

    /// Closes the open transaction as one undo point. One that changed nothing leaves no point.
    ///
    /// # Errors
    /// If it left faults in the scene that were not there before; it is then taken back.
    pub fn commit(&mut self) -> Result<(), EditError> {
        let Some(point) = self.open.take().map(Transaction::into_point) else { return Ok(()) };
        let mut before = self.scene.clone();
        let _ = point.reverse(&mut before);
        if before == self.scene {
            return Ok(());
        }
        let old = problem::check(&before);
        let mut new = problem::check(&self.scene);
        new.retain(|p| p.severity == Severity::Error && !old.contains(p));
        if !new.is_empty() {
            self.scene = before;
            return Err(EditError::Problems(new));
        }
        if self.saved_at.is_some_and(|saved| saved > self.done.len()) {
            self.saved_at = None;
        }
        self.done.push(point);
        self.undone.clear();
        Ok(())
    }

    /// Takes the open transaction back. The change says what to recompute.
    pub fn cancel(&mut self) -> Change {
        match self.open.take() {
            Some(open) => open.into_point().reverse(&mut self.scene).1,
            None => Change::default(),
        }
    }

    /// One transaction from beginning to end: `edits` is handed the document to read, and all of what it returns is
    /// applied, or nothing.
    ///
    /// # Errors
    /// As [`Document::apply`] and [`Document::commit`].
    pub fn edit(&mut self, name: &str, edits: impl IntoIterator<Item = Edit>) -> Result<Change, EditError> {
        self.commit()?;
        self.begin(name);
        let mut change = Change::default();
        for edit in edits {
            match self.apply(edit) {
                Ok(touched) => change.join(touched),
                Err(error) => {
                    self.cancel();
                    return Err(error);
                }
            }
        }
        self.commit()?;
        Ok(change)
    }

    /// Goes one point back; none if there is none. An open transaction is taken back instead.
    pub fn undo(&mut self) -> Option<Change> {
        if self.open.is_some() {
            return Some(self.cancel());
        }
        let point = self.done.pop()?;
        let (forward, change) = point.reverse(&mut self.scene);
        self.undone.push(forward);
        Some(change)
    }

    /// Goes one undone point forward; none if there is none.
    pub fn redo(&mut self) -> Option<Change> {
        if self.open.is_some() {
            return None;
        }
        let point = self.undone.pop()?;
        let (backward, change) = point.reverse(&mut self.scene);
        self.done.push(backward);
        Some(change)
    }

    /// What undo would take back, by name.
    pub fn undo_name(&self) -> Option<&str> {
        self.done.last().map(|point| point.name.as_str())
    }

    /// What redo would bring again, by name.
    pub fn redo_name(&self) -> Option<&str> {
        self.undone.last().map(|point| point.name.as_str())
    }

    /// Says that the scene is saved as it is now. With a transaction open, what was saved is no point of the history.
    pub fn mark_saved(&mut self) {
        self.saved_at = self.open.is_none().then_some(self.done.len());
    }

    /// Whether the scene differs from what was last saved.
    pub fn is_modified(&self) -> bool {
        self.open.is_some() || self.saved_at != Some(self.done.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Category, CloudModel, IdCounter, ModelId};

    fn add_model(document: &Document) -> [Edit; 2] {
        let mut counter = document.scene().next_id;
        let model = CloudModel::new(ModelId::new(&mut counter), "new", Category::Stratus);
        [Edit::NextId(counter), Edit::Model(ListEdit::Insert { at: 0, value: model })]
    }

    #[test]
    fn undo_brings_back_the_id_counter_too() {
        let mut document = Document::new(Scene::default());
        let start = document.scene().clone();
        document.edit("Add model", add_model(&document)).expect("it fits");
        let after = document.scene().clone();
        assert!(document.is_modified() && after.models.len() == 1);
        document.undo();
        assert_eq!(*document.scene(), start);
        assert!(!document.is_modified());
        document.redo();
        assert_eq!(*document.scene(), after);
    }

    #[test]
    fn a_drag_is_one_step_and_can_be_dropped() {
        let mut document = Document::new(Scene::default());
        let start = document.scene().clone();
        for hour in [13.0, 14.0, 15.0] {
            document.apply(Edit::TimeOfDay(hour)).expect("a time");
        }
        document.cancel();
        assert_eq!(*document.scene(), start);
        for hour in [13.0, 14.0, 15.0] {
            document.apply(Edit::TimeOfDay(hour)).expect("a time");
        }
        document.commit().expect("in range");
        assert_eq!(document.scene().time_of_day_h, 15.0);
        document.undo();
        assert_eq!(*document.scene(), start);
        assert!(document.undo().is_none());
    }

    #[test]
    fn a_fault_takes_the_whole_transaction_back() {
        let mut document = Document::new(Scene::default());
        let start = document.scene().clone();
        let error = document.edit("Bad", [Edit::Name("x".into()), Edit::TimeOfDay(f64::NAN)]);
        assert!(matches!(error, Err(EditError::Problems(_))), "{error:?}");
        assert_eq!(*document.scene(), start);
        let taken = document.scene().cameras[0].clone();
        let error = document.edit("Bad", [Edit::Camera(ListEdit::Insert { at: 0, value: taken })]);
        assert!(matches!(error, Err(EditError::Taken { .. })), "{error:?}");
        assert_eq!(*document.scene(), start);
        let gone = ModelId::new(&mut IdCounter(99));
        let error = document.edit("Bad", [Edit::Name("x".into()), Edit::Model(ListEdit::Remove(gone))]);
        assert!(matches!(error, Err(EditError::NotFound { .. })), "{error:?}");
        assert_eq!(*document.scene(), start);
    }

    #[test]
    fn saved_and_then_undone_is_modified() {
        let mut document = Document::new(Scene::default());
        document.edit("Rename", [Edit::Name("a".into())]).expect("fits");
        document.mark_saved();
        assert!(!document.is_modified());
        document.undo();
        assert!(document.is_modified());
        document.edit("Rename", [Edit::Name("b".into())]).expect("fits");
        assert!(document.is_modified(), "the saved state is out of reach now");
        document.undo();
        document.redo();
        assert!(document.is_modified());
    }
}
