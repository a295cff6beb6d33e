//! Menus and toolbar: nothing but the command table.

use crate::command::{Command, Menu, Row, TABLE};
use crate::editor::Action;
use crate::theme;
use egui::{Button, Ui};

/// How a command is offered now.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CommandState {
    /// Whether it has something to work on.
    pub(crate) enabled: bool,
    /// Whether what it switches is switched on.
    pub(crate) on: bool,
}

const MENUS: [(Menu, &str); 4] = [(Menu::File, "File"), (Menu::Edit, "Edit"), (Menu::Add, "Add"), (Menu::View, "View")];

/// The row of menus.
pub(crate) fn menu_bar(ui: &mut Ui, state: &dyn Fn(Command) -> CommandState, actions: &mut Vec<Action>) {
    egui::MenuBar::new().ui(ui, |ui| {
        for (menu, title) in MENUS {
            ui.menu_button(title, |ui| {
                for row in TABLE.iter().filter(|row| row.menu == menu) {
                    let mut button = Button::new(row.name);
                    if let Some(shortcut) = &row.shortcut {
                        button = button.shortcut_text(ui.ctx().format_shortcut(shortcut));
                    }
                    offer(ui, row, button, state, actions);
                }
            });
        }
    });
}

/// The row of buttons.
pub(crate) fn toolbar(ui: &mut Ui, state: &dyn Fn(Command) -> CommandState, actions: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        for (i, (menu, title)) in MENUS.iter().enumerate() {
            if i > 0 {
                ui.add_space(theme::GAP);
                ui.separator();
                ui.add_space(theme::GAP);
            }
            for row in TABLE.iter().filter(|row| row.in_toolbar && row.menu == *menu) {
                let name = row.name.trim_end_matches('…');
                let text = if row.menu == Menu::Add { format!("{title} {}", name.to_lowercase()) } else { name.into() };
                offer(ui, row, Button::new(text), state, actions);
            }
        }
    });
}

fn offer(
    ui: &mut Ui,
    row: &Row,
    button: Button<'_>,
    state: &dyn Fn(Command) -> CommandState,
    actions: &mut Vec<Action>,
) {
    let tooltip = row.tooltip(ui.ctx());
    let CommandState { enabled, on } = state(row.command);
    let response = ui.add_enabled(enabled, button.selected(on));
    if response.on_hover_text(&tooltip).on_disabled_hover_text(&tooltip).clicked() {
        actions.push(Action::Command(row.command));
    }
}
