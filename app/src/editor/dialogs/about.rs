//! What this is, and what it draws with.

use super::{buttons, window};
use crate::theme;
use egui::{Context, Grid, Label};

/// Some when it was closed.
pub(super) fn show(context: &Context, facts: &[(&'static str, String)]) -> Option<()> {
    window(context, theme::DIALOG_WIDTH, "Cloudwright", (), |ui| {
        ui.label("An editor for the clouds of flight scenes.");
        ui.add_space(theme::GAP);
        Grid::new("about").num_columns(2).min_col_width(theme::NAME_WIDTH).show(ui, |ui| {
            for (name, value) in facts {
                ui.label(*name);
                ui.add(Label::new(value).wrap().selectable(true));
                ui.end_row();
            }
        });
        ui.add_space(theme::GAP);
        ui.weak("MIT OR Apache-2.0. The clouds are Niniane Wang's (2004); the sky is Hosek's and Wilkie's (2012).");
        buttons(ui, |ui| ui.button("OK").clicked().then_some(()))
    })
}
