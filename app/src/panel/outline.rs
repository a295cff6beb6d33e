//! The scene as a tree: models with their boxes, clouds, cameras, flights. A click selects, with Ctrl or Shift more than one.

use crate::state::{Action, Choose, Item, Reading, ViewChange};
use crate::theme::icon;
use crate::widget::name_it;
use cloudwright_core::scene::CloudModel;
use egui::collapsing_header::CollapsingState;
use egui::{Align, Button, Id, Layout, Response, ScrollArea, TextWrapMode, Ui};

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let scene = reading.session.scene();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
        section(ui, "Clouds", scene.clouds.len(), |ui| {
            for cloud in &scene.clouds {
                row(ui, &named(&cloud.name, "cloud", cloud.id.0), Item::Cloud(cloud.id), reading, actions);
            }
        });
        section(ui, "Models", scene.models.len(), |ui| {
            for model in &scene.models {
                model_row(ui, model, reading, actions);
            }
        });
        section(ui, "Cameras", scene.cameras.len(), |ui| {
            for camera in &scene.cameras {
                let name = named(&camera.name, "camera", camera.id.0);
                let response = row(ui, &name, Item::Camera(camera.id), reading, actions);
                if response.on_hover_text("Double-click to look through it").double_clicked() {
                    actions.push(Action::LookThrough(camera.id));
                }
            }
        });
        section(ui, "Paths", scene.paths.len(), |ui| {
            for path in &scene.paths {
                row(ui, &named(&path.name, "path", path.id.0), Item::Path(path.id), reading, actions);
            }
        });
        section(ui, "Aircraft", scene.aircraft.len(), |ui| {
            for aircraft in &scene.aircraft {
                let name = named(&aircraft.name, "aircraft", aircraft.id.0);
                row(ui, &name, Item::Aircraft(aircraft.id), reading, actions);
            }
        });
    });
}

fn section(ui: &mut Ui, title: &str, count: usize, body: impl FnOnce(&mut Ui)) {
    egui::CollapsingHeader::new(format!("{title} ({count})")).id_salt(title).default_open(true).show(ui, body);
}

fn model_row(ui: &mut Ui, model: &CloudModel, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let id = Id::unique(("outline model", model.id));
    let mut state = CollapsingState::load_with_default_open(ui.ctx(), id, true);
    // A box that was chosen in the viewport must be seen here.
    let inside = |item: &Item| matches!(item, Item::Box(of, _) | Item::Sprite(of, ..) if *of == model.id);
    if reading.view.selection.items().iter().any(inside) && !state.is_open() {
        state.set_open(true);
    }
    let header = state.show_header(ui, |ui| {
        row(ui, &named(&model.name, "model", model.id.0), Item::Model(model.id), reading, actions)
    });
    header.body(|ui| {
        for each in &model.boxes {
            row(ui, &named(&each.name, "box", each.id.0), Item::Box(model.id, each.id), reading, actions);
        }
    });
}

fn row(ui: &mut Ui, text: &str, item: Item, reading: &Reading<'_>, actions: &mut Vec<Action>) -> Response {
    let view = reading.view;
    let hidden = view.hidden.contains(&item);
    ui.allocate_ui_with_layout(
        egui::vec2(ui.available_width(), ui.spacing().interact_size.y),
        Layout::right_to_left(Align::Center),
        |ui| {
            if !matches!(item, Item::Camera(_) | Item::Path(_) | Item::Aircraft(_)) {
                let locked = view.locked.contains(&item);
                let (glyph, word) =
                    if locked { (icon::LOCK_SIMPLE, "Unlock") } else { (icon::LOCK_SIMPLE_OPEN, "Lock") };
                if small(ui, glyph, &format!("{word} {text}"), locked).clicked() {
                    actions.push(Action::View(ViewChange::Locked(item, !locked)));
                }
                let (glyph, word) = if hidden { (icon::EYE_SLASH, "Show") } else { (icon::EYE, "Hide") };
                if small(ui, glyph, &format!("{word} {text}"), hidden).clicked() {
                    actions.push(Action::View(ViewChange::Hidden(item, !hidden)));
                }
            }
            ui.with_layout(
                Layout::left_to_right(Align::Center).with_main_justify(true).with_main_align(Align::Min),
                |ui| {
                    let mut label = egui::RichText::new(text);
                    if hidden {
                        label = label.weak();
                    }
                    let response = ui.add(Button::selectable(view.selection.contains(item), label));
                    if response.clicked() {
                        let modifiers = ui.input(|input| input.modifiers);
                        let how = if modifiers.command || modifiers.shift { Choose::Toggle } else { Choose::Only };
                        actions.push(Action::Select { items: vec![item], through: None, how });
                    }
                    response
                },
            )
            .inner
        },
    )
    .inner
}

/// A quiet button: strong only when what it says is so.
fn small(ui: &mut Ui, glyph: &str, name: &str, on: bool) -> Response {
    let text = egui::RichText::new(glyph);
    let response = ui.add(Button::new(if on { text } else { text.weak() }).frame(false));
    name_it(ui, &response, name);
    response.on_hover_text(name)
}

fn named(name: &str, kind: &str, id: u64) -> String {
    if name.is_empty() { format!("{kind} {id}") } else { name.into() }
}
