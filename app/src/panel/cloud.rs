//! Placed clouds.

use crate::state::{Action, Item, Reading};
use crate::widget::{Fields, Kept, fields, kept};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::{Cloud, Formation, FormationChange};
use cloudwright_core::weather::Formed;
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
            formation(rows, &mut cloud.formation);
        },
        |cloud| Edit::Cloud(ListEdit::Replace(cloud)),
    );
    let Some(cloud) = clouds.first() else { return };
    let clock_s = reading.clock.time_s();
    if !Formed::at(cloud.formation.as_ref(), clock_s).shows() {
        ui.weak(format!("Nothing of it shows at the clock's {clock_s:.1} s: put the clock on in the Flight panel."));
    }
    let placed: Vec<_> = clouds.iter().filter_map(|cloud| reading.session.placed(cloud.id)).collect();
    kept::line(ui, &Kept::of_clouds(&placed));
    if ui.button("Select its model").clicked() {
        actions.push(Action::select(Item::Model(cloud.model)));
    }
}

/// Whether the cloud forms or dissipates by the scene's clock, and when.
fn formation(rows: &mut Fields<'_>, formation: &mut Option<Formation>) {
    let doc = "By the clock in the Flight panel: a cloud forms from its core, and dissolves from its edges.";
    let all = [
        (None, "always whole".into()),
        (Some(FormationChange::Forming), "forms".into()),
        (Some(FormationChange::Dissipating), "dissipates".into()),
    ];
    let mut change = formation.map(|formation| formation.change);
    rows.choice("Formation", doc, &mut change, &all);
    *formation = change.map(|change| Formation { change, ..formation.unwrap_or_default() });
    if let Some(Formation { start_s, core_s, edges_s, threshold, .. }) = formation {
        rows.number(&p::FORMATION_START_S, start_s);
        rows.number(&p::FORMATION_CORE_S, core_s);
        rows.number(&p::FORMATION_EDGES_S, edges_s);
        rows.number(&p::FORMATION_THRESHOLD, threshold);
    }
}
