//! A colour with its brightness beside it: the picker shows sRGB, which ends at white.

use super::{Fields, Values, name_it, number_field};
use cloudwright_core::color::{Rgb, linear_from_srgb, srgb_from_linear};
use cloudwright_core::parameter::{self, Parameter};
use egui::Ui;

impl Fields<'_> {
    /// A colour, and its opacity if it has one.
    pub(in crate::panel) fn color(&mut self, label: &str, value: &mut Rgb, alpha: Option<&mut f32>) {
        self.row(label, parameter::COLOR.doc, |values| {
            values.color(label, value);
            if let Some(alpha) = alpha {
                values.alpha(label, alpha);
            }
        });
    }
}

impl Values<'_> {
    fn color(&mut self, label: &str, value: &mut Rgb) {
        self.value(label, value, |ui, value| color_field(ui, label, value));
        let name = format!("{label} brightness");
        let mut brightness = f64::from(brightness_of(*value));
        self.number(&name, &BRIGHTNESS, &mut brightness);
        set_brightness(value, brightness);
    }

    fn alpha(&mut self, label: &str, alpha: &mut f32) {
        let mut opacity = f64::from(*alpha);
        self.number(&format!("{label} opacity"), &parameter::ALPHA, &mut opacity);
        if opacity != f64::from(*alpha) {
            *alpha = opacity as f32;
        }
    }
}

const BRIGHTNESS: Parameter =
    Parameter { min: 1.0, label: "Brightness", doc: "Above 1: brighter than white.", ..parameter::COLOR };

fn set_brightness(value: &mut Rgb, brightness: f64) {
    let before = f64::from(brightness_of(*value));
    if brightness != before {
        *value = *value * (brightness / before) as f32;
    }
}

/// How much brighter than white a colour is. Whether that was changed.
pub(in crate::panel) fn brightness_field(ui: &mut Ui, name: &str, value: &mut Rgb) -> bool {
    let mut brightness = f64::from(brightness_of(*value));
    let changed = number_field(ui, name, &BRIGHTNESS, &mut brightness, false);
    set_brightness(value, brightness);
    changed
}

/// What a colour is divided by to fit into sRGB: 1 unless it is brighter than white.
pub(in crate::panel) fn brightness_of(color: Rgb) -> f32 {
    color.to_array().into_iter().fold(1.0, f32::max)
}

/// The nearest 8-bit sRGB of a linear colour, its brightness left out.
pub(in crate::panel) fn srgb_of(color: Rgb) -> [u8; 3] {
    (color * (1.0 / brightness_of(color)))
        .to_array()
        .map(|c| (srgb_from_linear(c.clamp(0.0, 1.0)) * 255.0).round() as u8)
}

/// A button that opens the picker. Whether the colour was changed; its brightness stays.
pub(in crate::panel) fn color_field(ui: &mut Ui, label: &str, value: &mut Rgb) -> bool {
    let mut bytes = srgb_of(*value);
    let response = ui.color_edit_button_srgb(&mut bytes);
    name_it(ui, &response, label);
    let changed = response.on_hover_text(parameter::COLOR.doc).changed();
    if changed {
        let [r, g, b] = bytes.map(|c| linear_from_srgb(f32::from(c) / 255.0) * brightness_of(*value));
        *value = Rgb::new(r, g, b);
    }
    changed
}
