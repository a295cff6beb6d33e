//! The shading groups of the selected model: the list above, below it how the chosen ones take the sun.

mod curve;
mod light;
mod list;

pub(super) use list::{group_name, members};

use crate::command::Command;
use crate::state::{Action, Reading};
use crate::theme;
use crate::widget::name_it;
use egui::{ScrollArea, Ui};

/// A list that scrolls by itself shows so many groups, where there is room for them and for the light's numbers.
const GROUPS: f32 = 4.0;
/// Title and numbers of the light, with what shows that there is more; and all of its rows, but for the curve.
const ROWS_OF_LIGHT: [f32; 2] = [6.0, 9.0];

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let Some(model) = reading.view.selection.model(reading.session.scene()) else {
        ui.weak("Select a cloud to see its shading groups.");
        return;
    };
    buttons(ui, reading, actions);
    ui.add_space(theme::GAP * 0.5);
    // A long list scrolls by itself where there is room for both, so that the light stays in sight.
    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    let [least, all] = ROWS_OF_LIGHT.map(|rows| ui.available_height() - rows * row);
    if least < GROUPS * row {
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            list::show(ui, model, reading, actions);
            light::show(ui, model, reading, actions);
        });
        return;
    }
    let most = (all - theme::CURVE_HEIGHT).max(GROUPS * row);
    let list = ScrollArea::vertical().id_salt("groups").max_height(most).auto_shrink([false, true]);
    list.show(ui, |ui| list::show(ui, model, reading, actions));
    let light = ScrollArea::vertical().id_salt("light").auto_shrink(false);
    light.show(ui, |ui| light::show(ui, model, reading, actions));
}

fn buttons(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let has_members = list::has_members(reading);
    let mut offer = |ui: &mut Ui, command: Command, name: &str, enabled: bool, on: bool| {
        let row = command.row();
        let button = egui::Button::new(format!("{} {name}", row.icon.unwrap_or_default())).selected(on);
        let response = ui.add_enabled(enabled, button);
        name_it(ui, &response, name);
        let tooltip = row.tooltip(ui.ctx());
        if response.on_hover_text(&tooltip).on_disabled_hover_text(tooltip).clicked() {
            actions.push(Action::Command(command));
        }
    };
    ui.horizontal_wrapped(|ui| {
        offer(ui, Command::NewGroup, "New group from selection", has_members, false);
        offer(ui, Command::AutoGroup, "Group automatically", true, false);
        offer(ui, Command::GroupView, "Show tints", true, reading.view.group_view);
    });
}
