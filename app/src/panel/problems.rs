//! What is wrong with the scene, and what to do about it; a click selects the thing.

use super::Reading;
use crate::editor::Action;
use crate::theme::{self, icon};
use cloudwright_core::problem::{self, Severity};
use egui::{RichText, ScrollArea, Ui};

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let _ = actions;
    let session = reading.session;
    let problems = problem::check_with_sprites(session.scene(), session.derived().clouds());
    if problems.is_empty() {
        ui.weak("Nothing is wrong.");
        return;
    }
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for problem in problem::shortened(problems) {
            let (glyph, color) = match problem.severity {
                Severity::Error => (icon::X, theme::error(ui)),
                Severity::Note => (icon::INFO, ui.visuals().text_color()),
            };
            ui.horizontal_wrapped(|ui| {
                ui.label(RichText::new(glyph).color(color));
                ui.label(RichText::new(&problem.place).weak().monospace());
                ui.label(RichText::new(&problem.message).color(color));
                ui.weak(&problem.hint);
            });
        }
    });
}
