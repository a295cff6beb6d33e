//! The one field for a number.

use super::{Values, name_it};
use crate::theme;
use cloudwright_core::parameter::Parameter;
use egui::{DragValue, Response, Ui};

impl Values<'_> {
    /// A number.
    pub(in crate::panel) fn number(&mut self, name: &str, parameter: &Parameter, value: &mut f64) {
        self.value(name, value, |ui, value| number_field(ui, name, parameter, value, false));
    }

    /// A whole number.
    pub(in crate::panel) fn whole(&mut self, name: &str, parameter: &Parameter, value: &mut u32) {
        self.value(name, value, |ui, value| {
            let mut number = f64::from(*value);
            let changed = number_field(ui, name, parameter, &mut number, true);
            *value = number as u32;
            changed
        });
    }
}

/// A field to drag or type in, within the parameter's range. Whether it was changed.
pub(crate) fn number_field(ui: &mut Ui, name: &str, parameter: &Parameter, value: &mut f64, whole: bool) -> bool {
    let before = *value;
    let mut field = DragValue::new(value)
        .range(parameter.min..=parameter.max)
        .clamp_existing_to_range(false)
        .update_while_editing(false)
        .speed(speed(parameter, before, whole))
        .max_decimals(if whole { 0 } else { 3 });
    if !parameter.unit.is_empty() {
        let space = if parameter.unit == "°" { "" } else { " " };
        field = field.suffix(format!("{space}{}", parameter.unit));
    }
    let response = ui.add_sized([theme::NUMBER_WIDTH, ui.spacing().interact_size.y], field);
    name_it(ui, &response, name);
    let changed = response.changed();
    describe(response, name, parameter);
    // "nan" can be typed.
    if !parameter.allows(*value) {
        *value = before;
    }
    changed && *value != before
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
        "EV" => 0.02,
        _ => ((parameter.max - parameter.min) * 0.002).min(0.01),
    }
}

fn describe(response: Response, name: &str, parameter: &Parameter) {
    response.on_hover_ui(|ui| {
        let Parameter { min, max, unit, doc, .. } = parameter;
        ui.label(format!("{name}: {doc}\n{min} to {max} {unit}").trim_end());
    });
}
