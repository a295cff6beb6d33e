//! What one sprite shows at eight pixels side by side.

use super::super::bins::TILE;

/// Pixels that are drawn at once.
pub const LANES: usize = 8;

/// A channel of a tile.
pub type Plane = [[f32; LANES]; TILE * TILE / LANES];

/// Values of eight pixels.
pub type Lanes = [f32; LANES];

/// Fragments of one sprite at eight pixels, of alpha 0 where it has none.
#[derive(Debug, Clone, Copy)]
pub struct Fragments<const G: usize> {
    /// One over the view depth of the sprite's plane, 1/m, where it shows or not.
    pub nearness: Lanes,
    /// Opacity.
    pub alpha: Lanes,
    /// Red, green and blue in each light, premultiplied.
    pub lights: [[Lanes; 3]; G],
}

impl<const G: usize> Fragments<G> {
    /// Clear.
    pub const NONE: Self = Self { nearness: [0.0; LANES], alpha: [0.0; LANES], lights: [[[0.0; LANES]; 3]; G] };

    /// Puts one at a lane.
    pub fn set(&mut self, lane: usize, alpha: f32, lights: &[[f32; 3]; G]) {
        self.alpha[lane] = alpha;
        for (channel, value) in self.lights.as_flattened_mut().iter_mut().zip(lights.as_flattened()) {
            channel[lane] = *value;
        }
    }

    /// Adds them, at a group of pixels, to `lights`, behind what lets `through` as much, and takes what they hide from that.
    #[inline(always)]
    pub fn blend(&self, lights: &mut [[Plane; 3]; G], group: usize, through: &mut Lanes) {
        for (planes, color) in lights.as_flattened_mut().iter_mut().zip(self.lights.as_flattened()) {
            for lane in 0..LANES {
                planes[group][lane] += through[lane] * color[lane];
            }
        }
        self.take(through);
    }

    /// Takes what they hide.
    #[inline(always)]
    pub fn take(&self, through: &mut Lanes) {
        for (through, alpha) in through.iter_mut().zip(&self.alpha) {
            *through -= *through * alpha;
        }
    }

    /// Changes places with `other` where `swap` says so.
    #[inline(always)]
    pub fn swap(&mut self, other: &mut Self, swap: [bool; LANES]) {
        let lanes = |a: &mut Lanes, b: &mut Lanes| {
            for lane in 0..LANES {
                (a[lane], b[lane]) = if swap[lane] { (b[lane], a[lane]) } else { (a[lane], b[lane]) };
            }
        };
        lanes(&mut self.nearness, &mut other.nearness);
        lanes(&mut self.alpha, &mut other.alpha);
        for (a, b) in self.lights.as_flattened_mut().iter_mut().zip(other.lights.as_flattened_mut()) {
            lanes(a, b);
        }
    }
}
