//! The view through a saved camera: it sees a little more than the camera, whose picture has a frame of the shape in which
//! pictures are rendered; what lies around it is darkened.
//!
//! The view follows the camera, as tracks and hands move it, until a hand moves the view.

use super::overlay;
use crate::state::Reading;
use crate::theme;
use cloudwright_core::scene::{Camera, CameraId};
use egui::{Align2, Painter, Rect, StrokeKind, Ui, Vec2, vec2};

/// Of the viewport, what the frame may take of its height and of its width.
const FILL: f32 = 0.9;

/// The camera that is looked through.
#[derive(Debug, Clone)]
pub(super) struct Through {
    id: CameraId,
    /// As it was when it was last followed.
    pub(super) last: Camera,
}

impl Through {
    pub(super) fn new(camera: &Camera) -> Self {
        Self { id: camera.id, last: camera.clone() }
    }

    pub(super) fn id(&self) -> CameraId {
        self.id
    }

    /// Where the camera is at the clock's time; none if the scene has it no longer.
    pub(super) fn now(&self, reading: &Reading<'_>) -> Option<Camera> {
        let camera = reading.session.scene().cameras.with_id(self.id)?;
        Some(reading.session.derived().timeline().camera_at(camera, reading.clock.time_s()))
    }
}

/// Where a picture of so many pixels lies in `rect`.
pub(super) fn frame(rect: Rect, size: [u32; 2]) -> Rect {
    let [width, height] = size.map(|side| side.max(1) as f32);
    let scale = (rect.width() / width).min(rect.height() / height) * FILL;
    Rect::from_center_size(rect.center(), vec2(width, height) * scale)
}

/// The camera that sees in `rect` what `camera` does in the frame.
pub(super) fn eye(camera: &Camera, rect: Rect, size: [u32; 2]) -> Camera {
    let wider = f64::from(rect.height() / frame(rect, size).height());
    let tan_half = (camera.field_of_view_deg * 0.5).to_radians().tan() * wider;
    Camera { field_of_view_deg: 2.0 * tan_half.atan().to_degrees(), ..camera.clone() }
}

/// Darkens what lies around the frame, and says whose it is.
pub(super) fn paint(ui: &mut Ui, painter: &Painter, rect: Rect, camera: &Camera, size: [u32; 2]) {
    let frame = frame(rect, size);
    let (left, right) = (rect.with_max_x(frame.left()), rect.with_min_x(frame.right()));
    let between = rect.with_min_x(frame.left()).with_max_x(frame.right());
    for around in [left, right, between.with_max_y(frame.top()), between.with_min_y(frame.bottom())] {
        painter.rect_filled(around, 0.0, theme::AROUND_FRAME);
    }
    painter.rect_stroke(frame, 0.0, theme::casing(theme::CAMERA), StrokeKind::Outside);
    painter.rect_stroke(frame, 0.0, theme::CAMERA, StrokeKind::Outside);
    let [width, height] = size;
    let words = format!("{} · {width} × {height}", overlay::camera_name(camera));
    overlay::plate(ui, frame.left_top() + Vec2::splat(theme::VIEWPORT_MARGIN), Align2::LEFT_TOP, &words);
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::camera::View;
    use egui::pos2;
    use glam::DVec3;

    #[test]
    fn the_frame_shows_what_the_camera_sees() {
        let mut camera = Camera::free(DVec3::new(10.0, 900.0, -40.0));
        (camera.heading_deg, camera.field_of_view_deg) = (70.0, 55.0);
        let rect = Rect::from_min_size(pos2(30.0, 60.0), vec2(800.0, 500.0));
        for size in [[1920, 1080], [1080, 1920], [400, 400], [3000, 10], [1, 16_384]] {
            let frame = frame(rect, size);
            assert!(rect.shrink(1.0).contains_rect(frame), "{size:?}");
            let [width, height] = size.map(|side| side as f32);
            assert!((frame.width() / frame.height() / (width / height) - 1.0).abs() < 1e-3, "{size:?}");
            let picture = View::new(&camera, size[0], size[1]);
            let seen = View::new(&eye(&camera, rect, size), 800, 500);
            for (x, y) in [(0.0, 0.0), (width, 0.0), (0.3 * width, 0.9 * height)] {
                let at = seen.project(picture.ray(x, y) * 500.0).expect("before the eye");
                let wanted = frame.min + frame.size() * vec2(x / width, y / height) - rect.min;
                assert!((vec2(at.x, at.y) - wanted).length() < 0.1, "{size:?}: {at} for {wanted:?}");
            }
        }
    }
}
