//! What stands in the viewport's corners: the tool's options, the cameras, and what pointer and keys do.

use crate::command::Command;
use crate::state::{Action, Reading, Snap, Tool, ViewChange};
use crate::theme::{self, icon};
use crate::widget::{name_it, number_field};
use cloudwright_core::property::{Number, POSITION};
use cloudwright_core::scene::Camera;
use egui::{Align2, Color32, FontId, Label, Layout, Painter, Pos2, Rect, RichText, Ui, UiBuilder, Vec2, vec2};

const BASE_ALTITUDE: Number =
    Number { label: "Base altitude", doc: "The altitude of the plane that the box tool draws on.", ..POSITION };
const SNAP_STEP: Number =
    Number { label: "Snap step", unit: "m", min: 0.01, max: 1e5, doc: "What moves and sizes snap to." };
const SNAP_ANGLE: Number = Number { label: "Snap angle", unit: "°", min: 0.1, max: 180.0, doc: "What turns snap to." };

/// Of the shade around words.
const PLATE: Vec2 = vec2(6.0, 3.0);

/// Shows options and cameras in the upper corners of `rect`.
pub(super) fn show(ui: &mut Ui, rect: Rect, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let inner = rect.shrink(theme::VIEWPORT_MARGIN);
    if !inner.is_positive() {
        return;
    }
    let mut corner = |name: &str, layout: Layout, content: &mut dyn FnMut(&mut Ui)| {
        let builder = UiBuilder::new().id_salt(name).max_rect(inner).layout(layout);
        ui.scope_builder(builder, |ui| {
            ui.set_clip_rect(rect.intersect(ui.clip_rect()));
            theme::overlay(ui).show(ui, |ui| ui.horizontal(|ui| content(ui)));
        });
    };
    if !matches!(reading.view.tool, Tool::Select) {
        corner("tool options", Layout::left_to_right(egui::Align::Min), &mut |ui| options(ui, reading, actions));
    }
    corner("cameras", Layout::right_to_left(egui::Align::Min), &mut |ui| cameras(ui, reading, actions));
}

fn options(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let view = reading.view;
    if view.tool == Tool::Box {
        let mut altitude = view.base_altitude_m(reading.session.scene());
        if labelled(ui, "Base", &BASE_ALTITUDE, &mut altitude) {
            actions.push(Action::View(ViewChange::BaseAltitude(altitude)));
        }
    }
    let snap = egui::Button::new(icon::MAGNET).selected(view.snap.on);
    let response = ui.add(snap);
    name_it(ui, &response, "Snap to steps");
    if response.on_hover_text(Command::Snap.row().tooltip(ui.ctx())).clicked() {
        actions.push(Action::Command(Command::Snap));
    }
    let mut snap = view.snap;
    let changed = if view.tool == Tool::Rotate {
        labelled(ui, "", &SNAP_ANGLE, &mut snap.angle_deg)
    } else {
        labelled(ui, "", &SNAP_STEP, &mut snap.step_m)
    };
    if changed && snap != view.snap {
        actions.push(Action::View(ViewChange::Snap(Snap { on: true, ..snap })));
    }
}

/// A number under its number's label; on the screen it may be shorter.
fn labelled(ui: &mut Ui, shown: &str, number: &Number, value: &mut f64) -> bool {
    if !shown.is_empty() {
        ui.label(shown);
    }
    number_field(ui, number.label, number, value, false)
}

fn cameras(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let menu = ui.menu_button(icon::VIDEO_CAMERA, |ui| {
        for camera in &reading.session.scene().cameras {
            let name = camera_name(camera);
            let response = ui.button(&name);
            name_it(ui, &response, &format!("Look through {name}"));
            if response.clicked() {
                actions.push(Action::LookThrough(camera.id));
            }
        }
        if !reading.session.scene().cameras.is_empty() {
            ui.separator();
            if ui.button("Align camera to view").clicked() {
                actions.push(Action::Command(Command::AlignCamera));
            }
        }
        if ui.button("Add camera from view").clicked() {
            actions.push(Action::Command(Command::AddCamera));
        }
    });
    name_it(ui, &menu.response, "Cameras");
    menu.response.on_hover_text("Look through a camera");
    if let Some(method) = reading.view.method {
        let response = ui.button(format!("{} {}", icon::X, method.name));
        name_it(ui, &response, &format!("Drawn by {}", method.name));
        let help = format!("{} A click goes back to the window's own way.", method.about);
        if response.on_hover_text(help).clicked() {
            actions.push(Action::View(ViewChange::Method(None)));
        }
    }
}

/// A camera in words.
pub(super) fn camera_name(camera: &Camera) -> String {
    if camera.name.is_empty() { format!("camera {}", camera.id) } else { camera.name.clone() }
}

/// What the primary button does, and how the view is moved.
pub(super) fn hint(painter: &Painter, rect: Rect, tool: Tool, drawing: bool) {
    let tool = match (tool, drawing) {
        (Tool::Select, _) => "click: choose, again: behind   drag: marquee",
        (Tool::Move, _) => "arrows and squares: move   Ctrl: snap",
        (Tool::Rotate, _) => "rings: turn   Ctrl: snap",
        (Tool::Scale, _) => "handles: stretch   Ctrl: snap",
        (Tool::Box, false) => "drag: footprint   Enter: box in the middle   Ctrl: snap",
        (Tool::Box, true) => "pull the height   click or Enter: done   Esc: drop",
    };
    let text = format!("{tool}   middle or Alt drag: turn, with Shift: move   hold right: fly   wheel: nearer");
    at_the_foot(painter, rect, &text);
}

/// What pointer and keys do while the selection follows the pointer.
pub(super) fn grab_hint(painter: &Painter, rect: Rect) {
    at_the_foot(
        painter,
        rect,
        "X Y Z: along an axis   with Shift: across it   figures: by so much   Ctrl: snap   click or Enter: done   Esc: drop",
    );
}

/// What pointer and keys do while one flies.
pub(super) fn flying_hint(painter: &Painter, rect: Rect, speed: &str) {
    let text = format!("W S A D: fly   E Q: up, down   wheel: {speed}   Shift: fast   Ctrl: slow   Esc: stop");
    at_the_foot(painter, rect, &text);
}

/// On board of a path.
pub(super) fn on_board_hint(painter: &Painter, rect: Rect) {
    at_the_foot(painter, rect, "on board   drag or fly: leave the path here   Esc: back to the view from before");
}

/// That what is flown is recorded, at the picture's head.
pub(super) fn recording(painter: &Painter, rect: Rect) {
    let at = rect.center_top() + vec2(0.0, theme::VIEWPORT_MARGIN);
    text_on_shade(painter, at, Align2::CENTER_TOP, &format!("{} recording", icon::RECORD));
}

fn at_the_foot(painter: &Painter, rect: Rect, text: &str) {
    let at = rect.left_bottom() + vec2(theme::VIEWPORT_MARGIN, -theme::VIEWPORT_MARGIN);
    text_on_shade(painter, at, Align2::LEFT_BOTTOM, text);
}

/// Words at a place in the picture, their upper left corner; moved in where the rim would cut them off.
pub(super) fn label(painter: &Painter, at: Pos2, text: &str) {
    text_on_shade(painter, at, Align2::LEFT_TOP, text);
}

/// Words that screen readers read too, on the side of a place that `align` says.
pub(super) fn words(ui: &mut Ui, at: Pos2, align: Align2, text: &str) {
    words_on(ui, at, align, text, Color32::TRANSPARENT);
}

/// The same on a shade.
pub(super) fn plate(ui: &mut Ui, at: Pos2, align: Align2, text: &str) {
    words_on(ui, at, align, text, theme::VIEWPORT_SHADE);
}

fn words_on(ui: &mut Ui, at: Pos2, align: Align2, text: &str, shade: Color32) {
    let font = FontId::proportional(theme::SMALL_TEXT);
    let size = ui.painter().layout_no_wrap(text.into(), font.clone(), theme::VIEWPORT_TEXT).size();
    let place = align.anchor_size(at, size);
    ui.painter().rect_filled(place.expand2(PLATE), 4.0, shade);
    let text = RichText::new(text).font(font).color(theme::VIEWPORT_TEXT);
    ui.put(place, Label::new(text).selectable(false).extend());
}

fn text_on_shade(painter: &Painter, at: Pos2, align: Align2, text: &str) {
    let room = painter.clip_rect().shrink2(PLATE);
    let width = room.width() - 2.0 * theme::VIEWPORT_MARGIN;
    let galley = painter.layout(text.into(), FontId::proportional(11.0), theme::VIEWPORT_TEXT, width);
    let text_rect = align.anchor_size(at, galley.size());
    let inwards = (room.right() - text_rect.right()).min(0.0).max(room.left() - text_rect.left());
    let upwards = (room.bottom() - text_rect.bottom()).min(0.0).max(room.top() - text_rect.top());
    let text_rect = text_rect.translate(vec2(inwards, upwards));
    painter.rect_filled(text_rect.expand2(PLATE), 4.0, theme::VIEWPORT_SHADE);
    painter.galley(text_rect.min, galley, theme::VIEWPORT_TEXT);
}
