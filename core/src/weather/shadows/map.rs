//! The shadows for the ground, on the CPU: optical depths of all spots, summed texel by texel.
//!
//! The twin in WGSL is render/src/pass/shadows/shadows.wgsl.

use super::{FALLOFF, ShadowPlane, Shadows, Spot, spots};
use crate::math::exp;
use crate::weather::CloudNow;
use rayon::prelude::*;

/// Rows that one thread draws at once.
const ROWS: usize = 32;

/// What is left of the light, e^(−τ/10) from 0 to 1, at the middles of a plane's texels; linear between.
#[derive(Debug, Clone, PartialEq)]
pub struct ShadowMap {
    /// Where its texels lie.
    pub plane: ShadowPlane,
    left: Vec<f32>,
}

impl ShadowMap {
    /// Of `clouds`; none if there is nothing to draw on. The same bytes on any number of threads.
    pub fn new(clouds: &[CloudNow<'_>], shadows: &Shadows) -> Option<Self> {
        let plane = shadows.plane?;
        let casters: Vec<&CloudNow<'_>> = clouds.iter().filter(|cloud| cloud.casts()).collect();
        let of_clouds: Vec<Vec<Spot>> =
            casters.par_iter().map(|cloud| spots(cloud, shadows, &plane).collect()).collect();
        let all: Vec<Spot> = of_clouds.concat();
        let [width, height] = plane.size.map(|side| side as usize);
        let mut left = vec![0.0_f32; width * height];
        left.par_chunks_mut(width * ROWS).enumerate().for_each(|(strip, texels)| {
            let first = strip * ROWS;
            let rows = texels.len() / width;
            let reaches = |spot: &&Spot| spot.reaches_rows(first as f32, (first + rows) as f32);
            all.iter().filter(reaches).for_each(|spot| draw(spot, texels, [width, rows], first));
            texels.iter_mut().for_each(|depth| *depth = exp(-FALLOFF * *depth));
        });
        Some(Self { plane, left })
    }

    /// At a place, texels from the first one's beginning; beyond the edge nothing is lost.
    #[inline(always)]
    pub fn left(&self, [x, y]: [f32; 2]) -> f32 {
        let [width, height] = self.plane.size;
        let within = |at: f32, side: u32| (at - 0.5).max(0.0).min((side - 1) as f32);
        let (x, y) = (within(x, width), within(y, height));
        // Not beyond the last but one, so that there is a next.
        let (column, row) = ((x as u32).min(width - 2), (y as u32).min(height - 2));
        let (share_x, share_y) = (x - column as f32, y - row as f32);
        let at = (row * width + column) as usize;
        let pair = |at: usize| self.left[at] + (self.left[at + 1] - self.left[at]) * share_x;
        let (low, high) = (pair(at), pair(at + width as usize));
        low + (high - low) * share_y
    }
}

/// Adds a spot to some rows of texels, whose middles lie at halves.
fn draw(spot: &Spot, texels: &mut [f32], size: [usize; 2], first_row: usize) {
    let [x, y] = spot.center;
    let on_strip = Spot { center: [x - 0.5, y - 0.5 - first_row as f32], ..*spot };
    on_strip.draw(size, |at, depth| texels[at] += depth);
}
