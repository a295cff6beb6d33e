//! What is wrong, as a list to read and close.

use super::{buttons, window};
use crate::opening;
use crate::theme;
use crate::visible;
use cloudwright_core::problem::Problem;
use egui::{RichText, ScrollArea, Ui};

#[derive(Debug)]
pub(in crate::editor) struct Trouble {
    pub(super) title: String,
    pub(super) problems: Vec<Problem>,
}

impl Trouble {
    /// Some when it was closed.
    pub(super) fn show(&self, context: &egui::Context) -> Option<()> {
        window(context, theme::WIDE_DIALOG_WIDTH, &self.title, (), |ui| {
            ScrollArea::vertical().max_height(theme::DIALOG_LIST_HEIGHT).show(ui, |ui| {
                for problem in &self.problems {
                    show_problem(ui, problem);
                }
            });
            buttons(ui, |ui| ui.button("OK").clicked().then_some(()))
        })
    }
}

fn show_problem(ui: &mut Ui, problem: &Problem) {
    if !problem.place.is_empty() {
        let mark = opening::severity_name(problem);
        let place = visible::one_line(&problem.place);
        ui.label(RichText::new(format!("{mark} at {place}")).monospace().color(theme::error(ui)));
    }
    ui.label(visible::lines(&problem.message));
    if !problem.hint.is_empty() {
        ui.weak(visible::lines(&problem.hint));
    }
    ui.add_space(theme::GAP);
}
