//! Pixels on the CPU: the renderer that needs no GPU, driver or display.
//!
//! [`fast`] draws in sorted order, in tiles on all cores, front to back, and stops where nothing more shows through.
//! [`plain`] draws the same one fragment at a time and is its oracle. [`truth`] orders every ray's own fragments and
//! is what error figures are measured against. All three share sprites on the screen ([`prepare()`]) and one definition
//! of a fragment ([`ScreenSprite::fragment`]). What [`models`] there are stands behind and among the sprites.

pub(crate) mod bins;
pub mod fast;
pub mod layers;
pub mod models;
pub mod plain;
mod prepare;
pub mod truth;

pub(crate) use prepare::FINER;
pub use prepare::{Glow, Hit, Linear, ScreenSprite, prepare, prepare_alone, trilinear};

use crate::frame::Frame;
use crate::image::{LinearPicture, Picture};
use crate::tone::encode;
use rayon::prelude::*;

/// `draw`n in the frame's order; and while another one fades out, mixed with that.
fn faded<T>(frame: &Frame<'_>, draw: impl Fn(&Frame<'_>) -> T, mix: impl Fn(T, T, f32) -> T) -> T {
    let drawn = draw(frame);
    match frame.older() {
        Some((older, share)) => mix(drawn, draw(&older), share),
        None => drawn,
    }
}

/// Exposure, tone curve, sRGB and dither for a whole picture.
pub fn develop(linear: &LinearPicture, exposure: f32) -> Picture {
    let LinearPicture { width, height, ref pixels } = *linear;
    let encode_pixel = |(i, color): (usize, &crate::color::Rgb)| {
        let i = i as u32;
        encode(*color * exposure, i % width, i / width)
    };
    Picture { width, height, pixels: pixels.par_iter().enumerate().map(encode_pixel).collect() }
}
