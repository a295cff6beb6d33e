//! Aircraft on their paths.

use super::Reading;
use super::fields::fields;
use crate::editor::Action;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::Aircraft;
use egui::Ui;

/// `aircraft` has at least one, the one whose values are shown.
pub(super) fn fields_of(ui: &mut Ui, aircraft: &[Aircraft], reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let paths: Vec<_> = reading.session.scene().paths.iter().map(|path| (path.id, path.name.clone())).collect();
    fields(
        ui,
        "Change aircraft",
        actions,
        aircraft,
        |rows, aircraft| {
            rows.text("Name", &mut aircraft.name);
            rows.choice("Path", "Along which path it flies.", &mut aircraft.path, &paths);
            rows.number(&p::AIRCRAFT_AHEAD_S, &mut aircraft.ahead_s);
            rows.number(&p::AIRCRAFT_SCALE, &mut aircraft.scale);
        },
        |aircraft| Edit::Aircraft(ListEdit::Replace(aircraft)),
    );
}
