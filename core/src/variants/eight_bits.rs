//! Blending into eight bits a channel, as screens had when the article was written: each sprite that covers a pixel
//! rounds it again, and thin layers add up to bands, or to nothing.

use crate::color::{Premultiplied, Rgb, linear_from_srgb, srgb_from_linear};
use crate::frame::Frame;
use crate::image::LinearPicture;
use crate::raster::prepare;

/// The frame over its background in linear light, every blend stored as 8-bit sRGB; white is the most that it holds.
pub fn linear_picture(frame: &Frame<'_>) -> LinearPicture {
    let (width, height) = (frame.view.width, frame.view.height);
    let background = |i: u32| {
        let ray = frame.view.ray((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
        stored(frame.background.color(ray, frame.view.pixel()) * frame.exposure)
    };
    let mut pixels: Vec<Rgb> = (0..width * height).map(background).collect();
    for sprite in prepare(frame) {
        let [left, top, right, bottom] = sprite.bounds;
        for y in top as u32..(bottom.ceil() as u32).min(height) {
            for x in left as u32..(right.ceil() as u32).min(width) {
                let at = (x as f32 + 0.5, y as f32 + 0.5);
                if let Some((fragment, _)) = sprite.fragment(frame.atlas, at.0, at.1, |_| sprite.mip) {
                    let pixel = &mut pixels[(y * width + x) as usize];
                    *pixel = blended(fragment, *pixel, frame.exposure);
                }
            }
        }
    }
    for pixel in &mut pixels {
        *pixel = blended(frame.veil, *pixel, frame.exposure) * (1.0 / frame.exposure);
    }
    LinearPicture { width, height, pixels }
}

fn blended(fragment: Premultiplied, behind: Rgb, exposure: f32) -> Rgb {
    stored(Rgb::new(fragment.r, fragment.g, fragment.b) * exposure + behind * (1.0 - fragment.a))
}

fn stored(color: Rgb) -> Rgb {
    let store =
        |linear: f32| linear_from_srgb((srgb_from_linear(linear.clamp(0.0, 1.0)) * 255.0 + 0.5).floor() / 255.0);
    Rgb::new(store(color.r), store(color.g), store(color.b))
}
