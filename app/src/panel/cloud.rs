//! Placed clouds.

use crate::state::{Action, Item, Reading};
use crate::widget::{Fields, Kept, kept, section};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::{CLOUD_FORMING, CLOUD_LOOK, CLOUD_PLACE, Owner, Property, Value};
use cloudwright_core::scene::{Cloud, Thing};
use cloudwright_core::weather::Formed;
use egui::Ui;

/// `clouds` has at least one, the one whose values are shown.
pub(super) fn fields_of(ui: &mut Ui, clouds: &[&Cloud], reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let scene = reading.session.scene();
    // A cloud without a seed has its model's.
    let seed = |cloud: &Cloud, _: &Property| scene.model(cloud.model).map(|model| Value::Whole(model.seed));
    let owners = || clouds.iter().map(|cloud| Owner::Thing(Thing::Cloud(cloud.id)));
    let parts = [("Place", CLOUD_PLACE), ("Look and wind", CLOUD_LOOK), ("Forming", CLOUD_FORMING)];
    for (title, rows) in parts {
        section(ui, title, |ui| {
            let edit = |_, cloud| Edit::Cloud(ListEdit::Replace(cloud));
            let show = |fields: &mut Fields<'_, Cloud>, ui: &mut Ui| fields.rows(ui, rows);
            Fields::of(clouds, reading).inheriting(seed).owned(owners()).show(ui, "Change cloud", actions, show, edit);
        });
    }
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
