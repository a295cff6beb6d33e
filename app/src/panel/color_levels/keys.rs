//! The diamonds of the chosen level: height, colour and opacity of it, in all selected models.

use crate::state::{Action, Reading, color_levels};
use crate::widget::key_button;
use cloudwright_core::scene::CloudModel;
use egui::Ui;

pub(super) fn show(
    ui: &mut Ui,
    models: &[&CloudModel],
    level: usize,
    reading: &Reading<'_>,
    actions: &mut Vec<Action>,
) {
    let Some(first) = models.first() else { return };
    ui.horizontal(|ui| {
        ui.weak(format!("Key level {}:", level + 1));
        for (at, (row, _)) in color_levels::targets(first.id, level).enumerate() {
            let value = |model: &&CloudModel| {
                let shown = color_levels::shown(reading, model);
                let (row, target) = color_levels::targets(model.id, level).nth(at)?;
                Some((target, color_levels::key_value(row, shown.get(level)?)?))
            };
            let label = format!("Level {} {}", level + 1, row.property.label.to_lowercase());
            let values = models.iter().filter_map(value).collect();
            actions.extend(key_button(ui, &label, &values, reading));
            ui.label(row.property.label);
        }
    });
}
