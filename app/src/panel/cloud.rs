//! Placed clouds.

use super::Reading;
use super::fields::fields;
use crate::editor::{Action, Item};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::Cloud;
use egui::Ui;

/// `clouds` has at least one, the one whose values are shown.
pub(super) fn fields_of(ui: &mut Ui, clouds: &[Cloud], reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let scene = reading.session.scene();
    let models: Vec<_> = scene.models.iter().map(|model| (model.id, model.name.clone())).collect();
    fields(
        ui,
        "Change cloud",
        actions,
        clouds,
        |rows, cloud| {
            rows.text("Name", &mut cloud.name);
            rows.choice("Model", "What is placed.", &mut cloud.model, &models);
            rows.vector("Position", &p::POSITION, &mut cloud.position);
            rows.number(&p::HEADING_DEG, &mut cloud.heading_deg);
            rows.number(&p::CLOUD_SCALE, &mut cloud.scale);
            let mut own = cloud.seed.is_some();
            rows.check("Seed of its own", "Other sprites than the model's other clouds.", &mut own);
            let model_seed = scene.model(cloud.model).map_or(1, |model| model.seed);
            cloud.seed = own.then(|| cloud.seed.unwrap_or(model_seed));
            if let Some(seed) = &mut cloud.seed {
                rows.seed(seed);
            }
        },
        |cloud| Edit::Cloud(ListEdit::Replace(cloud)),
    );
    let Some(cloud) = clouds.first() else { return };
    if let Some(placed) = reading.session.placed(cloud.id) {
        ui.weak(format!(
            "{} of {} sprites kept, {} groups",
            placed.sprites.len(),
            placed.candidate_count,
            placed.groups.len()
        ));
    }
    if ui.button("Select its model").clicked() {
        actions.push(Action::select(Item::Model(cloud.model)));
    }
}
