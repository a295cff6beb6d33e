//! The scene's cameras in the viewport, as small frustums: when one is selected, and all when all outlines are shown.

use super::screen::Screen;
use crate::state::{Item, Reading};
use crate::theme;
use cloudwright_core::camera::View;
use cloudwright_core::scene::{Camera, CameraId};
use egui::{Painter, Pos2, Shape, Stroke};
use glam::Vec3;

/// How long a frustum is drawn, points.
const LENGTH: f32 = 44.0;
/// How near to a camera's eye or picture a click means it, points.
const REACH: f32 = 14.0;

/// Paints the frustums.
pub(super) fn paint(painter: &Painter, screen: &Screen, reading: &Reading<'_>) {
    for camera in shown(screen, reading) {
        let selected = reading.view.selection.contains(Item::Camera(camera.id));
        let stroke = if selected { theme::SELECTED_BOX } else { theme::CAMERA };
        for stroke in [theme::casing(stroke), stroke] {
            frustum(painter, screen, &camera, stroke);
        }
    }
}

/// The camera that a click means.
pub(super) fn under(at: Pos2, screen: &Screen, reading: &Reading<'_>) -> Option<CameraId> {
    let near = shown(screen, reading).filter_map(|camera| {
        let ends = [Vec3::ZERO, frame(screen, &camera)?.ahead];
        let distances = ends.map(|end| {
            let place = screen.project(screen.relative(camera.position) + end);
            place.map_or(f32::INFINITY, |place| place.distance(at))
        });
        Some((distances[0].min(distances[1]), camera.id))
    });
    near.filter(|(distance, _)| *distance <= REACH).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, id)| id)
}

/// Those that are drawn. One that is looked through, or nearly so, would be all around the eye.
/// They stand where their tracks have them now.
fn shown<'a>(screen: &Screen, reading: &'a Reading<'a>) -> impl Iterator<Item = Camera> + use<'a> {
    let (view, eye) = (reading.view, screen.view.eye);
    let is_drawn = |camera: &&Camera| view.show_all_boxes || view.selection.contains(Item::Camera(camera.id));
    let (timeline, clock_s) = (reading.session.derived().timeline(), reading.clock.time_s());
    let drawn = reading.session.scene().cameras.iter().filter(is_drawn);
    drawn.map(move |camera| timeline.camera_at(camera, clock_s)).filter(move |now| now.position.distance(eye) > 1.0)
}

/// A camera's picture, from its eye.
struct PictureFrame {
    ahead: Vec3,
    across: Vec3,
    up: Vec3,
}

fn frame(screen: &Screen, camera: &Camera) -> Option<PictureFrame> {
    screen.project(screen.relative(camera.position))?;
    let seen = View::new(camera, 16, 9);
    let length = screen.metres_per_point(camera.position) as f32 * LENGTH;
    // A wide camera's picture is drawn nearer, so that it stays small.
    let ahead = length / (1.0 + seen.tan_half_height);
    let half_height = ahead * seen.tan_half_height;
    let half_width = half_height * 16.0 / 9.0;
    Some(PictureFrame { ahead: seen.forward * ahead, across: seen.right * half_width, up: seen.up * half_height })
}

fn frustum(painter: &Painter, screen: &Screen, camera: &Camera, stroke: Stroke) {
    let Some(PictureFrame { ahead, across, up }) = frame(screen, camera) else { return };
    let eye = screen.relative(camera.position);
    let corners = [up - across, up + across, across - up, -across - up].map(|corner| eye + ahead + corner);
    let line = |a: Vec3, b: Vec3| {
        if let Some(ends) = screen.line(a, b) {
            painter.line_segment(ends, stroke);
        }
    };
    for i in 0..4 {
        line(eye, corners[i]);
        line(corners[i], corners[(i + 1) % 4]);
    }
    // Which way is up.
    let roof = [up * 1.15 - across * 0.5, up * 1.15 + across * 0.5, up * 1.8].map(|p| screen.project(eye + ahead + p));
    if let [Some(a), Some(b), Some(c)] = roof {
        painter.add(Shape::convex_polygon(vec![a, b, c], stroke.color, Stroke::NONE));
    }
}
