//! The shading groups of the selected model.

use super::Reading;
use crate::editor::Action;
use egui::Ui;

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let _ = actions;
    if reading.view.selection.model(reading.session.scene()).is_none() {
        ui.weak("Select a cloud to see its shading groups.");
    }
}
