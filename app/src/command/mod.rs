//! The command table: every action once, with its name, help and shortcut.
//!
//! Menus, toolbar and tooltips read it. A new command is a row here and an arm in the editor.

use egui::{Key, KeyboardShortcut, Modifiers};

/// Something that the user can have done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Command {
    /// Start over.
    New,
    /// Read a scene.
    Open,
    /// Choose among the scenes that were open last.
    OpenRecent,
    /// Write the scene.
    Save,
    /// Write the scene under another name.
    SaveAs,
    /// Read the scene's file again.
    Revert,
    /// Leave.
    Quit,
    /// One step back.
    Undo,
    /// One step forward.
    Redo,
    /// A new model with a box, placed where the view looks.
    AddCloud,
    /// Another placement of the selected model.
    PlaceModel,
    /// A box in the selected model.
    AddBox,
    /// A camera where the view is.
    AddCamera,
    /// Another one like the selection.
    Duplicate,
    /// Takes the selection out.
    Delete,
    /// Brings the selection into view.
    FrameSelection,
    /// Brings all clouds into view.
    FrameAll,
    /// Shows or hides the outlines of all boxes.
    ShowBoxes,
    /// Dark or light.
    SwitchTheme,
}

/// In which menu a command stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Menu {
    /// Scenes on disk.
    File,
    /// History and selection.
    Edit,
    /// New things.
    Add,
    /// How it is looked at.
    View,
}

/// A row of the table.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// Which command.
    pub command: Command,
    /// As in menus.
    pub name: &'static str,
    /// One sentence for the tooltip.
    pub help: &'static str,
    /// Keys; none for a rare one.
    pub shortcut: Option<KeyboardShortcut>,
    /// Where it stands.
    pub menu: Menu,
    /// Whether it has a button of its own; a gap is left between buttons of different menus.
    pub in_toolbar: bool,
}

const fn keys(modifiers: Modifiers, key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(modifiers, key))
}

const fn row(
    command: Command,
    name: &'static str,
    help: &'static str,
    shortcut: Option<KeyboardShortcut>,
    menu: Menu,
    in_toolbar: bool,
) -> Row {
    Row { command, name, help, shortcut, menu, in_toolbar }
}

const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

/// All commands, in the order of the menus.
pub const TABLE: &[Row] = &[
    row(Command::New, "New", "Start a new scene", keys(CTRL, Key::N), Menu::File, true),
    row(Command::Open, "Open…", "Open a scene file", keys(CTRL, Key::O), Menu::File, true),
    row(
        Command::OpenRecent,
        "Open recent…",
        "Open one of the last ten scenes",
        keys(CTRL_SHIFT, Key::O),
        Menu::File,
        false,
    ),
    row(Command::Save, "Save", "Save the scene", keys(CTRL, Key::S), Menu::File, true),
    row(Command::SaveAs, "Save as…", "Save under another name", keys(CTRL_SHIFT, Key::S), Menu::File, false),
    row(Command::Revert, "Revert…", "Go back to the scene as it was last saved", None, Menu::File, false),
    row(Command::Quit, "Quit", "Close the editor", keys(CTRL, Key::Q), Menu::File, false),
    row(Command::Undo, "Undo", "Take the last change back", keys(CTRL, Key::Z), Menu::Edit, true),
    row(Command::Redo, "Redo", "Bring an undone change again", keys(CTRL_SHIFT, Key::Z), Menu::Edit, true),
    row(Command::Duplicate, "Duplicate", "Add another one like the selection", keys(CTRL, Key::D), Menu::Edit, false),
    row(
        Command::Delete,
        "Delete",
        "Take the selection out of the scene",
        keys(Modifiers::NONE, Key::Delete),
        Menu::Edit,
        false,
    ),
    row(Command::AddCloud, "Cloud", "Add a cloud with a model of its own where the view looks", None, Menu::Add, true),
    row(Command::PlaceModel, "Placement", "Place the selected model again", None, Menu::Add, false),
    row(
        Command::AddBox,
        "Box",
        "Add a box of sprites to the selected model",
        keys(Modifiers::NONE, Key::B),
        Menu::Add,
        true,
    ),
    row(Command::AddCamera, "Camera", "Add a camera that sees what the view sees", None, Menu::Add, true),
    row(
        Command::FrameSelection,
        "Frame selection",
        "Bring the selection into view",
        keys(Modifiers::NONE, Key::F),
        Menu::View,
        true,
    ),
    row(Command::FrameAll, "Frame all", "Bring all clouds into view", keys(Modifiers::NONE, Key::A), Menu::View, false),
    row(
        Command::ShowBoxes,
        "Show all boxes",
        "Show or hide the outlines of all boxes",
        keys(Modifiers::SHIFT, Key::B),
        Menu::View,
        true,
    ),
    row(Command::SwitchTheme, "Dark or light", "Switch between the dark and the light look", None, Menu::View, false),
];

impl Command {
    /// Its row.
    pub fn row(self) -> &'static Row {
        // The test below sees to it that each has one; the first stands in.
        TABLE.iter().find(|row| row.command == self).unwrap_or(&TABLE[0])
    }
}

impl Row {
    /// Help and keys, for tooltips.
    pub fn tooltip(&self, context: &egui::Context) -> String {
        match &self.shortcut {
            Some(shortcut) => format!("{} ({})", self.help, context.format_shortcut(shortcut)),
            None => self.help.into(),
        }
    }

    /// Whether its keys are also letters, which belong to a text that is being typed.
    pub fn is_typing(&self) -> bool {
        self.shortcut.is_some_and(|shortcut| !shortcut.modifiers.command)
    }
}

/// The commands whose keys were pressed. Keys with more modifiers are looked at first, so that undo does not take redo's.
pub fn pressed(context: &egui::Context) -> Vec<Command> {
    let typing = context.text_edit_focused();
    let mut rows: Vec<&Row> = TABLE.iter().filter(|row| row.shortcut.is_some()).collect();
    rows.sort_by_key(|row| row.shortcut.is_some_and(|shortcut| !shortcut.modifiers.shift));
    context.input_mut(|input| {
        let hit = |row: &&Row| {
            let history = matches!(row.command, Command::Undo | Command::Redo | Command::Duplicate);
            let leave_to_text = typing && (row.is_typing() || history);
            !leave_to_text && row.shortcut.is_some_and(|shortcut| input.consume_shortcut(&shortcut))
        };
        rows.into_iter().filter(hit).map(|row| row.command).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_rows_share_a_command_or_keys() {
        for (i, a) in TABLE.iter().enumerate() {
            for b in &TABLE[i + 1..] {
                assert_ne!(a.command, b.command);
                assert!(a.shortcut.is_none() || a.shortcut != b.shortcut, "{} and {}", a.name, b.name);
            }
            assert_eq!(a.command.row().name, a.name);
        }
    }
}
