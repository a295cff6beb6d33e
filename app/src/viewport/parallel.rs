//! The orthographic view: seen from so far away, through so narrow an angle, that rays run side by side.
//!
//! Every renderer draws what an eye sees; so this is one that stands [`FAR`] times as far away as its picture is high, on a
//! level with what is looked at. What lies as far before or behind that as the picture is high is off by half a pixel at
//! the rim of one of 1,000 rows; ten times as far, by five. Farther still the eye can't stand: places relative to it are
//! rounded to 24 bits, which at this distance is an eighth of a pixel. Haze is left out, as all would be lost in it, and so
//! is the ground where it is seen from its edge, which is a line then: it would reach up to the eye's own height.

use super::overlay;
use super::screen::Screen;
use crate::theme;
use cloudwright_core::camera::View;
use cloudwright_core::draw_list::Hidden;
use cloudwright_core::scene::Camera;
use egui::Painter;
use glam::DVec3;

/// Times the picture's height.
const FAR: f64 = 2000.0;

/// The far eye that sees what `near` does at `distance_m` before it, at the same size.
pub(super) fn eye(near: &Camera, distance_m: f64) -> Camera {
    let height_m = 2.0 * (near.field_of_view_deg * 0.5).to_radians().tan() * distance_m;
    let forward = View::new(near, 1, 1).forward.as_dvec3();
    Camera {
        position: near.position + forward * (distance_m - FAR * height_m),
        field_of_view_deg: 2.0 * (0.5 / FAR).atan().to_degrees(),
        ..near.clone()
    }
}

/// What such an eye can't show.
pub(super) fn hide(eye: &Camera, hidden: &mut Hidden) {
    hidden.haze = true;
    hidden.ground = eye.pitch_deg.abs() <= eye.field_of_view_deg;
}

/// Paints the ground as the line that it is from its edge, below (or above) the point that is looked at.
pub(super) fn paint_ground(painter: &Painter, screen: &Screen, looked_at: DVec3, ground_m: f64) {
    let rect = screen.rect;
    let Some(at) = screen.project(screen.relative(DVec3 { y: ground_m, ..looked_at })) else { return };
    if rect.y_range().contains(at.y) {
        painter.hline(rect.x_range(), at.y, theme::casing(theme::GRID));
        painter.hline(rect.x_range(), at.y, theme::GRID);
        overlay::label(painter, egui::pos2(rect.left() + theme::VIEWPORT_MARGIN, at.y + 5.0), "ground");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;

    /// In a picture of 1,000 rows, parallel rays shift nothing: a place shows where its shadow on the plane through what
    /// is looked at does.
    #[test]
    fn places_off_the_plane_shift_by_no_more_than_is_said() {
        let mut near = Camera::free(DVec3::new(4e5, 1500.0, -3e5));
        for [heading_deg, pitch_deg] in [[0.0, 0.0], [0.0, -90.0], [90.0, 0.0], [33.0, -40.0]] {
            (near.heading_deg, near.pitch_deg) = (heading_deg, pitch_deg);
            let distance_m = 2500.0;
            let [seen_near, seen] = [near.clone(), eye(&near, distance_m)].map(|camera| View::new(&camera, 1600, 1000));
            let middle = near.position + seen_near.forward.as_dvec3() * distance_m;
            let height_m = 1000.0 * f64::from(seen_near.pixel()) * distance_m;
            for (x, y) in [(0.0, 0.0), (0.8, 0.5), (-0.8, 0.5), (0.3, -0.5)] {
                let across = seen.right.as_dvec3() * x + seen.up.as_dvec3() * y;
                let on_plane = middle + across * height_m;
                let shown = |view: &View, place: DVec3| view.project((place - view.eye).as_vec3()).expect("before it");
                let wanted = Vec2::new(800.0 + 1000.0 * x as f32, 500.0 - 1000.0 * y as f32);
                assert!(shown(&seen_near, on_plane).distance(wanted) < 0.05, "the same size");
                for off in [-1.0, 0.0, 1.0] {
                    let place = on_plane + seen.forward.as_dvec3() * (off * height_m);
                    let shift = shown(&seen, place).distance(wanted);
                    // Half a pixel, and what rounding adds along both axes.
                    assert!(shift < 0.5 + 0.25, "{heading_deg}° {pitch_deg}° ({x}, {y}) off by {off}: {shift}");
                }
            }
        }
    }
}
