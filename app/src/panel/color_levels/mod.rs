//! The five colour levels of the selected models: an upright gradient with its handles beside the cloud that it paints,
//! and below it all values as a table.
//!
//! What a hand does to the primary's levels is done to those of all selected models. The level that was touched last
//! is the chosen one, here and on the cloud in the viewport.

mod keys;
mod scale;
mod silhouette;
mod table;

use crate::command::Command;
use crate::state::{Action, Reading, color_levels};
use crate::theme::icon;
use crate::widget::{checkerboard, choose_level, chosen_level, color32, name_it};
use cloudwright_core::preset::LevelPreset;
use cloudwright_core::scene::ColorLevels;
use cloudwright_core::shading::level_color;
use egui::{Button, Painter, Rect, Response, ScrollArea, Sense, Ui, vec2};

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let models = reading.view.selection.models(reading.session.scene());
    let Some(model) = models.first() else {
        ui.weak("Select a cloud to see its colour levels.");
        return;
    };
    let room = ui.available_height();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        let top = ui.cursor().top();
        ui.horizontal(|ui| tools(ui, reading, &model.color_levels, actions));
        if models.len() > 1 {
            ui.weak(format!("{} models: changes go to all of them", models.len()));
        }
        let mut levels = color_levels::shown(reading, model);
        let mut chosen = chosen_level(ui.ctx());
        let room = room - (ui.cursor().top() - top) - table::height(ui);
        scale::show(ui, room, reading, &mut levels, &mut chosen);
        let level = chosen;
        let mut diamond = |ui: &mut Ui, path: &str| keys::show(ui, &models, level, path, reading, actions);
        table::show(ui, &mut levels, &mut chosen, &mut diamond);
        choose_level(ui.ctx(), chosen);
        let live = ui.input(|input| input.pointer.any_down());
        actions.extend(color_levels::change(reading, &levels, live));
    });
}

fn tools(ui: &mut Ui, reading: &Reading<'_>, levels: &ColorLevels, actions: &mut Vec<Action>) {
    let presets = ui.menu_button(format!("Presets {}", icon::CARET_DOWN), |ui| {
        for preset in LevelPreset::all() {
            let offered = offer(ui, preset);
            let replaced = color_levels::replace(reading, "Preset of colour levels", preset.levels);
            if offered.clicked() {
                actions.push(replaced);
            } else if offered.hovered() {
                actions.push(replaced.previewed());
            }
        }
    });
    name_it(ui, &presets.response, "Presets of colour levels");
    for (command, text, enabled) in
        [(Command::CopyLevels, "Copy", true), (Command::PasteLevels, "Paste", reading.copied_levels.is_some())]
    {
        let response = ui.add_enabled(enabled, Button::new(text));
        if response.on_hover_text(command.row().tooltip(ui.ctx())).clicked() {
            actions.push(Action::Command(command));
        }
    }
    let arrange = ui.menu_button(format!("Arrange {}", icon::CARET_DOWN), |ui| {
        if ui.button("Turn upside down").clicked() {
            actions.push(color_levels::replace(reading, "Turn colour levels", color_levels::upside_down(*levels)));
        }
        if ui.button("Space evenly").clicked() {
            actions.push(color_levels::replace(reading, "Space colour levels", color_levels::evenly_spaced(*levels)));
        }
    });
    name_it(ui, &arrange.response, "Arrange colour levels");
}

fn offer(ui: &mut Ui, preset: &LevelPreset) -> Response {
    const SWATCH: egui::Vec2 = vec2(18.0, 20.0);
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(SWATCH, Sense::hover());
        paint_gradient(ui.painter(), rect, &preset.levels);
        ui.button(preset.label)
    })
    .inner
}

/// The levels upright, row by row so that steps stay sharp, over a board that shows how clear they are.
fn paint_gradient(painter: &Painter, rect: Rect, levels: &ColorLevels) {
    checkerboard::paint(painter, rect);
    let mut mesh = egui::Mesh::default();
    let rows = rect.height().round().max(1.0) as u32;
    let row_height = rect.height() / rows as f32;
    for row in 0..rows {
        let top = rect.top() + row as f32 * row_height;
        let height = 1.0 - (row as f32 + 0.5) / rows as f32;
        let color = color32(level_color(levels, height));
        mesh.add_colored_rect(Rect::from_x_y_ranges(rect.x_range(), top..=top + row_height), color);
    }
    painter.add(mesh);
}
