//! How a scene changes: edits in transactions, and the way back.
//!
//! A [`Document`] owns a scene and hands it out to read only. Each [`Edit`] is a named value whose application yields
//! its inverse; a transaction collects inverses and becomes one undo point, or nothing. A drag is one transaction that
//! stays open over many frames. What a transaction touched is told by its [`Change`].

mod budget;
mod edit;
mod history;
mod past;
mod set;
mod told;
mod transaction;

pub use edit::{Edit, ListEdit};
pub use history::History;
pub use past::Past;
pub use set::{ForEditable, for_each_editable};

pub use crate::change::Change;

use crate::problem::{self, Problem, Severity};
use crate::property::{Address, Refusal};
use crate::scene::Scene;
use std::sync::Arc;
use transaction::{Transaction, UndoPoint};

/// An open scene with its history.
#[derive(Debug, Clone, Default)]
pub struct Document {
    scene: Scene,
    /// Points that can be undone, oldest first.
    done: Vec<Arc<UndoPoint>>,
    /// Points that can be redone, next one last.
    undone: Vec<Arc<UndoPoint>>,
    open: Option<Transaction>,
    /// The state that was last saved; none if that is no state of the history.
    saved_at: Option<SavedMark>,
    /// How many points were ever made.
    made_count: u64,
    /// The state before the oldest point: others may have been forgotten.
    begun_at: SavedMark,
    /// Of memory for what can be undone; none for as much as there is.
    most_bytes: Option<u64>,
}

/// A state of the scene in its history: after which undo point, counted through all that were ever made; 0 at the
/// start. A mark is taken when saving begins and handed back when the file is whole, whatever was edited meanwhile.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct SavedMark(u64);

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
    /// A property can't be set so.
    #[error("{address}: {refusal}")]
    Refused {
        /// Which.
        address: Address,
        /// Why.
        refusal: Refusal,
    },
    /// The transaction would have left the scene with faults that it did not have before.
    #[error("{}", .problems.iter().map(Problem::to_string).collect::<Vec<_>>().join("; "))]
    Problems {
        /// The faults.
        problems: Vec<Problem>,
        /// What the transaction had touched, for whoever followed it step by step.
        taken_back: Change,
    },
}

impl Document {
    /// Opens a scene that is as it was saved.
    pub fn new(scene: Scene) -> Self {
        Self { scene, saved_at: Some(SavedMark(0)), ..Self::default() }
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
        self.close(false)
    }

    /// The same, under a name that tells what was changed where that is one property: "Width of belly from 210 to 340 m".
    ///
    /// # Errors
    /// As [`Document::commit`].
    pub fn commit_told(&mut self) -> Result<(), EditError> {
        self.close(true)
    }

    fn close(&mut self, tell: bool) -> Result<(), EditError> {
        let Some(mut point) = self.open.take().map(Transaction::into_point) else { return Ok(()) };
        let mut before = self.scene.clone();
        let (forward, change) = point.reverse(&mut before);
        if tell && let Some(told) = told::told(&point.name, point.inverses(), forward.inverses(), &self.scene) {
            point.name = told;
        }
        if before == self.scene {
            return Ok(());
        }
        let problems = self.new_errors(&before, &change);
        if !problems.is_empty() {
            self.scene = before;
            return Err(EditError::Problems { problems, taken_back: change });
        }
        self.made_count += 1;
        point.mark = SavedMark(self.made_count);
        self.done.push(Arc::new(point));
        self.undone.clear();
        self.forget_oldest();
        Ok(())
    }

    /// What `change` has made wrong in the scene, which was `before`.
    fn new_errors(&self, before: &Scene, change: &Change) -> Vec<Problem> {
        let mut errors = problem::check_touched(&self.scene, change);
        errors.retain(|problem| problem.severity == Severity::Error);
        if !errors.is_empty() {
            let old = problem::check(before);
            errors.retain(|problem| !old.contains(problem));
        }
        errors
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
        self.undone.push(Arc::new(forward));
        Some(change)
    }

    /// Goes one undone point forward; none if there is none.
    pub fn redo(&mut self) -> Option<Change> {
        if self.open.is_some() {
            return None;
        }
        let point = self.undone.pop()?;
        let (backward, change) = point.reverse(&mut self.scene);
        self.done.push(Arc::new(backward));
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

    /// What leads again from the scene before the last undo point to the one after it, in order: so another document that
    /// has the scene before can take the point over. None if there is no point.
    pub fn last_edits(&self) -> Vec<Edit> {
        let Some(point) = self.done.last() else { return Vec::new() };
        point.reverse(&mut self.scene.clone()).0.into_edits()
    }

    /// The state that the scene is in, an open transaction apart.
    pub fn mark(&self) -> SavedMark {
        self.done.last().map_or(self.begun_at, |point| point.mark)
    }

    /// Says that the scene is saved as it was at `mark`.
    pub fn mark_saved(&mut self, mark: SavedMark) {
        self.saved_at = Some(mark);
    }

    /// Says that no state of the history is what a file holds.
    pub fn mark_unsaved(&mut self) {
        self.saved_at = None;
    }

    /// Whether the scene differs from what was last saved.
    pub fn is_modified(&self) -> bool {
        self.open.is_some() || self.saved_at != Some(self.mark())
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
        assert!(matches!(error, Err(EditError::Problems { .. })), "{error:?}");
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
        document.mark_saved(document.mark());
        assert!(!document.is_modified());
        document.undo();
        assert!(document.is_modified());
        document.edit("Rename", [Edit::Name("b".into())]).expect("fits");
        assert!(document.is_modified(), "the saved state is out of reach now");
        document.undo();
        document.redo();
        assert!(document.is_modified());
    }

    #[test]
    fn what_is_edited_while_saving_stays_modified() {
        let mut document = Document::new(Scene::default());
        document.edit("Rename", [Edit::Name("a".into())]).expect("fits");
        let mark = document.mark();
        document.edit("Rename", [Edit::Name("b".into())]).expect("fits");
        document.mark_saved(mark);
        assert!(document.is_modified());
        document.undo();
        assert!(!document.is_modified(), "this is what was saved");
        document.undo();
        document.edit("Rename", [Edit::Name("c".into())]).expect("fits");
        document.mark_saved(mark);
        assert!(document.is_modified(), "as many steps, but not the same");
        document.mark_unsaved();
        document.undo();
        assert!(document.is_modified());
    }
}
