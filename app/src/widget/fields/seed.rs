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
            let mut field = DragValue::new(&mut seed);
            if mixed {
                field = field.custom_formatter(|_, _| MIXED.into()).custom_parser(|text| {
                    let seed = text.trim().parse().ok();
                    typed.set(seed.is_some());
                    seed
                });
            }
            if field_with_dice(ui, label, "Re-roll", if mixed { MIXED_DOC } else { doc }, field) {
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

/// A seed: to be typed, or rolled. Whether it is another one.
pub(crate) fn seed_field(ui: &mut Ui, label: &str, dice: &str, doc: &str, seed: &mut u64) -> bool {
    let before = *seed;
    // Scripts and files count seeds with a sign.
    let field = DragValue::new(seed).range(0..=i64::MAX as u64);
    if field_with_dice(ui, label, dice, doc, field) {
        *seed = random::another_seed(before);
    }
    *seed != before
}

/// Whether the dice were clicked.
fn field_with_dice(ui: &mut Ui, label: &str, dice: &str, doc: &str, field: DragValue<'_>) -> bool {
    let field = field.speed(0.05).update_while_editing(false);
    let response = ui.add_sized([theme::SEED_WIDTH, ui.spacing().interact_size.y], field);
    name_it(ui, &response, label);
    if !doc.is_empty() {
        response.on_hover_text(doc);
    }
    let button = ui.button(icon::DICE_FIVE);
    name_it(ui, &button, dice);
    button.on_hover_text("Roll another one.").clicked()
}
