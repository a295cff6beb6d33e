//! Menus and toolbar: nothing but the command table, and the plugins that there are.

use super::{menu_keys, plugin};
use crate::command::{Command, Menu, Row, TABLE};
use crate::plugins::Library;
use crate::state::Action;
use crate::theme;
use crate::visible;
use crate::widget::name_it;
use egui::{Button, ScrollArea, Ui};

/// How a command is offered now.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CommandState<'a> {
    /// Whether it has something to work on.
    pub(crate) enabled: bool,
    /// Whether what it switches is switched on.
    pub(crate) on: bool,
    /// What it would work on, by name, where that does not show.
    pub(crate) on_what: Option<&'a str>,
}

/// How each command is offered now.
pub(crate) type CommandStates<'a> = dyn Fn(Command) -> CommandState<'a> + 'a;

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
    state: &CommandStates<'_>,
    library: &Library,
    wanted: Option<Menu>,
    actions: &mut Vec<Action>,
) {
    let mut open = None;
    egui::MenuBar::new().ui(ui, |ui| {
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

fn rows(ui: &mut Ui, menu: Menu, state: &CommandStates<'_>, library: &Library, actions: &mut Vec<Action>) {
    if menu == Menu::Plugins {
        plugin::menus(ui, library, actions);
        ui.separator();
    }
    // Who wants to write a plugin looks for the panel here.
    let script = (menu == Menu::Plugins).then(|| Command::ScriptPanel.row());
    for row in TABLE.iter().filter(|row| row.menu == menu).chain(script) {
        let mut button = Button::new((row.icon.unwrap_or(" "), row.name));
        if let Some(keys) = row.shortcut_text(ui.ctx()) {
            button = button.shortcut_text(keys);
        }
        offer(ui, row, button, row.name, state, actions);
    }
}

/// The row of buttons: icons with their names in tooltips.
pub(crate) fn toolbar(ui: &mut Ui, state: &CommandStates<'_>, actions: &mut Vec<Action>) {
    ui.horizontal_wrapped(|ui| {
        for (i, group) in BUTTONS.iter().enumerate() {
            if i > 0 {
                ui.add_space(theme::GAP * 0.5);
                ui.separator();
                ui.add_space(theme::GAP * 0.5);
            }
            for row in group.iter().map(|command| command.row()) {
                let text = theme::tool_text(row.icon.unwrap_or(row.name));
                offer(ui, row, Button::new(text), &tool_name(row), state, actions);
            }
        }
    });
}

/// "Add cloud", not "Cloud": a button has no menu around it.
fn tool_name(row: &Row) -> String {
    if row.menu == Menu::Add { format!("Add {}", row.label().to_lowercase()) } else { row.label().into() }
}

fn offer(ui: &mut Ui, row: &Row, button: Button<'_>, name: &str, state: &CommandStates<'_>, actions: &mut Vec<Action>) {
    let CommandState { enabled, on, on_what } = state(row.command);
    let response = ui.add_enabled(enabled, button.selected(on));
    name_it(ui, &response, name);
    let tooltip = |ui: &mut Ui| {
        ui.strong(name);
        ui.label(row.tooltip(ui.ctx()));
        if let Some(what) = on_what {
            ui.weak(visible::one_line(what));
        }
    };
    if response.on_hover_ui(tooltip).on_disabled_hover_ui(tooltip).clicked() {
        actions.push(Action::Command(row.command));
    }
}
