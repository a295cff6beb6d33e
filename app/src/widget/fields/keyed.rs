//! Fields of what can be keyed. They show what the tracks say at the clock's time; what is changed there becomes a key if
//! *Auto-key* is on, else the scene's value, which stays beside the track until it is keyed.

use super::key::{self, key_button, point_at};
use super::{Fields, name_with, named};
use crate::state::{Action, Reading, TimelineChange, Values};
use cloudwright_core::arrange::keys;
use cloudwright_core::document::Edit;
use cloudwright_core::property::{Owner, Refusal, Row, Target, Value};
use cloudwright_core::scene::KeyValue;
use egui::{Rect, Ui};

/// What changes of keyed values come to.
#[derive(Default)]
pub(super) struct Changed {
    /// To be keyed, and what of.
    values: Values,
    label: &'static str,
    /// Changed beside their tracks.
    unkeyed: Vec<Target>,
}

impl Changed {
    /// All of it as actions, together with other edits of the same change.
    pub(super) fn ask(
        self,
        name: &'static str,
        mut edits: Vec<Edit>,
        live: bool,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) {
        if !self.unkeyed.is_empty() {
            actions.push(Action::Timeline(TimelineChange::Unkeyed(self.unkeyed)));
        }
        if !self.values.is_empty() {
            let mut rekeyed = keys::keyed(reading.session.scene(), &self.values, reading.clock.time_s());
            rekeyed.edits.append(&mut edits);
            let name = format!("Key {}", self.label.to_lowercase());
            actions.push(Action::Keys { name, rekeyed, live, choose: false });
        } else if !edits.is_empty() {
            actions.push(Action::Change { name, edits, live });
        }
    }
}

impl<T: Clone + PartialEq> Fields<'_, T> {
    /// What is shown of the thing at that place: its track's number, or its own value.
    pub(crate) fn value(&self, row: &'static Row<T>, part: usize, at: usize) -> Option<Value> {
        let own = row.value(self.things.get(at)?, part)?;
        let keyed = self.target(row, at).and_then(|target| self.reading.keyed_number(&target, part));
        Some(keyed.map_or(own, Value::Number))
    }

    /// Whether a track says what is shown of the first thing.
    pub(super) fn is_moved(&self, row: &'static Row<T>) -> bool {
        self.target(row, 0).is_some_and(|target| self.reading.keyed_number(&target, 0).is_some())
    }

    /// Whether not all things show the same.
    pub(super) fn parts_differ(&self, row: &'static Row<T>, part: usize) -> bool {
        let mut values = (0..self.things.len()).filter_map(|at| self.value(row, part, at));
        values.next().is_some_and(|first| values.any(|other| other != first))
    }

    /// What stands before names, if diamonds do.
    pub(super) fn indent(&self) -> f32 {
        if self.owners.is_empty() { 0.0 } else { key::WIDTH }
    }

    /// What a track of the thing at that place would move; none if none can.
    fn target(&self, row: &'static Row<T>, at: usize) -> Option<Target> {
        let owner: Owner = *self.owners.get(at)?;
        row.property.keyed.then_some(Target { owner, property: &row.property })
    }

    /// What would be keyed of all things.
    pub(super) fn values(&self, row: &'static Row<T>) -> Values {
        let value = |at: usize| Some((self.target(row, at)?, self.key_value(row, at)?));
        (0..self.things.len()).filter_map(value).collect()
    }

    fn key_value(&self, row: &'static Row<T>, at: usize) -> Option<KeyValue> {
        let number = |part| match self.value(row, part, at)? {
            Value::Number(number) => Some(number),
            _ => None,
        };
        match row.property.parts.names().len() {
            1 => Some(KeyValue::One(number(0)?)),
            3 => Some(KeyValue::Three([number(0)?, number(1)?, number(2)?])),
            _ => None,
        }
    }

    /// Sets a part of the thing at that place, or has it keyed.
    pub(super) fn set_in(
        &self,
        thing: &mut T,
        at: usize,
        (row, part, value): (&'static Row<T>, usize, &Value),
        changed: &mut Changed,
    ) -> Result<(), Refusal> {
        let target = self.target(row, at).filter(|target| self.reading.has_track(target));
        let (Some(target), Value::Number(number)) = (target, value) else { return row.set(thing, part, value) };
        if self.reading.view.timeline.auto_key {
            let known = changed.values.iter().position(|(each, _)| *each == target);
            let at = known.or_else(|| {
                changed.values.push((target, self.key_value(row, at)?));
                Some(changed.values.len() - 1)
            });
            if let Some((_, keyed)) = at.and_then(|at| changed.values.get_mut(at)) {
                keyed.parts_mut()[part] = *number;
                changed.label = row.property.label;
            }
            return Ok(());
        }
        // The other parts are shown as their track has them, and stay so.
        for other in (0..target.parts()).filter(|other| *other != part) {
            if let Some(shown) = self.value(row, other, at) {
                row.set(thing, other, &shown)?;
            }
        }
        changed.unkeyed.push(target);
        row.set(thing, part, value)
    }

    /// A row's name behind its diamond.
    pub(super) fn name_with_key(&mut self, ui: &mut Ui, label: &str, doc: &str, values: &Values) {
        if values.is_empty() {
            return named(ui, self.indent(), label, doc);
        }
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 5.0;
            self.asked.extend(key_button(ui, label, values, self.reading));
            name_with(ui, label, doc);
        });
    }

    /// *Key this value* means the row that the pointer is at.
    pub(super) fn note_pointer(&self, ui: &Ui, numbers: Rect, label: &str, values: &Values) {
        if !values.is_empty() {
            let row = Rect::from_min_max(egui::pos2(ui.max_rect().left(), numbers.top()), numbers.max);
            point_at(ui, row, label, values);
        }
    }
}
