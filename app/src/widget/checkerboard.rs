//! The board that shows through where a colour is clear.

use crate::theme;
use egui::{Mesh, Painter, Rect, pos2};

/// Of a field's side, points.
const FIELD: f32 = 5.0;

/// Fills `rect`.
pub(crate) fn paint(painter: &Painter, rect: Rect) {
    let mut mesh = Mesh::default();
    let [light, dark] = theme::CHECKERBOARD;
    mesh.add_colored_rect(rect, light);
    let count = |length: f32| (length.max(0.0) / FIELD).ceil() as u32;
    for row in 0..count(rect.height()) {
        for column in (row % 2..count(rect.width())).step_by(2) {
            let corner = pos2(rect.left() + column as f32 * FIELD, rect.top() + row as f32 * FIELD);
            let field = Rect::from_min_size(corner, egui::Vec2::splat(FIELD)).intersect(rect);
            mesh.add_colored_rect(field, dark);
        }
    }
    painter.add(mesh);
}
