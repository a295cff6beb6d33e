//! The diamonds of the chosen level: height, colour and opacity of it, in all selected models.

use crate::state::{Action, Reading, Values, color_levels};
use crate::widget::key_button;
use cloudwright_core::scene::CloudModel;
use egui::Ui;

/// The diamond of what `path` names of a level.
pub(super) fn show(
    ui: &mut Ui,
    models: &[&CloudModel],
    level: usize,
    path: &str,
    reading: &Reading<'_>,
    actions: &mut Vec<Action>,
) {
    let value = |model: &&CloudModel| {
        let shown = color_levels::shown(reading, model);
        let (row, target) = color_levels::targets(model.id, level).find(|(row, _)| row.property.path == path)?;
        Some((target, color_levels::key_value(row, shown.get(level)?)?))
    };
    let values: Values = models.iter().filter_map(value).collect();
    if let Some((target, _)) = values.first() {
        let label = format!("Level {} {}", level + 1, target.property.label.to_lowercase());
        actions.extend(key_button(ui, &label, &values, reading));
    }
}
