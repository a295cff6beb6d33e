//! Voxels of extinction: balls are added to them, lines taken through them.

use super::ball::Ball;
use super::profile::{Profile, Profiles};
use crate::watch::Watch;
use glam::{DVec3, UVec3, Vec3};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Layers of voxels that one thread adds at a time.
const SLAB: usize = 4;
/// Balls of at most so many voxels from middle to rim are measured as the voxels see them; of larger ones the sum over
/// voxels is the whole within a few thousandths.
const COARSE: f32 = 12.0;
/// Steps of a line through a voxel.
const STEPS: f32 = 2.0;

/// Extinction in voxels, along the world's axes.
#[derive(Debug, Clone, PartialEq)]
pub struct DensityGrid {
    /// Voxels along x, y and z.
    pub size: UVec3,
    /// The side of a voxel, metres.
    pub voxel_m: f32,
    /// The corner of the first voxel, metres in the world.
    pub corner: DVec3,
    /// Extinction, a metre⁻¹: x runs fastest, then y, then z.
    pub extinction: Vec<f32>,
}

/// A ball as the voxels see it, all lengths in voxels.
struct Seen<'a> {
    profile: &'a Profile,
    center: Vec3,
    reach: Vec3,
    /// A voxel's side in half widths, along x, y and z.
    per_half: Vec3,
    /// What the profile is multiplied with; of a ball that lies between the voxels' middles, all that its one voxel gets.
    scale: f32,
    is_between: bool,
}

impl DensityGrid {
    /// One without extinction.
    pub fn clear(size: UVec3, voxel_m: f32, corner: DVec3) -> Self {
        let [x, y, z] = size.to_array().map(|count| count as usize);
        Self { size, voxel_m, corner, extinction: vec![0.0; x * y * z] }
    }

    /// Adds balls, which count from what lies `from_corner` of the grid, each times what `weight` says of its tile. All of
    /// a ball is added, wherever the voxels' middles lie. Without a result if `watch` is cancelled.
    pub(super) fn add(
        &mut self,
        balls: &[Ball],
        from_corner: Vec3,
        profiles: &Profiles,
        weight: impl Fn(u8) -> f32 + Sync,
        watch: &Watch,
    ) {
        let see = |ball: &Ball| {
            let mut seen = self.see(ball, from_corner, profiles.of(ball.tile, ball.opacity));
            seen.scale *= weight(ball.tile);
            seen
        };
        let seen: Vec<Seen<'_>> = balls.par_iter().map(see).collect();
        let [width, height] = [self.size.x as usize, self.size.y as usize];
        let (done, slabs) = (AtomicUsize::new(0), (self.size.z as usize).div_ceil(SLAB));
        // A slab takes the balls in their order, so no sum depends on the threads.
        self.extinction.par_chunks_mut(width * height * SLAB).enumerate().for_each(|(slab, voxels)| {
            let first = slab * SLAB;
            for ball in &seen {
                if watch.is_cancelled() {
                    return;
                }
                for z in ball.range(2, first..first + voxels.len() / (width * height)) {
                    let layer = &mut voxels[(z - first) * width * height..][..width * height];
                    for y in ball.range(1, 0..height) {
                        ball.add_to_row(&mut layer[y * width..][..width], y, z);
                    }
                }
            }
            watch.reach((done.fetch_add(1, Ordering::Relaxed) + 1) as f32 / slabs as f32);
        });
    }

    fn see<'a>(&self, ball: &Ball, from_corner: Vec3, profile: &'a Profile) -> Seen<'a> {
        let voxel_m = self.voxel_m;
        // Its middle is within the grid, where rounding might have it without.
        let last = self.size.as_vec3() - 1e-3;
        let mut seen = Seen {
            profile,
            center: ((ball.center + from_corner) / voxel_m).clamp(Vec3::ZERO, last),
            reach: ball.reach() / voxel_m,
            per_half: Vec3::splat(voxel_m) / ball.half,
            // A ball's chords are level, and as long as it is wide.
            scale: 1.0 / ball.half.x,
            is_between: false,
        };
        if seen.reach.min_element() <= COARSE {
            let voxel = f64::from(voxel_m) * f64::from(voxel_m) * f64::from(voxel_m);
            let ball_m3 = f64::from(ball.half.x) * f64::from(ball.half.y) * f64::from(ball.half.z);
            let whole = f64::from(profile.whole()) * f64::from(seen.scale) * ball_m3 / voxel;
            let sum = seen.sum(self.size);
            if sum > 0.0 {
                seen.scale *= (whole / sum) as f32;
            } else {
                (seen.scale, seen.is_between) = (whole as f32, true);
                (seen.center, seen.reach) = (seen.center.floor() + 0.5, Vec3::splat(0.25));
            }
        }
        seen
    }

    fn index(&self, UVec3 { x, y, z }: UVec3) -> usize {
        ((z as usize) * (self.size.y as usize) + y as usize) * (self.size.x as usize) + x as usize
    }

    /// Extinction at a place from the corner, metres: linear between voxels' middles, 0 outside.
    pub fn at(&self, from_corner: Vec3) -> f32 {
        let place = from_corner / self.voxel_m - 0.5;
        let base = place.floor();
        let share = place - base;
        let mut sum = 0.0;
        for corner in 0..8 {
            let step = Vec3::new((corner & 1) as f32, (corner >> 1 & 1) as f32, (corner >> 2) as f32);
            let voxel = base + step;
            if voxel.cmplt(Vec3::ZERO).any() || voxel.cmpge(self.size.as_vec3()).any() {
                continue;
            }
            let weight = Vec3::ONE - (share - step).abs();
            sum += weight.element_product() * self.extinction[self.index(voxel.as_uvec3())];
        }
        sum
    }

    /// The sum of extinction along a line through a place from the corner.
    pub(super) fn depth(&self, through: Vec3, direction: Vec3) -> f32 {
        // Half a voxel around the grid it falls to nothing.
        let (low, high) = (Vec3::splat(-0.5 * self.voxel_m), (self.size.as_vec3() + 0.5) * self.voxel_m);
        let (a, b) = ((low - through) / direction, (high - through) / direction);
        let along = |axis: usize| direction[axis].abs() > 1e-6;
        let ends = (0..3).filter(|axis| along(*axis)).map(|axis| (a[axis].min(b[axis]), a[axis].max(b[axis])));
        let (from, to) = ends.fold((f32::NEG_INFINITY, f32::INFINITY), |(from, to), (a, b)| (from.max(a), to.min(b)));
        if from >= to {
            return 0.0;
        }
        let steps = ((to - from) / self.voxel_m * STEPS).ceil().max(1.0);
        let step = (to - from) / steps;
        (0..steps as usize).map(|i| self.at(through + direction * ((i as f32 + 0.5) * step + from))).sum::<f32>() * step
    }
}

impl Seen<'_> {
    /// The voxels within reach along an axis, of `all`.
    fn range(&self, axis: usize, all: Range<usize>) -> Range<usize> {
        let (first, last) = (self.center[axis] - self.reach[axis], self.center[axis] + self.reach[axis]);
        (first.max(0.0) as usize).max(all.start)..(last.max(0.0) as usize + 1).min(all.end)
    }

    /// Square of the distance from the middle along an axis, in half widths.
    fn square(&self, axis: usize, voxel: usize) -> f32 {
        let away = (voxel as f32 + 0.5 - self.center[axis]) * self.per_half[axis];
        away * away
    }

    fn add_to_row(&self, row: &mut [f32], y: usize, z: usize) {
        let off = self.square(1, y) + self.square(2, z);
        let all = self.range(0, 0..row.len());
        if self.is_between {
            row[all].iter_mut().for_each(|voxel| *voxel += self.scale);
            return;
        }
        let first = all.start;
        for (x, voxel) in row[all].iter_mut().enumerate() {
            *voxel += self.profile.at_square(off + self.square(0, first + x)) * self.scale;
        }
    }

    /// What it adds to all voxels.
    fn sum(&self, size: UVec3) -> f64 {
        let [x, y, z] = size.to_array().map(|count| count as usize);
        let mut sum = 0.0;
        for z in self.range(2, 0..z) {
            for y in self.range(1, 0..y) {
                let off = self.square(1, y) + self.square(2, z);
                for x in self.range(0, 0..x) {
                    sum += f64::from(self.profile.at_square(off + self.square(0, x)) * self.scale);
                }
            }
        }
        sum
    }
}
