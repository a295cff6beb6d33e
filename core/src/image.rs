//! Pictures in memory.

use crate::color::{Premultiplied, Rgb};

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
        let side = side.max(1);
        let (width, height) = (self.width / side, self.height / side);
        let mean = |x: u32, y: u32| {
            let block = (0..side * side)
                .map(|i| self.pixels[((y * side + i / side) * self.width + x * side + i % side) as usize]);
            block.fold(Rgb::BLACK, |sum, color| sum + color) * (1.0 / (side * side) as f32)
        };
        Self { width, height, pixels: (0..width * height).map(|i| mean(i % width, i / width)).collect() }
    }
}

impl Picture {
    /// The pixels as bytes, for PNG files and textures.
    pub fn as_bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.pixels)
    }
}
