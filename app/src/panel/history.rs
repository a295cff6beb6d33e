//! All changes, oldest first; a click goes there.

use super::Reading;
use crate::editor::Action;
use egui::Ui;

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let _ = actions;
    ui.weak(reading.session.document().undo_name().unwrap_or("As opened"));
}
