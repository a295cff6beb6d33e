//! The aircraft on a path.

use super::button;
use crate::command::Command;
use crate::panel::models::aircraft_menu;
use crate::state::{Action, Item, Reading};
use crate::theme::icon;
use crate::widget::{name_it, number_field};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::AIRCRAFT_AHEAD_S;
use cloudwright_core::scene::{Aircraft, CameraPath};
use egui::{Button, Grid, Ui};

pub(super) fn show(ui: &mut Ui, path: &CameraPath, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let here: Vec<&Aircraft> = reading.session.scene().aircraft.iter().filter(|each| each.path == path.id).collect();
    if here.is_empty() {
        ui.weak("None flies along this path.");
    }
    Grid::new("traffic").num_columns(4).show(ui, |ui| {
        for aircraft in here {
            line(ui, aircraft, reading, actions);
            ui.end_row();
        }
    });
    button(ui, Command::AddAircraft, "Add aircraft", "Add aircraft to the path", false, actions);
}

fn line(ui: &mut Ui, aircraft: &Aircraft, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let item = Item::Aircraft(aircraft.id);
    let name = if aircraft.name.is_empty() { format!("aircraft {}", aircraft.id) } else { aircraft.name.clone() };
    let response = ui.add(Button::selectable(reading.view.selection.contains(item), &name));
    name_it(ui, &response, &format!("Select {name}"));
    if response.on_hover_text("Its values are in the inspector.").clicked() {
        actions.push(Action::select(item));
    }
    let mut ahead_s = aircraft.ahead_s;
    if number_field(ui, &format!("{name} ahead"), &AIRCRAFT_AHEAD_S, &mut ahead_s, false) {
        let aircraft = Aircraft { ahead_s, ..aircraft.clone() };
        let live = ui.input(|input| input.pointer.any_down());
        actions.push(Action::change("Change aircraft", Edit::Aircraft(ListEdit::Replace(aircraft)), live));
    }
    aircraft_menu(ui, aircraft, actions);
    let delete = ui.button(icon::TRASH);
    name_it(ui, &delete, &format!("Delete {name}"));
    if delete.on_hover_text("Delete aircraft").clicked() {
        actions.push(Action::change("Delete aircraft", Edit::Aircraft(ListEdit::Remove(aircraft.id)), false));
    }
}
