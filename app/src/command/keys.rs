//! Which commands' keys were pressed.

use super::{Command, Row, keymap};
use egui::text_selection::LabelSelectionState;
use egui::{Context, Event, Id, KeyboardShortcut, Response};

/// The commands whose keys were pressed. Keys with more modifiers are looked at first, so that undo does not take redo's.
///
/// While text is typed, plain keys and those that texts use themselves are left to it.
pub(crate) fn pressed(context: &Context) -> Vec<Command> {
    let typing = context.text_edit_focused();
    let focused = context.memory(|memory| memory.focused());
    let delete_is_taken = focused.is_some() && focused == context.data(|data| data.get_temp(owner_of_delete()));
    let mut all: Vec<(KeyboardShortcut, &Row)> = keymap::of(context).all().collect();
    all.sort_by_key(|(keys, _)| !keys.modifiers.shift && !keys.modifiers.alt);
    let in_timeline = timeline_has_keys(context);
    let of_text = typing || has_selected_text(context);
    context.input_mut(|input| {
        // Where the system has its own words for these keys, it says them in the place of the keys.
        let cut_or_copy: Vec<Command> = input.events.iter().filter(|_| !of_text).filter_map(cut_or_copy).collect();
        let hit = |(keys, row): &(KeyboardShortcut, &Row)| {
            let leave = (typing && belongs_to_text(*keys, row)) || (delete_is_taken && row.command == Command::Delete);
            !leave && input.consume_shortcut(keys)
        };
        let commands = all.into_iter().filter(hit).map(|(_, row)| row.command).chain(cut_or_copy);
        commands.map(|command| if in_timeline { command.in_timeline() } else { command }).collect()
    })
}

/// What came from the clipboard.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Pasted {
    /// Words.
    Text(String),
    /// An image.
    Picture,
}

/// What came from the clipboard and is not for a field that is typed in.
pub(crate) fn pasted(context: &Context) -> Option<Pasted> {
    if context.text_edit_focused() {
        return None;
    }
    let of = |event: &Event| match event {
        Event::Paste(text) => Some(Pasted::Text(text.clone())),
        Event::PasteImage(_) => Some(Pasted::Picture),
        _ => None,
    };
    context.input(|input| input.events.iter().find_map(of))
}

fn cut_or_copy(event: &Event) -> Option<Command> {
    match event {
        Event::Cut => Some(Command::Cut),
        Event::Copy => Some(Command::Copy),
        _ => None,
    }
}

/// Whether words of a label are marked, which copying then means.
fn has_selected_text(context: &Context) -> bool {
    context.plugin::<LabelSelectionState>().lock().has_selection()
}

/// In the frame to come, keys that select, delete and the like are about the timeline's keys.
pub(crate) fn give_keys_to_timeline(context: &Context) {
    let frame = context.cumulative_frame_nr();
    context.data_mut(|data| data.insert_temp(owner_of_keys(), frame));
}

fn timeline_has_keys(context: &Context) -> bool {
    let given: Option<u64> = context.data(|data| data.get_temp(owner_of_keys()));
    given.is_some_and(|frame| frame + 1 >= context.cumulative_frame_nr())
}

fn owner_of_keys() -> Id {
    Id::unique("timeline has the keys")
}

/// While `handle` has the focus, Delete is its own and not the selection's.
pub(crate) fn delete_belongs_to(context: &Context, handle: &Response) {
    if handle.has_focus() {
        context.data_mut(|data| data.insert_temp(owner_of_delete(), handle.id));
    }
}

fn owner_of_delete() -> Id {
    Id::unique("owner of the Delete key")
}

fn belongs_to_text(keys: KeyboardShortcut, row: &Row) -> bool {
    let plain = !keys.modifiers.command;
    let edits = matches!(
        row.command,
        Command::Undo
            | Command::Redo
            | Command::Duplicate
            | Command::SelectAll
            | Command::Cut
            | Command::Copy
            | Command::Paste
    );
    // To the beginning and the end of the text.
    let moves = matches!(row.command, Command::MarkIn | Command::MarkOut);
    plain || edits || moves
}
