//! Pictures in memory.

mod layered;

pub use layered::{LayeredPixel, Layers};

use crate::color::{Premultiplied, Rgb};
use std::ops::{Add, Mul};

/// Clouds alone: linear, premultiplied, before exposure and haze-free sky; for measures and for compositing.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Top row first.
    pub pixels: Vec<Premultiplied>,
}

/// A finished scene in linear light, before exposure and tone curve.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearPicture {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Top row first.
    pub pixels: Vec<Rgb>,
}

/// A finished picture as a display shows it: sRGB, 8 bits a channel, opaque.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// RGBA with alpha 255, top row first.
    pub pixels: Vec<[u8; 4]>,
}

impl Layer {
    /// As [`LinearPicture::reduced`].
    pub fn reduced(&self, side: u32) -> Self {
        let ([width, height], pixels) = reduced([self.width, self.height], &self.pixels, side, Premultiplied::CLEAR);
        Self { width, height, pixels }
    }

    /// Itself, with a `share` (0 to 1) of `other`, which is of the same size.
    #[must_use]
    pub fn mix(mut self, other: Self, share: f32) -> Self {
        for (pixel, other) in self.pixels.iter_mut().zip(other.pixels) {
            *pixel = pixel.mix(other, share);
        }
        self
    }
}

impl LinearPicture {
    /// Itself, with a `share` (0 to 1) of `other`, which is of the same size.
    #[must_use]
    pub fn mix(mut self, other: Self, share: f32) -> Self {
        for (pixel, other) in self.pixels.iter_mut().zip(other.pixels) {
            *pixel = pixel.mix(other, share);
        }
        self
    }

    /// Each `side` × `side` pixels averaged into one, in linear light; a rest at the right and lower edge is left out.
    pub fn reduced(&self, side: u32) -> Self {
        let ([width, height], pixels) = reduced([self.width, self.height], &self.pixels, side, Rgb::BLACK);
        Self { width, height, pixels }
    }
}

/// The means of `side` × `side` pixels, and their size.
fn reduced<P: Copy + Add<Output = P> + Mul<f32, Output = P>>(
    size: [u32; 2],
    pixels: &[P],
    side: u32,
    zero: P,
) -> ([u32; 2], Vec<P>) {
    let side = side.max(1);
    let [width, height] = size.map(|length| length / side);
    let mean = |x: u32, y: u32| {
        let block = (0..side * side).map(|i| pixels[((y * side + i / side) * size[0] + x * side + i % side) as usize]);
        block.fold(zero, |sum, pixel| sum + pixel) * (1.0 / (side * side) as f32)
    };
    ([width, height], (0..width * height).map(|i| mean(i % width, i / width)).collect())
}

impl Picture {
    /// The pixels as bytes, for PNG files and textures.
    pub fn as_bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.pixels)
    }
}
