//! Words, taken over when the field is left.

use super::{Fields, MIXED, MIXED_DOC, name_it, row_of};
use crate::theme;
use cloudwright_core::property::{Row, Value};
use egui::{Id, Key, ScrollArea, TextEdit, TextStyle, Ui};

/// More are not taken: a window is no place to read a book in.
pub(crate) const MOST_CHARACTERS: usize = 200_000;

impl<T: Clone + PartialEq> Fields<'_, T> {
    /// Words; none may be shown as none.
    pub(super) fn text(&mut self, ui: &mut Ui, row: &'static Row<T>, label: &str, value: &Value) {
        let mixed = self.differ(|thing| row.value(thing, 0));
        let before = if let (Value::Text(text), false) = (value, mixed) { text.as_str() } else { "" };
        let mut new = None;
        row_of(ui, self.indent(), label, "", |ui| {
            let (hint, doc) = if mixed { (MIXED, MIXED_DOC) } else { ("", "") };
            new = text_field(ui, label, hint, doc, before);
        });
        if let Some(new) = new {
            self.set(row, 0, Value::Text(new));
        }
    }
}

/// A line to type in. What was typed, once the field is left and it is other words than `before`.
pub(crate) fn text_field(ui: &mut Ui, label: &str, hint: &str, doc: &str, before: &str) -> Option<String> {
    let id: Id = ui.next_auto_id();
    let mut typed = ui.data(|data| data.get_temp(id)).unwrap_or_else(|| before.to_owned());
    let response = ui.add(TextEdit::singleline(&mut typed).hint_text(hint).desired_width(f32::INFINITY));
    name_it(ui, &response, label);
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, typed));
        return None;
    }
    ui.data_mut(|data| data.remove::<String>(id));
    let kept = response.lost_focus() && !ui.input(|input| input.key_pressed(Key::Escape));
    if !doc.is_empty() {
        response.on_hover_text(doc);
    }
    (kept && typed != before).then_some(typed)
}

/// As [`text_field`], of several lines that scroll beyond `rows`; what was typed is told at once. `focused` is whether it
/// is to be typed in from this frame on.
pub(crate) fn lines_field(
    ui: &mut Ui,
    label: &str,
    [hint, doc]: [&str; 2],
    rows: usize,
    focused: bool,
    before: &str,
) -> Option<String> {
    let id: Id = ui.next_auto_id();
    // Who takes it may keep other words, such as without spaces at the end.
    let mut typed = ui.data(|data| data.get_temp(id)).unwrap_or_else(|| before.to_owned());
    let height = ui.text_style_height(&TextStyle::Monospace) * rows as f32 + 2.0 * theme::GAP;
    let field = TextEdit::multiline(&mut typed).font(TextStyle::Monospace).hint_text(hint).desired_rows(rows);
    let field = field.char_limit(MOST_CHARACTERS).desired_width(f32::INFINITY);
    let response = ScrollArea::vertical().id_salt(id).max_height(height).show(ui, |ui| ui.add(field)).inner;
    name_it(ui, &response, label);
    if focused {
        response.request_focus();
    }
    let changed = response.changed();
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, typed.clone()));
    } else {
        ui.data_mut(|data| data.remove::<String>(id));
    }
    if !doc.is_empty() {
        response.on_hover_text(doc);
    }
    changed.then_some(typed)
}
