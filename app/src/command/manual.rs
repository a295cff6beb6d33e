//! README's manual of shortcuts, from the table.

use super::{Menu, TABLE};
use egui::{KeyboardShortcut, ModifierNames};

/// Between these lines of README.md stands the manual.
pub const MARKS: [&str; 2] = ["<!-- shortcuts: from the command table -->", "<!-- end of shortcuts -->"];

/// The commands that have keys, a Markdown table.
pub fn shortcuts() -> String {
    let mut text = String::from("| menu | command | keys | what it does |\n|---|---|---|---|\n");
    for menu in Menu::ALL {
        let rows = TABLE.iter().filter(|row| row.menu == menu);
        for (row, keys) in rows.filter_map(|row| Some((row, row.shortcut.as_ref()?))) {
            text += &format!("| {} | {} | {} | {} |\n", menu.name(), row.label(), in_words(keys), row.help);
        }
    }
    text
}

/// As on a PC's keyboard.
fn in_words(shortcut: &KeyboardShortcut) -> String {
    shortcut.format(&ModifierNames::NAMES, false)
}
