//! How far a GPU's clouds may be from the plain renderer's, pixel by pixel, from how a GPU rounds.
//!
//! Both blend the same fragments; the GPU's differ in two ways. (1) The target has 16-bit floats: each blend rounds what
//! it stores by up to 2⁻¹⁰ of it (software rasterizers truncate; hardware rounds to nearest, half of that). (2) Texture
//! units filter with weights of 8 bits, some with sums of 8 bits too: each of a texel's four interpolations on the way
//! (two along, one across, one between levels) may be off by 1/255 in each channel.
//! An error made by one sprite is covered by the next like the colour it sits on, so the allowance of a pixel is blended
//! along with the picture: e ← (1 − α) e + the fragment's error + the blend's.

use cloudwright_core::frame::Frame;
use cloudwright_core::image::Layer;
use cloudwright_core::raster::{plain, prepare};

/// Greatest error of a filtered texel.
const TEXEL: f32 = 4.0 / 255.0;
/// Greatest relative error of a stored 16-bit float, and the step of the smallest ones.
const STORE: f32 = 1.0 / 1024.0;
const STORE_LEAST: f32 = 1.0 / 16_777_216.0;

/// The plain renderer's clouds, and how far another's may be from them.
pub struct Allowance {
    /// What is wanted.
    pub clouds: Layer,
    /// Red, green, blue, alpha of each pixel.
    pub errors: Vec<[f32; 4]>,
}

impl Allowance {
    /// For the clouds of `frame`.
    pub fn new(frame: &Frame<'_>) -> Self {
        let (width, height) = (frame.view.width, frame.view.height);
        let mut shown = vec![[0.0_f32; 4]; (width * height) as usize];
        let mut errors = shown.clone();
        for sprite in prepare(frame) {
            let [left, top, right, bottom] = sprite.bounds;
            for y in top as u32..(bottom.ceil() as u32).min(height) {
                for x in left as u32..(right.ceil() as u32).min(width) {
                    let at = (x as f32 + 0.5, y as f32 + 0.5);
                    let Some((fragment, _)) = sprite.fragment(frame.atlas, at.0, at.1, |_| sprite.mip) else {
                        continue;
                    };
                    let brightest = |c: usize| sprite.corners.iter().map(|corner| corner[c]).fold(0.0, f32::max);
                    let fragment = [fragment.r, fragment.g, fragment.b, fragment.a];
                    let texel_alpha = TEXEL * brightest(3);
                    let i = (y * width + x) as usize;
                    for c in 0..4 {
                        let before = shown[i][c];
                        let light = if c < 3 { brightest(c) + sprite.haze[c] } else { 1.0 };
                        let after = fragment[c] + (1.0 - fragment[3]) * before;
                        shown[i][c] = after;
                        errors[i][c] = (1.0 - fragment[3]) * errors[i][c]
                            + texel_alpha * (light + before)
                            + STORE * after
                            + STORE_LEAST;
                    }
                }
            }
        }
        // The veil covers what is wrong behind it, and is stored once more.
        let veil = [frame.veil.r, frame.veil.g, frame.veil.b, frame.veil.a];
        if frame.veil.a > 0.0 {
            for (errors, shown) in errors.iter_mut().zip(&shown) {
                for c in 0..4 {
                    let after = veil[c] + (1.0 - veil[3]) * shown[c];
                    errors[c] = (1.0 - veil[3]) * errors[c] + STORE * after + STORE_LEAST;
                }
            }
        }
        Self { clouds: plain::clouds(frame), errors }
    }

    /// The worst pixel of `got`: the largest share of its allowance that a channel takes (up to 1 is fine), the largest
    /// difference, and where the share is largest.
    pub fn worst(&self, got: &Layer) -> Worst {
        let mut worst = Worst::default();
        for (i, (want, got)) in self.clouds.pixels.iter().zip(&got.pixels).enumerate() {
            let differences = [want.r - got.r, want.g - got.g, want.b - got.b, want.a - got.a];
            for (difference, allowed) in differences.into_iter().zip(self.errors[i]) {
                let share = if difference == 0.0 { 0.0 } else { difference.abs() / allowed };
                worst.difference = worst.difference.max(difference.abs());
                worst.mean += difference.abs() / (4 * self.errors.len()) as f32;
                // A NaN counts as the worst.
                if share > worst.share || share.is_nan() {
                    (worst.share, worst.pixel) = (share, [i as u32 % self.clouds.width, i as u32 / self.clouds.width]);
                }
            }
        }
        worst
    }
}

/// How far a layer is off.
#[derive(Debug, Clone, Copy, Default)]
pub struct Worst {
    /// Of the allowance; up to 1 is fine.
    pub share: f32,
    /// Largest in any channel, linear.
    pub difference: f32,
    /// Mean over all channels, linear.
    pub mean: f32,
    /// Where the share is largest.
    pub pixel: [u32; 2],
}
