//! The five colour levels of the selected model.

use super::Reading;
use super::fields::fields;
use crate::editor::Action;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use egui::{ScrollArea, Ui};

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let Some(model) = reading.view.selection.model(reading.session.scene()) else {
        ui.weak("Select a cloud to see its colour levels.");
        return;
    };
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        fields(
            ui,
            "Change colour levels",
            actions,
            std::slice::from_ref(model),
            |rows, model| {
                // Highest first, as they lie in the cloud.
                for i in (0..model.color_levels.len()).rev() {
                    let lowest = if i > 0 { model.color_levels[i - 1].height } else { 0.0 };
                    let highest = model.color_levels.get(i + 1).map_or(1.0, |level| level.height);
                    let level = &mut model.color_levels[i];
                    rows.labelled(&format!("Level {} height", i + 1), &p::LEVEL_HEIGHT, &mut level.height);
                    // Levels stay in order: one stops at its neighbour.
                    level.height = level.height.clamp(lowest, highest.max(lowest));
                    rows.color(&format!("Level {} colour", i + 1), &mut level.color.rgb, Some(&mut level.color.a));
                }
            },
            |model| Edit::Model(ListEdit::Replace(model)),
        );
    });
}
