//! Cloud models: category and culling. Boxes are in the outline, colours in their own panel.

use crate::command::Command;
use crate::state::{Action, Reading};
use crate::widget::{Fields, Kept, kept};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::CloudModel;
use egui::Ui;
use std::collections::HashMap;

/// `models` has at least one, the one whose values are shown.
pub(super) fn fields_of(ui: &mut Ui, models: &[&CloudModel], reading: &Reading<'_>, actions: &mut Vec<Action>) {
    Fields::of(models, reading)
        .show(ui, "Change model", actions, Fields::all, |_, model| Edit::Model(ListEdit::Replace(model)));
    placed_as(ui, models, reading);
    ui.horizontal_wrapped(|ui| {
        for command in [Command::AddBox, Command::PlaceModel, Command::PlaceMany] {
            let row = command.row();
            if ui.button(row.name).on_hover_text(row.tooltip(ui.ctx())).clicked() {
                actions.push(Action::Command(command));
            }
        }
    });
}

/// The counts of each model's first cloud: those of the others differ only if they have seeds of their own.
fn placed_as(ui: &mut Ui, models: &[&CloudModel], reading: &Reading<'_>) {
    let mut first = HashMap::new();
    for cloud in &reading.session.scene().clouds {
        first.entry(cloud.model).or_insert(cloud.id);
    }
    let placed = models.iter().filter_map(|model| reading.session.placed(*first.get(&model.id)?));
    let placed: Vec<_> = placed.collect();
    if placed.is_empty() {
        ui.weak("Placed nowhere.");
    } else {
        kept::line(ui, &Kept::of_clouds(&placed));
    }
}
