//! The command palette: any command or plugin by typing parts of its name.

use super::plugin::kind_name;
use crate::command::{Command, TABLE};
use crate::plugins::{Library, Origin};
use crate::state::{Action, CommandState};
use crate::theme;
use crate::visible;
use crate::widget::{fitted, name_it};
use cloudwright_scripts::PluginKind;
use egui::{Button, Context, Id, Key, Modal, Modifiers, ScrollArea, TextEdit};

/// What is typed and which line is chosen, while the palette is open.
#[derive(Debug, Default)]
pub(crate) struct Palette {
    typed: String,
    line: usize,
}

/// Something to choose.
struct Line<'a> {
    name: String,
    help: &'a str,
    menu: &'static str,
    icon: Option<&'static str>,
    does: Does<'a>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Does<'a> {
    Command(Command),
    Plugin(&'a Origin),
}

impl Palette {
    /// Shows it. What was chosen, or none when it was left; nothing while it stays open.
    pub(crate) fn show(
        &mut self,
        context: &Context,
        state: &dyn Fn(Command) -> CommandState,
        library: &Library,
    ) -> Option<Option<Action>> {
        let (down, up) = context.input_mut(|input| {
            let mut pressed = |key| input.consume_key(Modifiers::NONE, key);
            (pressed(Key::ArrowDown), pressed(Key::ArrowUp))
        });
        let enter = context.input(|input| input.key_pressed(Key::Enter));
        let mut chosen = None;
        let modal = Modal::new(Id::unique("palette")).frame(theme::dialog(context)).show(context, |ui| {
            fitted(ui, theme::DIALOG_WIDTH, |ui| {
                let field = ui.add(
                    TextEdit::singleline(&mut self.typed).hint_text("Type a command").desired_width(f32::INFINITY),
                );
                name_it(ui, &field, "Find a command");
                field.request_focus();
                if field.changed() {
                    self.line = 0;
                    // The field was laid out before the keys were read.
                    context.request_repaint();
                }
                let found = matches(&self.typed, library);
                self.line = (self.line + usize::from(down)).saturating_sub(usize::from(up)).min(found.len().max(1) - 1);
                ui.add_space(theme::GAP);
                ScrollArea::vertical().max_height(theme::DIALOG_LIST_HEIGHT).auto_shrink(false).show(ui, |ui| {
                    if found.is_empty() {
                        ui.weak(format!("No command matches “{}”", visible::one_line(self.typed.trim())));
                    }
                    for (line, row) in found.iter().enumerate() {
                        let mut button =
                            Button::selectable(line == self.line, (row.icon.unwrap_or(" "), row.name.as_str()));
                        let (enabled, keys) = match row.does {
                            Does::Command(command) => (state(command).enabled, command.row().shortcut_text(ui.ctx())),
                            Does::Plugin(_) => (true, None),
                        };
                        if let Some(keys) = keys {
                            button = button.shortcut_text(keys);
                        }
                        let response = ui.add_enabled(enabled, button.min_size([ui.available_width(), 0.0].into()));
                        name_it(ui, &response, &format!("{}: {}", row.menu, row.name));
                        if line == self.line && (down || up) {
                            response.scroll_to_me(None);
                        }
                        if response.on_hover_text(row.help).clicked() || (enter && line == self.line && enabled) {
                            chosen = Some(match row.does {
                                Does::Command(command) => Action::Command(command),
                                Does::Plugin(origin) => Action::Plugin(origin.clone()),
                            });
                        }
                    }
                });
            });
        });
        match chosen {
            Some(action) => Some(Some(action)),
            None => modal.should_close().then_some(None),
        }
    }
}

/// All that can be chosen, in the order of the menus, plugins by kind behind the commands.
fn lines(library: &Library) -> impl Iterator<Item = Line<'_>> {
    let commands = TABLE.iter().map(|row| Line {
        name: row.name.into(),
        help: row.help,
        menu: row.menu.name(),
        icon: row.icon,
        does: Does::Command(row.command),
    });
    let plugins = PluginKind::ALL.iter().flat_map(|kind| {
        library.of_kind(*kind).into_iter().map(|(entry, plugin)| Line {
            name: visible::one_line(&library.label(&entry.origin, plugin)) + "…",
            help: &plugin.description.sentence,
            menu: kind_name(*kind),
            icon: None,
            does: Does::Plugin(&entry.origin),
        })
    });
    commands.chain(plugins)
}

/// The lines that hold the typed words, best first: in the name's beginning, in the name, in menu or help.
fn matches<'a>(typed: &str, library: &'a Library) -> Vec<Line<'a>> {
    let typed = typed.trim().to_lowercase();
    let rank = |line: &Line<'_>| {
        let name = line.name.to_lowercase();
        if name.starts_with(&typed) {
            Some(0)
        } else if name.contains(&typed) {
            Some(1)
        } else if holds_words(&format!("{} {name} {}", line.menu, line.help).to_lowercase(), &typed) {
            Some(2)
        } else {
            None
        }
    };
    let mut found: Vec<_> = lines(library).filter_map(|line| Some((rank(&line)?, line))).collect();
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, line)| line).collect()
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
        let library = Library::read(None);
        let does = |typed: &str| matches(typed, &library).first().map(|line| line.does);
        assert_eq!(does("und"), Some(Does::Command(Command::Undo)));
        assert_eq!(does("MIRROR up"), Some(Does::Command(Command::MirrorY)));
        assert_eq!(does("scatter clouds"), Some(Does::Plugin(&Origin::Shipped("scatter_clouds"))));
        assert!(matches("tints of", &library).iter().any(|line| line.does == Does::Command(Command::GroupView)));
        assert!(matches("xyzzy", &library).is_empty());
        assert_eq!(matches("", &library).len(), TABLE.len() + library.entries().len());
    }
}
