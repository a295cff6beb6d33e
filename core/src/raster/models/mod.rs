//! Aircraft and props: opaque triangles behind and among the sprites, which read how near they are.
//!
//! A triangle's corners a, b, c count from the eye. The ray ρ through a pixel meets it where ρ·(b×c), ρ·(c×a) and
//! ρ·(a×b), each over a·(b×c), are all positive: they are the corners' weights over the view depth, and their sum is
//! one over the depth. All are linear in the pixel, so perspective needs no division, and what the near plane cuts no
//! clipping (Olano and Greer, *Triangle Scan Conversion using 2D Homogeneous Coordinates*, Graphics Hardware 1997).
//! Which triangle a sample shows is found first, and only that is lit. [`plain`] is the oracle; the GPU's twin is
//! models.wgsl.

pub mod plain;

use super::bins::{TILE, TileRect};
use crate::camera::{NEAR_M, View};
use crate::color::{Premultiplied, Rgb};
use crate::frame::Frame;
use crate::model_in_view::ModelInView;
use crate::model_mesh::ModelVertex;
use crate::sky::{DomeTables, haze_share};
use glam::{DVec2, DVec3, Vec3};
use rayon::prelude::*;

/// What the ground gives back of the sky's light, from below.
const GROUND_SHARE: f32 = 0.45;

/// The nearest models at the samples of a tile.
#[derive(Debug)]
pub(crate) struct ModelTile {
    /// Samples from one row to the next: a whole tile's, whatever the tile's width.
    stride: usize,
    /// One over the view depth, 1/m; 0 where there is no model.
    nearness: Vec<f32>,
    /// Linear light, hazed.
    colors: Vec<Rgb>,
}

impl ModelTile {
    /// One over the view depth of what a sample of the tile shows, and its colour; none where there is no model.
    pub(crate) fn at(&self, x: usize, y: usize) -> Option<(f32, Rgb)> {
        let at = y * self.stride + x;
        (self.nearness[at] > 0.0).then(|| (self.nearness[at], self.colors[at]))
    }

    /// One over the view depth at the samples of a row from `x` on.
    #[inline]
    pub(crate) fn nearness(&self, x: usize, y: usize) -> &[f32] {
        &self.nearness[y * self.stride + x..(y + 1) * self.stride]
    }
}

/// What of a sprite shows where a model is. It stands for something as deep as it is wide: so much of it shows as lies
/// before the model, and no edge is seen where the quad cuts it. Depths are the view's, metres.
#[inline]
pub(crate) fn share_before(model_nearness: f32, sprite_depth: f32, sprite_half_depth: f32) -> f32 {
    (0.5 + 0.5 * (1.0 / model_nearness - sprite_depth) / sprite_half_depth).clamp(0.0, 1.0)
}

/// `fragment`, as far as it lies before a model.
#[inline]
pub(crate) fn before(fragment: Premultiplied, model_nearness: f32, depth: f32, half_depth: f32) -> Premultiplied {
    fragment * share_before(model_nearness, depth, half_depth)
}

/// The models of a frame on the screen.
pub(crate) struct Models<'a> {
    frame: &'a Frame<'a>,
    dome: DomeTables,
    triangles: Vec<Triangle>,
    /// For each row of tiles the triangles that may touch it.
    rows: Vec<Vec<u32>>,
}

/// A triangle that may show.
struct Triangle {
    /// Each corner's weight over the view depth, at the picture's top left corner, and its change a pixel to the right
    /// and down.
    weights: [DVec3; 3],
    /// Left, top, right, bottom, pixels: no sample outside can be covered.
    bounds: [f32; 4],
    /// Its model, and the first of its corners there.
    model: u32,
    first: u32,
    /// Whether its outer side is seen.
    is_outside: bool,
}

impl<'a> Models<'a> {
    /// None if none shows.
    pub(crate) fn new(frame: &'a Frame<'a>) -> Option<Self> {
        let mut triangles = Vec::new();
        for (model, at) in frame.models.iter().zip(0..) {
            let corners = model.mesh.vertices().par_chunks_exact(3).with_min_len(256).zip(0_u32..u32::MAX);
            triangles.par_extend(corners.filter_map(|(corners, i)| {
                let corners = [0, 1, 2].map(|i| corner(model, &corners[i]));
                Triangle::new(&frame.view, corners, [at, 3 * i])
            }));
        }
        if triangles.is_empty() {
            return None;
        }
        let mut rows = vec![Vec::new(); (frame.view.height as usize).div_ceil(TILE)];
        for (triangle, index) in triangles.iter().zip(0..) {
            let [first, last] = [triangle.bounds[1], triangle.bounds[3]].map(|y| y as usize / TILE);
            let last = last.min(rows.len() - 1);
            rows[first.min(last)..=last].iter_mut().for_each(|row| row.push(index));
        }
        Some(Self { frame, dome: DomeTables::new(&frame.background.dome), triangles, rows })
    }

    /// What they show in a tile of `side` × `side` samples a pixel; none where there are none.
    pub(crate) fn tile(&self, rect: TileRect, side: u32) -> Option<ModelTile> {
        let row = self.rows.get(rect.top as usize / TILE)?;
        let [left, right] = [rect.left as f32, (rect.left + rect.width) as f32];
        let touches = |triangle: &Triangle| triangle.bounds[0] <= right && triangle.bounds[2] >= left;
        let mut members =
            row.iter().map(|at| (*at, &self.triangles[*at as usize])).filter(|(_, each)| touches(each)).peekable();
        members.peek()?;
        let stride = TILE * side as usize;
        let mut nearness = vec![0.0_f32; stride * rect.height as usize * side as usize];
        let mut shown = vec![u32::MAX; nearness.len()];
        for (index, triangle) in members {
            triangle.cover(rect, side, |x, y, near| {
                let at = y * stride + x;
                if near > nearness[at] {
                    (nearness[at], shown[at]) = (near, index);
                }
            });
        }
        let color = |(at, index): (usize, &u32)| {
            let triangle = self.triangles.get(*index as usize)?;
            let [x, y] = [at % stride, at / stride].map(|i| (i as f64 + 0.5) / f64::from(side));
            Some(self.color(triangle, DVec2::new(f64::from(rect.left) + x, f64::from(rect.top) + y)))
        };
        let colors = shown.iter().enumerate().map(|shown| color(shown).unwrap_or(Rgb::BLACK)).collect();
        Some(ModelTile { stride, nearness, colors })
    }

    /// What a triangle shows at a pixel coordinate.
    fn color(&self, triangle: &Triangle, at: DVec2) -> Rgb {
        let model = &self.frame.models[triangle.model as usize];
        let corners = &model.mesh.vertices()[triangle.first as usize..][..3];
        let over_depth = triangle.weights.map(|weight| weight_at(weight, at.x, at.y));
        let depth = 1.0 / over_depth.iter().sum::<f64>();
        let weights = over_depth.map(|weight| (weight * depth) as f32);
        let (mut normal, mut color) = (Vec3::ZERO, Rgb::BLACK);
        for (corner, weight) in corners.iter().zip(weights) {
            (normal, color) = (normal + corner.normal * weight, color + corner.color * weight);
        }
        let normal = model.turn * if triangle.is_outside { normal } else { -normal };
        let point = self.frame.view.ray(at.x as f32, at.y as f32) * depth as f32;
        lit((self.frame, model.sunlit), (point, normal), color, |direction| self.dome.horizon(direction))
    }
}

/// A corner's place, metres from the eye.
fn corner(model: &ModelInView, vertex: &ModelVertex) -> Vec3 {
    model.from_eye + model.turn * (vertex.position * model.scale)
}

/// The light that comes from a point, whose surface looks along `normal` (any length): the sun's, the sky's and what the
/// ground gives back of that, behind haze of the `horizon`'s colour.
fn lit(
    (frame, sunlit): (&Frame<'_>, f32),
    (point, normal): (Vec3, Vec3),
    color: Rgb,
    horizon: impl Fn(Vec3) -> Rgb,
) -> Rgb {
    let (light, normal) = (&frame.now.light, normal.normalize_or(Vec3::Y));
    let sun = light.directional_max * (sunlit * normal.dot(light.direction).max(0.0));
    let sky = light.ambient_max.rgb * (GROUND_SHARE + (1.0 - GROUND_SHARE) * (0.5 + 0.5 * normal.y));
    let hazed = haze_share(point.length(), frame.background.haze_length_m);
    (color * (sun + sky)).mix(horizon(point), hazed)
}

fn weight_at(weight: DVec3, x: f64, y: f64) -> f64 {
    weight.x + weight.y * x + weight.z * y
}

impl Triangle {
    /// None if it is seen edge-on or not at all.
    fn new(view: &View, corners: [Vec3; 3], [model, first]: [u32; 2]) -> Option<Self> {
        let bounds = bounds(view, &corners)?;
        let [a, b, c] = corners.map(|corner| corner.as_dvec3());
        let normals = [b.cross(c), c.cross(a), a.cross(b)];
        let volume = a.dot(normals[0]);
        let pixel = f64::from(view.pixel());
        let [right, down] = [view.right.as_dvec3() * pixel, view.up.as_dvec3() * -pixel];
        let top_left =
            view.forward.as_dvec3() - right * (0.5 * f64::from(view.width)) - down * (0.5 * f64::from(view.height));
        let rays = [top_left, right, down];
        let weights = normals.map(|normal| DVec3::from_array(rays.map(|ray| normal.dot(ray) / volume)));
        let is_finite = weights.iter().all(|weight| weight.is_finite());
        is_finite.then_some(Self { weights, bounds, model, first, is_outside: volume < 0.0 })
    }

    /// Tells of each sample of the tile that it covers: its place among the tile's samples, and one over the depth.
    fn cover(&self, rect: TileRect, side: u32, mut tell: impl FnMut(usize, usize, f32)) {
        let samples = f64::from(side);
        let span = |from: f32, to: f32, start: u32, length: u32| {
            let place = |at: f32| (f64::from(at) - f64::from(start)) * samples;
            // A sample to spare, for rounding.
            let first = (place(from) - 1.0).max(0.0) as usize;
            first..((place(to) + 1.0).max(0.0).ceil() as usize).min((length * side) as usize)
        };
        let columns = span(self.bounds[0], self.bounds[2], rect.left, rect.width);
        let place = |start: u32, i: usize| f64::from(start) + (i as f64 + 0.5) / samples;
        for row in span(self.bounds[1], self.bounds[3], rect.top, rect.height) {
            let starts = self.weights.map(|weight| weight_at(weight, 0.0, place(rect.top, row)));
            for column in columns.clone() {
                let x = place(rect.left, column);
                let [a, b, c] = [0, 1, 2].map(|i| starts[i] + self.weights[i].y * x);
                let near = (a + b + c) as f32;
                if a >= 0.0 && b >= 0.0 && c >= 0.0 && near > 0.0 && near <= 1.0 / NEAR_M {
                    tell(column, row, near);
                }
            }
        }
    }
}

/// Around the corners on the screen; for a triangle that the near plane cuts, the whole picture. None if it is not seen.
fn bounds(view: &View, corners: &[Vec3; 3]) -> Option<[f32; 4]> {
    let whole = [0.0, 0.0, view.width as f32, view.height as f32];
    if corners.iter().all(|corner| view.depth(*corner) < NEAR_M) {
        return None;
    }
    let [Some(a), Some(b), Some(c)] = corners.map(|corner| view.project(corner)) else { return Some(whole) };
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    let is_seen = high.x >= 0.0 && high.y >= 0.0 && low.x <= whole[2] && low.y <= whole[3];
    is_seen.then(|| [low.x.max(0.0), low.y.max(0.0), high.x.min(whole[2]), high.y.min(whole[3])])
}
