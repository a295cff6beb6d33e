//! The plain renderer: one sprite after the other, one fragment after the other. Slow and easy to trust.

use super::models;
use super::{develop, faded, prepare};
use crate::color::{Premultiplied, Rgb};
use crate::frame::Frame;
use crate::image::{Layer, LinearPicture, Picture};

/// The frame's clouds alone, sprites in the list's order, one sample at each pixel's centre.
pub fn clouds(frame: &Frame<'_>) -> Layer {
    faded(frame, |frame| in_order(frame, &[]), Layer::mix)
}

/// As far as they lie before the models, if there are `models` at the pixels.
fn in_order(frame: &Frame<'_>, models: &[Option<(f32, Rgb)>]) -> Layer {
    let (width, height) = (frame.view.width, frame.view.height);
    let mut pixels = vec![frame.veil; width as usize * height as usize];
    for sprite in prepare(frame).iter().rev() {
        let [left, top, right, bottom] = sprite.bounds;
        for y in top as u32..(bottom.ceil() as u32).min(height) {
            for x in left as u32..(right.ceil() as u32).min(width) {
                let shown = sprite.fragment(frame.atlas, x as f32 + 0.5, y as f32 + 0.5, |_| sprite.mip);
                let Some((mut fragment, depth)) = shown else { continue };
                let at = (y * width + x) as usize;
                if let Some(Some((nearness, _))) = models.get(at) {
                    fragment = models::before(fragment, *nearness, depth, sprite.half_depth_m);
                }
                put_behind(&mut pixels[at], fragment);
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

/// The frame in linear light: clouds over sky, ground and models.
pub fn linear_picture(frame: &Frame<'_>) -> LinearPicture {
    let center = |i: u32| [(i % frame.view.width) as f32 + 0.5, (i / frame.view.width) as f32 + 0.5];
    let placed = models::plain::PlacedModels::new(frame);
    let models: Vec<_> =
        (0..frame.view.width * frame.view.height).map(|i| placed.nearest(center(i)[0], center(i)[1])).collect();
    let Layer { width, height, pixels } = faded(frame, |frame| in_order(frame, &models), Layer::mix);
    let (background, footprint) = (frame.behind(), frame.view.pixel());
    let pixels = pixels.into_iter().zip(models).zip(0_u32..).map(|((cloud, model), i)| {
        let [x, y] = center(i);
        let behind = model.map(|(_, color)| color);
        cloud.over(behind.unwrap_or_else(|| background.color(frame.view.ray(x, y), footprint)))
    });
    LinearPicture { width, height, pixels: pixels.collect() }
}

/// The frame as a display shows it.
pub fn picture(frame: &Frame<'_>) -> Picture {
    develop(&linear_picture(frame), frame.now.exposure)
}
