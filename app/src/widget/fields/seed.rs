//! Seeds: any whole number, no use in dragging it. The dice roll another one, for each of several things its own.

use super::choice::check;
use super::{Change, Fields, MIXED, MIXED_DOC, name_it, row_of};
use crate::theme::{self, icon};
use cloudwright_core::property::{Refusal, Row, Value};
use cloudwright_core::random;
use egui::{DragValue, Ui};
use std::cell::Cell;

impl<T: Clone + PartialEq> Fields<'_, T> {
    /// A seed. One that may be inherited has a box to tick beneath it.
    pub(super) fn seed(&mut self, ui: &mut Ui, row: &'static Row<T>, label: &str) {
        let Some(first) = self.things.first() else { return };
        let Some(Value::Whole(before)) = self.effective(row, 0, first) else { return };
        let is_own = row.value(first, 0) != Some(Value::None);
        let mixed = self.differ(|thing| self.effective(row, 0, thing));
        let doc = row.property.doc;
        let (mut seed, typed) = (before, Cell::new(false));
        row_of(ui, self.indent(), label, doc, |ui| {
            let mut field = DragValue::new(&mut seed).speed(0.05).update_while_editing(false);
            if mixed {
                field = field.custom_formatter(|_, _| MIXED.into()).custom_parser(|text| {
                    let seed = text.trim().parse().ok();
                    typed.set(seed.is_some());
                    seed
                });
            }
            let response = ui.add_sized([theme::SEED_WIDTH, ui.spacing().interact_size.y], field);
            name_it(ui, &response, label);
            response.on_hover_text(if mixed { MIXED_DOC } else { doc });
            let dice = ui.button(icon::DICE_FIVE);
            name_it(ui, &dice, "Re-roll");
            if dice.on_hover_text("Roll another one.").clicked() {
                self.changes.push(Change::Roll(row));
            }
        });
        if seed != before || typed.get() {
            self.set(row, 0, Value::Whole(seed));
        }
        if let Some(none) = row.property.none {
            let mut own = is_own;
            let differ = self.differ(|thing| row.value(thing, 0).map(|value| Value::Flag(value != Value::None)));
            if check(
                ui,
                self.indent(),
                &format!("{label} of its own"),
                &format!("Else it is {none}."),
                differ,
                &mut own,
            ) {
                self.changes.push(Change::Own(row, own));
            }
        }
    }

    /// Gives `thing` another seed.
    pub(super) fn roll(&self, row: &Row<T>, thing: &mut T) -> Result<(), Refusal> {
        let Some(Value::Whole(seed)) = self.effective(row, 0, thing) else { return Err(Refusal::NotThere) };
        row.set(thing, 0, &Value::Whole(random::another_seed(seed)))
    }

    /// Makes the seed that `thing` has its own, or has it inherit one.
    pub(super) fn own(&self, row: &Row<T>, thing: &mut T, own: bool) -> Result<(), Refusal> {
        let seed = if own { self.effective(row, 0, thing).ok_or(Refusal::NotThere)? } else { Value::None };
        row.set(thing, 0, &seed)
    }
}
