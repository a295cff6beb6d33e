//! The viewport's rectangle and what is seen in it: from points of the window to the world and back.
//!
//! Lines are cut off at the near plane and at the rim: near the eye their ends lie millions of points away.

use cloudwright_core::camera::{NEAR_M, View};
use cloudwright_core::scene::Camera;
use egui::{Pos2, Rect, pos2, vec2};
use glam::{DVec3, Vec3};

/// A view in a rectangle of the window, in points: pointers and outlines don't care how fine the picture is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Screen {
    pub(super) rect: Rect,
    pub(super) view: View,
}

impl Screen {
    pub(super) fn new(camera: &Camera, rect: Rect) -> Self {
        let view = View::new(camera, rect.width() as u32, rect.height() as u32);
        // The view counts whole points.
        let rect = Rect::from_min_size(rect.min, vec2(view.width as f32, view.height as f32));
        Self { rect, view }
    }

    /// Through a point of the window; as long as [`View::ray`] says.
    pub(super) fn ray(&self, at: Pos2) -> Vec3 {
        self.view.ray(at.x - self.rect.left(), at.y - self.rect.top())
    }

    /// A place in the world relative to the eye. The subtraction is in f64, so it is exact far from the origin.
    pub(super) fn relative(&self, place: DVec3) -> Vec3 {
        (place - self.view.eye).as_vec3()
    }

    /// Where an eye-relative point shows, if it lies before the near plane.
    pub(super) fn project(&self, point: Vec3) -> Option<Pos2> {
        self.view.project(point).map(|at| pos2(self.rect.left() + at.x, self.rect.top() + at.y))
    }

    /// Where a place in the world shows within the rectangle.
    pub(super) fn find(&self, place: DVec3) -> Option<Pos2> {
        self.project(self.relative(place)).filter(|at| self.rect.contains(*at))
    }

    /// Metres that a point of the window covers at a place in the world; the near plane's at least.
    pub(super) fn metres_per_point(&self, place: DVec3) -> f64 {
        f64::from(self.view.depth(self.relative(place)).max(NEAR_M)) * f64::from(self.view.pixel())
    }

    /// The part of an eye-relative line that shows.
    pub(super) fn line(&self, a: Vec3, b: Vec3) -> Option<[Pos2; 2]> {
        let (a, b) = before_near_plane(&self.view, a, b)?;
        within(self.rect, self.project(a)?, self.project(b)?)
    }

    /// How far along a line through `place` the pointer is, metres along the unit vector `direction`; none if the line
    /// is seen from its end.
    pub(super) fn along(&self, at: Pos2, place: DVec3, direction: DVec3) -> Option<f64> {
        const LEAST_SINE: f64 = 0.05;
        let ray = self.ray(at).as_dvec3().normalize();
        let from_eye = place - self.view.eye;
        let cosine = ray.dot(direction);
        let sine_squared = 1.0 - cosine * cosine;
        let along = (cosine * from_eye.dot(ray) - from_eye.dot(direction)) / sine_squared;
        (sine_squared > LEAST_SINE * LEAST_SINE && along.is_finite()).then_some(along)
    }
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

/// The part of a line within a rectangle (Liang and Barsky).
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

    fn screen() -> Screen {
        let rect = Rect::from_min_max(pos2(10.0, 20.0), pos2(110.0, 120.0));
        Screen::new(&Camera::free(DVec3::ZERO), rect)
    }

    #[test]
    fn lines_are_cut_at_the_near_plane_and_the_rim() {
        let screen = screen();
        let ahead = |x: f32, y: f32, depth: f32| Vec3::new(x, y, -depth);
        let seen = screen.line(ahead(-1.0, 0.0, 10.0), ahead(1.0, 0.0, 10.0)).expect("in view");
        assert!((seen[0].y - 70.0).abs() < 1e-3 && seen[0].x < seen[1].x);
        assert!(screen.line(ahead(0.0, 0.0, -5.0), ahead(1.0, 0.0, -1.0)).is_none(), "behind the eye");
        assert!(screen.line(ahead(9e3, 0.0, 10.0), ahead(8e3, 0.0, 10.0)).is_none(), "beside the picture");
        let through = screen.line(ahead(0.5, 0.2, 10.0), ahead(0.5, 0.2, -10.0)).expect("partly in view");
        for end in through {
            assert!(screen.rect.expand(0.01).contains(end), "{end}");
        }
    }

    #[test]
    fn the_pointer_slides_along_a_line() {
        let screen = screen();
        let place = DVec3::new(3.0, -2.0, -50.0);
        for (direction, metres) in [(DVec3::Y, 7.0), (DVec3::X, -4.0), (DVec3::new(0.6, 0.0, -0.8), 9.0)] {
            let at = screen.find(place + direction * metres).expect("in view");
            let along = screen.along(at, place, direction).expect("seen from the side");
            assert!((along - metres).abs() < 1e-3, "{along} for {metres}");
        }
        let at = screen.find(place).expect("in view");
        assert!(screen.along(at, place, place.normalize()).is_none(), "seen from its end");
    }
}
