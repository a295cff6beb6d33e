//! Many placements: how many, over which area, and what is left to chance. The scene shows them while they are chosen.

use super::corner::{self, Answer};
use crate::theme;
use crate::widget::{number_field, seed_field};
use cloudwright_core::arrange::place_many::{MOST_CLOUDS, Pattern, Places};
use cloudwright_core::property::{CLOUD_SCALE, Number};
use egui::{Context, Grid, Id, Ui};

const COUNT: Number =
    Number { label: "Placements", unit: "", min: 1.0, max: MOST_CLOUDS as f64, doc: "How many clouds." };
const AREA: Number =
    Number { label: "Area", unit: "m", min: 0.0, max: 1e6, doc: "The rectangle that they are strewn over." };
const SPREAD: Number =
    Number { label: "Altitude spread", unit: "m", min: 0.0, max: 20_000.0, doc: "Between the lowest and the highest." };

/// How many, and where, before anything is chosen.
pub(crate) fn default_places(center: glam::DVec3) -> Places {
    Places {
        center,
        extent: glam::DVec2::splat(10_000.0),
        count: 12,
        pattern: Pattern::Strewn,
        altitude_spread_m: 100.0,
        scale: [0.8, 1.25],
        seed: 1,
        random_heading: true,
    }
}

/// Asks in a corner, so that the clouds can be seen.
pub(crate) fn ask_place_many(context: &Context, model: &str, places: &mut Places) -> Option<Answer> {
    corner::ask(context, Id::unique("place many"), theme::DIALOG_WIDTH, |ui| {
        ui.heading("Many placements");
        ui.weak(format!("of “{model}”, around the point that the view looks at"));
        ui.add_space(theme::GAP);
        Grid::new("place many").num_columns(2).min_col_width(theme::NAME_WIDTH).show(ui, |ui| rows(ui, places));
        ui.add_space(theme::GAP);
        corner::buttons(ui, "Place", true)
    })
}

fn rows(ui: &mut Ui, places: &mut Places) {
    let row = |ui: &mut Ui, label: &str, values: &mut dyn FnMut(&mut Ui)| {
        ui.label(label);
        ui.horizontal(|ui| values(ui));
        ui.end_row();
    };
    row(ui, COUNT.label, &mut |ui| {
        let mut count = f64::from(places.count);
        if number_field(ui, COUNT.label, &COUNT, &mut count, true) {
            places.count = count as u32;
        }
        for (pattern, name) in [(Pattern::Strewn, "strewn"), (Pattern::Grid, "in rows")] {
            ui.radio_value(&mut places.pattern, pattern, name);
        }
    });
    row(ui, AREA.label, &mut |ui| {
        number_field(ui, "Area width", &AREA, &mut places.extent.x, false);
        ui.label("×");
        number_field(ui, "Area depth", &AREA, &mut places.extent.y, false);
    });
    row(ui, SPREAD.label, &mut |ui| {
        number_field(ui, SPREAD.label, &SPREAD, &mut places.altitude_spread_m, false);
    });
    row(ui, "Scale", &mut |ui| {
        let [smallest, largest] = &mut places.scale;
        if number_field(ui, "Scale from", &CLOUD_SCALE, smallest, false) {
            *largest = largest.max(*smallest);
        }
        ui.label("to");
        if number_field(ui, "Scale to", &CLOUD_SCALE, largest, false) {
            *smallest = smallest.min(*largest);
        }
    });
    row(ui, "", &mut |ui| {
        ui.checkbox(&mut places.random_heading, "Turned by chance");
    });
    row(ui, "Seed", &mut |ui| {
        seed_field(ui, "Seed of the placements", "Re-roll the placements", "", &mut places.seed);
    });
}
