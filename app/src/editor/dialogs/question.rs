//! A question with two or three answers. Esc gives the one that loses nothing.

use super::{buttons, window};
use crate::theme;
use crate::visible;
use std::path::Path;

/// Index of the first answer.
pub(super) const FIRST: usize = 0;
/// Index of the second answer.
pub(super) const SECOND: usize = 1;

pub(super) struct Question {
    heading: &'static str,
    text: String,
    answers: &'static [&'static str],
    /// The answer that Esc gives.
    escape: usize,
}

impl Question {
    pub(super) fn unsaved(name: &str) -> Self {
        Self {
            heading: "Save the changes?",
            text: format!("{name} has changes that are not saved. They are lost without saving."),
            answers: &["Save", "Don't save", "Cancel"],
            escape: 2,
        }
    }

    pub(super) fn revert(name: &str) -> Self {
        Self {
            heading: "Go back to the saved scene?",
            text: format!("All changes to {name} since it was last saved are lost."),
            answers: &["Revert", "Cancel"],
            escape: 1,
        }
    }

    pub(super) fn in_the_way(path: &Path, reason: &str) -> Self {
        Self {
            heading: "Replace the file?",
            text: format!("{}: {reason}. What it holds is lost when it is replaced.", path.display()),
            answers: &["Replace", "Save as…", "Cancel"],
            escape: 2,
        }
    }

    pub(super) fn changed_on_disk(name: &str) -> Self {
        Self {
            heading: "The file has changed",
            text: format!("Another program changed {name}, and there are changes here that are not saved."),
            answers: &["Keep mine", "Load theirs"],
            escape: 0,
        }
    }

    /// The answer's index, when it is given.
    pub(super) fn ask(&self, context: &egui::Context) -> Option<usize> {
        window(context, theme::DIALOG_WIDTH, self.heading, self.escape, |ui| {
            ui.label(visible::one_line(&self.text));
            buttons(ui, |ui| {
                let mut answered = None;
                for (index, answer) in self.answers.iter().enumerate() {
                    if ui.button(*answer).clicked() {
                        answered = Some(index);
                    }
                }
                answered
            })
        })
    }
}
