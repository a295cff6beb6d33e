//! What one frame tells of a method, and what all of them come to.
//!
//! Along a path, frames lie at places spread over the whole flight; at each, the next frame is drawn too, and what has
//! changed between the two is compared with the truth's own change. Every figure is kept by itself, so a run that was
//! broken off goes on at the place where it stopped.

use super::charted::Drawing;
use super::report::{Error, Figure, FrameFigures, MethodFigures, Stability};
use cloudwright_core::image::Picture;
use cloudwright_core::measure::{PIXELS_PER_DEGREE, flip, linear_error, opacity_error};

impl FrameFigures {
    /// Compares what a method drew with the truth: a frame, and along a path the next one.
    pub fn of(at_s: f64, drawings: &[Drawing], truths: &[Drawing]) -> Self {
        let (Some(drawing), Some(truth)) = (drawings.first(), truths.first()) else { return Self::default() };
        let errors = flip(&truth.picture, &drawing.picture, PIXELS_PER_DEGREE).ok();
        let opacity = truth.clouds.as_ref().zip(drawing.clouds.as_ref()).and_then(|(a, b)| opacity_error(a, b).ok());
        let mut stability = cloudwright_core::measure::Stability::new();
        let steps = drawings
            .iter()
            .zip(truths)
            .filter_map(|(drawing, truth)| stability.add(&drawing.linear, &truth.linear).ok());
        let changed = steps.flatten().last();
        Self {
            at_s,
            contrast: contrast(&truth.picture),
            drawn_ms: Some(drawings.iter().map(|drawing| drawing.drawn_ms).sum::<f64>() / drawings.len() as f64),
            error: Error {
                flip_mean: errors.as_ref().map(|map| map.mean()),
                flip_p99: errors.as_ref().map(|map| map.percentile(0.99).into()),
                rmse: linear_error(&truth.linear, &drawing.linear).ok().map(|error| error.rmse),
                opacity_max: opacity.map(|error| error.largest.into()),
            },
            excess_mean: changed.as_ref().map(|map| map.mean()),
            excess_p999: changed.as_ref().map(|map| map.percentile(0.999).into()),
        }
    }
}

impl MethodFigures {
    /// Sets `error` and `stability` to what the frames come to.
    pub fn sum_up(&mut self) {
        let all = |of: fn(&FrameFigures) -> Figure| self.frames.iter().filter_map(of).collect::<Vec<f64>>();
        let most = |of| all(of).into_iter().reduce(f64::max);
        self.error = Error {
            flip_mean: mean(&all(|frame| frame.error.flip_mean)),
            flip_p99: most(|frame| frame.error.flip_p99),
            // Frames are of one size, so the mean of mean squares is that of all.
            rmse: mean(&all(|frame| frame.error.rmse.map(|rmse| rmse * rmse))).map(f64::sqrt),
            opacity_max: most(|frame| frame.error.opacity_max),
        };
        self.stability = most(|frame| frame.excess_mean).map(|worst| Stability {
            excess_mean: mean(&all(|frame| frame.excess_mean)),
            excess_p999: most(|frame| frame.excess_p999),
            worst_frame: Some(worst),
        });
    }
}

fn contrast(picture: &Picture) -> f64 {
    let greens = || picture.pixels.iter().map(|[_, green, ..]| f64::from(*green) / 255.0);
    let count = picture.pixels.len().max(1) as f64;
    let mean = greens().sum::<f64>() / count;
    (greens().map(|green| (green - mean) * (green - mean)).sum::<f64>() / count).sqrt()
}

/// None of none.
pub(super) fn mean(values: &[f64]) -> Figure {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}
