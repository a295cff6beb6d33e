//! The colour levels on the cloud itself: a thin upright scale at the selected cloud's right side, from its bottom to
//! its top as the view sees them, with the five levels as handles.
//!
//! It shows while the panel of colour levels does. A cloud that the view looks down on, or that is too small to take a
//! handle of, has none.

use super::grip;
use super::places::Places;
use crate::state::{Action, Reading, color_levels};
use crate::theme;
use crate::widget::{Handle, LEVEL_STEP, choose_level, chosen_level, color32};
use cloudwright_core::camera::View;
use cloudwright_core::color::Rgba;
use cloudwright_core::property::LEVEL_HEIGHT;
use cloudwright_core::sprites::PlacedCloud;
use egui::{CursorIcon, Pos2, Rect, Stroke, Ui, pos2, vec2};
use glam::Vec3;

/// Between the cloud and its scale, and between the scale and the viewport's rim, points.
const GAP: f32 = 14.0;
/// A shorter scale is of no use, points.
const MIN_LENGTH: f32 = 40.0;
/// Of a handle, points.
const RADIUS: f32 = 5.0;
/// Of a cloud with more sprites, evenly chosen ones tell its width.
const MAX_SPRITES: usize = 1000;

/// Shows the scale, to the left of `right`.
pub(super) fn show(ui: &mut Ui, rect: Rect, right: f32, view: &View, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let scene = reading.session.scene();
    let selection = &reading.view.selection;
    let placed = selection.cloud(scene).filter(|cloud| reading.levels_shown && reading.view.shows(scene, cloud));
    let model = selection.model(scene);
    let Some((cloud, model)) = placed.and_then(|cloud| reading.session.placed(cloud.id)).zip(model) else {
        return;
    };
    // The eye stands to the cloud at rest as it does to the cloud where it is seen.
    let carried = placed.map_or(cloud.origin, |placed| Places::of(reading).middle(placed)) - cloud.origin;
    let view = View { eye: view.eye - carried, ..*view };
    let Some(scale) = Scale::new(cloud, &view, rect, right) else { return };
    let painter = ui.painter_at(rect);
    painter.line_segment([scale.bottom, scale.top], Stroke::new(3.0, theme::VIEWPORT_SHADE));
    painter.line_segment([scale.bottom, scale.top], Stroke::new(1.0, theme::VIEWPORT_TEXT));

    let shown = color_levels::shown(reading, model);
    let mut levels = shown;
    let mut live = false;
    let mut chosen = chosen_level(ui.ctx());
    let mut beside = 0.0;
    let middles = shown.iter().enumerate().map(|(index, level)| {
        let at = scale.at(level.height);
        let near = index > 0 && scale.at(shown[index - 1].height).distance(at) < 2.0 * RADIUS;
        beside = if near { beside + 2.0 * RADIUS + 1.0 } else { 0.0 };
        at + vec2(beside, 0.0)
    });
    let middles: Vec<Pos2> = middles.collect();
    for ((index, level), grip) in shown.iter().enumerate().zip(grip::grips(&middles)) {
        let middle = middles[index];
        if !rect.contains(middle) {
            continue;
        }
        let handled = Handle {
            id: ui.scope_id().with(("level on the cloud", index)),
            rect: grip,
            name: &format!("Level {} on the cloud", index + 1),
            number: &LEVEL_HEIGHT,
            value: level.height,
            step: LEVEL_STEP,
        }
        .show(ui, |start, way| scale.height(scale.at(start) + way));
        if let Some(height) = handled.wanted {
            levels = color_levels::moved(shown, index, height);
            live = handled.live;
        }
        let tag = handled.response;
        if tag.clicked() || tag.gained_focus() || handled.wanted.is_some() {
            chosen = index;
        }
        let edge = if index == chosen { theme::CHOSEN } else { theme::VIEWPORT_TEXT };
        let radius = if tag.hovered() || tag.dragged() || tag.has_focus() { RADIUS + 1.5 } else { RADIUS };
        painter.circle_filled(middle, radius + 2.0, theme::VIEWPORT_SHADE);
        painter.circle(middle, radius, color32(Rgba { a: 1.0, ..level.color }), Stroke::new(1.5, edge));
        tag.on_hover_cursor(CursorIcon::ResizeVertical).on_hover_text(format!(
            "Level {}: height {:.3}",
            index + 1,
            level.height
        ));
    }
    choose_level(ui.ctx(), chosen);
    actions.extend(color_levels::change(reading, &levels, live));
}

/// An upright line in the world on the screen.
struct Scale {
    bottom: Pos2,
    top: Pos2,
    /// View depths of both ends, metres: the far half looks shorter.
    depths: [f32; 2],
}

impl Scale {
    fn new(cloud: &PlacedCloud, view: &View, rect: Rect, right: f32) -> Option<Self> {
        let level = Vec3::new(view.right.x, 0.0, view.right.z).try_normalize()?;
        let step = cloud.sprites.len().div_ceil(MAX_SPRITES).max(1);
        let out = |p: Vec3| (p - cloud.center).dot(level);
        let sideways = cloud.sprites.iter().step_by(step).map(|sprite| out(sprite.position) + sprite.radius());
        let side = cloud.center + level * sideways.reduce(f32::max)?;
        let ends =
            [cloud.bottom, cloud.top].map(|y| (cloud.origin - view.eye).as_vec3() + Vec3::new(side.x, y, side.z));
        let on_screen = |end: Vec3| view.project(end).map(|at| pos2(rect.left() + at.x + GAP, rect.top() + at.y));
        let (bottom, top) = (on_screen(ends[0])?, on_screen(ends[1])?);
        // A cloud that reaches out of the picture keeps its scale at the rim; one that is outside has none.
        let out = (bottom.x.max(top.x) - (right - GAP)).max(0.0);
        let (bottom, top) = (bottom - vec2(out, 0.0), top - vec2(out, 0.0));
        let visible = out < rect.width() && bottom.x.min(top.x) > rect.left() && bottom.y > rect.top();
        let scale = Self { bottom, top, depths: ends.map(|end| view.depth(end)) };
        let upright = bottom.y - top.y >= MIN_LENGTH && top.y < rect.bottom();
        (visible && upright && bottom.is_finite() && top.is_finite()).then_some(scale)
    }

    /// Where a height within the cloud shows.
    fn at(&self, height: f64) -> Pos2 {
        let [near, far] = self.depths;
        let height = height.clamp(0.0, 1.0) as f32;
        let share = height * far / (near + (far - near) * height);
        self.bottom + (self.top - self.bottom) * share
    }

    /// The inverse of [`Scale::at`], for the nearest point of the line.
    fn height(&self, at: Pos2) -> f64 {
        let [near, far] = self.depths;
        let along = self.top - self.bottom;
        let share = ((at - self.bottom).dot(along) / along.length_sq()).clamp(0.0, 1.0);
        f64::from(share * near / (far + (near - far) * share))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_lie_where_the_view_sees_them() {
        let scale = Scale { bottom: pos2(10.0, 300.0), top: pos2(40.0, 100.0), depths: [900.0, 2000.0] };
        for height in [0.0, 0.2, 0.5, 0.9, 1.0] {
            assert!((scale.height(scale.at(height)) - height).abs() < 1e-5, "{height}");
        }
        // The far half is shorter: its middle shows above the line's.
        assert!(scale.at(0.5).y < 200.0);
        assert_eq!(scale.height(pos2(-500.0, 9000.0)), 0.0);
    }
}
