//! A cloud model: category, culling and colour levels. Its boxes are in the outline.

use super::fields::{fields, heading};
use crate::command::Command;
use crate::editor::Action;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::{Category, CloudModel, CullRadius};
use egui::Ui;

#[derive(Clone, Copy, PartialEq)]
enum CullKind {
    Sprite,
    Height,
    Metres,
}

pub(super) fn fields_of(ui: &mut Ui, model: &CloudModel, actions: &mut Vec<Action>) {
    ui.heading("Cloud model");
    fields(ui, "Change model", actions, |rows| {
        let mut model = model.clone();
        rows.text("Name", &mut model.name);
        let categories: Vec<_> = Category::ALL.into_iter().map(|each| (each, category_name(each))).collect();
        rows.choice("Category", "Which tiles its boxes show.", &mut model.category, &categories);
        rows.seed(&mut model.seed);
        let before = cull_kind(model.cull_radius);
        let mut kind = before;
        let kinds = [
            (CullKind::Sprite, "share of the sprite's size".into()),
            (CullKind::Height, "share of the cloud's height".into()),
            (CullKind::Metres, "metres".into()),
        ];
        rows.choice("Cull by", "What the cull radius is measured in.", &mut kind, &kinds);
        if kind != before {
            model.cull_radius = match kind {
                CullKind::Sprite => CullRadius::SpriteFraction(p::CULL_FRACTION.default),
                CullKind::Height => CullRadius::CloudHeightFraction(p::CULL_FRACTION.default),
                CullKind::Metres => CullRadius::Metres(p::CULL_METRES.default),
            };
        }
        match &mut model.cull_radius {
            CullRadius::SpriteFraction(share) | CullRadius::CloudHeightFraction(share) => {
                rows.number(&p::CULL_FRACTION, share);
            }
            CullRadius::Metres(metres) => rows.number(&p::CULL_METRES, metres),
        }
        Edit::Model(ListEdit::Replace(model))
    });
    if ui.button("Add box").on_hover_text(Command::AddBox.row().help).clicked() {
        actions.push(Action::Command(Command::AddBox));
    }
    heading(ui, "Colour levels");
    levels(ui, model, actions);
}

/// Highest first, as they lie in the cloud.
fn levels(ui: &mut Ui, model: &CloudModel, actions: &mut Vec<Action>) {
    fields(ui, "Change colour levels", actions, |rows| {
        let mut model = model.clone();
        for i in (0..model.color_levels.len()).rev() {
            let lowest = if i > 0 { model.color_levels[i - 1].height } else { 0.0 };
            let highest = model.color_levels.get(i + 1).map_or(1.0, |level| level.height);
            let level = &mut model.color_levels[i];
            rows.labelled(&format!("Level {} height", i + 1), &p::LEVEL_HEIGHT, &mut level.height);
            // Levels stay in order: one stops at its neighbour.
            level.height = level.height.clamp(lowest, highest.max(lowest));
            rows.color(&format!("Level {} colour", i + 1), &mut level.color.rgb, Some(&mut level.color.a));
        }
        Edit::Model(ListEdit::Replace(model))
    });
}

fn cull_kind(radius: CullRadius) -> CullKind {
    match radius {
        CullRadius::SpriteFraction(_) => CullKind::Sprite,
        CullRadius::CloudHeightFraction(_) => CullKind::Height,
        CullRadius::Metres(_) => CullKind::Metres,
    }
}

/// The file's name in words.
pub(super) fn category_name(category: Category) -> String {
    category.name().replace('_', " ")
}
