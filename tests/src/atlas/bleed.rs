//! The luminance of texels that are clear.

use super::TILE_SIZE;
use super::finish::to_byte;
use super::noise::saturate;

/// Fills the clear texels with the luminance of their neighbourhood, so that straight-alpha
/// filters and mip levels find no black or white there. It is the pull and push of S. Gortler
/// et al., *The Lumigraph*, SIGGRAPH 1996: halve with alpha as weight, then fill in from coarse to fine.
pub fn spread(alpha: &[f32], luminance: &[f32]) -> Vec<f32> {
    // What rounds to alpha 0 shall be filled, too.
    let weights: Vec<f32> = alpha.iter().map(|&alpha| if to_byte(alpha) == 0 { 0.0 } else { alpha }).collect();
    spread_level(&weights, luminance, TILE_SIZE)
}

fn spread_level(weights: &[f32], values: &[f32], side: usize) -> Vec<f32> {
    if side <= 1 {
        return values.to_vec();
    }
    let half = side / 2;
    let mut coarse_weights = Vec::with_capacity(half * half);
    let mut coarse_values = Vec::with_capacity(half * half);
    for cell in 0..half * half {
        let corner = cell / half * 2 * side + cell % half * 2;
        let (mut weight, mut sum) = (0.0, 0.0);
        for texel in [corner, corner + 1, corner + side, corner + side + 1] {
            weight += weights[texel];
            sum += weights[texel] * values[texel];
        }
        coarse_weights.push(saturate(weight));
        coarse_values.push(if weight > 0.0 { sum / weight } else { 0.0 });
    }
    let coarse = spread_level(&coarse_weights, &coarse_values, half);
    let fetch = |column: isize, row: isize| {
        let last = half as isize - 1;
        coarse[row.clamp(0, last) as usize * half + column.clamp(0, last) as usize]
    };
    (0..side * side)
        .map(|texel| {
            if weights[texel] > 0.0 {
                return values[texel];
            }
            // Between the four nearest coarse cells, at quarters.
            let (column, row) = ((texel % side) as isize, (texel / side) as isize);
            let (near_x, near_y) = (column / 2, row / 2);
            let far_x = near_x + if column % 2 == 0 { -1 } else { 1 };
            let far_y = near_y + if row % 2 == 0 { -1 } else { 1 };
            0.5625 * fetch(near_x, near_y)
                + 0.1875 * (fetch(far_x, near_y) + fetch(near_x, far_y))
                + 0.0625 * fetch(far_x, far_y)
        })
        .collect()
}
