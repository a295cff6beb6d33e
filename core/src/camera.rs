//! A camera resolved for one picture: eye, axes and how wide it sees.

use crate::scene::Camera;
use glam::{DVec3, Vec2, Vec3};

/// Nothing nearer than this, measured along the view direction, is drawn. Metres.
pub const NEAR_M: f32 = 0.1;

/// A point of view for a picture of a given size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// The eye, metres in the world.
    pub eye: DVec3,
    /// To the right of the picture, unit.
    pub right: Vec3,
    /// To the top of the picture, unit.
    pub up: Vec3,
    /// Into the picture, unit.
    pub forward: Vec3,
    /// Tangent of half the vertical field of view.
    pub tan_half_height: f32,
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Of a side of a panorama ([`crate::panorama`]) the up of its camera, which all sides share; none for a picture by
    /// itself. Only the CPU draws such views.
    pub of_panorama: Option<Vec3>,
}

impl View {
    /// What `camera` sees in a picture of `width` × `height` pixels (at least 1 each).
    pub fn new(camera: &Camera, width: u32, height: u32) -> Self {
        let sin_cos = |deg: f64| {
            let rad = deg.to_radians();
            (libm::sin(rad), libm::cos(rad))
        };
        let (sin_heading, cos_heading) = sin_cos(camera.heading_deg);
        let (sin_pitch, cos_pitch) = sin_cos(camera.pitch_deg);
        let (sin_roll, cos_roll) = sin_cos(camera.roll_deg);
        let forward = DVec3::new(sin_heading * cos_pitch, sin_pitch, -cos_heading * cos_pitch);
        let level_right = DVec3::new(cos_heading, 0.0, sin_heading);
        let level_up = level_right.cross(forward);
        Self {
            eye: camera.position,
            right: (level_right * cos_roll - level_up * sin_roll).as_vec3(),
            up: (level_up * cos_roll + level_right * sin_roll).as_vec3(),
            forward: forward.as_vec3(),
            tan_half_height: libm::tan((camera.field_of_view_deg * 0.5).to_radians()) as f32,
            width: width.max(1),
            height: height.max(1),
            of_panorama: None,
        }
    }

    /// The up by which sprites straight above and below the eye are turned.
    pub fn up_at_poles(&self) -> Vec3 {
        self.of_panorama.unwrap_or(self.up)
    }

    /// The depth, metres, that says how fine an eye-relative point's surroundings are drawn: the view depth, but in a
    /// panorama what all its sides agree on, the distance.
    pub fn depth_of_detail(&self, point: Vec3) -> f32 {
        if self.of_panorama.is_some() { point.length() } else { self.depth(point) }
    }

    /// Length of a pixel's side on a plane at distance 1.
    pub fn pixel(&self) -> f32 {
        2.0 * self.tan_half_height / self.height as f32
    }

    /// The ray through pixel coordinates (0, 0 is the picture's top left corner), with length 1 *along the view
    /// direction*: a point at view depth t lies at t times this.
    pub fn ray(&self, x: f32, y: f32) -> Vec3 {
        let pixel = self.pixel();
        self.forward
            + self.right * ((x - 0.5 * self.width as f32) * pixel)
            + self.up * ((0.5 * self.height as f32 - y) * pixel)
    }

    /// View depth of an eye-relative point: metres along the view direction.
    pub fn depth(&self, point: Vec3) -> f32 {
        point.dot(self.forward)
    }

    /// Pixel coordinates of an eye-relative point before the near plane, else none.
    pub fn project(&self, point: Vec3) -> Option<Vec2> {
        let depth = self.depth(point);
        (depth >= NEAR_M).then(|| {
            let scale = 1.0 / (depth * self.pixel());
            Vec2::new(
                0.5 * self.width as f32 + point.dot(self.right) * scale,
                0.5 * self.height as f32 - point.dot(self.up) * scale,
            )
        })
    }

    /// Whether a sphere, eye-relative, may show: false only if it surely lies outside.
    pub fn sees_sphere(&self, center: Vec3, radius: f32) -> bool {
        let depth = self.depth(center);
        if depth < NEAR_M - radius {
            return false;
        }
        let tan_half_width = self.tan_half_height * self.width as f32 / self.height as f32;
        // Distance to a side plane of the frustum, whose normal is (1, tan)/|(1, tan)| in (across, depth).
        let outside = |across: f32, tan: f32| across.abs() - depth * tan > radius * (1.0 + tan * tan).sqrt();
        !outside(center.dot(self.right), tan_half_width) && !outside(center.dot(self.up), self.tan_half_height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heading_pitch_and_roll_turn_the_right_way() {
        let mut camera = Camera::free(DVec3::ZERO);
        let axes = |c: &Camera| {
            let view = View::new(c, 100, 100);
            (view.forward, view.right, view.up)
        };
        let near = |a: Vec3, b: Vec3| a.distance(b) < 1e-6;
        let (forward, right, up) = axes(&camera);
        assert!(near(forward, Vec3::NEG_Z) && near(right, Vec3::X) && near(up, Vec3::Y), "north");
        camera.heading_deg = 90.0;
        assert!(near(axes(&camera).0, Vec3::X), "90° is east");
        camera.pitch_deg = 90.0;
        assert!(near(axes(&camera).0, Vec3::Y) && near(axes(&camera).2, Vec3::NEG_X), "straight up");
        camera.pitch_deg = 0.0;
        camera.roll_deg = 90.0;
        assert!(near(axes(&camera).1, Vec3::NEG_Y), "right wing down");
    }

    #[test]
    fn rays_and_projection_agree() {
        let mut camera = Camera::free(DVec3::ZERO);
        (camera.heading_deg, camera.pitch_deg, camera.roll_deg) = (33.0, -12.0, 5.0);
        let view = View::new(&camera, 640, 360);
        for (x, y) in [(0.0, 0.0), (320.0, 180.0), (640.0, 1.0), (13.5, 333.25)] {
            let back = view.project(view.ray(x, y) * 1234.0).expect("it is before the camera");
            assert!(back.distance(Vec2::new(x, y)) < 1e-2, "{back}");
        }
    }
}
