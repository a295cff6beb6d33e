//! README's manual of shortcuts, from the table.

use super::{Keymap, Menu, Row, TABLE};
use egui::{KeyboardShortcut, ModifierNames};

/// Between these lines of README.md stands the manual.
pub const MARKS: [&str; 2] = ["<!-- shortcuts: from the command table -->", "<!-- end of shortcuts -->"];

/// The commands that have keys, a Markdown table.
pub fn shortcuts() -> String {
    let mut text =
        String::from("| menu | command | keys | in Blender's keymap | what it does |\n|---|---|---|---|---|\n");
    let shown = |keymap: Keymap, row: &Row| keymap.shown(row.command).map_or_else(String::new, |keys| in_words(&keys));
    for row in Menu::ALL.iter().flat_map(|menu| TABLE.iter().filter(|row| row.menu == *menu)) {
        let [own, blender] = [Keymap::Own, Keymap::Blender].map(|keymap| shown(keymap, row));
        if own.is_empty() && blender.is_empty() {
            continue;
        }
        let other = if own == blender { "" } else { blender.as_str() };
        text += &format!("| {} | {} | {own} | {other} | {} |\n", row.menu.name(), row.label(), row.help);
    }
    text
}

/// As on a PC's keyboard.
fn in_words(shortcut: &KeyboardShortcut) -> String {
    shortcut.format(&ModifierNames::NAMES, false)
}
