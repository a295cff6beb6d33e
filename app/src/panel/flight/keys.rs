//! A path's keys as a table: when each is passed, and how fast the way to the next is flown.
//!
//! Only the lines in sight are laid out, so a recorded path costs no more than a short one.

use super::button;
use crate::command::Command;
use crate::state::{Action, Item, Reading, ViewChange};
use crate::theme::{self, icon};
use crate::widget::{name_it, number_field};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::flight::{SHORTEST_LEG_S, leg_speed_mps, with_speed_from};
use cloudwright_core::property::{KEY_TIME_S, LEG_SPEED_MPS, Number};
use cloudwright_core::scene::{CameraPath, PathKey};
use egui::{Button, ScrollArea, Ui, vec2};

/// Of the column of numbers, points.
const NUMBER_COLUMN: f32 = 34.0;
/// Of the column of speeds, with their units, points.
const SPEED_COLUMN: f32 = 84.0;
/// Lines in sight.
const LINES: f32 = 8.0;

pub(super) fn show(ui: &mut Ui, path: &CameraPath, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        for (command, name) in
            [(Command::KeyAfterLast, "Add key after the last"), (Command::KeyAtClock, "Key at clock")]
        {
            button(ui, command, name, name, false, actions);
        }
    });
    let height = ui.spacing().interact_size.y;
    ui.horizontal(|ui| {
        for (width, text) in [(NUMBER_COLUMN, "Key"), (theme::NUMBER_WIDTH, "Time"), (SPEED_COLUMN, "Speed")] {
            let (place, _) = ui.allocate_exact_size(vec2(width, height), egui::Sense::hover());
            ui.put(place, egui::Label::new(egui::RichText::new(text).weak()).selectable(false));
        }
    });
    let lines = ScrollArea::vertical().id_salt("keys").max_height(LINES * (height + ui.spacing().item_spacing.y));
    lines.auto_shrink([false, true]).show_rows(ui, height, path.keys.len(), |ui, shown| {
        for (index, key) in path.keys.iter().enumerate().take(shown.end).skip(shown.start) {
            ui.push_id(index, |ui| ui.horizontal(|ui| line(ui, path, index, key, reading, actions)));
        }
    });
}

fn line(ui: &mut Ui, path: &CameraPath, index: usize, key: &PathKey, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let number = index + 1;
    let selected = reading.view.selection.contains(Item::Path(path.id)) && reading.view.key_of(path.id) == Some(index);
    let size = vec2(NUMBER_COLUMN, ui.spacing().interact_size.y);
    let response = ui.add_sized(size, Button::selectable(selected, number.to_string()));
    name_it(ui, &response, &format!("Key {number}"));
    if response.on_hover_text("Work on this key: Move and Rotate take it alone.").clicked() {
        actions.push(Action::select(Item::Path(path.id)));
        actions.push(Action::View(ViewChange::PathKey(Some((path.id, index)))));
    }
    let live = ui.input(|input| input.pointer.any_down());
    let mut time_s = key.time_s;
    if number_field(ui, &format!("Time of key {number}"), &between_neighbours(path, index), &mut time_s, false) {
        let mut path = path.clone();
        if let Some(key) = path.keys.get_mut(index) {
            key.time_s = time_s;
        }
        actions.push(Action::change("Key's time", Edit::Path(ListEdit::Replace(path)), live));
    }
    let size = vec2(SPEED_COLUMN, ui.spacing().interact_size.y);
    ui.allocate_ui(size, |ui| {
        ui.set_min_width(SPEED_COLUMN);
        if let Some(speed_mps) = leg_speed_mps(&path.keys, index) {
            let unit = reading.units.speed();
            let mut speed = in_whole(unit.from_si(speed_mps));
            let in_unit = Number {
                unit: unit.name,
                min: unit.from_si(LEG_SPEED_MPS.min),
                max: unit.from_si(LEG_SPEED_MPS.max),
                ..LEG_SPEED_MPS
            };
            if number_field(ui, &format!("Speed from key {number}"), &in_unit, &mut speed, false) {
                let keys = with_speed_from(&path.keys, index, unit.to_si(speed));
                let path = CameraPath { keys, ..path.clone() };
                actions.push(Action::change("Leg's speed", Edit::Path(ListEdit::Replace(path)), live));
            }
        }
    });
    let there = ui.button("Go there");
    name_it(ui, &there, &format!("Go to key {number}"));
    if there.on_hover_text("The view sees what this key sees, and the clock is at its time.").clicked() {
        actions.push(Action::GoToKey(path.id, index));
    }
    let delete = ui.add_enabled(path.keys.len() > 1, Button::new(icon::TRASH));
    name_it(ui, &delete, &format!("Delete key {number}"));
    if delete.on_hover_text("Delete key").on_disabled_hover_text("A path has one key at least.").clicked() {
        let mut path = path.clone();
        path.keys.remove(index);
        actions.push(Action::change("Delete key", Edit::Path(ListEdit::Replace(path)), false));
    }
}

/// A speed as it is read: whole, or to a tenth of a slow one.
fn in_whole(speed: f64) -> f64 {
    if speed < 10.0 { (speed * 10.0).round() / 10.0 } else { speed.round() }
}

/// A key's time lies between its neighbours'.
fn between_neighbours(path: &CameraPath, index: usize) -> Number {
    let time = |index: Option<usize>| Some(path.keys.get(index?)?.time_s);
    let min = time(index.checked_sub(1)).map_or(KEY_TIME_S.min, |before| before + SHORTEST_LEG_S);
    let max = time(index.checked_add(1)).map_or(KEY_TIME_S.max, |after| after - SHORTEST_LEG_S);
    Number { min, max: max.max(min), ..KEY_TIME_S }
}
