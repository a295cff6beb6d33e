//! Layouts of the panels by their names: one to be given, or one to be chosen.

use super::{buttons, window};
use crate::theme::{self, icon};
use crate::visible;
use crate::widget::name_it;
use egui::{Align, Button, Context, Key, Layout, ScrollArea, TextEdit, Ui};

/// Of a name, characters.
pub(in crate::editor) const LONGEST_NAME: usize = 60;

/// Some(None) if the user changed their mind.
pub(super) fn name(context: &Context, name: &mut String) -> Option<Option<String>> {
    window(context, theme::DIALOG_WIDTH, "Save layout as", None, |ui| {
        ui.label("Where the panels are now is kept under this name. One that has it already is replaced.");
        let label = ui.label("Name");
        let field = TextEdit::singleline(name).char_limit(LONGEST_NAME).desired_width(f32::INFINITY);
        let field = ui.add(field).labelled_by(label.id);
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        // Typing can begin at once.
        if ui.memory(|memory| memory.focused().is_none()) {
            field.request_focus();
        }
        let given = (!name.trim().is_empty()).then(|| name.trim().to_owned());
        let done = buttons(ui, |ui| {
            let go = ui.add_enabled(given.is_some(), Button::new("Keep layout")).clicked();
            let cancel = ui.button("Cancel").clicked();
            if go { Some(given.clone()) } else { cancel.then_some(None) }
        });
        done.or((entered && given.is_some()).then_some(given))
    })
}

/// What becomes of a layout.
pub(super) enum Choice {
    Use(String),
    Delete(String),
    Close,
}

pub(super) fn choose<'a>(context: &Context, names: impl Iterator<Item = &'a String>) -> Option<Choice> {
    window(context, theme::DIALOG_WIDTH, "Layouts", Choice::Close, |ui| {
        let mut chosen = None;
        ScrollArea::vertical().max_height(theme::DIALOG_LIST_HEIGHT).show(ui, |ui| {
            for name in names {
                chosen = row(ui, name).or(chosen.take());
            }
        });
        chosen.or(buttons(ui, |ui| ui.button("Done").clicked().then_some(Choice::Close)))
    })
}

fn row(ui: &mut Ui, name: &str) -> Option<Choice> {
    let shown = visible::one_line(name);
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let delete = ui.button(icon::TRASH);
        name_it(ui, &delete, &format!("Delete layout {shown}"));
        let size = egui::vec2(ui.available_width(), 0.0);
        let used = ui.add(Button::new(shown.as_str()).truncate().min_size(size));
        name_it(ui, &used, &format!("Use layout {shown}"));
        let delete = delete.on_hover_text("Delete it").clicked().then(|| Choice::Delete(name.into()));
        delete.or(used.clicked().then(|| Choice::Use(name.into())))
    })
    .inner
}
