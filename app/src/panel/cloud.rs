//! Placed clouds.

use super::Reading;
use super::fields::fields;
use super::kept::{self, Kept};
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
            let model_seed = scene.model(cloud.model).map_or(1, |model| model.seed);
            let before = cloud.seed.unwrap_or(model_seed);
            let mut seed = before;
            rows.seed("Seed", "Another number strews this cloud's sprites anew.", &mut seed);
            if seed != before {
                cloud.seed = Some(seed);
            }
            let mut own = cloud.seed.is_some();
            rows.check("Seed of its own", "Other sprites than the model's other clouds.", &mut own);
            cloud.seed = own.then_some(seed);
        },
        |cloud| Edit::Cloud(ListEdit::Replace(cloud)),
    );
    let Some(cloud) = clouds.first() else { return };
    let placed: Vec<_> = clouds.iter().filter_map(|cloud| reading.session.placed(cloud.id)).collect();
    kept::line(ui, &Kept::of_clouds(&placed));
    if ui.button("Select its model").clicked() {
        actions.push(Action::select(Item::Model(cloud.model)));
    }
}
