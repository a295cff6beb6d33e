//! Marching one puff: from lobes to a field of density, and through it to alpha and luminance.
//!
//! The field follows A. Schneider and N. Vos, *The Real-Time Volumetric Cloudscapes of
//! Horizon Zero Dawn*, SIGGRAPH 2015: a smooth body, swollen by billows and eroded
//! only where it is thin.

use super::light::sample;
use super::lobes::Lobe;
use super::noise::{Vec3, billow, mix, perlin, perlin_fractal, saturate, smoothstep};
use super::{TILE_SIZE, Texels};

/// How a puff's body turns into density.
#[derive(Clone, Copy)]
pub struct Substance {
    /// How far the billows push the surface, and their base frequency.
    pub swell: f32,
    pub frequency: f32,
    /// 0: billows by Worley alone; 1: clouded by Perlin alone.
    pub haze: f32,
    /// How deep below the surface the density has become full.
    pub edge: f32,
    /// How much of the thin outer parts is torn away.
    pub tear: f32,
    /// Extinction at full density, for a tile two units wide.
    pub extinction: f32,
    /// Where the flat base lies, if there is one.
    pub base: Option<f32>,
    pub seed: u32,
}

impl Substance {
    /// Nothing swells farther out of the lobes than this.
    fn reach(&self) -> f32 {
        1.3 * self.swell
    }
}

/// Slices through the depth of a tile.
const SLICES: usize = 56;
/// The optical depth at which a texel is done (alpha 0.999).
pub const OPAQUE: f32 = 7.0;
/// How far lobes melt into one another, by generation: the great ones make one body, the
/// small ones keep their creases.
const BLENDS: [f32; 4] = [0.10, 0.04, 0.03, 0.02];
/// The height over which a flat base gathers its density.
const BASE_EDGE: f32 = 0.14;

pub struct Puff {
    pub lobes: Vec<Lobe>,
    pub substance: Substance,
}

impl Puff {
    pub fn march(&self) -> Texels {
        let light = self.openness();
        let mut optical_depth = vec![0.0_f32; TILE_SIZE * TILE_SIZE];
        let mut seen = vec![0.0_f32; TILE_SIZE * TILE_SIZE];
        let mut nearness = vec![0.0_f32; TILE_SIZE * TILE_SIZE];
        let mut weight = vec![0.0_f32; TILE_SIZE * TILE_SIZE];
        let step = 2.0 / SLICES as f32;
        for index in 0..SLICES {
            // From the viewer inwards.
            let z = 1.0 - (index as f32 + 0.5) * step;
            let Some(body) = self.body(TILE_SIZE, z, 3) else {
                continue;
            };
            for (texel, &depth) in body.iter().enumerate() {
                // Behind this nothing is seen any more.
                if optical_depth[texel] > OPAQUE {
                    continue;
                }
                let p = cell_place(texel, TILE_SIZE, z);
                let density = self.density(p, depth, 3);
                if density <= 0.0 {
                    continue;
                }
                let through = libm::expf(-optical_depth[texel]);
                let thickness = density * self.substance.extinction * step;
                optical_depth[texel] += thickness;
                let added = through * (1.0 - libm::expf(-thickness));
                seen[texel] += added * sample(&light, p);
                nearness[texel] += added * z;
                weight[texel] += added;
            }
        }
        let mean = |sums: Vec<f32>| {
            let pairs = sums.iter().zip(&weight);
            pairs.map(|(&sum, &weight)| if weight > 0.0 { sum / weight } else { 0.0 }).collect()
        };
        Texels { openness: mean(seen), nearness: mean(nearness), alpha: weight }
    }

    /// How deep each cell of a slice lies inside the union of the lobes (negative outside).
    pub fn body(&self, side: usize, z: f32, generation: u32) -> Option<Vec<f32>> {
        let mut body = vec![-1.0_f32; side * side];
        let mut touched = false;
        for lobe in self.lobes.iter().filter(|lobe| lobe.generation <= generation) {
            let reach = lobe.radius + self.substance.reach();
            let dz = z - lobe.centre[2];
            if dz * dz >= reach * reach {
                continue;
            }
            touched = true;
            let columns = span(lobe.centre[0], reach, side);
            for row in span(-lobe.centre[1], reach, side) {
                let dy = -place(row, side) - lobe.centre[1];
                for column in columns.clone() {
                    let dx = place(column, side) - lobe.centre[0];
                    let depth = lobe.radius - (dx * dx + dy * dy + dz * dz).sqrt();
                    let cell = &mut body[row * side + column];
                    *cell = smooth_union(*cell, depth, BLENDS[lobe.generation.min(3) as usize]);
                }
            }
        }
        touched.then_some(body)
    }

    pub fn density(&self, p: Vec3, depth: f32, octaves: u32) -> f32 {
        let s = &self.substance;
        if depth <= -s.reach() {
            return 0.0;
        }
        // Well inside the noise cannot show.
        let mut d = if depth > s.edge + s.swell {
            1.0
        } else if octaves == 0 {
            saturate(depth / s.edge)
        } else {
            // The noise itself is bent a little: straight cells look like crystals.
            let bend = 0.06 * perlin([p[0] * 3.1, p[1] * 3.1, p[2] * 3.1], s.seed ^ 0x51);
            let q = [p[0] + bend, p[1] - bend, p[2] + bend];
            let puffs = billow(q, s.frequency, octaves, s.seed) - 0.48;
            let fog =
                if s.haze > 0.0 { 0.9 * perlin_fractal(q, 0.8 * s.frequency, octaves, s.seed ^ 0xF0) } else { 0.0 };
            let surface = depth + s.swell * 2.0 * mix(puffs, fog, s.haze);
            let full = saturate(surface / s.edge);
            if full > 0.0 && full < 1.0 && s.tear > 0.0 {
                let torn = 0.5 + perlin_fractal(q, 6.5, 2, s.seed ^ 0x7EA2);
                let kept = full - s.tear * (1.0 - full) * saturate(torn);
                saturate(kept)
            } else {
                full
            }
        };
        if let Some(base) = s.base {
            let ragged = 0.07 * perlin_fractal([p[0], 0.4 * p[1], p[2]], 4.0, 3, s.seed ^ 0xBA5E);
            d *= smoothstep(base, base + BASE_EDGE, p[1] + ragged);
        }
        // The frame: erosion rather than a window, so that no straight edge can show.
        saturate(d - 1.0 + smoothstep(0.02, 0.14, margin(p[0], p[1])))
    }
}

/// The coordinate of a cell's centre among so many between -1 and 1.
pub fn place(index: usize, side: usize) -> f32 {
    (2 * index + 1) as f32 / side as f32 - 1.0
}

/// The centre of a cell of a slice, row 0 at the top.
pub fn cell_place(cell: usize, side: usize, z: f32) -> Vec3 {
    [place(cell % side, side), -place(cell / side, side), z]
}

/// How far inside the tile's frame a place lies, the frame's corners being rounded.
pub fn margin(x: f32, y: f32) -> f32 {
    let (xx, yy) = (x * x, y * y);
    1.0 - (xx * xx + yy * yy).sqrt().sqrt()
}

/// The cells whose centres may lie within a reach of a coordinate.
fn span(centre: f32, reach: f32, side: usize) -> core::ops::Range<usize> {
    let scale = 0.5 * side as f32;
    let low = libm::floorf((centre - reach + 1.0) * scale).max(0.0) as usize;
    let high = libm::ceilf((centre + reach + 1.0) * scale).max(0.0) as usize;
    low.min(side)..high.min(side)
}

/// The greater of two depths, rounded over where they meet (I. Quilez's polynomial form).
fn smooth_union(a: f32, b: f32, blend: f32) -> f32 {
    let overlap = (blend - (a - b).abs()).max(0.0) / blend;
    a.max(b) + 0.25 * blend * overlap * overlap
}
