//! The one field for a number.

use super::{Values, name_it, refusal};
use crate::theme;
use cloudwright_core::parameter::Parameter;
use egui::{DragValue, Response, Ui};
use std::cell::Cell;

impl Values<'_> {
    /// A number.
    pub(crate) fn number(&mut self, name: &str, parameter: &Parameter, value: &mut f64) {
        self.value(name, value, |ui, value| number_field(ui, name, parameter, value, false));
    }

    /// A whole number.
    pub(crate) fn whole(&mut self, name: &str, parameter: &Parameter, value: &mut u32) {
        self.value(name, value, |ui, value| {
            let mut number = f64::from(*value);
            let changed = number_field(ui, name, parameter, &mut number, true);
            *value = number as u32;
            changed
        });
    }
}

/// A field to drag or type in, within the parameter's range. Whether it was changed.
///
/// What is typed and lies outside is not taken: the field keeps its value and says for a while which range it has.
pub(crate) fn number_field(ui: &mut Ui, name: &str, parameter: &Parameter, value: &mut f64, whole: bool) -> bool {
    let before = *value;
    let refused = Cell::new(None);
    let mut field = DragValue::new(value)
        .range(parameter.min..=parameter.max)
        .clamp_existing_to_range(false)
        .update_while_editing(false)
        .custom_parser(|text| {
            let typed = typed_number(text, parameter.unit)?;
            if !parameter.allows(typed) {
                refused.set(Some(typed));
            }
            parameter.allows(typed).then_some(typed)
        })
        .speed(speed(parameter, before, whole))
        .max_decimals(if whole { 0 } else { 3 });
    if !parameter.unit.is_empty() {
        let space = if parameter.unit == "°" { "" } else { " " };
        field = field.suffix(format!("{space}{}", parameter.unit));
    }
    let response = ui.add_sized([theme::NUMBER_WIDTH, ui.spacing().interact_size.y], field);
    name_it(ui, &response, name);
    // Screen readers hand values over as they are.
    if !parameter.allows(*value) {
        refused.set(Some(*value));
        *value = before;
    }
    if let Some(typed) = refused.get() {
        refusal::tell(ui, &response, format!("{typed} is outside {}", range_of(parameter)));
    }
    let changed = response.changed() && *value != before;
    if !refusal::show(ui, &response, changed) {
        describe(response, name, parameter);
    }
    changed
}

/// A number as people type it, with its unit or without.
fn typed_number(text: &str, unit: &str) -> Option<f64> {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).map(|c| if c == '−' { '-' } else { c }).collect();
    text.strip_suffix(unit).unwrap_or(&text).parse().ok()
}

fn range_of(parameter: &Parameter) -> String {
    let Parameter { min, max, unit, .. } = parameter;
    format!("{min} to {max} {unit}").trim_end().into()
}

/// What a point of dragging changes: a length by its own size, anything else by its range.
fn speed(parameter: &Parameter, value: f64, whole: bool) -> f64 {
    if whole {
        return 0.25;
    }
    match parameter.unit {
        "m" => (value.abs() * 0.01).clamp(0.1, 1e4),
        "°" => 0.5,
        "h" => 0.02,
        "s" | "km/h" | "kt" => (value.abs() * 0.01).clamp(0.05, 100.0),
        "EV" => 0.02,
        _ => ((parameter.max - parameter.min) * 0.002).min(0.01),
    }
}

fn describe(response: Response, name: &str, parameter: &Parameter) {
    response.on_hover_ui(|ui| {
        ui.label(format!("{name}: {}\n{}", parameter.doc, range_of(parameter)));
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
