//! A colour with its brightness beside it: the picker shows sRGB, which ends at white.

use super::{Fields, MIXED, MIXED_DOC, number_field, picker};
use cloudwright_core::color::{Rgb, Rgba, linear_from_srgb, srgb_from_linear};
use cloudwright_core::property::{self, Number, Row, Value};
use egui::{Color32, Ui};

impl<T: Clone + PartialEq> Fields<'_, T> {
    /// A colour to pick, and how much brighter than white it is where it may be that.
    pub(super) fn color(&mut self, ui: &mut Ui, row: &'static Row<T>, label: &str) {
        let property = &row.property;
        let channel = |part| match self.value(row, part, 0) {
            Some(Value::Number(value)) => Some(value as f32),
            _ => None,
        };
        let (Some(r), Some(g), Some(b)) = (channel(0), channel(1), channel(2)) else { return };
        let before = Rgb::new(r, g, b);
        let mut value = before;
        let values = self.values(row);
        self.name_with_key(ui, label, property.doc, &values);
        let fields = ui.horizontal(|ui| {
            color_field(ui, label, &mut value);
            if property.kind.number().is_some_and(|number| number.max > 1.0) {
                brightness_field(ui, &format!("{label} brightness"), &mut value);
            }
            if (0..3).any(|part| self.parts_differ(row, part)) {
                ui.weak(MIXED).on_hover_text(MIXED_DOC);
            }
        });
        if value != before {
            for (part, channel) in value.to_array().into_iter().enumerate() {
                self.set(row, part, Value::Number(channel.into()));
            }
        }
        self.note_pointer(ui, fields.response.rect, label, &values);
        ui.end_row();
    }
}

const BRIGHTNESS: Number =
    Number { min: 1.0, label: "Brightness", doc: "Above 1: brighter than white.", ..property::COLOR };

fn set_brightness(value: &mut Rgb, brightness: f64) {
    let before = f64::from(brightness_of(*value));
    if brightness != before {
        *value = *value * (brightness / before) as f32;
    }
}

/// How much brighter than white a colour is. Whether that was changed.
pub(crate) fn brightness_field(ui: &mut Ui, name: &str, value: &mut Rgb) -> bool {
    let mut brightness = f64::from(brightness_of(*value));
    let changed = number_field(ui, name, &BRIGHTNESS, &mut brightness, false);
    set_brightness(value, brightness);
    changed
}

/// What a colour is divided by to fit into sRGB: 1 unless it is brighter than white.
fn brightness_of(color: Rgb) -> f32 {
    color.to_array().into_iter().fold(1.0, f32::max)
}

/// The nearest 8-bit sRGB of a linear colour, its brightness left out.
fn srgb_of(color: Rgb) -> [u8; 3] {
    (color * (1.0 / brightness_of(color)))
        .to_array()
        .map(|c| (srgb_from_linear(c.clamp(0.0, 1.0)) * 255.0).round() as u8)
}

/// As the eye sees it, with its opacity.
pub(crate) fn color32(color: Rgba) -> Color32 {
    let [r, g, b] = srgb_of(color.rgb);
    Color32::from_rgba_unmultiplied(r, g, b, (color.a.clamp(0.0, 1.0) * 255.0).round() as u8)
}

/// A button that opens the picker. Whether the colour was changed; its brightness stays.
pub(crate) fn color_field(ui: &mut Ui, label: &str, value: &mut Rgb) -> bool {
    let mut bytes = srgb_of(*value);
    let response = picker::button(ui, label, &mut bytes);
    let changed = response.on_hover_text(property::COLOR.doc).changed();
    if changed {
        let [r, g, b] = bytes.map(|c| linear_from_srgb(f32::from(c) / 255.0) * brightness_of(*value));
        *value = Rgb::new(r, g, b);
    }
    changed
}
