//! Names, and numbers that nobody drags.

use super::{Fields, name_it};
use egui::{DragValue, Id, Key, TextEdit};

impl Fields<'_> {
    /// A name. It is taken over when the field is left.
    pub(in crate::panel) fn text(&mut self, label: &str, value: &mut String) {
        self.row(label, "", |values| {
            values.value(label, value, |ui, value| {
                let id: Id = ui.next_auto_id();
                let mut typed = ui.data(|data| data.get_temp(id)).unwrap_or_else(|| value.clone());
                let response = ui.add(TextEdit::singleline(&mut typed).desired_width(f32::INFINITY));
                name_it(ui, &response, label);
                if response.has_focus() {
                    ui.data_mut(|data| data.insert_temp(id, typed));
                    return false;
                }
                ui.data_mut(|data| data.remove::<String>(id));
                let kept = response.lost_focus() && !ui.input(|input| input.key_pressed(Key::Escape));
                let changed = kept && typed != *value;
                if changed {
                    *value = typed;
                }
                changed
            });
        });
    }

    /// A seed: any whole number, no use in dragging it.
    pub(in crate::panel) fn seed(&mut self, value: &mut u64) {
        const DOC: &str = "Another number strews the sprites anew.";
        self.row("Seed", DOC, |values| {
            values.value("Seed", value, |ui, value| {
                let response = ui.add(DragValue::new(value).speed(0.05).update_while_editing(false));
                name_it(ui, &response, "Seed");
                response.on_hover_text(DOC).changed()
            });
        });
    }
}
