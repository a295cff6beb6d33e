//! Speed against accuracy for the open scene: what each method costs and gets wrong, and the viewport drawn by any of
//! them, beside the truth or under a map of what is wrong.

mod figures;
mod lens;
mod plot;
mod table;

use crate::chart::front;
use crate::chart::text::figure;
use crate::state::{Action, ChartChange, Reading, WIDTHS_PX};
use crate::theme;
use crate::widget::{name_it, number_field, section, work_bar};
use cloudwright_core::property::Number;
use egui::{ComboBox, ScrollArea, Ui};

const TOLERANCE: Number = Number {
    label: "Good enough",
    unit: "",
    min: 0.0001,
    max: 1.0,
    doc: "The mean FLIP that a method may have: 0.01 is hard to see, 0.05 is plain.",
};

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        measure(ui, reading, actions);
        let charting = reading.charting;
        if let Some(trouble) = charting.trouble() {
            ui.colored_label(theme::error(ui), format!("Nothing was measured: {trouble}."));
        }
        match charting.report() {
            Some(report) => {
                if charting.is_stale() {
                    let what = "The scene or the view has changed since this was measured.";
                    ui.colored_label(theme::warning(ui), what);
                }
                if report.unfinished && charting.progress().is_none() {
                    ui.colored_label(theme::warning(ui), "Measuring was stopped: times are of a first try, or lack.");
                }
                plot::show(ui, report, reading, actions);
                tolerance(ui, reading, actions);
            }
            None if charting.progress().is_none() => {
                ui.weak(
                    "Measures what each method takes for a picture, and how much that looks different from the truth: \
                     each ray's own fragments in their own order.",
                );
            }
            None => {}
        }
        section(ui, "In the viewport", |ui| lens::show(ui, reading, actions));
        if let Some(report) = charting.report() {
            section(ui, "Methods", |ui| table::show(ui, report, reading, actions));
        }
    });
}

/// What is measured, and the button that begins and ends it.
fn measure(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let charting = reading.charting;
    let mut change = |change| actions.push(Action::Chart(change));
    ui.add_enabled_ui(charting.progress().is_none(), |ui| {
        ui.horizontal(|ui| {
            let path = reading.clock.path_to_fly(reading.session.scene());
            let name = |along_path: bool| match path.filter(|_| along_path) {
                Some(path) if path.name.is_empty() => "along the path".into(),
                Some(path) => format!("along “{}”", path.name),
                None => "this view".to_owned(),
            };
            let combo = ComboBox::from_id_salt("measured").selected_text(name(charting.along_path)).show_ui(ui, |ui| {
                for along_path in [false, true] {
                    let can = !along_path || path.is_some();
                    let text = if can { name(along_path) } else { "along a path: there is none".into() };
                    let choice = egui::Button::selectable(along_path == charting.along_path, text);
                    if ui.add_enabled(can, choice).clicked() {
                        change(ChartChange::AlongPath(along_path));
                    }
                }
            });
            name_it(ui, &combo.response, "What is measured");
            combo.response.on_hover_text("Along a path, flicker is measured too: at five places of it.");
            let text = |width_px: u32| format!("{width_px} px wide");
            let combo = ComboBox::from_id_salt("width").selected_text(text(charting.width_px)).show_ui(ui, |ui| {
                for width_px in WIDTHS_PX {
                    if ui.selectable_label(width_px == charting.width_px, text(width_px)).clicked() {
                        change(ChartChange::Width(width_px));
                    }
                }
            });
            name_it(ui, &combo.response, "Width of the pictures");
            combo.response.on_hover_text("Of the pictures that are measured, in the viewport's shape.");
        });
    });
    ui.horizontal(|ui| match charting.progress() {
        Some(share) => {
            if ui.button("Stop").clicked() {
                change(ChartChange::Stop);
            }
            work_bar(ui, "Progress of measuring", share);
        }
        None => {
            let button = ui.button("Measure").on_hover_text(
                "In the background, on all cores but the window's: compare its times with one another, not with those of \
                 `cloudwright chart`.",
            );
            if button.clicked() {
                change(ChartChange::Measure);
            }
        }
    });
}

/// What is good enough, and which method to take then.
fn tolerance(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let charting = reading.charting;
    let Some(report) = charting.report() else { return };
    ui.horizontal(|ui| {
        ui.label(TOLERANCE.label).on_hover_text(TOLERANCE.doc);
        let mut value = charting.tolerance;
        if number_field(ui, TOLERANCE.label, &TOLERANCE, &mut value, false) {
            actions.push(Action::Chart(ChartChange::Tolerance(value)));
        }
        let cheapest = front::cheapest_within(&report.methods, charting.tolerance);
        ui.label(match cheapest {
            _ if report.unfinished => "cheapest: not known yet".into(),
            Some(method) => format!("cheapest: {}, {} ms", method.name, figure(method.cost.frame_ms)),
            None => "no method is".into(),
        });
    });
}
