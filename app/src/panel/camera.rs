//! Saved cameras.

use crate::state::{Action, Reading};
use crate::widget::Fields;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::Camera;
use egui::Ui;

/// `cameras` has at least one, the one whose values are shown.
pub(super) fn fields_of(ui: &mut Ui, cameras: &[&Camera], reading: &Reading<'_>, actions: &mut Vec<Action>) {
    Fields::of(cameras, reading)
        .show(ui, "Change camera", actions, Fields::all, |_, camera| Edit::Camera(ListEdit::Replace(camera)));
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
