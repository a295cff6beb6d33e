//! A placed cloud.

use super::fields::fields;
use crate::editor::{Action, Selection, Session};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::Cloud;
use egui::Ui;

pub(super) fn fields_of(ui: &mut Ui, cloud: &Cloud, session: &Session, actions: &mut Vec<Action>) {
    ui.heading("Cloud");
    let scene = session.scene();
    let models: Vec<_> = scene.models.iter().map(|model| (model.id, model.name.clone())).collect();
    fields(ui, "Change cloud", actions, |rows| {
        let mut cloud = cloud.clone();
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
        Edit::Cloud(ListEdit::Replace(cloud))
    });
    if let Some(placed) = session.derived().clouds().iter().find(|placed| placed.id == cloud.id) {
        ui.weak(format!(
            "{} of {} sprites kept, {} groups",
            placed.sprites.len(),
            placed.candidate_count,
            placed.groups.len()
        ));
    }
    if ui.button("Select its model").clicked() {
        actions.push(Action::Select(Selection::Model(cloud.model)));
    }
}
