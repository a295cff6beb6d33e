//! How much memory the way back may take: the oldest points are forgotten beyond that.

use super::Document;
use serde::Serialize;
use std::io;

/// Counts what is written.
struct Counter(u64);

impl io::Write for Counter {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0 += bytes.len() as u64;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// About what a value takes: its length as JSON, which is within a factor of three.
pub(super) fn bytes_of(value: &impl Serialize) -> u64 {
    let mut counter = Counter(0);
    // What can't be said as JSON is no number, and refused by every edit.
    let _ = serde_json::to_writer(&mut counter, value);
    counter.0
}

impl Document {
    /// From now on, what can be undone takes about `most_bytes` at most; the last step can always be.
    pub fn keep_past_within(&mut self, most_bytes: u64) {
        if self.most_bytes != Some(most_bytes) {
            self.most_bytes = Some(most_bytes);
            self.forget_oldest();
        }
    }

    /// Forgets the oldest points, until the rest are within bounds.
    pub(super) fn forget_oldest(&mut self) {
        let Some(most) = self.most_bytes else { return };
        let mut left = most;
        let kept = self.done.iter().rev().take_while(|point| match left.checked_sub(point.bytes()) {
            Some(rest) => {
                left = rest;
                true
            }
            None => false,
        });
        let forgotten = self.done.len() - kept.count().clamp(self.done.len().min(1), self.done.len());
        if let Some(last) = forgotten.checked_sub(1) {
            self.begun_at = self.done[last].mark;
            self.done.drain(..forgotten);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::document::{Document, Edit};
    use crate::problem::sound_scene;

    fn named(count: usize, most_bytes: Option<u64>) -> Document {
        let mut document = Document::new(sound_scene());
        if let Some(most) = most_bytes {
            document.keep_past_within(most);
        }
        for step in 0..count {
            document.edit(&format!("step {step}"), [Edit::Name(format!("{step:08}"))]).expect("sound");
        }
        document
    }

    #[test]
    fn the_oldest_steps_are_forgotten_and_the_last_never() {
        let one = named(1, None).done[0].bytes();
        for (most_bytes, wanted) in [(0, 1), (one - 1, 1), (5 * one + one / 2, 5), (1 << 40, 20)] {
            let document = named(20, Some(most_bytes));
            assert!((document.done.len() as i64 - wanted).abs() <= 1, "{most_bytes}: {}", document.done.len());
            let mut late = named(20, None);
            late.keep_past_within(most_bytes);
            assert_eq!(late.done.len(), document.done.len(), "the same, if the bound comes later");
            assert_eq!(late.undo_name(), Some("step 19"));
        }
    }

    #[test]
    fn what_was_forgotten_is_not_what_was_saved() {
        let mut document = named(20, Some(400));
        assert!(document.done.len() < 10);
        while document.undo().is_some() {}
        assert!(document.is_modified(), "the saved state is out of reach");
        assert_eq!(document.history().saved_at(), None);
        document.mark_saved(document.mark());
        assert!(!document.is_modified());
        assert_eq!(document.history().saved_at(), Some(0));
        document.redo();
        assert!(document.is_modified());
    }
}
