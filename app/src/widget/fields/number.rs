//! The one field for a number.

use super::{Fields, MIXED, MIXED_DOC, name_it, refusal};
use crate::theme;
use cloudwright_core::property::{Kind, Number, Parts, Row, Value};
use egui::{DragValue, Response, Ui};
use std::cell::Cell;

impl<T: Clone + PartialEq> Fields<'_, T> {
    /// A number, or several that belong together.
    pub(super) fn numbers(&mut self, ui: &mut Ui, row: &'static Row<T>, label: &str) {
        let property = &row.property;
        let Some(number) = property.kind.number() else { return };
        let whole = matches!(property.kind, Kind::Integer(_));
        let values = self.values(row);
        self.name_with_key(ui, label, property.doc, &values);
        let numbers = ui.horizontal(|ui| {
            for (part, part_label) in property.parts.labels().iter().enumerate() {
                if part > 0 && property.parts == Parts::Ends {
                    ui.label("to");
                }
                let Some(Value::Number(mut value)) = self.value(row, part, 0) else { continue };
                if self.is_moved(row) {
                    value = in_short(value);
                }
                let mixed = self.parts_differ(row, part);
                let name = format!("{label} {part_label}");
                if field(ui, name.trim_end(), &Span { whole, ..number.into() }, &mut value, mixed) {
                    self.set(row, part, Value::Number(if whole { value.trunc() } else { value }));
                }
            }
        });
        self.note_pointer(ui, numbers.response.rect, label, &values);
        ui.end_row();
    }
}

/// What a number means and may be, as its field needs to know: of the core's [`Number`], or of what a plugin says.
#[derive(Clone, Copy)]
pub(crate) struct Span<'a> {
    pub(crate) unit: &'a str,
    pub(crate) min: f64,
    pub(crate) max: f64,
    /// One sentence for the artist.
    pub(crate) doc: &'a str,
    /// Without decimals.
    pub(crate) whole: bool,
    /// How far one notch goes; none: as the range or the unit suggests.
    pub(crate) step: Option<f64>,
}

impl<'a> From<&'a Number> for Span<'a> {
    fn from(&Number { unit, min, max, doc, .. }: &'a Number) -> Self {
        Self { unit, min, max, doc, whole: false, step: None }
    }
}

/// Beyond this, both ways, a range is none worth telling.
pub(crate) const ENDLESS: f64 = 1e12;

/// A field to drag or type in, within the number's range. Whether it was changed.
///
/// What is typed and lies outside is not taken: the field keeps its value and says for a while which range it has.
pub(crate) fn number_field(ui: &mut Ui, name: &str, number: &Number, value: &mut f64, whole: bool) -> bool {
    field(ui, name, &Span { whole, ..number.into() }, value, false)
}

/// As [`number_field`], for a number that the core does not know.
pub(crate) fn span_field(ui: &mut Ui, name: &str, span: &Span<'_>, value: &mut f64) -> bool {
    field(ui, name, span, value, false)
}

/// What a track makes of a number, without digits that nobody reads.
fn in_short(value: f64) -> f64 {
    let parts = if value.abs() >= 1000.0 { 1.0 } else { 10_f64.powi(decimals(value, "") as i32) };
    (value * parts).round() / parts
}

/// How many decimals of a number are shown: 825.8, 12.34, 0.125; of a time all that tell frames apart.
fn decimals(value: f64, unit: &str) -> usize {
    match (unit, value.abs()) {
        ("s" | "h", _) => 3,
        (_, 100.0..) => 1,
        (_, 10.0..) => 2,
        _ => 3,
    }
}

/// The field of a number. One that is `mixed` stands for several that differ, and shows none.
fn field(ui: &mut Ui, name: &str, span: &Span<'_>, value: &mut f64, mixed: bool) -> bool {
    let before = *value;
    let shown = if span.whole { 0 } else { decimals(before, span.unit) };
    let refused = Cell::new(None);
    // Of mixed values, the one that is shown may be typed to be had by all.
    let taken = Cell::new(false);
    let mut field = DragValue::new(value)
        .range(span.min..=span.max)
        .clamp_existing_to_range(false)
        .update_while_editing(false)
        .custom_parser(|text| {
            let typed = typed_number(text, span.unit)?;
            // Who leaves the field as it reads has not rounded it.
            let typed = if format!("{before:.shown$}").parse() == Ok(typed) { before } else { typed };
            let is_allowed = span.allows(typed);
            if !is_allowed {
                refused.set(Some(typed));
            }
            taken.set(is_allowed);
            is_allowed.then_some(typed)
        })
        .speed(span.speed(before))
        .max_decimals(shown);
    if mixed {
        field = field.custom_formatter(|_, _| MIXED.into());
    } else if !span.unit.is_empty() {
        let space = if span.unit == "°" { "" } else { " " };
        field = field.suffix(format!("{space}{}", span.unit));
    }
    let response = ui.add_sized([theme::NUMBER_WIDTH, ui.spacing().interact_size.y], field);
    name_it(ui, &response, name);
    // Screen readers hand values over as they are.
    if !span.allows(*value) {
        refused.set(Some(*value));
        *value = before;
    }
    if let Some(typed) = refused.get() {
        refusal::tell(ui, &response, format!("{typed} is outside {}", span.range()));
    }
    let changed = response.changed() && *value != before || mixed && taken.get();
    if !refusal::show(ui, &response, changed) {
        describe(response, name, span, mixed);
    }
    changed
}

/// A number as people type it, with its unit or without.
fn typed_number(text: &str, unit: &str) -> Option<f64> {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).map(|c| if c == '−' { '-' } else { c }).collect();
    text.strip_suffix(unit).unwrap_or(&text).parse().ok()
}

impl Span<'_> {
    fn allows(&self, value: f64) -> bool {
        value >= self.min && value <= self.max
    }

    /// In words: "1 to 60 s"; none of what has no end.
    fn range(&self) -> String {
        let Self { min, max, unit, .. } = self;
        if *min <= -ENDLESS && *max >= ENDLESS {
            return String::new();
        }
        format!("{min} to {max} {unit}").trim_end().into()
    }

    /// What a point of dragging changes: a length by its own size, anything else by its range.
    fn speed(&self, value: f64) -> f64 {
        if let Some(step) = self.step.filter(|_| !self.whole) {
            return step * 0.25;
        }
        match self.unit {
            _ if self.whole => 0.25,
            "m" | "ft" => (value.abs() * 0.01).clamp(0.1, 1e4),
            "°" => 0.5,
            "h" => 0.02,
            "s" | "km/h" | "kt" => (value.abs() * 0.01).clamp(0.05, 100.0),
            "EV" => 0.02,
            _ => ((self.max - self.min) * 0.002).min(0.01),
        }
    }
}

fn describe(response: Response, name: &str, span: &Span<'_>, mixed: bool) {
    response.on_hover_ui(|ui| {
        if mixed {
            ui.label(MIXED_DOC);
        }
        let words = if span.doc.is_empty() { name.into() } else { format!("{name}: {}", span.doc) };
        ui.label(format!("{words}\n{}", span.range()).trim_end());
    });
}

#[cfg(test)]
mod tests {
    use super::typed_number;

    #[test]
    fn numbers_as_people_type_them() {
        for (text, unit, want) in [
            ("12.5", "m", Some(12.5)),
            (" −3 ", "", Some(-3.0)),
            ("200 m", "m", Some(200.0)),
            ("45°", "°", Some(45.0)),
            ("1 000", "", Some(1000.0)),
            ("", "m", None),
            ("m", "m", None),
            ("a lot", "", None),
        ] {
            assert_eq!(typed_number(text, unit), want, "{text}");
        }
    }
}
