//! The figures, from cheap to dear; a click on a name has the viewport draw by that method.

use super::figures::{card, choose_method, family, is_chosen, mark};
use crate::chart::report::{MethodFigures, Report};
use crate::chart::text::figure;
use crate::state::{Action, Reading};
use crate::theme;
use egui::{Align, Grid, Layout, RichText, Ui, vec2};

pub(super) fn show(ui: &mut Ui, report: &Report, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let flickers = report.methods.iter().any(|method| method.stability.is_some());
    let mut methods: Vec<&MethodFigures> = report.methods.iter().collect();
    let cost = |method: &MethodFigures| method.cost.frame_ms.unwrap_or(f64::INFINITY);
    methods.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    let columns = if flickers { 4 } else { 3 };
    Grid::new("figures").num_columns(columns).striped(true).show(ui, |ui| {
        ui.weak("MethodFigures");
        let heads = [("ms", "Of a picture."), ("FLIP", "Mean difference from the truth, as an eye sees it: 0 to 1.")];
        let flicker = ("flicker", "How much more a pixel changes from frame to frame than the truth's does.");
        for (name, help) in heads.into_iter().chain(flickers.then_some(flicker)) {
            right(ui, RichText::new(name).weak(), Some(help));
        }
        ui.end_row();
        for row in methods {
            let name = RichText::new(&row.name).color(theme::family(ui, family(row)));
            let name = if row.on_front { name.strong() } else { name };
            let label = |ui: &mut Ui| {
                mark(ui, family(row));
                ui.selectable_label(is_chosen(row, reading), name)
            };
            let response = ui.horizontal(label).inner;
            ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(family(row).name()));
            let response = response.on_hover_ui(|ui| card(ui, row));
            if response.clicked() {
                actions.push(choose_method(row, reading));
            }
            let excess = row.stability.as_ref().and_then(|stability| stability.excess_mean);
            let figures = [row.cost.frame_ms, row.error.flip_mean].into_iter().chain(flickers.then_some(excess));
            figures.for_each(|value| right(ui, RichText::new(figure(value)), None));
            ui.end_row();
        }
    });
    if !report.left_out.is_empty() {
        let names: Vec<&str> = report.left_out.iter().map(|one| one.name.as_str()).collect();
        ui.weak(format!("Left out: {}.", names.join(", "))).on_hover_ui(|ui| {
            for one in &report.left_out {
                ui.label(format!("{}: {}", one.name, one.reason));
            }
        });
    }
}

fn right(ui: &mut Ui, text: RichText, help: Option<&str>) {
    let size = vec2(theme::NUMBER_WIDTH, ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
        let response = ui.label(text);
        if let Some(help) = help {
            response.on_hover_text(help);
        }
    });
}
