//! A blur over one tile.

use super::TILE_SIZE;

/// A weighted blur by three boxes each way, which is close to a Gaussian of that radius.
pub fn blur(weights: &[f32], values: &[f32], radius: usize) -> Vec<f32> {
    let mut weights = weights.to_vec();
    let mut sums: Vec<f32> = weights.iter().zip(values).map(|(&w, &v)| w * v).collect();
    for _ in 0..3 {
        for (step, line) in [(1, TILE_SIZE), (TILE_SIZE, 1)] {
            weights = box_blur(&weights, step, line, radius);
            sums = box_blur(&sums, step, line, radius);
        }
    }
    sums.iter().zip(&weights).map(|(&sum, &weight)| if weight > 1e-6 { sum / weight } else { 0.0 }).collect()
}

fn box_blur(values: &[f32], step: usize, line: usize, radius: usize) -> Vec<f32> {
    let mut blurred = vec![0.0; values.len()];
    for start in (0..TILE_SIZE).map(|index| index * line) {
        for index in 0..TILE_SIZE {
            let low = index.saturating_sub(radius);
            let high = (index + radius).min(TILE_SIZE - 1);
            let sum: f32 = (low..=high).map(|near| values[start + near * step]).sum();
            blurred[start + index * step] = sum / (2 * radius + 1) as f32;
        }
    }
    blurred
}
