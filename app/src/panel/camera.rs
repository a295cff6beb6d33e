//! What can be done with a saved camera, beside its values.

use crate::state::Action;
use cloudwright_core::scene::CameraId;
use egui::Ui;

/// From the view to the camera and back.
pub(super) fn views(ui: &mut Ui, id: CameraId, actions: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        if ui.button("Look through").on_hover_text("The view goes where this camera is.").clicked() {
            actions.push(Action::LookThrough(id));
        }
        if ui.button("Set from view").on_hover_text("This camera goes where the view is.").clicked() {
            actions.push(Action::SetFromView(id));
        }
    });
}
