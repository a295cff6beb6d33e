//! Outlines of boxes, painted over the picture: in the world, cut off at the near plane and at the viewport's rim.

use crate::editor::{Item, ViewState};
use crate::theme;
use cloudwright_core::camera::{NEAR_M, View};
use cloudwright_core::scene::{Cloud, CloudBox, Scene};
use egui::{Painter, Pos2, Rect, Stroke, pos2};
use glam::{DQuat, DVec3, Vec3};

/// Corner indices: bit 0 is x, bit 1 y, bit 2 z.
const EDGES: [(usize, usize); 12] =
    [(0, 1), (2, 3), (4, 5), (6, 7), (0, 2), (1, 3), (4, 6), (5, 7), (0, 4), (1, 5), (2, 6), (3, 7)];

/// Paints the boxes that the selection asks for, and all if the view says so.
pub(super) fn paint(painter: &Painter, rect: Rect, view: &View, scene: &Scene, state: &ViewState) {
    // What is selected comes last, on top.
    let mut on_top = Vec::new();
    for cloud in scene.clouds.iter().filter(|cloud| state.shows(cloud)) {
        let Some(model) = scene.model(cloud.model) else { continue };
        for each in &model.boxes {
            match stroke_of(cloud, each, state) {
                Some(stroke) => on_top.push((cloud, each, stroke)),
                None if state.show_all_boxes => outline(painter, rect, view, cloud, each, theme::OTHER_BOX),
                None => {}
            }
        }
    }
    on_top.sort_by_key(|(.., stroke)| *stroke == theme::SELECTED_BOX);
    for (cloud, each, stroke) in on_top {
        outline(painter, rect, view, cloud, each, stroke);
    }
}

/// How a box stands out; none for one that has nothing to do with the selection.
fn stroke_of(cloud: &Cloud, each: &CloudBox, state: &ViewState) -> Option<Stroke> {
    let strokes = state.selection.items().iter().filter_map(|item| match *item {
        Item::Box(of, id) if of == cloud.model && id == each.id => Some(theme::SELECTED_BOX),
        Item::Cloud(id) if id == cloud.id => Some(theme::SELECTED_BOX),
        Item::Model(of) | Item::Box(of, _) | Item::Sprite(of, ..) | Item::Group(of, _) if of == cloud.model => {
            Some(theme::RELATED_BOX)
        }
        _ => None,
    });
    strokes.max_by_key(|stroke| *stroke == theme::SELECTED_BOX)
}

/// A point of a cloud's model in the world.
pub(super) fn to_world(cloud: &Cloud, point: DVec3) -> DVec3 {
    // Headings turn clockwise from above, which is negative about +y.
    DQuat::from_rotation_y(-cloud.heading_deg.to_radians()) * (point * cloud.scale) + cloud.position
}

fn outline(painter: &Painter, rect: Rect, view: &View, cloud: &Cloud, each: &CloudBox, stroke: Stroke) {
    let corner = |i: usize| {
        let sign = |bit: usize| if i & bit == 0 { -0.5 } else { 0.5 };
        let in_box = each.size * DVec3::new(sign(1), sign(2), sign(4));
        (to_world(cloud, each.center + each.orientation * in_box) - view.eye).as_vec3()
    };
    let corners: [Vec3; 8] = std::array::from_fn(corner);
    for (a, b) in EDGES {
        if let Some([from, to]) = on_screen(view, rect, corners[a], corners[b]) {
            painter.line_segment([from, to], stroke);
        }
    }
}

/// The part of an eye-relative edge that shows.
fn on_screen(view: &View, rect: Rect, a: Vec3, b: Vec3) -> Option<[Pos2; 2]> {
    let (a, b) = before_near_plane(view, a, b)?;
    let to_screen = |p: Vec3| view.project(p).map(|at| pos2(rect.left() + at.x, rect.top() + at.y));
    within(rect, to_screen(a)?, to_screen(b)?)
}

/// Cut where it passes the near plane; a hair's breadth before it, so that rounding can't put the end behind.
fn before_near_plane(view: &View, a: Vec3, b: Vec3) -> Option<(Vec3, Vec3)> {
    const NEAR: f32 = NEAR_M * 1.001;
    let (depth_a, depth_b) = (view.depth(a), view.depth(b));
    let cut = || a + (b - a) * ((NEAR - depth_a) / (depth_b - depth_a));
    match (depth_a >= NEAR, depth_b >= NEAR) {
        (true, true) => Some((a, b)),
        (true, false) => Some((a, cut())),
        (false, true) => Some((cut(), b)),
        (false, false) => None,
    }
}

/// The part of a line within a rectangle (Liang and Barsky): near the eye its ends lie millions of points away.
fn within(rect: Rect, a: Pos2, b: Pos2) -> Option<[Pos2; 2]> {
    let delta = b - a;
    let (mut enter, mut leave) = (0.0_f32, 1.0_f32);
    for (step, to_edge) in [
        (-delta.x, a.x - rect.left()),
        (delta.x, rect.right() - a.x),
        (-delta.y, a.y - rect.top()),
        (delta.y, rect.bottom() - a.y),
    ] {
        if step == 0.0 {
            if to_edge < 0.0 {
                return None;
            }
        } else if step < 0.0 {
            enter = enter.max(to_edge / step);
        } else {
            leave = leave.min(to_edge / step);
        }
    }
    (enter <= leave).then(|| [a + delta * enter, a + delta * leave])
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::scene::Camera;

    #[test]
    fn edges_are_cut_at_the_near_plane_and_the_rim() {
        let rect = Rect::from_min_max(pos2(10.0, 20.0), pos2(110.0, 120.0));
        let view = View::new(&Camera::free(DVec3::ZERO), 100, 100);
        let ahead = |x: f32, y: f32, depth: f32| Vec3::new(x, y, -depth);
        let seen = on_screen(&view, rect, ahead(-1.0, 0.0, 10.0), ahead(1.0, 0.0, 10.0)).expect("in view");
        assert!((seen[0].y - 70.0).abs() < 1e-3 && seen[0].x < seen[1].x);
        assert!(on_screen(&view, rect, ahead(0.0, 0.0, -5.0), ahead(1.0, 0.0, -1.0)).is_none(), "behind the eye");
        assert!(on_screen(&view, rect, ahead(9e3, 0.0, 10.0), ahead(8e3, 0.0, 10.0)).is_none(), "beside the picture");
        let through = on_screen(&view, rect, ahead(0.5, 0.2, 10.0), ahead(0.5, 0.2, -10.0)).expect("partly in view");
        for end in through {
            assert!(rect.expand(0.01).contains(end), "{end}");
        }
    }
}
