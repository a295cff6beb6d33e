//! What aircraft and props look like.

use crate::state::{Action, Item, Reading};
use crate::widget::name_it;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::{Aircraft, AircraftId, PropId};
use egui::Ui;

/// A row for what the aircraft looks like.
pub(super) fn aircraft(ui: &mut Ui, id: AircraftId, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let Some(aircraft) = reading.session.scene().aircraft.with_id(id) else { return };
    ui.horizontal(|ui| {
        ui.label("Model");
        aircraft_menu(ui, aircraft, actions);
    });
}

/// What an aircraft looks like: the built-in one, or a file beside the scene's.
pub(super) fn aircraft_menu(ui: &mut Ui, aircraft: &Aircraft, actions: &mut Vec<Action>) {
    let shown = aircraft.model.as_deref().unwrap_or("built-in");
    let menu = ui.menu_button(shown, |ui| {
        if ui.selectable_label(aircraft.model.is_none(), "Built-in aircraft").clicked() {
            let aircraft = Aircraft { model: None, ..aircraft.clone() };
            actions.push(Action::change("Aircraft's model", Edit::Aircraft(ListEdit::Replace(aircraft)), false));
        }
        if ui.button("From a file…").clicked() {
            actions.push(Action::ChooseModel(Item::Aircraft(aircraft.id)));
        }
    });
    let name = if aircraft.name.is_empty() { format!("aircraft {}", aircraft.id) } else { aircraft.name.clone() };
    name_it(ui, &menu.response, &format!("Model of {name}"));
    menu.response.on_hover_text("The built-in aircraft, or a .glb file that lies beside the scene's file.");
}

/// A row for what stands: a file beside the scene's.
pub(super) fn prop(ui: &mut Ui, id: PropId, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let Some(prop) = reading.session.scene().props.with_id(id) else { return };
    ui.horizontal(|ui| {
        ui.label("Model");
        let button = ui.button(&prop.model);
        let name = if prop.name.is_empty() { format!("prop {id}") } else { prop.name.clone() };
        name_it(ui, &button, &format!("Model of {name}"));
        if button.on_hover_text("A .glb file that lies beside the scene's file; press to choose another.").clicked() {
            actions.push(Action::ChooseModel(Item::Prop(id)));
        }
    });
}
