//! A frame by a method: what is shown, and what errors are measured on.

use super::{Renderer, Settings, keep};
use crate::derived::Derived;
use crate::frame::{Frame, Sight};
use crate::image::{Layer, LinearPicture, Picture};
use crate::measure::Counts;
use crate::raster::{develop, fast, plain, truth};
use crate::scene::Scene;
use crate::sprites::Atlas;
use crate::variants::eight_bits;
use crate::watch::Watch;
use std::borrow::Cow;

/// What a method makes of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// In linear light, before exposure.
    pub linear: LinearPicture,
    /// The clouds alone; none where a method has no opacity of its own.
    pub clouds: Option<Layer>,
}

impl Settings {
    /// The clouds with the sprites that are drawn.
    pub fn clouds<'a>(&self, derived: &'a Derived, atlas: &Atlas) -> Cow<'a, Derived> {
        if self.kept < 1.0 { Cow::Owned(keep(derived, atlas, self.kept)) } else { Cow::Borrowed(derived) }
    }

    /// The frame to draw for a picture of `sight`'s size, whose history is one of [`Settings::history`]; `derived` is
    /// from [`Settings::clouds`].
    pub fn frame<'a>(&self, scene: &Scene, derived: &'a Derived, atlas: &'a Atlas, sight: &Sight<'_>) -> Frame<'a> {
        let size = sight.size.map(|length| length * self.pixels_a_pixel());
        Frame { filter: self.filter, ..Frame::of(scene, derived, atlas, &Sight { size, ..*sight }) }
    }

    /// How many of the frame's pixels lie side by side in one of the picture's.
    pub fn pixels_a_pixel(&self) -> u32 {
        // The truth takes its samples itself.
        if self.renderer == Renderer::Truth { 1 } else { self.samples_side.max(1) }
    }

    /// Draws a [`Settings::frame`]; none on a GPU. The truth looks at `watch` as in [`Settings::picture`].
    pub fn draw(&self, frame: &Frame<'_>, watch: &Watch) -> Option<Drawn> {
        let (linear, clouds) = match self.renderer {
            Renderer::Truth => {
                let (linear, clouds) = truth::picture_and_clouds(frame, self.samples_side, watch);
                (linear, Some(clouds))
            }
            Renderer::Fast { stop_below } => {
                (fast::linear_picture_stopping(frame, stop_below), Some(fast::clouds(frame, stop_below)))
            }
            Renderer::Plain => (plain::linear_picture(frame), Some(plain::clouds(frame))),
            Renderer::EightBits => (eight_bits::linear_picture(frame), None),
            Renderer::Gpu => return None,
        };
        let drawn = Drawn { linear, clouds };
        Some(drawn.reduced(self.pixels_a_pixel()))
    }

    /// Draws a [`Settings::frame`] as a display shows it, with no more work than that takes; none on a GPU. The truth,
    /// which may take long, tells `watch` how far it is, and leaves the rest black once that is cancelled.
    pub fn picture(&self, frame: &Frame<'_>, watch: &Watch) -> Option<Picture> {
        let side = self.pixels_a_pixel();
        let linear = match self.renderer {
            Renderer::Fast { stop_below } if side == 1 => return Some(fast::picture_stopping(frame, stop_below)),
            Renderer::Fast { stop_below } => fast::linear_picture_stopping(frame, stop_below),
            Renderer::Truth => truth::linear_picture(frame, self.samples_side, watch),
            Renderer::Plain => plain::linear_picture(frame),
            Renderer::EightBits => eight_bits::linear_picture(frame),
            Renderer::Gpu => return None,
        };
        let linear = if side > 1 { linear.reduced(side) } else { linear };
        Some(develop(&linear, frame.exposure))
    }

    /// Counts what drawing a [`Settings::frame`] takes. The truth blends and sorts the fragments of each sample.
    pub fn counts(&self, frame: &Frame<'_>) -> Counts {
        let counts = Counts::of(frame);
        if self.renderer != Renderer::Truth {
            return counts;
        }
        let samples = self.samples_side * self.samples_side;
        let fragments = counts.fragments * u64::from(samples);
        Counts {
            fragments,
            keys_sorted: fragments,
            overdraw_mean: counts.overdraw_mean * f64::from(samples),
            overdraw_p99: counts.overdraw_p99 * samples as f32,
            ..counts
        }
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
