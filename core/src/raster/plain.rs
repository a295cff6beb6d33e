//! The plain renderer: one sprite after the other, one fragment after the other. Slow and easy to trust.

use super::{develop, faded, prepare};
use crate::color::Premultiplied;
use crate::frame::Frame;
use crate::image::{Layer, LinearPicture, Picture};

/// The frame's clouds alone, sprites in the list's order, one sample at each pixel's centre.
pub fn clouds(frame: &Frame<'_>) -> Layer {
    faded(frame, in_order, Layer::mix)
}

fn in_order(frame: &Frame<'_>) -> Layer {
    let (width, height) = (frame.view.width, frame.view.height);
    let mut pixels = vec![frame.veil; width as usize * height as usize];
    for sprite in prepare(frame).iter().rev() {
        let [left, top, right, bottom] = sprite.bounds;
        for y in top as u32..(bottom.ceil() as u32).min(height) {
            for x in left as u32..(right.ceil() as u32).min(width) {
                if let Some((fragment, _)) =
                    sprite.fragment(frame.atlas, x as f32 + 0.5, y as f32 + 0.5, |_| sprite.mip)
                {
                    put_behind(&mut pixels[(y * width + x) as usize], fragment);
                }
            }
        }
    }
    Layer { width, height, pixels }
}

/// Adds `fragment` behind what `pixel` shows already: `over`, front to back.
pub fn put_behind(pixel: &mut Premultiplied, fragment: Premultiplied) {
    let through = 1.0 - pixel.a;
    pixel.r += through * fragment.r;
    pixel.g += through * fragment.g;
    pixel.b += through * fragment.b;
    pixel.a += through * fragment.a;
}

/// The frame in linear light: clouds over sky and ground.
pub fn linear_picture(frame: &Frame<'_>) -> LinearPicture {
    let Layer { width, height, pixels } = clouds(frame);
    let footprint = frame.view.pixel();
    let pixels = pixels.into_iter().zip(0_u32..).map(|(cloud, i)| {
        let ray = frame.view.ray((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
        cloud.over(frame.background.color(ray, footprint))
    });
    LinearPicture { width, height, pixels: pixels.collect() }
}

/// The frame as a display shows it.
pub fn picture(frame: &Frame<'_>) -> Picture {
    develop(&linear_picture(frame), frame.now.exposure)
}
