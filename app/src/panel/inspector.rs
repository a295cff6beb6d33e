//! The values of what is selected, and below them time and sky.

use super::fields::heading;
use super::{camera, cloud, cloud_box, model, sky};
use crate::editor::{Action, Selection, Session, box_of};
use egui::{ScrollArea, Ui};

/// The panel on the right.
pub(crate) fn inspector(ui: &mut Ui, session: &Session, selected: Selection, actions: &mut Vec<Action>) {
    let scene = session.scene();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        match selected {
            Selection::Nothing => {
                ui.heading("Nothing selected");
                ui.weak("Click a cloud, or choose something on the left.");
            }
            Selection::Model(id) => {
                if let Some(found) = scene.model(id) {
                    ui.push_id(id, |ui| model::fields_of(ui, found, actions));
                }
            }
            Selection::Box(of, id) => {
                if let (Some(model), Some(found)) = (scene.model(of), box_of(scene, of, id)) {
                    ui.push_id(id, |ui| cloud_box::fields_of(ui, model, found, session, actions));
                }
            }
            Selection::Cloud(id) => {
                if let Some(found) = scene.cloud(id) {
                    ui.push_id(id, |ui| cloud::fields_of(ui, found, session, actions));
                }
            }
            Selection::Camera(id) => {
                if let Some(found) = scene.cameras.iter().find(|camera| camera.id == id) {
                    ui.push_id(id, |ui| camera::fields_of(ui, found, actions));
                }
            }
        }
        heading(ui, "Time and sky");
        sky::fields_of(ui, scene, actions);
    });
}
