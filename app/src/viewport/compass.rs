//! The compass in the viewport's upper right corner: the world's axes as the view sees them. A click on an end looks from
//! there, a second one from the opposite side; a drag turns the view.

use super::overlay;
use super::screen::Screen;
use super::side::Side;
use crate::state::Action;
use crate::theme;
use crate::widget::name_it;
use egui::{Align2, Color32, CursorIcon, FontId, Pos2, Rect, Sense, Stroke, Ui, Vec2, vec2};

/// From its middle to an end's, points.
const ARM: f32 = 30.0;
/// Of an end, points.
const END: f32 = 9.0;
/// Of a drag across it, in points of a drag across the picture: half a turn takes its width.
const PACE: f32 = 6.0;
/// Below the corner's menu, points.
const BELOW: f32 = 48.0;
/// A viewport that is less high and wide has none, points: its clouds and their handles need the room.
const LEAST_ROOM: Vec2 = vec2(400.0, 300.0);

/// Where it stands in `rect`; none where it would be in the way.
pub(super) fn place(rect: Rect) -> Option<Rect> {
    let size = Vec2::splat(2.0 * (ARM + END + 2.0));
    let corner = rect.right_top() + vec2(-theme::VIEWPORT_MARGIN - size.x, BELOW);
    (rect.width() >= LEAST_ROOM.x && rect.height() >= LEAST_ROOM.y).then(|| Rect::from_min_size(corner, size))
}

/// Shows it and asks for another view; how far a hand turns this one, points of a drag across the picture.
pub(super) fn show(ui: &mut Ui, place: Rect, screen: &Screen, orthographic: bool, actions: &mut Vec<Action>) -> Vec2 {
    let view = &screen.view;
    let middle = place.center();
    let ball = ui.interact(place, ui.scope_id().with("compass"), Sense::drag());
    name_it(ui, &ball, "Compass");
    let mut turned = ball.drag_delta();
    let mut ends = Side::ALL.map(|side| {
        let direction = side.direction().as_vec3();
        let at = middle + vec2(direction.dot(view.right), -direction.dot(view.up)) * ARM;
        (direction.dot(view.forward), side, at)
    });
    // Away from the eye first, so that what is near lies on top and has the pointer.
    ends.sort_by(|a, b| b.0.total_cmp(&a.0));
    let painter = ui.painter_at(place.expand(1.0));
    let ring = if ball.hovered() || ball.dragged() { theme::HUD_SHADE } else { theme::VIEWPORT_SHADE };
    painter.circle_filled(middle, place.width() * 0.5, ring);
    for (depth, side, at) in ends {
        let looks_from = depth < -0.999;
        let response = ui.interact(
            Rect::from_center_size(at, Vec2::splat(2.0 * END)),
            ui.scope_id().with(("compass", side.words())),
            Sense::click_and_drag(),
        );
        turned += response.drag_delta();
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name(side)));
        let lit = response.hovered() || response.has_focus();
        end(&painter, middle, at, side, depth, lit);
        if response.clicked() {
            let side = if looks_from { side.opposite() } else { side };
            actions.push(Action::Command(side.command()));
        }
        let row = side.command().row();
        response.on_hover_cursor(CursorIcon::PointingHand).on_hover_text(row.tooltip(ui.ctx()));
    }
    let side = ends.iter().find(|(depth, ..)| *depth < -0.999_999).map(|(_, side, _)| side.words());
    let words: Vec<&str> = side.into_iter().chain(orthographic.then_some("orthographic")).collect();
    if !words.is_empty() {
        overlay::plate(ui, place.right_bottom() + vec2(-6.0, 8.0), Align2::RIGHT_TOP, &words.join(", "));
    }
    turned * PACE
}

fn name(side: Side) -> String {
    format!("Look {}", side.words())
}

/// One end: those of the positive axes filled, with a line from the middle; the others as rings.
fn end(painter: &egui::Painter, middle: Pos2, at: Pos2, side: Side, depth: f32, lit: bool) {
    let color = match side {
        Side::East | Side::West => theme::AXIS_X,
        Side::Top | Side::Bottom => theme::AXIS_Y,
        Side::South | Side::North => theme::AXIS_Z,
    };
    let dark = Color32::from_rgb(24, 26, 30);
    // What is farther is dimmer.
    let color = if lit { theme::GIZMO_HOVERED } else { theme::mix(color, dark, (0.25 + 0.3 * depth).max(0.0)) };
    let is_positive = matches!(side, Side::East | Side::Top | Side::South);
    if is_positive {
        painter.line_segment([middle, at], Stroke::new(2.0, color));
        painter.circle_filled(at, END, color);
    } else {
        painter.circle(at, END, theme::mix(color, dark, 0.65), Stroke::new(1.5, color));
    }
    let ink = if is_positive || lit { dark } else { theme::VIEWPORT_TEXT };
    painter.text(at, Align2::CENTER_CENTER, side.letter(), FontId::proportional(theme::SMALL_TEXT), ink);
}
