//! Menus and toolbar: nothing but the command table, and the plugins that there are.

use super::{menu_keys, plugin};
use crate::command::{Command, Menu, TABLE};
use crate::plugins::Library;
use crate::state::{Action, CommandState};
use crate::theme;
use crate::widget::{menu_line, offer};
use egui::containers::menu::MenuConfig;
use egui::{Button, ScrollArea, Ui};

/// The buttons, in groups.
const BUTTONS: &[&[Command]] = &[
    &[Command::New, Command::Save],
    &[Command::Undo, Command::Redo],
    &[Command::SelectTool, Command::MoveTool, Command::RotateTool, Command::ScaleTool, Command::BoxTool, Command::Snap],
    &[Command::AddCloud, Command::AddPreset, Command::AddBox, Command::AddCamera],
    &[Command::Duplicate, Command::Delete],
    &[Command::FrameSelection, Command::ShowBoxes, Command::SpriteMarks, Command::GroupView, Command::PlayTime],
];

/// The row of menus, of which `wanted` opens.
pub(crate) fn menu_bar(
    ui: &mut Ui,
    state: &dyn Fn(Command) -> CommandState,
    library: &Library,
    wanted: Option<Menu>,
    actions: &mut Vec<Action>,
) {
    let mut open = None;
    let bar = egui::MenuBar::new().style(theme::menu).config(MenuConfig::new().style(theme::menu));
    bar.ui(ui, |ui| {
        for menu in Menu::ALL {
            let shown = ui.menu_button(menu_keys::name(ui, menu), |ui| {
                // Long menus in low windows.
                let room = ui.ctx().content_rect().bottom() - ui.next_widget_position().y - theme::DIALOG_MARGIN;
                ScrollArea::vertical().max_height(room).min_scrolled_height(room).show(ui, |ui| {
                    rows(ui, menu, state, library, actions);
                });
            });
            if wanted == Some(menu) {
                menu_keys::open(ui, &shown.response);
            }
            if shown.inner.is_some() {
                open = Some(menu);
            }
        }
    });
    menu_keys::keep(ui, open);
}

fn rows(
    ui: &mut Ui,
    menu: Menu,
    state: &dyn Fn(Command) -> CommandState,
    library: &Library,
    actions: &mut Vec<Action>,
) {
    if menu == Menu::Plugins {
        plugin::menus(ui, library, actions);
        ui.separator();
    }
    // Who wants to write a plugin looks for the panel here.
    let script = (menu == Menu::Plugins).then(|| Command::ScriptPanel.row());
    for row in TABLE.iter().filter(|row| row.menu == menu).chain(script) {
        if menu_line(ui, row, state(row.command)) {
            actions.push(Action::Command(row.command));
        }
    }
}

/// The row of buttons: icons with their names in tooltips.
pub(crate) fn toolbar(ui: &mut Ui, state: &dyn Fn(Command) -> CommandState, actions: &mut Vec<Action>) {
    ui.horizontal_wrapped(|ui| {
        for (i, group) in BUTTONS.iter().enumerate() {
            if i > 0 {
                ui.add_space(theme::GAP * 0.5);
                ui.separator();
                ui.add_space(theme::GAP * 0.5);
            }
            for row in group.iter().map(|command| command.row()) {
                let text = theme::tool_text(row.icon.unwrap_or(row.name));
                if offer(ui, row, Button::new(text), &row.full_label(), state(row.command)) {
                    actions.push(Action::Command(row.command));
                }
            }
        }
    });
}
