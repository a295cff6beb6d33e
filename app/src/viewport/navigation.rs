//! Moving the view: a camera and the distance to the point that it turns about.
//!
//! A hand moves the eye no lower than a little above the ground, or than where it is already: beneath it there is nothing
//! to see.

use super::parallel;
use super::side::Side;
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
const MAX_PITCH_DEG: f64 = 90.0;
const MIN_DISTANCE_M: f64 = 1.0;
/// Of the eye over the ground, at least, metres.
const EYE_HEIGHT_M: f64 = 2.0;

/// A camera that can be moved by hand.
#[derive(Debug, Clone)]
pub(super) struct Navigation {
    camera: Camera,
    distance_m: f64,
    /// No hand moves the eye below this altitude, metres.
    floor_m: f64,
    is_orthographic: bool,
    /// From where it looks and can't be turned.
    pinned: Option<Side>,
}

impl Navigation {
    pub(super) fn new(camera: Camera, distance_m: f64) -> Self {
        let distance_m = distance_m.max(MIN_DISTANCE_M);
        Self { camera, distance_m, floor_m: f64::NEG_INFINITY, is_orthographic: false, pinned: None }
    }

    /// From now on above ground of that altitude, metres.
    pub(super) fn stay_above(&mut self, ground_m: Option<f64>) {
        self.floor_m = ground_m.map_or(f64::NEG_INFINITY, |altitude_m| altitude_m + EYE_HEIGHT_M);
    }

    /// The camera that is moved: in an orthographic view, the one that sees the same at the same size.
    pub(super) fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The camera that sees the picture.
    pub(super) fn eye(&self) -> Camera {
        if self.is_orthographic { parallel::eye(&self.camera, self.distance_m) } else { self.camera.clone() }
    }

    /// Whether rays run side by side.
    pub(super) fn is_orthographic(&self) -> bool {
        self.is_orthographic
    }

    /// What is looked at keeps its size.
    pub(super) fn set_orthographic(&mut self, orthographic: bool) {
        self.is_orthographic = orthographic;
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
        if points == Vec2::ZERO || self.pinned.is_some() {
            return;
        }
        let pivot = self.pivot();
        self.turn_head(DVec2::new(f64::from(points.x), f64::from(-points.y)) * DEG_PER_POINT);
        // Further up, the eye would be too low.
        let sine = (pivot.y - self.lowest_m()) / self.distance_m;
        self.camera.pitch_deg = self.camera.pitch_deg.min(sine.clamp(-1.0, 1.0).asin().to_degrees());
        self.stand_at(pivot - self.forward() * self.distance_m);
    }

    /// Turns the head by heading and pitch: the eye stays, and the pivot goes with the look.
    pub(super) fn turn_head(&mut self, deg: DVec2) {
        let heading = self.camera.heading_deg + deg.x;
        self.camera.heading_deg = (heading + 180.0).rem_euclid(360.0) - 180.0;
        self.camera.pitch_deg = (self.camera.pitch_deg + deg.y).clamp(-MAX_PITCH_DEG, MAX_PITCH_DEG);
    }

    /// Looks from a side at what is looked at.
    pub(super) fn look_from(&mut self, side: Side) {
        let pivot = self.pivot();
        [self.camera.heading_deg, self.camera.pitch_deg] = side.look_deg();
        self.camera.roll_deg = 0.0;
        self.stand_back(pivot);
    }

    /// From now on only from that side.
    pub(super) fn pin_to(&mut self, side: Side) {
        self.look_from(side);
        self.pinned = Some(side);
    }

    /// From where it looks and can't be turned; nothing if it can.
    pub(super) fn pinned(&self) -> Option<Side> {
        self.pinned
    }

    /// Moves the eye, and the pivot with it.
    pub(super) fn fly(&mut self, way_m: DVec3) {
        self.stand_at(self.camera.position + way_m);
    }

    /// Moves along the picture, so that the pivot's plane follows the pointer.
    pub(super) fn pan(&mut self, points: Vec2, view: &View) {
        let metres = f64::from(view.pixel()) * self.eye_distance_m();
        let across = view.right.as_dvec3() * f64::from(-points.x) + view.up.as_dvec3() * f64::from(points.y);
        self.stand_at(self.camera.position + across * metres);
    }

    /// Towards (or away from) an eye-relative point, by a share of the way.
    pub(super) fn zoom(&mut self, points: f32, towards: Vec3) {
        let mut share = 1.0 - (-f64::from(points) * ZOOM_PER_POINT).exp();
        if self.is_orthographic {
            return self.magnify(share, towards);
        }
        let down_m = -f64::from(towards.y) * share;
        let room_m = self.camera.position.y - self.lowest_m();
        if down_m > room_m {
            share *= room_m / down_m;
        }
        self.stand_at(self.camera.position + towards.as_dvec3() * share);
        let depth = f64::from(towards.dot(View::new(&self.camera, 1, 1).forward));
        self.distance_m = (depth * (1.0 - share)).max(MIN_DISTANCE_M);
    }

    /// The orthographic view's zoom: what is under a ray from its eye stays there.
    fn magnify(&mut self, share: f64, ray: Vec3) {
        let pivot = self.pivot();
        let eye = self.eye();
        let depth = f64::from(ray.dot(View::new(&eye, 1, 1).forward));
        let under = eye.position + ray.as_dvec3() * (self.eye_distance_m() / depth);
        let distance_m = self.distance_m * (1.0 - share);
        if distance_m >= MIN_DISTANCE_M && under.is_finite() {
            self.distance_m = distance_m;
            self.stand_at(pivot.lerp(under, share) - self.forward() * distance_m);
        }
    }

    /// From the camera that sees the picture to the pivot, metres.
    fn eye_distance_m(&self) -> f64 {
        (self.pivot() - self.eye().position).length()
    }

    /// So far away that a sphere fills the picture, in the same direction.
    pub(super) fn frame(&mut self, center: DVec3, radius_m: f64) {
        self.distance_m = self.distance_of(radius_m);
        self.stand_back(center);
    }

    /// From now on about the middle of a sphere, from as far away as the eye is, or as the sphere fills the picture from.
    pub(super) fn turn_about(&mut self, center: DVec3, radius_m: f64) {
        self.distance_m = center.distance(self.camera.position).max(self.distance_of(radius_m));
        self.stand_back(center);
    }

    /// From which a sphere fills the picture, metres.
    fn distance_of(&self, radius_m: f64) -> f64 {
        let half_angle = (self.camera.field_of_view_deg * 0.5).to_radians();
        (radius_m.max(MIN_DISTANCE_M) / half_angle.sin() * 1.1).max(MIN_DISTANCE_M)
    }

    /// At the pivot's distance before it, but no farther than the ground lets the eye.
    fn stand_back(&mut self, pivot: DVec3) {
        let forward = self.forward();
        let room_m = (pivot.y - self.floor_m) / forward.y;
        if forward.y > 0.0 && room_m > MIN_DISTANCE_M && !self.is_orthographic {
            self.distance_m = self.distance_m.min(room_m);
        }
        self.stand_at(pivot - forward * self.distance_m);
    }

    /// The altitude below which the eye is not moved, metres. An orthographic view's is far off anyway.
    fn lowest_m(&self) -> f64 {
        if self.is_orthographic { f64::NEG_INFINITY } else { self.floor_m.min(self.camera.position.y) }
    }

    /// Within the scene's bounds, and not too low.
    fn stand_at(&mut self, position: DVec3) {
        if position.is_finite() {
            let bound = DVec3::splat(property::POSITION.max);
            let position = position.clamp(-bound, bound);
            self.camera.position = DVec3 { y: position.y.max(self.lowest_m()), ..position };
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
        assert_eq!(navigation.camera().pitch_deg, 90.0);
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
    fn an_orthographic_view_is_moved_as_any_other() {
        let mut camera = Camera::free(DVec3::new(3e5, 1500.0, 2e5));
        (camera.heading_deg, camera.pitch_deg) = (40.0, -20.0);
        let mut navigation = Navigation::new(camera, 900.0);
        navigation.set_orthographic(true);
        let pivot = navigation.pivot();
        let shown = |navigation: &Navigation, place: DVec3| {
            let view = View::new(&navigation.eye(), 800, 600);
            view.project((place - view.eye).as_vec3()).expect("before the eye")
        };
        let middle = glam::Vec2::new(400.0, 300.0);
        assert!(shown(&navigation, pivot).distance(middle) < 0.2);
        let view = View::new(&navigation.eye(), 800, 600);
        let under = |navigation: &Navigation| {
            let view = View::new(&navigation.eye(), 800, 600);
            view.eye
                + (view.ray(200.0, 450.0) / view.ray(200.0, 450.0).length()).as_dvec3() * (pivot - view.eye).length()
        };
        let place = under(&navigation);
        navigation.zoom(80.0, view.ray(200.0, 450.0) * 7.0);
        let seen = shown(&navigation, place);
        assert!(seen.distance(glam::Vec2::new(200.0, 450.0)) < 1.0, "{seen}");
        assert!((navigation.distance() - 900.0 * (-0.32_f64).exp()).abs() < 1e-6);
        navigation.zoom(-80.0, view.ray(200.0, 450.0));
        assert!(shown(&navigation, pivot).distance(middle) < 1.0);
        navigation.pan(vec2(30.0, -20.0), &View::new(&navigation.eye(), 800, 600));
        let panned = shown(&navigation, pivot) - middle;
        assert!(panned.distance(glam::Vec2::new(30.0, -20.0)) < 1.0, "{panned}");
        for side in Side::ALL {
            let pivot = navigation.pivot();
            navigation.look_from(side);
            assert!(navigation.pivot().distance(pivot) < 1e-3, "the axes are f32");
            assert!(shown(&navigation, pivot).distance(middle) < 0.2, "{side:?}");
        }
        navigation.set_orthographic(false);
        assert_eq!(navigation.eye(), *navigation.camera());
    }

    #[test]
    fn no_hand_moves_the_eye_below_the_ground() {
        let start = {
            let mut camera = Camera::free(DVec3::new(3.0, 400.0, 500.0));
            camera.pitch_deg = 30.0;
            let mut navigation = Navigation::new(camera, 800.0);
            navigation.stay_above(Some(100.0));
            navigation
        };
        let view = View::new(start.camera(), 800, 600);
        let ahead = view.forward * 800.0;
        let ways: [(&str, &dyn Fn(&mut Navigation)); 4] = [
            ("zoom", &|navigation| navigation.zoom(-100.0, ahead)),
            ("orbit", &|navigation| navigation.orbit(vec2(3.0, -40.0))),
            ("pan", &|navigation| navigation.pan(vec2(0.0, -90.0), &view)),
            ("fly", &|navigation| navigation.fly(DVec3::new(5.0, -60.0, 0.0))),
        ];
        for (name, way) in ways {
            let mut navigation = start.clone();
            for _ in 0..20 {
                way(&mut navigation);
            }
            let height = navigation.camera().position.y - 100.0;
            assert!((height - EYE_HEIGHT_M).abs() < 1e-3, "{name}: {height} m over the ground");
            // One that is below it stays where it is.
            let mut below = start.clone();
            below.stay_above(Some(900.0));
            way(&mut below);
            assert!((below.camera().position.y - 400.0).abs() < 1e-9, "{name}: {}", below.camera().position.y);
        }
        let mut navigation = start.clone();
        navigation.zoom(-1e4, ahead);
        let view = View::new(navigation.camera(), 800, 600);
        let seen = view.project((start.pivot() - view.eye).as_vec3()).expect("before the eye");
        assert!(seen.distance(glam::Vec2::new(400.0, 300.0)) < 0.01, "the look keeps its place: {seen}");
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
