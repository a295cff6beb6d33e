//! How much a picture flickers along a path: its change from frame to frame beyond what the truth changes.
//!
//! Clouds, light and camera move, so pictures must change; what matters is what a method adds. For each channel of each
//! pixel, excess = max(0, |ΔM| − |ΔT|), M the method's and T the truth's linear light, Δ from one frame to the next;
//! the largest channel is the pixel's. The geometry is ours and the truth is drawn for the same frames, so no optical
//! flow has to be guessed. A constant error costs nothing here; that is what the error figures are for.

use super::errors::{SizesDiffer, apart};
use super::percentile::Histogram;
use super::pixel_map::PixelMap;
use crate::color::Rgb;
use crate::image::LinearPicture;
use rayon::prelude::*;

/// Takes a path's pictures one after the other.
#[derive(Debug, Clone)]
pub struct Stability {
    /// The method's and the truth's last pictures.
    last: Option<[LinearPicture; 2]>,
    /// Mean excess of each step from frame to frame.
    steps: Vec<f64>,
    excesses: Histogram,
}

/// What a method adds to the truth's own change, in linear light for each step from frame to frame. Less than two
/// frames change nothing: all is 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StabilityFigures {
    /// Over all pixels of all steps.
    pub excess_mean: f64,
    /// What 99.9 % of all pixels of all steps don't exceed, within 1/2,048 of itself.
    pub excess_p999: f32,
    /// The mean over the pixels of the worst step.
    pub worst_frame: f64,
    /// Which frame, counted from 0, that step led to; the first of equally bad ones.
    pub worst_frame_index: usize,
}

impl Default for Stability {
    fn default() -> Self {
        Self::new()
    }
}

impl Stability {
    /// Before the first frame.
    pub fn new() -> Self {
        Self { last: None, steps: Vec::new(), excesses: Histogram::new() }
    }

    /// Adds the path's next frame, as a method and as the truth draw it, and gives the excess of the step to it; none
    /// for the first frame.
    ///
    /// # Errors
    /// If a picture is not of the size of all others; the frame is then left out.
    pub fn add(&mut self, method: &LinearPicture, truth: &LinearPicture) -> Result<Option<PixelMap>, SizesDiffer> {
        let size = [method.width, method.height];
        SizesDiffer::check(size, [truth.width, truth.height])?;
        let Some([last_method, last_truth]) = &self.last else {
            self.last = Some([method.clone(), truth.clone()]);
            return Ok(None);
        };
        SizesDiffer::check([last_method.width, last_method.height], size)?;
        let before = last_method.pixels.par_iter().zip(&last_truth.pixels);
        let now = method.pixels.par_iter().zip(&truth.pixels);
        let values = before.zip(now).map(|((m0, t0), (m1, t1))| excess([*m0, *m1], [*t0, *t1])).collect();
        let map = PixelMap { width: method.width, height: method.height, values };
        map.values.iter().for_each(|excess| self.excesses.add(*excess));
        self.steps.push(map.mean());
        self.last = Some([method.clone(), truth.clone()]);
        Ok(Some(map))
    }

    /// What the frames so far come to.
    pub fn figures(&self) -> StabilityFigures {
        let mut worst = (0, 0.0);
        for (step, mean) in self.steps.iter().enumerate() {
            if *mean > worst.1 {
                worst = (step + 1, *mean);
            }
        }
        StabilityFigures {
            // All frames are of one size, so the mean of means is the mean.
            excess_mean: self.steps.iter().sum::<f64>() / self.steps.len().max(1) as f64,
            excess_p999: self.excesses.percentile(0.999),
            worst_frame: worst.1,
            worst_frame_index: worst.0,
        }
    }
}

/// Of the largest channel, from one frame to the next.
fn excess(method: [Rgb; 2], truth: [Rgb; 2]) -> f32 {
    let ([m0, m1], [t0, t1]) = (method.map(Rgb::to_array), truth.map(Rgb::to_array));
    // f32::max passes over what is no number: where both change infinitely, nothing is in excess.
    (0..3).map(|c| apart(m1[c], m0[c]) - apart(t1[c], t0[c])).fold(0.0, f32::max)
}
