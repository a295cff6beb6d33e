//! The history as a list: every undo point by name, and the way to any of them.

use super::transaction::UndoPoint;
use super::{Change, Document};

/// What was done and what was undone again, oldest first.
#[derive(Debug, Clone, Copy)]
pub struct History<'a> {
    document: &'a Document,
}

impl<'a> History<'a> {
    /// How many points there are, done and undone.
    pub fn len(&self) -> usize {
        self.document.done.len() + self.document.undone.len()
    }

    /// Whether nothing has been done yet.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many points are done: the present lies behind that many names, and the rest are undone.
    pub fn done_count(&self) -> usize {
        self.document.done.len()
    }

    /// How many points were done when the scene was last saved; none if that state is out of reach.
    pub fn saved_at(&self) -> Option<usize> {
        let saved = self.document.saved_at?;
        std::iter::once(self.document.begun_at)
            .chain(self.points().map(|point| point.mark))
            .position(|mark| mark == saved)
    }

    /// The points' names, oldest first.
    pub fn names(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        self.points().map(|point| point.name.as_str())
    }

    fn points(&self) -> impl Iterator<Item = &'a UndoPoint> + use<'a> {
        let Document { done, undone, .. } = self.document;
        done.iter().chain(undone.iter().rev()).map(AsRef::as_ref)
    }
}

impl Document {
    /// The history, to show. An open transaction is not in it yet.
    pub fn history(&self) -> History<'_> {
        History { document: self }
    }

    /// Undoes or redoes until `done_count` points are done (all, if there are fewer). An open transaction is taken back
    /// first. None if the scene stays as it is.
    pub fn jump_to(&mut self, done_count: usize) -> Option<Change> {
        let mut change = self.is_open().then(|| self.cancel());
        loop {
            let step = match self.done.len().cmp(&done_count) {
                std::cmp::Ordering::Less => self.redo(),
                std::cmp::Ordering::Equal => None,
                std::cmp::Ordering::Greater => self.undo(),
            };
            let Some(step) = step else { return change };
            change.get_or_insert_default().join(step);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::document::{Document, Edit, ListEdit};
    use crate::problem::sound_scene;

    #[test]
    fn jumps_to_any_state_and_says_what_it_touched() {
        let mut document = Document::new(sound_scene());
        let mut states = vec![document.scene().clone()];
        assert!(document.history().is_empty() && document.jump_to(7).is_none());
        for step in 1..=4 {
            let mut cloud = document.scene().clouds[0].clone();
            cloud.position.x = f64::from(step);
            let edits = [Edit::Name(format!("{step}")), Edit::Cloud(ListEdit::Replace(cloud))];
            document.edit(&format!("Step {step}"), edits).expect("sound");
            states.push(document.scene().clone());
        }
        let names = |document: &Document| document.history().names().map(String::from).collect::<Vec<_>>();
        let all = names(&document);
        assert_eq!(all, ["Step 1", "Step 2", "Step 3", "Step 4"]);
        let id = states[0].clouds[0].id;
        for done_count in [1, 3, 0, 4, 4, 2, 99] {
            let before = document.history().done_count();
            let change = document.jump_to(done_count);
            let present = done_count.min(4);
            assert_eq!(*document.scene(), states[present], "{done_count}");
            assert_eq!((document.history().done_count(), document.history().len()), (present, 4));
            assert_eq!(change.map(|change| change.touches_cloud(id)), (before != present).then_some(true));
            assert_eq!(names(&document), all, "the list stays as it is");
        }
        assert_eq!(document.history().saved_at(), Some(0));
    }

    #[test]
    fn an_open_transaction_is_taken_back_first() {
        let mut document = Document::new(sound_scene());
        document.edit("Rename", [Edit::Name("a".into())]).expect("sound");
        let done = document.scene().clone();
        document.apply(Edit::TimeOfDay(3.0)).expect("a time");
        assert!(document.jump_to(1).is_some(), "the hour went back");
        assert_eq!(*document.scene(), done);
        assert!(document.jump_to(1).is_none());
    }
}
