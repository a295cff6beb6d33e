//! What the layers that were made cover, beside what the reports ask for, in eighths of the sky.

use crate::reports::{Made, MadeLayer, words};
use crate::theme;
use crate::units::Units;
use egui::{Grid, RichText, ScrollArea, Ui};

/// Points.
const HEIGHT: f32 = 150.0;

/// A row for each layer and time.
pub(super) fn show(ui: &mut Ui, made: &Made, units: Units) {
    if made.layers.is_empty() {
        ui.weak("The sky is clear.");
        return;
    }
    let has_times = made.skies.len() > 1;
    ScrollArea::vertical().id_salt("covers").max_height(HEIGHT).show(ui, |ui| {
        Grid::new("covers").num_columns(4).striped(true).min_col_width(theme::NUMBER_WIDTH).show(ui, |ui| {
            for head in ["Layer", if has_times { "Clock" } else { "" }, "Asked", "Measured"] {
                ui.label(RichText::new(head).weak());
            }
            ui.end_row();
            for layer in &made.layers {
                rows(ui, layer, has_times, units);
            }
        });
    });
}

fn rows(ui: &mut Ui, made: &MadeLayer, has_times: bool, units: Units) {
    let what = format!("{} at {}", words::name(&made.layer.genus), units.altitude().text(made.layer.base_m));
    if made.plugin.is_none() {
        ui.label(what);
        ui.label("");
        ui.weak("haze alone");
        return ui.end_row();
    }
    for (index, cover) in made.cover.iter().enumerate() {
        ui.label(if index == 0 { what.as_str() } else { "" });
        ui.label(if has_times { format!("{:.0} s", cover.time_s) } else { String::new() });
        ui.label(format!("{:.1} oktas", cover.asked_oktas));
        ui.label(format!("{:.1} oktas", cover.measured_oktas));
        ui.end_row();
    }
}
