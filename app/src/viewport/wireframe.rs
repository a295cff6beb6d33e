//! Outlines of boxes, painted over the picture where the clock has their clouds. Edges behind their own box are fainter.

use super::places::Places;
use super::screen::Screen;
use crate::state::{Item, Reading, ViewState};
use crate::theme;
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::scene::{Cloud, CloudBox};
use cloudwright_core::sprites::GroupKey;
use egui::{Color32, Painter, Stroke};
use glam::{DVec3, Vec3};
use std::rc::Rc;

/// Corner indices: bit 0 is x, bit 1 y, bit 2 z. Four edges along each axis.
const EDGES: [(usize, usize); 12] =
    [(0, 1), (2, 3), (4, 5), (6, 7), (0, 2), (1, 3), (4, 6), (5, 7), (0, 4), (1, 5), (2, 6), (3, 7)];

/// Paints the boxes that the selection asks for, and all if the view says so.
pub(super) fn paint(painter: &Painter, screen: &Screen, reading: &Reading<'_>) {
    let (scene, state) = (reading.session.scene(), reading.view);
    let places = Places::of(reading);
    // What is selected comes last, on top.
    let mut on_top = Vec::new();
    for cloud in scene.clouds.iter().filter(|cloud| state.shows(scene, cloud)) {
        if !shows_boxes_of(cloud, state) {
            continue;
        }
        let Some(model) = scene.model(cloud.model) else { continue };
        let now = Rc::new(places.seen(cloud).into_owned());
        let folder = scene.folder_of(cloud);
        for each in &model.boxes {
            if state.hidden.contains(&Item::Box(model.id, each.id)) {
                continue;
            }
            let other = (state.show_all_boxes || state.group_view).then_some(theme::OTHER_BOX);
            let stroke = stroke_of(cloud, each, state);
            let tint = state.group_view.then(|| tint(each));
            let tinted = |stroke: Stroke| Stroke { color: tint.unwrap_or(stroke.color), ..stroke };
            // What is selected looks so, whatever folder it is in.
            let of_folder = |other: Stroke| Stroke { color: folder.map_or(other.color, theme::of_folder), ..other };
            match (stroke, other) {
                (Some(stroke), _) => on_top.push((Rc::clone(&now), each, tinted(stroke))),
                (None, Some(other)) => outline(painter, screen, &now, each, tinted(of_folder(other))),
                (None, None) => {}
            }
        }
    }
    on_top.sort_by(|a, b| a.2.width.total_cmp(&b.2.width));
    for (cloud, each, stroke) in on_top {
        outline(painter, screen, &cloud, each, stroke);
    }
}

/// Paints a box as a selected one.
pub(super) fn paint_selected(painter: &Painter, screen: &Screen, cloud: &Cloud, each: &CloudBox) {
    outline(painter, screen, cloud, each, theme::SELECTED_BOX);
}

/// Paints a box as one that a press would take.
pub(super) fn paint_hovered(painter: &Painter, screen: &Screen, cloud: &Cloud, each: &CloudBox) {
    outline(painter, screen, cloud, each, theme::casing(theme::HOVERED));
    outline(painter, screen, cloud, each, theme::HOVERED);
}

/// A box's tint: that of the group it shares, or of its own.
fn tint(each: &CloudBox) -> Color32 {
    theme::tint_of(each.group.map_or(GroupKey::Lump(each.id, 0), GroupKey::Named))
}

/// How a box stands out; none for one that has nothing to do with the selection.
fn stroke_of(cloud: &Cloud, each: &CloudBox, state: &ViewState) -> Option<Stroke> {
    let selection = &state.selection;
    let strokes = [
        (selection.contains(Item::Box(cloud.model, each.id)), theme::SELECTED_BOX),
        (selection.contains(Item::Cloud(cloud.id)), theme::SELECTED_CLOUD),
        (is_in_selected_folder(cloud, state), theme::SELECTED_CLOUD),
        (selection.of_model(cloud.model) || selection.has_box_of(cloud.model), theme::RELATED_BOX),
    ];
    let strokes = strokes.into_iter().filter_map(|(is_its, stroke)| is_its.then_some(stroke));
    strokes.max_by(|a, b| a.width.total_cmp(&b.width))
}

/// Whether the pointer's aim includes a cloud's boxes: they are drawn.
pub(super) fn shows_boxes_of(cloud: &Cloud, state: &ViewState) -> bool {
    let (selection, model) = (&state.selection, cloud.model);
    let is_about =
        selection.contains(Item::Cloud(cloud.id)) || selection.of_model(model) || selection.has_box_of(model);
    state.show_all_boxes || state.group_view || is_about || is_in_selected_folder(cloud, state)
}

fn is_in_selected_folder(cloud: &Cloud, state: &ViewState) -> bool {
    cloud.folder.is_some_and(|id| state.selection.contains(Item::Folder(id)))
}

fn outline(painter: &Painter, screen: &Screen, cloud: &Cloud, each: &CloudBox, stroke: Stroke) {
    let space = ModelSpace::of(cloud);
    let corner = |i: usize| {
        let sign = |bit: usize| if i & bit == 0 { -0.5 } else { 0.5 };
        let in_box = each.size * DVec3::new(sign(1), sign(2), sign(4));
        screen.relative(space.to_world(each.center + each.orientation * in_box))
    };
    let corners: [Vec3; 8] = std::array::from_fn(corner);
    // In the box's own axes, from its middle: which faces the eye sees.
    let eye = each.orientation.conjugate() * (space.from_world(screen.view.eye) - each.center);
    let far = Stroke { color: stroke.color.gamma_multiply(theme::FAR_EDGE), ..stroke };
    let edge = |(i, (a, b)): (usize, (usize, usize))| {
        let axis = i / 4;
        let is_seen = |across: usize| {
            let positive = a & (1 << across) != 0;
            let half = each.size[across] * 0.5;
            if positive { eye[across] > half } else { eye[across] < -half }
        };
        let near = (0..3).filter(|across| *across != axis).any(is_seen);
        let inside = (0..3).all(|axis| eye[axis].abs() <= each.size[axis] * 0.5);
        Some((screen.line(corners[a], corners[b])?, if near || inside { stroke } else { far }))
    };
    let edges: Vec<_> = EDGES.into_iter().enumerate().filter_map(edge).collect();
    for (line, stroke) in &edges {
        painter.line_segment(*line, theme::casing(*stroke));
    }
    for (line, stroke) in edges {
        painter.line_segment(line, stroke);
    }
}
