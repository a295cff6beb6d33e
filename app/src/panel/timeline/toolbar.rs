//! The buttons over the timeline, and the exact time and value of the chosen keys.

use super::ends;
use super::sheet::part_name;
use crate::command::Command;
use crate::state::{Action, Reading, TimeSnap, TimelineChange};
use crate::theme::{self, icon};
use crate::widget::{name_it, number_field};
use cloudwright_core::arrange::keys::{self, MOST_S};
use cloudwright_core::property::{Number, Target};
use cloudwright_core::scene::{Leaves, TrackId};
use egui::scroll_area::ScrollBarVisibility;
use egui::{Button, RichText, ScrollArea, Ui};

const TIME: Number = Number {
    label: "Key time",
    unit: "s",
    min: -MOST_S,
    max: MOST_S,
    doc: "When the first chosen key stands; the others keep their distance.",
};

/// With less from left to right, the buttons stand closer, so that a place's three values are in sight too, points.
const ROOMY: f32 = 900.0;

pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    // In one line, whatever is chosen: the keys below are not to move away from the pointer.
    let line = ScrollArea::horizontal().id_salt("tools").scroll_bar_visibility(ScrollBarVisibility::AlwaysHidden);
    let is_narrow = ui.available_width() < ROOMY;
    line.show(ui, |ui| {
        ui.horizontal(|ui| {
            if is_narrow {
                ui.spacing_mut().item_spacing.x = 4.0;
                ui.spacing_mut().button_padding.x = 5.0;
            }
            tools(ui, is_narrow, reading, actions);
        });
    });
}

fn tools(ui: &mut Ui, is_narrow: bool, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    auto_key(ui, is_narrow, reading, actions);
    let play = if reading.clock.plays() { icon::PAUSE } else { icon::PLAY };
    for (command, text, on) in [
        (Command::PreviousKey, icon::SKIP_BACK, false),
        (Command::PlayFlight, play, false),
        (Command::NextKey, icon::SKIP_FORWARD, false),
        (Command::LoopFlight, icon::REPEAT, reading.clock.loops()),
    ] {
        button(ui, command, text, on, actions);
    }
    button(ui, Command::AddKeys, icon::PLUS, false, actions);
    button(ui, Command::RippleKeys, Command::RippleKeys.row().name, reading.view.timeline.ripple, actions);
    button(ui, Command::CurveView, icon::CHART_LINE, reading.view.timeline.curves, actions);
    snap(ui, reading, actions);
    ends::show(ui, reading, actions);
    chosen(ui, reading, actions);
}

/// Red while it is on: what hands change then is kept in keys.
fn auto_key(ui: &mut Ui, is_narrow: bool, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let on = reading.view.timeline.auto_key;
    let row = Command::AutoKey.row();
    let mut text =
        RichText::new(if is_narrow { icon::RECORD.into() } else { format!("{} {}", icon::RECORD, row.name) });
    if on {
        text = text.color(egui::Color32::WHITE).strong();
    }
    let button = Button::new(text);
    let response = ui.add(if on { button.fill(theme::AUTO_KEY) } else { button });
    name_it(ui, &response, row.name);
    if response.on_hover_text(row.tooltip(ui.ctx())).clicked() {
        actions.push(Action::Command(row.command));
    }
}

fn button(ui: &mut Ui, command: Command, text: &str, on: bool, actions: &mut Vec<Action>) {
    let row = command.row();
    let response = ui.add(Button::new(text).selected(on));
    name_it(ui, &response, &format!("{} in the timeline", row.label()));
    let tooltip = |ui: &mut Ui| {
        ui.strong(row.label());
        ui.label(row.tooltip(ui.ctx()));
    };
    if response.on_hover_ui(tooltip).clicked() {
        actions.push(Action::Command(command));
    }
}

fn snap(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let all = [(TimeSnap::Off, "Free"), (TimeSnap::Frames, "Frames"), (TimeSnap::Seconds, "Seconds")];
    let present = reading.view.timeline.snap;
    let shown = all.iter().find(|(each, _)| *each == present).map_or("", |(_, name)| name);
    let menu = ui.menu_button(format!("{} {shown}", icon::MAGNET), |ui| {
        for (each, name) in all {
            if ui.selectable_label(each == present, name).clicked() {
                actions.push(Action::Timeline(TimelineChange::Snap(each)));
                ui.close();
            }
        }
    });
    name_it(ui, &menu.response, "Times snap to");
    menu.response.on_hover_text(
        "What dragged keys snap to, besides other keys and the clock: 24 frames a second, or seconds. Shift drags finely, Ctrl by seconds.",
    );
}

/// Time, value and way on of the chosen keys.
fn chosen(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let places = &reading.view.timeline.chosen;
    let scene = reading.session.scene();
    let key_at = |(id, index): &(_, usize)| {
        let track = scene.tracks.with_id(*id)?;
        Some((track, track.keys.get(*index)?))
    };
    let first = places.iter().filter_map(key_at).min_by(|(_, a), (_, b)| a.time_s.total_cmp(&b.time_s));
    let Some((track, key)) = first else { return };
    ui.add_space(theme::GAP * 0.5);
    let live = ui.input(|input| input.pointer.any_down());
    let mut time_s = key.time_s;
    if number_field(ui, TIME.label, &TIME, &mut time_s, false) {
        let by_s = time_s - key.time_s;
        let rekeyed = if reading.view.timeline.ripple {
            keys::rippled(&scene.tracks, places, by_s, |_, _| {})
        } else {
            keys::moved(&scene.tracks, places, by_s)
        };
        actions.push(Action::Keys { name: "Move keys".into(), rekeyed, live, choose: true });
    }
    let shown = match (key.leaves, &key.handles) {
        (Leaves::Step, _) => "step",
        (Leaves::Linear, _) => "straight",
        (Leaves::Smooth, None) => "smooth",
        (Leaves::Smooth, Some(_)) => "handles",
    };
    let menu = ui.menu_button(shown, |ui| easing_menu(ui, actions));
    name_it(ui, &menu.response, "How keys are left");
    if let Ok(target) = track.property.parse::<Target>()
        && let Some(number) = target.property.kind.number()
    {
        // Of angles and hours, any round.
        let number = if target.property.cycle.is_some() { &Number { min: -1e6, max: 1e6, ..*number } } else { number };
        for (part, value) in key.value.parts().iter().enumerate() {
            let mut value = *value;
            let name = format!("Key value {}", part_name(&target, part));
            if number_field(ui, name.trim_end(), number, &mut value, false) {
                let same: std::collections::BTreeSet<_> =
                    places.iter().copied().filter(|place| is_alike(place, &target, reading)).collect();
                let rekeyed = keys::reshaped(&scene.tracks, &same, |_, key| key.value.parts_mut()[part] = value);
                actions.push(Action::Keys { name: "Set keys".into(), rekeyed, live, choose: false });
            }
        }
    }
    if places.len() > 1 {
        ui.weak(format!("{} keys", places.len()));
    }
}

/// Whether a chosen key is of the same property, of whatever thing.
fn is_alike(place: &(TrackId, usize), target: &Target, reading: &Reading<'_>) -> bool {
    let track = reading.session.scene().tracks.with_id(place.0);
    let other = track.and_then(|track| track.property.parse::<Target>().ok());
    other.is_some_and(|other| other.property.is_the_same(target.property))
}

/// How keys are left, as commands.
fn easing_menu(ui: &mut Ui, actions: &mut Vec<Action>) {
    for command in [Command::KeysStep, Command::KeysLinear, Command::KeysSmooth, Command::KeysFlat, Command::KeysFree] {
        offer(ui, command, actions);
    }
}

fn offer(ui: &mut Ui, command: Command, actions: &mut Vec<Action>) {
    let row = command.row();
    if ui.button(row.name).on_hover_text(row.help).clicked() {
        actions.push(Action::Command(command));
    }
}
