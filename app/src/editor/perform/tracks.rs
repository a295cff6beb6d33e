//! Whole tracks, by command: what they do beyond their keys, and those of the selection taken out.

use crate::command::Command;
use crate::editor::Editor;
use cloudwright_core::arrange::keys;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::{Beyond, Track};

impl Editor {
    /// The chosen tracks hold, repeat or swing, before their keys or after: each time the next of the three.
    pub(super) fn cycle_ends(&mut self, command: Command) {
        let of = |track: &Track| if command == Command::EndsBefore { track.before } else { track.after };
        let tracks: Vec<&Track> = self.chosen_tracks().collect();
        let Some(next) = tracks.first().map(|first| next(of(first))) else { return };
        let with = |track: &&Track| {
            let mut track = (*track).clone();
            *(if command == Command::EndsBefore { &mut track.before } else { &mut track.after }) = next;
            Edit::Track(ListEdit::Replace(track))
        };
        let edits = tracks.iter().map(with).collect();
        self.change(command.row().label(), edits, false);
    }

    /// Nothing of what is selected moves by keys any more.
    pub(super) fn clear_keys(&mut self) {
        let rekeyed = keys::cleared_of(self.session.scene(), self.view.selection.items());
        self.change_keys(Command::ClearKeys.row().label(), rekeyed, false, false);
    }

    /// Whether anything of what is selected has keys.
    pub(super) fn selection_has_keys(&self) -> bool {
        let items = self.view.selection.items();
        !items.is_empty() && !keys::cleared_of(self.session.scene(), items).edits.is_empty()
    }

    fn chosen_tracks(&self) -> impl Iterator<Item = &Track> {
        let chosen = &self.view.timeline.tracks;
        self.session.scene().tracks.iter().filter(|track| chosen.contains(&track.id))
    }
}

fn next(beyond: Beyond) -> Beyond {
    match beyond {
        Beyond::Hold => Beyond::Repeat,
        Beyond::Repeat => Beyond::Swing,
        Beyond::Swing => Beyond::Hold,
    }
}
