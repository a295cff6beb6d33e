//! What can be undone, outside of its document: so that it outlives a program that crashes.
//!
//! A text holds the newest points, as many as a limit of bytes allows. It may have been changed by anybody: of what is
//! read, only those points are taken up that fit the scene one after the other and lead to scenes without errors.

use super::transaction::UndoPoint;
use super::{Document, SavedMark};
use crate::scene::Scene;
use std::sync::Arc;

/// Older points are left out.
const MOST_POINTS: usize = 200;

/// The newest points that can be undone, oldest first. What had been undone is not among them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Past(Vec<Arc<UndoPoint>>);

impl Past {
    /// As JSON of no more than `most_bytes` (but for two brackets): the newest points that fit in.
    pub fn write(&self, most_bytes: usize) -> String {
        let mut left = most_bytes.saturating_sub(2);
        let mut texts = Vec::new();
        for point in self.0.iter().rev() {
            // Numbers that JSON can't say are refused by every edit.
            let Ok(text) = serde_json::to_string(&**point) else { break };
            let Some(rest) = left.checked_sub(text.len() + 1) else { break };
            left = rest;
            texts.push(text);
        }
        texts.reverse();
        format!("[{}]", texts.join(","))
    }

    /// What [`Past::write`] wrote; empty if it is anything else.
    pub fn read(text: &str) -> Self {
        let points: Vec<UndoPoint> = serde_json::from_str(text).unwrap_or_default();
        Self(points.into_iter().map(Arc::new).collect())
    }
}

impl Document {
    /// What can be undone. An open transaction is not in it yet.
    pub fn past(&self) -> Past {
        let first = self.done.len().saturating_sub(MOST_POINTS);
        Past(self.done[first..].to_vec())
    }

    /// Opens a scene that was not saved, with as much of its past as leads back from it.
    pub fn resume(scene: Scene, past: &Past) -> Self {
        let mut done = Vec::new();
        let mut present = scene.clone();
        for point in past.0.iter().rev().take(MOST_POINTS) {
            let Some(before) = point.lead_back(&present) else { break };
            present = before;
            done.push(UndoPoint::clone(point));
        }
        done.reverse();
        let made_count = done.len() as u64;
        for (mark, point) in (1..).zip(&mut done) {
            point.mark = SavedMark(mark);
        }
        let done = done.into_iter().map(Arc::new).collect();
        Self { scene, done, made_count, ..Self::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Edit, ListEdit};
    use crate::problem::{self, Severity, sound_scene};

    fn heading(document: &Document, heading_deg: f64) -> Edit {
        let mut cloud = document.scene().clouds[0].clone();
        cloud.heading_deg = heading_deg;
        Edit::Cloud(ListEdit::Replace(cloud))
    }

    /// Each state from the first to the last, and the document in the last.
    fn edited() -> (Vec<Scene>, Document) {
        let mut document = Document::new(sound_scene());
        let mut states = vec![document.scene().clone()];
        for step in 1..=4 {
            let edit = match step {
                3 => Edit::Cloud(ListEdit::Remove(document.scene().clouds[0].id)),
                4 => Edit::Name("renamed".into()),
                _ => heading(&document, f64::from(step)),
            };
            document.edit(&format!("step {step}"), [edit]).expect("sound");
            states.push(document.scene().clone());
        }
        (states, document)
    }

    fn names(document: &Document) -> Vec<String> {
        document.done.iter().map(|point| point.name.clone()).collect()
    }

    #[test]
    fn a_text_brings_the_whole_past_back() {
        let (states, document) = edited();
        let text = document.past().write(usize::MAX);
        let mut resumed = Document::resume(document.scene().clone(), &Past::read(&text));
        assert!(resumed.is_modified(), "no file holds it");
        assert_eq!(names(&resumed), ["step 1", "step 2", "step 3", "step 4"]);
        for state in states.iter().rev().skip(1) {
            resumed.undo().expect("a point");
            assert_eq!(resumed.scene(), state);
        }
        assert!(resumed.undo().is_none());
        while resumed.redo().is_some() {}
        assert_eq!(resumed.scene(), &states[4]);
    }

    #[test]
    fn what_does_not_fit_in_or_does_not_lead_back_is_left_out() {
        let (states, document) = edited();
        let all = document.past().write(usize::MAX);
        for most_bytes in [0, 2, all.len() / 2, all.len() - 1, all.len()] {
            let text = document.past().write(most_bytes);
            assert!(text.len() <= most_bytes.max(2), "{} of {most_bytes}", text.len());
            let resumed = Document::resume(document.scene().clone(), &Past::read(&text));
            assert!(all.len() == most_bytes || resumed.done.len() < 4, "{most_bytes}");
            assert_eq!(names(&resumed), names(&document)[4 - resumed.done.len()..], "the newest");
        }
        // Of another scene: the last two points take out what is not there, or add what is.
        let resumed = Document::resume(states[0].clone(), &document.past());
        assert_eq!(names(&resumed), ["step 4"], "it can be renamed back, but its cloud was not taken out");
        for broken in ["", "[", "{}", "[1]", "novel", r#"[{"name":"x"}]"#] {
            assert_eq!(Past::read(broken), Past::default(), "{broken}");
        }
    }

    /// A point that was changed by hand leads to no scene with errors.
    #[test]
    fn a_past_with_faults_ends_before_them() {
        let (_, document) = edited();
        let text = document.past().write(usize::MAX);
        let name = format!("\"{}\"", document.scene().name);
        assert!(!text.contains("1e9"), "{name}");
        let wild = text.replace("\"heading_deg\":1.0", "\"heading_deg\":1e9");
        assert_ne!(wild, text);
        let mut resumed = Document::resume(document.scene().clone(), &Past::read(&wild));
        while resumed.undo().is_some() {}
        assert!(problem::check(resumed.scene()).iter().all(|problem| problem.severity != Severity::Error));
    }
}
