//! Models, one ray after the other and one triangle after the other. Slow and easy to trust.

use super::{corner, lit};
use crate::camera::NEAR_M;
use crate::color::Rgb;
use crate::frame::Frame;
use glam::Vec3;

/// The models of a frame, placed before the eye.
#[derive(Debug)]
pub struct PlacedModels<'a> {
    frame: &'a Frame<'a>,
    placed: Vec<Placed>,
}

/// A model's corners, metres from the eye, and a ball around its origin that holds them.
#[derive(Debug)]
struct Placed {
    corners: Vec<[Vec3; 3]>,
    radius: f32,
}

/// What a ray meets: how far along it, and of which triangle of which model.
struct Met {
    depth: f64,
    model: usize,
    triangle: usize,
    weights: [f32; 3],
}

impl<'a> PlacedModels<'a> {
    /// Those of `frame`.
    pub fn new(frame: &'a Frame<'a>) -> Self {
        let placed = frame.models.iter().map(|model| {
            let corners = model.mesh.vertices().chunks_exact(3).map(|of| [0, 1, 2].map(|i| corner(model, &of[i])));
            let corners: Vec<[Vec3; 3]> = corners.collect();
            let radii = corners.as_flattened().iter().map(|corner| corner.distance(model.from_eye));
            Placed { radius: radii.fold(0.0, f32::max) * 1.001, corners }
        });
        Self { frame, placed: placed.collect() }
    }

    /// What the ray through a pixel coordinate meets first: one over the view depth, 1/m, and its colour in linear light.
    pub fn nearest(&self, x: f32, y: f32) -> Option<(f32, Rgb)> {
        let ray = self.frame.view.ray(x, y);
        let met = (0..self.placed.len()).flat_map(|model| self.met(ray, model));
        let Met { depth, model, triangle, weights } = met.min_by(|a, b| a.depth.total_cmp(&b.depth))?;
        let vertices = &self.frame.models[model].mesh.vertices()[3 * triangle..][..3];
        let (mut normal, mut color) = (Vec3::ZERO, Rgb::BLACK);
        for (vertex, weight) in vertices.iter().zip(weights) {
            (normal, color) = (normal + vertex.normal * weight, color + vertex.color * weight);
        }
        let [a, b, c] = self.placed[model].corners[triangle];
        let is_outside = (b - a).cross(c - a).dot(ray) < 0.0;
        let normal = self.frame.models[model].turn * if is_outside { normal } else { -normal };
        let horizon = |direction| self.frame.background.dome.horizon(direction);
        Some((
            (1.0 / depth) as f32,
            lit((self.frame, self.frame.models[model].sunlit), (ray * depth as f32, normal), color, horizon),
        ))
    }

    fn met(&self, ray: Vec3, model: usize) -> impl Iterator<Item = Met> {
        let Placed { corners, radius } = &self.placed[model];
        let middle = self.frame.models[model].from_eye;
        let passes = middle.cross(ray).length() <= radius * ray.length();
        let triangles = corners.iter().enumerate().filter(move |_| passes);
        triangles.filter_map(move |(triangle, corners)| {
            let (depth, weights) = meet(ray, *corners)?;
            (depth >= f64::from(NEAR_M)).then_some(Met { depth, model, triangle, weights })
        })
    }
}

/// How far along the ray a triangle is met, and the corners' weights there (Möller and Trumbore, *Fast, Minimum Storage
/// Ray/Triangle Intersection*, Journal of Graphics Tools 2(1), 1997).
fn meet(ray: Vec3, corners: [Vec3; 3]) -> Option<(f64, [f32; 3])> {
    let ray = ray.as_dvec3();
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let (along_b, along_c) = (b - a, c - a);
    let across = ray.cross(along_c);
    let determinant = along_b.dot(across);
    if determinant == 0.0 {
        return None;
    }
    let from_a = -a;
    let of_b = from_a.dot(across) / determinant;
    let turned = from_a.cross(along_b);
    let of_c = ray.dot(turned) / determinant;
    let is_within = of_b >= 0.0 && of_c >= 0.0 && of_b + of_c <= 1.0;
    let depth = along_c.dot(turned) / determinant;
    (is_within && depth.is_finite()).then_some((depth, [1.0 - of_b - of_c, of_b, of_c].map(|weight| weight as f32)))
}
