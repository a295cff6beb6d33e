//! How many fragments a frame blends: the cost that clouds of sprites are dear for.
//!
//! A GPU blends a fragment at each pixel whose centre lies in a sprite's quad, clear texels included. That many pixels
//! cover about as much area as the quad does on the screen, so the count is the sum of areas: each quad is clipped by
//! the near plane and the frustum's sides in view space (Sutherland and Hodgman 1974), projected, and measured by
//! Gauss's shoelace. It costs some hundred operations a sprite instead of a visit to each pixel. The CPU renderer stops
//! early and passes over clear texels, so it blends fewer.
//!
//! [`overdraw`] is that sum, cheap enough to show while someone edits. Where the fragments lie, and how many the worst
//! pixels have, takes counting: [`overdraw_map`].

use super::PixelMap;
use crate::camera::{NEAR_M, View};
use crate::facing::corners;
use crate::frame::Frame;
use crate::raster::bins::{TILE, TileRect, assemble, map_tiles};
use crate::raster::{Linear, ScreenSprite, prepare};
use glam::Vec3;
use rayon::prelude::*;

/// What blending a frame's sprites takes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Overdraw {
    /// Fragments blended: an area, so no whole number.
    pub fragments: f64,
    /// How often a pixel of the picture is blended over, on average.
    pub mean_per_pixel: f64,
}

/// Measures the frame's draw list.
pub fn overdraw(frame: &Frame<'_>) -> Overdraw {
    let view = &frame.view;
    // Sums of fixed parts in a fixed order: the same on any number of threads.
    let parts: Vec<f64> = frame
        .list
        .sprites
        .par_chunks(1024)
        .map(|part| {
            let area = |drawn: &crate::draw_list::DrawSprite| {
                let sprite = &frame.clouds[drawn.cloud as usize].sprites.all()[drawn.sprite as usize];
                let facing = frame.list.pose(drawn, view).facing(sprite.rotation);
                footprint_px(view, &corners(drawn.center, facing, sprite.width, sprite.height))
            };
            part.iter().map(area).sum()
        })
        .collect();
    // Not sum(), which of nothing is −0.
    let fragments = parts.iter().fold(0.0, |sum, part| sum + part);
    Overdraw { fragments, mean_per_pixel: fragments / (f64::from(view.width) * f64::from(view.height)) }
}

/// How many sprites of the frame's draw list are blended at each pixel: those whose quads its centre lies in.
pub fn overdraw_map(frame: &Frame<'_>) -> PixelMap {
    let (width, height) = (frame.view.width, frame.view.height);
    let sprites = prepare(frame);
    let tiles = map_tiles(&sprites, width, height, |rect, members| {
        let mut counts = vec![[0.0; TILE]; rect.height as usize];
        members.iter().for_each(|&member| count(&sprites[member as usize], rect, &mut counts));
        counts.iter().flat_map(|row| &row[..rect.width as usize]).copied().collect()
    });
    PixelMap { width, height, values: assemble(&tiles, width, height, 0.0) }
}

/// Adds 1 where a sprite's quad covers a pixel's centre. Texture coordinates and depth are quotients with one
/// denominator, so each side of the quad, and the near plane, is where a linear function changes sign.
fn count(sprite: &ScreenSprite, rect: TileRect, counts: &mut [[f32; TILE]]) {
    let (left, top) = (rect.left as f32 + 0.5 - sprite.anchor.x, rect.top as f32 + 0.5 - sprite.anchor.y);
    let near = |denominator: f32| sprite.depth - NEAR_M * denominator;
    for (row, counts) in counts.iter_mut().enumerate() {
        let y = top + row as f32;
        for (x, count) in counts.iter_mut().enumerate() {
            let at = |linear: Linear| linear.at(left + x as f32, y);
            let (u, v, denominator) = (at(sprite.u), at(sprite.v), at(sprite.denominator));
            let inside = u.min(denominator - u).min(v).min(denominator - v).min(near(denominator));
            // The denominator is not negative where u and the rest of it are not; at 0 the ray meets nothing.
            *count += if inside >= 0.0 && denominator > 0.0 { 1.0 } else { 0.0 };
        }
    }
}

/// Area of a convex, flat polygon (eye-relative corners) on the screen, in pixels.
fn footprint_px(view: &View, quad: &[Vec3; 4]) -> f64 {
    let tan_half_width = view.tan_half_height * view.width as f32 / view.height as f32;
    let in_view = |point: &Vec3| Vec3::new(point.dot(view.right), point.dot(view.up), point.dot(view.forward));
    let mut polygon = Polygon::new(&quad.each_ref().map(in_view));
    polygon.clip(|p| p.z - NEAR_M);
    polygon.clip(|p| tan_half_width * p.z - p.x);
    polygon.clip(|p| tan_half_width * p.z + p.x);
    polygon.clip(|p| view.tan_half_height * p.z - p.y);
    polygon.clip(|p| view.tan_half_height * p.z + p.y);
    let area = polygon.area_at_distance_1() / f64::from(view.pixel() * view.pixel());
    // What overflows is no area.
    if area.is_finite() { area } else { 0.0 }
}

/// The corners of a convex polygon: a quad clipped by five planes has at most nine.
struct Polygon {
    points: [Vec3; 9],
    len: usize,
}

impl Polygon {
    fn new(quad: &[Vec3; 4]) -> Self {
        let mut polygon = Self { points: [Vec3::ZERO; 9], len: 0 };
        quad.iter().for_each(|point| polygon.push(*point));
        polygon
    }

    fn push(&mut self, point: Vec3) {
        // Beyond nine only roundings of what is no number could lead.
        if let Some(place) = self.points.get_mut(self.len) {
            *place = point;
            self.len += 1;
        }
    }

    /// Keeps what lies where `side`, which is linear, is not negative.
    fn clip(&mut self, side: impl Fn(Vec3) -> f32) {
        let before = std::mem::replace(self, Self { points: [Vec3::ZERO; 9], len: 0 });
        for i in 0..before.len {
            let (from, to) = (before.points[i], before.points[(i + 1) % before.len]);
            let (a, b) = (side(from), side(to));
            if a >= 0.0 {
                self.push(from);
            }
            if (a >= 0.0) != (b >= 0.0) {
                self.push(from + (to - from) * (a / (a - b)));
            }
        }
    }

    /// Of its projection onto the plane z = 1.
    fn area_at_distance_1(&self) -> f64 {
        let projected = |i: usize| {
            let point = self.points[i % self.len].as_dvec3();
            (point.x / point.z, point.y / point.z)
        };
        let twice = (0..self.len).map(|i| {
            let ((ax, ay), (bx, by)) = (projected(i), projected(i + 1));
            ax * by - bx * ay
        });
        twice.sum::<f64>().abs() * 0.5
    }
}
