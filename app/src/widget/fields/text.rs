//! Names, and numbers that nobody drags.

use super::{Fields, name_it};
use crate::theme::{self, icon};
use cloudwright_core::random;
use egui::{DragValue, Id, Key, TextEdit};

impl Fields<'_> {
    /// A name. It is taken over when the field is left.
    pub(crate) fn text(&mut self, label: &str, value: &mut String) {
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

    /// A seed: any whole number, no use in dragging it. The dice roll another one, for each of several things its own.
    pub(crate) fn seed(&mut self, label: &str, doc: &str, value: &mut u64) {
        self.row(label, doc, |values| {
            values.value(label, value, |ui, value| {
                let field = DragValue::new(value).speed(0.05).update_while_editing(false);
                let response = ui.add_sized([theme::SEED_WIDTH, ui.spacing().interact_size.y], field);
                name_it(ui, &response, label);
                response.on_hover_text(doc).changed()
            });
            let mut rolled = false;
            values.value("Re-roll", &mut rolled, |ui, rolled| {
                let dice = ui.button(icon::DICE_FIVE);
                name_it(ui, &dice, "Re-roll");
                *rolled = dice.on_hover_text("Roll another one.").clicked();
                *rolled
            });
            if rolled {
                *value = random::another_seed(*value);
            }
        });
    }
}
