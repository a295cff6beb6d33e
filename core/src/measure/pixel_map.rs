//! One figure for each pixel, and what sums it up.

use super::percentile::percentile;
use rayon::prelude::*;

/// A figure for each pixel of a picture: an error, a count. Heat maps show it.
#[derive(Debug, Clone, PartialEq)]
pub struct PixelMap {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Top row first; not negative.
    pub values: Vec<f32>,
}

impl PixelMap {
    /// Mean over all pixels; 0 without any. Rows are summed in f64, then their sums, always in the same order.
    pub fn mean(&self) -> f64 {
        let row_sum = |row: &[f32]| row.iter().copied().map(f64::from).sum::<f64>();
        let rows: Vec<f64> = self.values.par_chunks((self.width as usize).max(1)).map(row_sum).collect();
        rows.iter().sum::<f64>() / self.values.len().max(1) as f64
    }

    /// The largest value; 0 without any.
    pub fn largest(&self) -> f32 {
        self.values.iter().copied().fold(0.0, f32::max)
    }

    /// The value that `share` (0 to 1) of all pixels don't exceed, by nearest rank; 0 without any.
    pub fn percentile(&self, share: f64) -> f32 {
        percentile(&self.values, share)
    }
}
