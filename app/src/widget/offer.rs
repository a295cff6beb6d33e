//! A command as a button, and menus of such at things.

use super::name_it;
use crate::command::{Command, Row, context::Groups};
use crate::state::{CommandState, Offered};
use crate::visible;
use egui::{Button, Response, Ui};

/// A button that does a command, with what it does and its keys in the tooltip. Whether it was pressed.
pub(crate) fn offer(ui: &mut Ui, row: &Row, button: Button<'_>, name: &str, state: CommandState) -> bool {
    let CommandState { enabled, on, on_what } = state;
    let response = ui.add_enabled(enabled, button.selected(on));
    name_it(ui, &response, name);
    let tooltip = |ui: &mut Ui| {
        ui.strong(name);
        ui.label(row.tooltip(ui.ctx()));
        if let Some(what) = &on_what {
            ui.weak(visible::one_line(what));
        }
    };
    response.on_hover_ui(tooltip).on_disabled_hover_ui(tooltip).clicked()
}

/// A line of a menu. Whether it was pressed.
pub(crate) fn menu_line(ui: &mut Ui, row: &Row, state: CommandState) -> bool {
    let mut button = Button::new((row.icon.unwrap_or(" "), row.name));
    if let Some(keys) = row.shortcut_text(ui.ctx()) {
        button = button.shortcut_text(keys);
    }
    offer(ui, row, button, row.name, state)
}

/// The menu of a click with the right button. What was chosen in it.
pub(crate) fn context_menu(response: &Response, groups: Groups, offered: &Offered) -> Option<Command> {
    let mut chosen = None;
    response.context_menu(|ui| {
        for (i, group) in groups.iter().enumerate() {
            if i > 0 {
                ui.separator();
            }
            for command in *group {
                if menu_line(ui, command.row(), offered.of(*command)) {
                    chosen = Some(*command);
                }
            }
        }
    });
    chosen
}
