//! Which commands' keys were pressed.

use super::{Command, Row, TABLE};

/// The commands whose keys were pressed. Keys with more modifiers are looked at first, so that undo does not take redo's.
///
/// While text is typed, plain keys and those that texts use themselves are left to it.
pub(crate) fn pressed(context: &egui::Context) -> Vec<Command> {
    let typing = context.text_edit_focused();
    let mut rows: Vec<&Row> = TABLE.iter().filter(|row| row.shortcut.is_some()).collect();
    rows.sort_by_key(|row| row.shortcut.is_some_and(|shortcut| !shortcut.modifiers.shift && !shortcut.modifiers.alt));
    context.input_mut(|input| {
        let hit = |row: &&Row| {
            let leave_to_text = typing && belongs_to_text(row);
            !leave_to_text && row.shortcut.is_some_and(|shortcut| input.consume_shortcut(&shortcut))
        };
        rows.into_iter().filter(hit).map(|row| row.command).collect()
    })
}

fn belongs_to_text(row: &Row) -> bool {
    let plain = row.shortcut.is_some_and(|shortcut| !shortcut.modifiers.command);
    plain || matches!(row.command, Command::Undo | Command::Redo | Command::Duplicate | Command::SelectAll)
}
