//! A saved camera.

use super::fields::fields;
use crate::editor::Action;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::Camera;
use egui::Ui;

pub(super) fn fields_of(ui: &mut Ui, camera: &Camera, actions: &mut Vec<Action>) {
    ui.heading("Camera");
    fields(ui, "Change camera", actions, |rows| {
        let mut camera = camera.clone();
        rows.text("Name", &mut camera.name);
        rows.vector("Position", &p::POSITION, &mut camera.position);
        rows.number(&p::HEADING_DEG, &mut camera.heading_deg);
        rows.number(&p::PITCH_DEG, &mut camera.pitch_deg);
        rows.number(&p::ROLL_DEG, &mut camera.roll_deg);
        rows.number(&p::FIELD_OF_VIEW_DEG, &mut camera.field_of_view_deg);
        Edit::Camera(ListEdit::Replace(camera))
    });
    ui.horizontal(|ui| {
        if ui.button("Look through").on_hover_text("The view goes where this camera is.").clicked() {
            actions.push(Action::LookThrough(camera.id));
        }
        if ui.button("Set from view").on_hover_text("This camera goes where the view is.").clicked() {
            actions.push(Action::SetFromView(camera.id));
        }
    });
}
