//! Saved cameras.

use crate::state::Action;
use crate::widget::fields;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::Camera;
use egui::Ui;

/// `cameras` has at least one, the one whose values are shown.
pub(super) fn fields_of(ui: &mut Ui, cameras: &[Camera], actions: &mut Vec<Action>) {
    fields(
        ui,
        "Change camera",
        actions,
        cameras,
        |rows, camera| {
            rows.text("Name", &mut camera.name);
            rows.vector("Position", &p::POSITION, &mut camera.position);
            rows.number(&p::HEADING_DEG, &mut camera.heading_deg);
            rows.number(&p::PITCH_DEG, &mut camera.pitch_deg);
            rows.number(&p::ROLL_DEG, &mut camera.roll_deg);
            rows.number(&p::FIELD_OF_VIEW_DEG, &mut camera.field_of_view_deg);
        },
        |camera| Edit::Camera(ListEdit::Replace(camera)),
    );
    let Some(camera) = cameras.first() else { return };
    ui.horizontal(|ui| {
        if ui.button("Look through").on_hover_text("The view goes where this camera is.").clicked() {
            actions.push(Action::LookThrough(camera.id));
        }
        if ui.button("Set from view").on_hover_text("This camera goes where the view is.").clicked() {
            actions.push(Action::SetFromView(camera.id));
        }
    });
}
