//! A frame by its rules: what is shown, and what errors are measured on.
//!
//! This is the one place that decides what draws. A GPU is not here: whoever has one draws the frames that ask for it.

use crate::frame::Frame;
use crate::image::{Layer, Layers, LinearPicture, Picture};
use crate::measure::Counts;
use crate::raster::layers::{self, Later};
use crate::raster::{develop, fast, plain, truth};
use crate::rules::Rasterizer;
use crate::variants::eight_bits;
use crate::watch::Watch;

/// A frame for figures.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// In linear light, before exposure.
    pub linear: LinearPicture,
    /// The clouds alone; none where a method has no opacity of its own.
    pub clouds: Option<Layer>,
}

/// Draws `frame` for figures; none on a GPU. The truth looks at `watch` as in [`picture`].
pub fn drawn(frame: &Frame<'_>, watch: &Watch) -> Option<Drawn> {
    let (linear, clouds) = match frame.rules.rasterizer {
        Rasterizer::Truth => {
            let (linear, clouds) = truth::picture_and_clouds(frame, frame.rules.samples_side, watch);
            (linear, Some(clouds))
        }
        Rasterizer::Fast(blending) => (fast::linear_picture_by(frame, blending), Some(fast::clouds(frame, blending))),
        Rasterizer::Plain => (plain::linear_picture(frame), Some(plain::clouds(frame))),
        Rasterizer::EightBits => (eight_bits::linear_picture(frame), None),
        Rasterizer::Gpu => return None,
    };
    let drawn = Drawn { linear, clouds };
    Some(drawn.reduced(frame.rules.pixels_a_pixel()))
}

/// Draws `frame` as a display shows it, with no more work than that takes; none on a GPU. The truth, which may take
/// long, tells `watch` how far it is, and leaves the rest black once that is cancelled.
pub fn picture(frame: &Frame<'_>, watch: &Watch) -> Option<Picture> {
    match frame.rules.rasterizer {
        Rasterizer::Fast(blending) if frame.rules.pixels_a_pixel() == 1 => Some(fast::picture_by(frame, blending)),
        _ => Some(develop(&linear(frame, watch)?, frame.now.exposure)),
    }
}

/// As [`picture`], in linear light, before exposure.
pub fn linear(frame: &Frame<'_>, watch: &Watch) -> Option<LinearPicture> {
    let side = frame.rules.pixels_a_pixel();
    let linear = match frame.rules.rasterizer {
        Rasterizer::Fast(blending) => fast::linear_picture_by(frame, blending),
        Rasterizer::Truth => truth::linear_picture(frame, frame.rules.samples_side, watch),
        Rasterizer::Plain => plain::linear_picture(frame),
        Rasterizer::EightBits => eight_bits::linear_picture(frame),
        Rasterizer::Gpu => return None,
    };
    Some(if side > 1 { linear.reduced(side) } else { linear })
}

/// `frame` in layers, with the motion until `later`, which was made by the same rules; none unless the fast renderer
/// draws it.
pub fn layers(frame: &Frame<'_>, later: &Later<'_>) -> Option<Layers> {
    let Rasterizer::Fast(blending) = frame.rules.rasterizer else { return None };
    let (layers, side) = (layers::layers(frame, later, blending), frame.rules.pixels_a_pixel());
    Some(if side > 1 { layers.reduced(side) } else { layers })
}

/// Counts what drawing `frame` takes. The truth blends and sorts the fragments of each sample.
pub fn counts(frame: &Frame<'_>) -> Counts {
    let counts = Counts::of(frame);
    if frame.rules.rasterizer != Rasterizer::Truth {
        return counts;
    }
    let side = frame.rules.samples_side;
    let samples = side * side;
    let fragments = counts.fragments * u64::from(samples);
    Counts {
        fragments,
        keys_sorted: fragments,
        overdraw_mean: counts.overdraw_mean * f64::from(samples),
        overdraw_p99: counts.overdraw_p99 * samples as f32,
        ..counts
    }
}

impl Drawn {
    /// As [`LinearPicture::reduced`].
    #[must_use]
    pub fn reduced(self, side: u32) -> Self {
        if side <= 1 {
            return self;
        }
        Self { linear: self.linear.reduced(side), clouds: self.clouds.map(|clouds| clouds.reduced(side)) }
    }
}
