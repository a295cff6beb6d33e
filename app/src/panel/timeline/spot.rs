//! What of the timeline can be taken by a hand in this frame, and how keys look.

use crate::theme;
use cloudwright_core::arrange::keys::KeyPlace;
use cloudwright_core::scene::{Leaves, TrackId, TrackKey};
use egui::accesskit::Role;
use egui::{Color32, Id, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, vec2};
use std::ops::Range;

/// From its middle to a corner, points.
pub(super) const RADIUS: f32 = 5.0;
/// So near to a key a press means it, points.
const REACH: f32 = 8.0;

/// Something to take.
#[derive(Debug, Clone)]
pub(super) struct Spot {
    pub(super) at: Pos2,
    pub(super) what: What,
    /// When it stands, seconds.
    pub(super) time_s: f64,
}

/// What is taken there.
#[derive(Debug, Clone)]
pub(super) enum What {
    /// A key; in the curves, one of its numbers.
    Key(KeyPlace, Option<usize>),
    /// All keys at that time of some of the found tracks.
    Sum(Range<usize>),
    /// A handle of a curve: of which number, after the key or before it.
    Handle { key: KeyPlace, part: usize, leaves: bool },
}

/// The nearest of `spots` to a press.
pub(super) fn under(spots: &[Spot], at: Pos2) -> Option<&Spot> {
    let near = spots.iter().filter(|spot| spot.at.distance(at) <= REACH);
    near.min_by(|a, b| a.at.distance(at).total_cmp(&b.at.distance(at)))
}

/// Has screen readers and tests know of a key. Whether they clicked it.
pub(super) fn announce(ui: &Ui, id: Id, at: Pos2, is_chosen: bool, name: impl Fn() -> String) -> bool {
    let rect = Rect::from_center_size(at, Vec2::splat(2.0 * RADIUS));
    let response = ui.interact(rect, id, Sense::hover());
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_chosen, name()));
    ui.ctx().accesskit_node_builder(id, |node| node.add_action(egui::accesskit::Action::Click));
    ui.input(|input| input.has_accesskit_action_request(id, egui::accesskit::Action::Click))
}

/// A key: a square if it is left by step, a diamond if straight, a disc if smoothly.
pub(super) fn paint(painter: &Painter, at: Pos2, key: &TrackKey, fill: Color32, edge: Stroke) {
    shape(painter, at, key.leaves, RADIUS, fill, edge);
    if key.handles.is_some() {
        painter.hline(at.x - RADIUS - 3.0..=at.x - RADIUS, at.y, edge);
        painter.hline(at.x + RADIUS..=at.x + RADIUS + 3.0, at.y, edge);
    }
}

pub(super) fn shape(painter: &Painter, at: Pos2, leaves: Leaves, radius: f32, fill: Color32, edge: Stroke) {
    match leaves {
        Leaves::Step => {
            let side = Vec2::splat(radius * 1.7);
            painter.rect(Rect::from_center_size(at, side), 0.0, fill, edge, egui::StrokeKind::Middle);
        }
        Leaves::Linear => {
            let corners = [vec2(0.0, -radius), vec2(radius, 0.0), vec2(0.0, radius), vec2(-radius, 0.0)];
            let corners = corners.map(|corner| at + corner * 1.15).to_vec();
            painter.add(Shape::convex_polygon(corners, fill, edge));
        }
        Leaves::Smooth => {
            painter.circle(at, radius * 0.95, fill, edge);
        }
    }
}

/// Of a track's curve among others.
pub(super) fn tint_of(track: TrackId) -> Color32 {
    theme::group_tint(track.0)
}

/// Around a key, chosen or not.
pub(super) fn edge(ui: &Ui, is_chosen: bool) -> Stroke {
    if is_chosen {
        Stroke::new(2.0, theme::CHOSEN)
    } else {
        Stroke::new(1.0, if ui.visuals().dark_mode { Color32::from_gray(16) } else { Color32::from_gray(60) })
    }
}
