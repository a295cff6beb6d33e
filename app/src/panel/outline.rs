//! The scene as a tree: models with their boxes, clouds, cameras. A click selects.

use crate::editor::{Action, Selection};
use cloudwright_core::scene::{CloudModel, Scene};
use egui::collapsing_header::CollapsingState;
use egui::{Button, Id, ScrollArea, TextWrapMode, Ui};

/// The tree.
pub(crate) fn outline(ui: &mut Ui, scene: &Scene, selected: Selection, actions: &mut Vec<Action>) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
        section(ui, "Models", scene.models.len(), |ui| {
            for model in &scene.models {
                model_row(ui, model, selected, actions);
            }
        });
        section(ui, "Clouds", scene.clouds.len(), |ui| {
            for cloud in &scene.clouds {
                row(ui, &named(&cloud.name, "cloud", cloud.id.0), Selection::Cloud(cloud.id), selected, actions);
            }
        });
        section(ui, "Cameras", scene.cameras.len(), |ui| {
            for camera in &scene.cameras {
                let name = named(&camera.name, "camera", camera.id.0);
                let response = row(ui, &name, Selection::Camera(camera.id), selected, actions);
                if response.on_hover_text("Double-click to look through it").double_clicked() {
                    actions.push(Action::LookThrough(camera.id));
                }
            }
        });
    });
}

fn section(ui: &mut Ui, title: &str, count: usize, body: impl FnOnce(&mut Ui)) {
    egui::CollapsingHeader::new(format!("{title} ({count})")).id_salt(title).default_open(true).show(ui, body);
}

fn model_row(ui: &mut Ui, model: &CloudModel, selected: Selection, actions: &mut Vec<Action>) {
    let id = Id::unique(("outline model", model.id));
    let mut state = CollapsingState::load_with_default_open(ui.ctx(), id, true);
    // A box that was chosen in the viewport must be seen here.
    if matches!(selected, Selection::Box(of, _) if of == model.id) && !state.is_open() {
        state.set_open(true);
    }
    let header = state.show_header(ui, |ui| {
        row(ui, &named(&model.name, "model", model.id.0), Selection::Model(model.id), selected, actions)
    });
    header.body(|ui| {
        for each in &model.boxes {
            let name = named(&each.name, "box", each.id.0);
            row(ui, &name, Selection::Box(model.id, each.id), selected, actions);
        }
    });
}

fn row(ui: &mut Ui, text: &str, this: Selection, selected: Selection, actions: &mut Vec<Action>) -> egui::Response {
    let response = ui.add(Button::selectable(this == selected, text));
    if response.clicked() {
        actions.push(Action::Select(this));
    }
    response
}

fn named(name: &str, kind: &str, id: u64) -> String {
    if name.is_empty() { format!("{kind} {id}") } else { name.into() }
}
