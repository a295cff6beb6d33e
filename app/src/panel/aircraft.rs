//! Aircraft on their paths.

use crate::state::{Action, Reading};
use crate::widget::{Fields, name_it};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::Aircraft;
use egui::Ui;

/// `aircraft` has at least one, the one whose values are shown.
pub(super) fn fields_of(ui: &mut Ui, aircraft: &[&Aircraft], reading: &Reading<'_>, actions: &mut Vec<Action>) {
    Fields::of(aircraft, reading)
        .show(ui, "Change aircraft", actions, Fields::all, |_, aircraft| Edit::Aircraft(ListEdit::Replace(aircraft)));
    let Some(aircraft) = aircraft.first() else { return };
    ui.horizontal(|ui| {
        ui.label("Model");
        model_menu(ui, aircraft, actions);
    });
}

/// What an aircraft looks like: the built-in one, or a file beside the scene's.
pub(super) fn model_menu(ui: &mut Ui, aircraft: &Aircraft, actions: &mut Vec<Action>) {
    let shown = aircraft.model.as_deref().unwrap_or("built-in");
    let menu = ui.menu_button(shown, |ui| {
        if ui.selectable_label(aircraft.model.is_none(), "Built-in aircraft").clicked() {
            let aircraft = Aircraft { model: None, ..aircraft.clone() };
            actions.push(Action::change("Aircraft's model", Edit::Aircraft(ListEdit::Replace(aircraft)), false));
        }
        if ui.button("From a file…").clicked() {
            actions.push(Action::ChooseModel(aircraft.id));
        }
    });
    let name = if aircraft.name.is_empty() { format!("aircraft {}", aircraft.id) } else { aircraft.name.clone() };
    name_it(ui, &menu.response, &format!("Model of {name}"));
    menu.response.on_hover_text("The built-in aircraft, or a .glb file that lies beside the scene's file.");
}
