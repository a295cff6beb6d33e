//! Which keys mean which command: the table's own, or Blender's laid over them.
//!
//! A keymap is a list of keys that come in addition to the table's. Where it takes a command's key for another one, that
//! command has it no longer.

use super::{Command, Row, TABLE};
use egui::{Context, Id, Key, KeyboardShortcut, Modifiers};
use serde::{Deserialize, Serialize};

/// Whose keys are used.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Keymap {
    /// As they stand in the table.
    #[default]
    Own,
    /// As in Blender, where it has the command.
    Blender,
}

const fn keys(modifiers: Modifiers, key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(modifiers, key)
}

/// What Blender 4's default keymap says, as far as we have the command.
const BLENDER: &[(Command, KeyboardShortcut)] = &[
    (Command::GrabPlace, keys(Modifiers::NONE, Key::G)),
    (Command::GrabTurn, keys(Modifiers::NONE, Key::R)),
    (Command::GrabSize, keys(Modifiers::NONE, Key::S)),
    (Command::GroupView, keys(Modifiers::SHIFT, Key::G)),
    (Command::ScaleTool, keys(Modifiers::SHIFT, Key::R)),
    (Command::Delete, keys(Modifiers::NONE, Key::X)),
    (Command::Duplicate, keys(Modifiers::ALT, Key::D)),
    (Command::DuplicateOwn, keys(Modifiers::SHIFT, Key::D)),
    (Command::FrameAll, keys(Modifiers::NONE, Key::Home)),
    (Command::SelectAll, keys(Modifiers::NONE, Key::A)),
    (Command::FlightStart, keys(Modifiers::SHIFT, Key::ArrowLeft)),
    (Command::FlightEnd, keys(Modifiers::SHIFT, Key::ArrowRight)),
    (Command::LookThrough, keys(Modifiers::NONE, Key::Num0)),
    (Command::QuadView, keys(Modifiers::ALT.plus(Modifiers::COMMAND), Key::Q)),
    (Command::AlignCamera, keys(Modifiers::ALT.plus(Modifiers::COMMAND), Key::Num0)),
    (Command::Solo, keys(Modifiers::NONE, Key::Slash)),
    (Command::KeyValue, keys(Modifiers::NONE, Key::I)),
    (Command::Palette, keys(Modifiers::NONE, Key::F3)),
];

impl Keymap {
    /// The one that these are switched to.
    pub fn other(self) -> Self {
        match self {
            Self::Own => Self::Blender,
            Self::Blender => Self::Own,
        }
    }

    fn over(self) -> &'static [(Command, KeyboardShortcut)] {
        match self {
            Self::Own => &[],
            Self::Blender => BLENDER,
        }
    }

    /// A command's keys, those first that are shown.
    pub(super) fn keys_of(self, row: &Row) -> impl Iterator<Item = KeyboardShortcut> + use<> {
        let command = row.command;
        let over = self.over().iter().filter(move |(of, _)| *of == command).map(|(_, keys)| *keys);
        let own = row.shortcut.filter(|own| !self.over().iter().any(|(_, keys)| keys == own));
        over.chain(own)
    }

    /// The keys that menus show.
    pub fn shown(self, command: Command) -> Option<KeyboardShortcut> {
        self.keys_of(command.row()).next()
    }

    /// All keys with their commands.
    pub(super) fn all(self) -> impl Iterator<Item = (KeyboardShortcut, &'static Row)> {
        TABLE.iter().flat_map(move |row| self.keys_of(row).map(move |keys| (keys, row)))
    }
}

/// The keymap of a window.
pub(crate) fn of(context: &Context) -> Keymap {
    context.data(|data| data.get_temp(id())).unwrap_or_default()
}

/// Uses another one from the next frame on.
pub(crate) fn choose(context: &Context, keymap: Keymap) {
    context.data_mut(|data| data.insert_temp(id(), keymap));
}

fn id() -> Id {
    Id::unique("keymap")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_commands_share_keys_and_none_that_had_some_has_lost_them() {
        for keymap in [Keymap::Own, Keymap::Blender] {
            let all: Vec<_> = keymap.all().collect();
            for (i, (keys, row)) in all.iter().enumerate() {
                for (others, other) in &all[i + 1..] {
                    assert!(keys != others, "{keymap:?}: {} and {}", row.name, other.name);
                }
            }
            for row in TABLE.iter().filter(|row| row.shortcut.is_some()) {
                let gave_up = keymap == Keymap::Blender && row.command == Command::KeyAfterLast;
                assert!(keymap.shown(row.command).is_some() || gave_up, "{keymap:?}: {}", row.name);
            }
        }
        assert_eq!(Keymap::Blender.shown(Command::Delete), Some(keys(Modifiers::NONE, Key::X)));
        assert!(Keymap::Blender.keys_of(Command::Delete.row()).count() == 2, "and the Delete key still");
        assert_eq!(Keymap::Own.shown(Command::GrabPlace), None);
    }
}
