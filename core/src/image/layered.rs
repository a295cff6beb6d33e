//! A picture in layers, for compositing: what stands behind the clouds, and the clouds' own lights, apart.
//!
//! Clouds are premultiplied, what is behind them is not, so that either can be changed or replaced:
//!
//! ```text
//! picture = ambient + directional + haze + (1 − alpha) · (sky + ground + models)
//! ```
//!
//! Sky, ground and models are black where another of them is; clouds show as far as they lie before the models. Depth and motion are sums over the clouds, each weighted by how much of
//! it shows; divided by alpha they are means.

use super::{LinearPicture, reduced};
use crate::color::Rgb;
use std::ops::{Add, Mul};

/// A picture in layers, in linear light, before exposure.
#[derive(Debug, Clone, PartialEq)]
pub struct Layers {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Top row first.
    pub pixels: Vec<LayeredPixel>,
}

/// One pixel of all layers.
#[derive(Debug, Clone, Copy, PartialEq, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct LayeredPixel {
    /// The sky's light on the clouds, premultiplied, what haze leaves of it.
    pub ambient: Rgb,
    /// The sun's light on the clouds, premultiplied, what haze leaves of it.
    pub directional: Rgb,
    /// What haze before the clouds adds, premultiplied.
    pub haze: Rgb,
    /// How much the clouds hide of what is behind them.
    pub alpha: f32,
    /// Distance of the clouds from the eye, metres, times alpha.
    pub depth_sum: f32,
    /// Pixels that the clouds move until the next frame, to the right and up, times alpha.
    pub motion_sum: [f32; 2],
    /// Sky and sun without clouds.
    pub sky: Rgb,
    /// The ground without clouds, hazed.
    pub ground: Rgb,
    /// How much of the pixel the ground fills.
    pub ground_share: f32,
    /// Aircraft and props without clouds, hazed.
    pub models: Rgb,
    /// How much of the pixel they fill.
    pub models_share: f32,
}

/// Numbers in a pixel.
const CHANNELS: usize = size_of::<LayeredPixel>() / size_of::<f32>();

/// Of a mean of pixels through which less than this gets, it is not told which background does.
const HARDLY: f32 = 1e-4;

impl LayeredPixel {
    /// The picture, from its layers.
    pub fn composed(&self) -> Rgb {
        self.ambient + self.directional + self.haze + (self.sky + self.ground + self.models) * (1.0 - self.alpha)
    }

    /// Mean distance of the clouds from the eye, metres; 0 where there are none.
    pub fn depth_m(&self) -> f32 {
        self.depth_sum * self.inverse_alpha()
    }

    /// Mean motion of the clouds until the next frame, pixels to the right and up; 0 where there are none.
    pub fn motion_px(&self) -> [f32; 2] {
        self.motion_sum.map(|sum| sum * self.inverse_alpha())
    }

    fn inverse_alpha(&self) -> f32 {
        if self.alpha > 0.0 { 1.0 / self.alpha } else { 0.0 }
    }

    fn with_background_times(mut self, share: f32) -> Self {
        (self.sky, self.ground, self.models) = (self.sky * share, self.ground * share, self.models * share);
        (self.ground_share, self.models_share) = (self.ground_share * share, self.models_share * share);
        self
    }
}

impl Add for LayeredPixel {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let [a, b]: [[f32; CHANNELS]; 2] = [self, other].map(bytemuck::cast);
        bytemuck::cast::<[f32; CHANNELS], _>(std::array::from_fn(|c| a[c] + b[c]))
    }
}

impl Mul<f32> for LayeredPixel {
    type Output = Self;
    fn mul(self, k: f32) -> Self {
        bytemuck::cast(bytemuck::cast::<_, [f32; CHANNELS]>(self).map(|channel| channel * k))
    }
}

impl Layers {
    /// The picture, from its layers.
    pub fn composed(&self) -> LinearPicture {
        let pixels = self.pixels.iter().map(LayeredPixel::composed).collect();
        LinearPicture { width: self.width, height: self.height, pixels }
    }

    /// Itself, with a `share` (0 to 1) of `other`, which is of the same size and has the same background.
    #[must_use]
    pub fn mix(mut self, other: Self, share: f32) -> Self {
        for (pixel, other) in self.pixels.iter_mut().zip(other.pixels) {
            *pixel = *pixel * (1.0 - share) + other * share;
        }
        self
    }

    /// Each `side` × `side` pixels averaged into one; a rest at the right and lower edge is left out. Of what is behind
    /// the clouds that counts which shows: the mean is that of the picture, and motion is in the pixels that come of it.
    pub fn reduced(&self, side: u32) -> Self {
        let size = [self.width, self.height];
        let seen: Vec<_> = self.pixels.iter().map(|p| p.with_background_times(1.0 - p.alpha)).collect();
        let ([width, height], seen) = reduced(size, &seen, side, LayeredPixel::default());
        let (_, all) = reduced(size, &self.pixels, side, LayeredPixel::default());
        let mean = |(seen, all): (LayeredPixel, LayeredPixel)| {
            let through = 1.0 - seen.alpha;
            let mut mean = if through > HARDLY { seen.with_background_times(1.0 / through) } else { all };
            mean.motion_sum = mean.motion_sum.map(|sum| sum / side.max(1) as f32);
            mean
        };
        Self { width, height, pixels: seen.into_iter().zip(all).map(mean).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mean_of_layers_is_the_layers_of_the_mean() {
        // The upper half of a pixel is bright sky, half hidden; the lower is dark ground, all but hidden.
        let sky = LayeredPixel { sky: Rgb::grey(8.0), alpha: 0.5, ambient: Rgb::grey(0.3), ..LayeredPixel::default() };
        let ground = LayeredPixel {
            ground: Rgb::grey(0.1),
            ground_share: 1.0,
            alpha: 0.9,
            directional: Rgb::grey(0.4),
            depth_sum: 0.9 * 500.0,
            motion_sum: [0.9 * 4.0, 0.0],
            ..LayeredPixel::default()
        };
        let layers = Layers { width: 2, height: 2, pixels: vec![sky, sky, ground, ground] };
        let one = layers.reduced(2);
        let (got, wanted) = (one.pixels[0].composed(), layers.composed().reduced(2).pixels[0]);
        assert!((got.r - wanted.r).abs() < 1e-5, "{got:?}, not {wanted:?}");
        // Through the sky's half comes five times as much.
        assert!((one.pixels[0].ground_share - 0.1 / 0.6).abs() < 1e-5);
        let hidden = LayeredPixel { alpha: 1.0, ..ground };
        let hidden = Layers { width: 2, height: 2, pixels: vec![hidden; 4] }.reduced(2);
        assert_eq!(hidden.pixels[0].ground_share, 1.0, "no division by what does not get through");
        assert_eq!(hidden.pixels[0].motion_px(), [0.9 * 4.0 / 2.0, 0.0], "two pixels are one now");
        assert_eq!(LayeredPixel::default().depth_m(), 0.0);
    }
}
