//! All changes, oldest first, with the present marked; a click goes there.
//!
//! Only the lines in sight are laid out, so a long history costs no more than a short one. When the present moves out of
//! sight the list follows it.

use crate::state::{Action, Reading};
use crate::theme::icon;
use crate::widget::name_it;
use egui::{Button, Id, RichText, ScrollArea, Ui};

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let history = reading.session.document().history();
    let (present, saved_at) = (history.done_count(), history.saved_at());
    let height = ui.spacing().interact_size.y;
    let mut area = ScrollArea::vertical().auto_shrink(false);
    if has_moved(ui, (present, history.len())) {
        let middle = present as f32 * (height + ui.spacing().item_spacing.y) - ui.available_height() * 0.5;
        area = area.vertical_scroll_offset(middle.max(0.0));
    }
    area.show_rows(ui, height, history.len() + 1, |ui, lines| {
        // The first line is the state before all changes.
        let names = std::iter::once("As opened").chain(history.names());
        for (count, name) in names.enumerate().take(lines.end).skip(lines.start) {
            let mark = if saved_at == Some(count) { icon::FLOPPY_DISK } else { " " };
            let text = if count > present { RichText::new(name).weak() } else { RichText::new(name) };
            let button = Button::selectable(count == present, (text, egui::Atom::grow(), RichText::new(mark).weak()));
            // All lines are of one height: a long name is read whole beside the pointer.
            let button = button.truncate();
            let response = ui.add_sized([ui.available_width(), height], button);
            name_it(ui, &response, &format!("History {count}: {name}"));
            let tip = match count.cmp(&present) {
                std::cmp::Ordering::Less => "Undo back to here",
                std::cmp::Ordering::Equal => "The present",
                std::cmp::Ordering::Greater => "Redo up to here",
            };
            if response.on_hover_text(format!("{name}\n{tip}")).clicked() && count != present {
                actions.push(Action::JumpTo(count));
            }
        }
    });
}

/// Whether this is another place in the history than in the last frame.
fn has_moved(ui: &Ui, place: (usize, usize)) -> bool {
    ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or(Id::unique("history place"), place), place) != place)
}
