//! Moving the view: a camera and the distance to the point that it turns about.

use cloudwright_core::camera::View;
use cloudwright_core::property;
use cloudwright_core::scene::Camera;
use egui::Vec2;
use glam::{DVec2, DVec3, Vec3};

/// Of turn a point of dragging.
const DEG_PER_POINT: f64 = 0.3;
/// Share of the way a point of scrolling; a notch of a wheel is some 50 points.
const ZOOM_PER_POINT: f64 = 0.004;
/// So that up stays up.
const MAX_PITCH_DEG: f64 = 89.9;
const MIN_DISTANCE_M: f64 = 1.0;

/// A camera that can be moved by hand.
#[derive(Debug, Clone)]
pub(super) struct Navigation {
    camera: Camera,
    distance_m: f64,
}

impl Navigation {
    pub(super) fn new(camera: Camera, distance_m: f64) -> Self {
        Self { camera, distance_m: distance_m.max(MIN_DISTANCE_M) }
    }

    pub(super) fn camera(&self) -> &Camera {
        &self.camera
    }

    /// To the point that the view turns about, metres.
    pub(super) fn distance(&self) -> f64 {
        self.distance_m
    }

    pub(super) fn pivot(&self) -> DVec3 {
        self.camera.position + self.forward() * self.distance_m
    }

    fn forward(&self) -> DVec3 {
        View::new(&self.camera, 1, 1).forward.as_dvec3()
    }

    /// Turns about the pivot: what is near follows the pointer.
    pub(super) fn orbit(&mut self, points: Vec2) {
        if points == Vec2::ZERO {
            return;
        }
        let pivot = self.pivot();
        self.turn_head(DVec2::new(f64::from(points.x), f64::from(-points.y)) * DEG_PER_POINT);
        self.stand_at(pivot - self.forward() * self.distance_m);
    }

    /// Turns the head by heading and pitch: the eye stays, and the pivot goes with the look.
    pub(super) fn turn_head(&mut self, deg: DVec2) {
        let heading = self.camera.heading_deg + deg.x;
        self.camera.heading_deg = (heading + 180.0).rem_euclid(360.0) - 180.0;
        self.camera.pitch_deg = (self.camera.pitch_deg + deg.y).clamp(-MAX_PITCH_DEG, MAX_PITCH_DEG);
    }

    /// Moves the eye, and the pivot with it.
    pub(super) fn fly(&mut self, way_m: DVec3) {
        self.stand_at(self.camera.position + way_m);
    }

    /// Moves along the picture, so that the pivot's plane follows the pointer.
    pub(super) fn pan(&mut self, points: Vec2, view: &View) {
        let metres = f64::from(view.pixel()) * self.distance_m;
        let across = view.right.as_dvec3() * f64::from(-points.x) + view.up.as_dvec3() * f64::from(points.y);
        self.stand_at(self.camera.position + across * metres);
    }

    /// Towards (or away from) an eye-relative point, by a share of the way.
    pub(super) fn zoom(&mut self, points: f32, towards: Vec3) {
        let share = 1.0 - (-f64::from(points) * ZOOM_PER_POINT).exp();
        self.stand_at(self.camera.position + towards.as_dvec3() * share);
        let depth = f64::from(towards.dot(View::new(&self.camera, 1, 1).forward));
        self.distance_m = (depth * (1.0 - share)).max(MIN_DISTANCE_M);
    }

    /// So far away that a sphere fills the picture, in the same direction.
    pub(super) fn frame(&mut self, center: DVec3, radius_m: f64) {
        let half_angle = (self.camera.field_of_view_deg * 0.5).to_radians();
        self.distance_m = (radius_m.max(MIN_DISTANCE_M) / half_angle.sin() * 1.1).max(MIN_DISTANCE_M);
        self.stand_at(center - self.forward() * self.distance_m);
    }

    /// Within the scene's bounds.
    fn stand_at(&mut self, position: DVec3) {
        if position.is_finite() {
            let bound = DVec3::splat(property::POSITION.max);
            self.camera.position = position.clamp(-bound, bound);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::vec2;

    #[test]
    fn orbit_keeps_the_pivot_and_pan_the_direction() {
        let mut navigation = Navigation::new(Camera::free(DVec3::new(3.0, 100.0, 500.0)), 400.0);
        let pivot = navigation.pivot();
        navigation.orbit(vec2(37.0, -120.0));
        assert!(navigation.pivot().distance(pivot) < 1e-3, "the axes are f32");
        assert!((navigation.camera().pitch_deg - 36.0).abs() < 1e-9);
        navigation.orbit(vec2(0.0, -1e6));
        assert!(navigation.camera().pitch_deg < 90.0);
        let before = navigation.forward();
        let view = View::new(navigation.camera(), 800, 600);
        navigation.pan(vec2(50.0, 20.0), &view);
        assert_eq!(navigation.forward(), before);
    }

    #[test]
    fn zoom_keeps_the_point_under_the_cursor() {
        let mut navigation = Navigation::new(Camera::free(DVec3::ZERO), 1000.0);
        let view = View::new(navigation.camera(), 800, 600);
        let point = view.ray(200.0, 450.0) * 700.0;
        navigation.zoom(60.0, point);
        let view = View::new(navigation.camera(), 800, 600);
        let seen = view.project(point - view.eye.as_vec3()).expect("before the eye");
        assert!(seen.distance(glam::Vec2::new(200.0, 450.0)) < 0.01, "{seen}");
        for _ in 0..1000 {
            navigation.zoom(1000.0, point);
            navigation.zoom(f32::NAN, point);
        }
        assert!(navigation.camera().position.is_finite());
    }

    #[test]
    fn framing_brings_a_sphere_into_the_picture() {
        let mut navigation = Navigation::new(Camera::free(DVec3::ZERO), 10.0);
        navigation.frame(DVec3::new(5000.0, 900.0, -300.0), 400.0);
        let view = View::new(navigation.camera(), 600, 600);
        let center = (DVec3::new(5000.0, 900.0, -300.0) - view.eye).as_vec3();
        let middle = view.project(center).expect("before the eye");
        assert!(middle.distance(glam::Vec2::splat(300.0)) < 0.5);
        let edge = view.project(center + view.up * 400.0).expect("before the eye");
        assert!(edge.y > 0.0 && edge.y < 60.0, "{edge}");
    }
}
