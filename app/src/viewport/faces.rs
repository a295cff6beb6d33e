//! Handles on the six faces of the selected box: each drags its face along the normal while the opposite face stays.
//!
//! They are widgets, so they take the pointer before the viewport does, and arrow keys move a focused one by a step.

use super::grip;
use super::onto::{Met, Planes};
use super::overlay;
use super::places::Places;
use super::screen::Screen;
use crate::state::{Action, Item, Reading, Tool, box_of};
use crate::theme;
use crate::widget::name_it;
use cloudwright_core::arrange::{ModelSpace, fill};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::BOX_SIZE;
use cloudwright_core::scene::{BoxId, CloudBox, ModelId};
use egui::{CursorIcon, EventFilter, Key, Modifiers, Painter, Pos2, Rect, Response, Sense, StrokeKind, Ui, Vec2, vec2};
use glam::DVec3;

const NAME: &str = "Move face";
/// On the screen; the handles of a smaller box would lie on one another. Points.
const LEAST_BOX: f32 = 36.0;
/// So flat is a box at least that was dragged flat, metres.
const LEAST_SIDE_M: f64 = 1.0;

/// Along which axis of the box, and on which side: −1 or 1.
#[derive(Debug, Clone, Copy)]
struct Face {
    axis: usize,
    side: f64,
}

impl Face {
    fn all() -> impl Iterator<Item = Self> {
        (0..3).flat_map(|axis| [-1.0, 1.0].map(|side| Self { axis, side }))
    }

    fn name(self) -> String {
        format!("Face {}{}", if self.side < 0.0 { "−" } else { "+" }, ["x", "y", "z"][self.axis])
    }

    /// Out of the box, in its own axes.
    fn normal(self) -> DVec3 {
        DVec3::AXES[self.axis] * self.side
    }

    fn center_in_world(self, space: &ModelSpace, each: &CloudBox) -> DVec3 {
        space.to_world(each.center + each.orientation * (self.normal() * (each.size[self.axis] * 0.5)))
    }

    /// The box when this face is moved outwards by `by`, metres of the model; `least` is the least that stays. Its sprites go
    /// along if it `keeps_fill`.
    fn moved(self, each: &CloudBox, by: f64, least: f64, keeps_fill: bool) -> CloudBox {
        let old = each.size[self.axis];
        let side = (old + by).clamp(least.min(BOX_SIZE.max), BOX_SIZE.max);
        let mut size = each.size;
        size[self.axis] = side;
        let mut new = if keeps_fill { fill::resized(each, size) } else { CloudBox { size, ..each.clone() } };
        new.center += each.orientation * (self.normal() * ((side - old) * 0.5));
        new
    }
}

/// The handles and the drag of one.
#[derive(Debug, Default)]
pub(super) struct Faces {
    held: Option<Held>,
}

#[derive(Debug)]
struct Held {
    face: Face,
    start: CloudBox,
    model: ModelId,
    space: ModelSpace,
    /// Where the drag began.
    from: Pos2,
    /// What the face may snap onto.
    onto: Planes,
}

impl Faces {
    /// Shows the handles where exactly one box is selected that may be changed, and asks for what the hand does. A click
    /// on a handle is meant for what lies there: its place.
    pub(super) fn show(
        &mut self,
        ui: &Ui,
        painter: &Painter,
        screen: &Screen,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) -> Option<Pos2> {
        if ui.input(|input| !input.pointer.primary_down() || input.key_pressed(Key::Escape)) {
            self.held = None;
        }
        let (space, model, each) = the_box(reading)?;
        let mut clicked = None;
        let centers =
            Face::all().map(|face| (face, screen.project(screen.relative(face.center_in_world(&space, each)))));
        let centers: Vec<(Face, Pos2)> = centers.filter_map(|(face, at)| Some((face, at?))).collect();
        let around = Rect::from_points(&centers.iter().map(|(_, at)| *at).collect::<Vec<_>>());
        if around.size().max_elem() < LEAST_BOX && self.held.is_none() {
            return None;
        }
        let grips = grip::grips(&centers.iter().map(|(_, at)| *at).collect::<Vec<_>>());
        for ((face, at), grip) in centers.into_iter().zip(grips).filter(|((_, at), _)| screen.rect.contains(*at)) {
            // Of this view: there may be four.
            let id = ui.scope_id().with(("box face", face.axis, face.side < 0.0));
            let response = ui.interact(grip, id, Sense::click_and_drag());
            name_it(ui, &response, &face.name());
            if response.drag_started_by(egui::PointerButton::Primary) {
                let from = ui.input(|input| input.pointer.press_origin()).unwrap_or(at);
                let normal = space.turn * each.orientation * face.normal();
                let own = |_, of: ModelId, id: BoxId| (of, id) == (model, each.id);
                let onto = Planes::across(normal, own, screen, reading);
                self.held = Some(Held { face, start: each.clone(), model, space, from, onto });
            }
            if response.dragged()
                && let (Some(held), Some(to)) = (&self.held, response.interact_pointer_pos())
                && let Some((new, met)) = held.dragged(to, snap_m(ui, reading), reading.view.keep_fill, screen)
            {
                let side_m = new.size[face.axis] * space.scale;
                if let Some(met) = met {
                    met.paint(painter, screen);
                }
                overlay::label(painter, to + vec2(16.0, 16.0), &format!("{side_m:.1} m"));
                actions.push(Action::change(NAME, Edit::Box(held.model, ListEdit::Replace(new)), true));
            }
            if response.clicked() {
                clicked = response.interact_pointer_pos();
            }
            actions.extend(by_keys(ui, &response, face, model, each, &space, reading));
            paint(painter, at, &response);
        }
        clicked
    }
}

impl Held {
    /// The box with its face where the hand is, or in the face of another one that it snaps onto.
    fn dragged(
        &self,
        to: Pos2,
        snap_m: Option<f64>,
        keeps_fill: bool,
        screen: &Screen,
    ) -> Option<(CloudBox, Option<Met>)> {
        let Self { face, start, space, from, onto, .. } = self;
        let normal = space.turn * start.orientation * face.normal();
        let center = face.center_in_world(space, start);
        let pulled_m = screen.along(to, center, normal)? - screen.along(*from, center, normal)?;
        let old_m = start.size[face.axis] * space.scale;
        let hand = center + normal * pulled_m;
        let met = snap_m.and_then(|_| onto.nearest([onto.along(hand)], hand, screen));
        // Onto a face that lies behind the opposite one it can't.
        let met = met.filter(|met| old_m + pulled_m + met.by_m >= LEAST_SIDE_M);
        let (side_m, least_m) = match (&met, snap_m) {
            (Some(met), _) => (old_m + pulled_m + met.by_m, LEAST_SIDE_M),
            (None, Some(step)) => (((old_m + pulled_m) / step).round() * step, step),
            (None, None) => (old_m + pulled_m, LEAST_SIDE_M),
        };
        Some((face.moved(start, (side_m - old_m) / space.scale, least_m / space.scale, keeps_fill), met))
    }
}

/// The one selected box, if handles belong on it.
fn the_box<'a>(reading: &Reading<'a>) -> Option<(ModelSpace, ModelId, &'a CloudBox)> {
    let (view, scene) = (reading.view, reading.session.scene());
    let [item @ Item::Box(model, id)] = view.selection.items() else { return None };
    if !matches!(view.tool, Tool::Select | Tool::Scale) || view.locked.contains(item) || view.hidden.contains(item) {
        return None;
    }
    let cloud = view.selection.cloud(scene).filter(|cloud| view.can_pick(scene, cloud) && cloud.scale > 0.0)?;
    Some((ModelSpace::of(&Places::of(reading).seen(cloud)), *model, box_of(scene, *model, *id)?))
}

fn snap_m(ui: &Ui, reading: &Reading<'_>) -> Option<f64> {
    let snap = reading.view.snap;
    let on = snap.on != ui.input(|input| input.modifiers.command);
    on.then_some(snap.step_m).filter(|step| *step > 0.0)
}

/// Up and right push the focused face out, down and left pull it in.
fn by_keys(
    ui: &Ui,
    response: &Response,
    face: Face,
    model: ModelId,
    each: &CloudBox,
    space: &ModelSpace,
    reading: &Reading<'_>,
) -> Option<Action> {
    if !response.has_focus() {
        return None;
    }
    let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
    let steps = ui.input_mut(|input| {
        let mut pressed = |key| f64::from(input.consume_key(Modifiers::NONE, key));
        pressed(Key::ArrowUp) + pressed(Key::ArrowRight) - pressed(Key::ArrowDown) - pressed(Key::ArrowLeft)
    });
    let by = steps * reading.view.snap.step_m / space.scale;
    let new = face.moved(each, by, LEAST_SIDE_M / space.scale, reading.view.keep_fill);
    (steps != 0.0).then(|| Action::change(NAME, Edit::Box(model, ListEdit::Replace(new)), false))
}

fn paint(painter: &Painter, at: Pos2, response: &Response) {
    let lit = response.hovered() || response.dragged() || response.has_focus();
    let (size, color) = if lit { (10.0, theme::GIZMO_HOVERED) } else { (7.0, theme::SELECTED_BOX.color) };
    let square = Rect::from_center_size(at, Vec2::splat(size));
    painter.rect(square, 1.0, color, theme::HANDLE_RIM, StrokeKind::Outside);
    if lit {
        painter.ctx().set_cursor_icon(CursorIcon::PointingHand);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;

    #[test]
    fn the_opposite_face_stays() {
        let mut each = CloudBox::new(BoxId(1), DVec3::new(1.0, 2.0, 3.0));
        each.orientation = DQuat::from_rotation_z(0.4);
        let space = ModelSpace { origin: DVec3::new(9.0, 8.0, 7.0), turn: DQuat::from_rotation_y(1.0), scale: 2.0 };
        for face in Face::all() {
            let opposite = Face { side: -face.side, ..face };
            for by in [120.0, -80.0, -1e9, 1e9] {
                let new = face.moved(&each, by, 1.0, true);
                let before = opposite.center_in_world(&space, &each);
                let after = opposite.center_in_world(&space, &new);
                assert!(before.distance(after) < 1e-6, "{}: {after}", face.name());
                assert!(new.size[face.axis] >= 1.0 && new.size[face.axis] <= BOX_SIZE.max);
            }
        }
    }
}
