//! The command palette: any command by typing parts of its name.

use crate::command::{Command, Row, TABLE};
use crate::panel::CommandState;
use crate::theme;
use crate::widget::name_it;
use egui::{Button, Context, Id, Key, Modal, Modifiers, ScrollArea, TextEdit};

/// What is typed and which line is chosen, while the palette is open.
#[derive(Debug, Default)]
pub(crate) struct Palette {
    typed: String,
    line: usize,
}

impl Palette {
    /// Shows it. The command that was chosen, or none when it was left; nothing while it stays open.
    pub(crate) fn show(
        &mut self,
        context: &Context,
        state: &dyn Fn(Command) -> CommandState,
    ) -> Option<Option<Command>> {
        let (down, up) = context.input_mut(|input| {
            let mut pressed = |key| input.consume_key(Modifiers::NONE, key);
            (pressed(Key::ArrowDown), pressed(Key::ArrowUp))
        });
        let enter = context.input(|input| input.key_pressed(Key::Enter));
        let mut chosen = None;
        let modal = Modal::new(Id::unique("palette")).frame(theme::dialog(context)).show(context, |ui| {
            ui.set_width(theme::DIALOG_WIDTH);
            let field =
                ui.add(TextEdit::singleline(&mut self.typed).hint_text("Type a command").desired_width(f32::INFINITY));
            name_it(ui, &field, "Find a command");
            field.request_focus();
            if field.changed() {
                self.line = 0;
                // The field was laid out before the keys were read.
                context.request_repaint();
            }
            let found = matches(&self.typed);
            self.line = (self.line + usize::from(down)).saturating_sub(usize::from(up)).min(found.len().max(1) - 1);
            ui.add_space(theme::GAP);
            ScrollArea::vertical().max_height(theme::DIALOG_LIST_HEIGHT).auto_shrink(false).show(ui, |ui| {
                for (line, row) in found.iter().enumerate() {
                    let mut button = Button::selectable(line == self.line, (row.icon.unwrap_or(" "), row.name));
                    if let Some(shortcut) = &row.shortcut {
                        button = button.shortcut_text(ui.ctx().format_shortcut(shortcut));
                    }
                    let enabled = state(row.command).enabled;
                    let response = ui.add_enabled(enabled, button.min_size([ui.available_width(), 0.0].into()));
                    name_it(ui, &response, &format!("{}: {}", row.menu.name(), row.name));
                    if line == self.line && (down || up) {
                        response.scroll_to_me(None);
                    }
                    if response.on_hover_text(row.help).clicked() || (enter && line == self.line && enabled) {
                        chosen = Some(row.command);
                    }
                }
            });
        });
        match chosen {
            Some(command) => Some(Some(command)),
            None => modal.should_close().then_some(None),
        }
    }
}

/// The rows that hold the typed words, best first: in the name's beginning, in the name, in menu or help.
fn matches(typed: &str) -> Vec<&'static Row> {
    let typed = typed.trim().to_lowercase();
    let rank = |row: &Row| {
        let name = row.name.to_lowercase();
        if name.starts_with(&typed) {
            Some(0)
        } else if name.contains(&typed) {
            Some(1)
        } else if holds_words(&format!("{} {name} {}", row.menu.name(), row.help).to_lowercase(), &typed) {
            Some(2)
        } else {
            None
        }
    };
    let mut found: Vec<_> = TABLE.iter().filter_map(|row| Some((rank(row)?, row))).collect();
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, row)| row).collect()
}

/// Whether each word of `typed` stands in `text`.
fn holds_words(text: &str, typed: &str) -> bool {
    typed.split_whitespace().all(|word| text.contains(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_by_parts_best_first() {
        assert_eq!(matches("und")[0].command, Command::Undo);
        assert_eq!(matches("MIRROR up")[0].command, Command::MirrorY);
        assert!(matches("tints of").iter().any(|row| row.command == Command::GroupView));
        assert!(matches("xyzzy").is_empty());
        assert_eq!(matches("").len(), TABLE.len());
    }
}
