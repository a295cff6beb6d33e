//! Which commands the menus at things offer: those that open at a click of the right button.

use super::Command;

/// In groups, with a line between two.
pub(crate) type Groups = &'static [&'static [Command]];

/// At a row of the outline.
pub(crate) const OUTLINE: Groups = &[
    &[Command::Rename, Command::Cut, Command::Copy, Command::Paste, Command::Duplicate, Command::DuplicateOwn],
    &[Command::Delete, Command::RemoveUnusedModels],
    &[Command::NewFolder, Command::MoveToFolder, Command::LeaveFolder, Command::SelectFolder],
    &[Command::FrameSelection, Command::Hide, Command::Lock, Command::Solo, Command::ShowAll],
    &[Command::PlaceModel, Command::AddBox, Command::LookThrough, Command::AlignCamera],
];

/// In the picture.
pub(crate) const VIEWPORT: Groups = &[
    &[Command::Cut, Command::Copy, Command::Paste, Command::Duplicate, Command::DuplicateOwn, Command::Delete],
    &[Command::FrameSelection, Command::Hide, Command::Lock, Command::Solo, Command::ShowAll],
    &[Command::AddCloud, Command::AddPreset, Command::AddBox, Command::AddCamera],
    &[Command::SelectAll, Command::SelectNone, Command::FrameAll],
];

/// At keys of the timeline.
pub(crate) const TIMELINE: Groups = &[
    &[Command::KeysStep, Command::KeysLinear, Command::KeysSmooth, Command::KeysFlat, Command::KeysFree],
    &[Command::CutKeys, Command::CopyKeys, Command::PasteKeys, Command::DuplicateKeys, Command::DeleteKeys],
    &[Command::MirrorKeys, Command::SlowKeys, Command::QuickenKeys],
    &[Command::SelectAllKeys, Command::SelectKeysBefore, Command::SelectKeysAfter],
];

/// At a panel's tab.
pub(crate) const TAB: Groups = &[
    &[
        Command::OutlinePanel,
        Command::InspectorPanel,
        Command::LevelsPanel,
        Command::GroupsPanel,
        Command::SkyPanel,
        Command::FlightPanel,
        Command::TimelinePanel,
        Command::ScriptPanel,
        Command::ChartPanel,
        Command::HistoryPanel,
        Command::ProblemsPanel,
    ],
    &[Command::ResetLayout],
];

/// All that any of them offers.
pub(crate) fn all() -> impl Iterator<Item = Command> {
    [OUTLINE, VIEWPORT, TIMELINE, TAB].into_iter().flatten().copied().flatten().copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::{Menu, TABLE};

    fn flat(groups: Groups) -> Vec<Command> {
        groups.iter().copied().flatten().copied().collect()
    }

    #[test]
    fn a_tab_offers_all_panels_and_no_menu_a_command_twice() {
        let is_panel = |command: Command| format!("{command:?}").ends_with("Panel");
        for row in TABLE.iter().filter(|row| row.menu == Menu::Window && is_panel(row.command)) {
            assert!(flat(TAB).contains(&row.command), "{}", row.name);
        }
        for all in [OUTLINE, VIEWPORT, TIMELINE, TAB].map(flat) {
            for (i, command) in all.iter().enumerate() {
                assert!(!all[i + 1..].contains(command), "{command:?}");
            }
        }
    }
}
