//! Blending into eight bits a channel, as screens had when the article was written: each sprite that covers a pixel
//! rounds it again, and thin layers add up to bands, or to nothing.

use crate::color::{Premultiplied, Rgb, linear_from_srgb};
use crate::frame::Frame;
use crate::image::LinearPicture;
use crate::raster::bins::{assemble, map_tiles};
use crate::raster::models::{Models, before};
use crate::raster::prepare;

/// The frame over its background in linear light, every blend stored as 8-bit sRGB; white is the most that it holds.
pub fn linear_picture(frame: &Frame<'_>) -> LinearPicture {
    let (width, height) = (frame.view.width, frame.view.height);
    let bytes = Bytes::new();
    let behind_all = frame.behind();
    let background = |x: u32, y: u32| {
        let ray = frame.view.ray(x as f32 + 0.5, y as f32 + 0.5);
        behind_all.color(ray, frame.view.pixel())
    };
    let (sprites, models) = (prepare(frame), Models::new(frame));
    let tiles = map_tiles(&sprites, width, height, |rect, members| {
        let models = models.as_ref().and_then(|models| models.tile(rect, 1));
        let pixel = |i: u32| {
            let (column, row) = (i % rect.width, i / rect.width);
            let (x, y) = (rect.left + column, rect.top + row);
            let model = models.as_ref().and_then(|models| models.at(column as usize, row as usize));
            let shown = members.iter().rev().filter_map(|&member| {
                let sprite = &sprites[member as usize];
                let (fragment, depth) = sprite.fragment(frame.atlas, x as f32 + 0.5, y as f32 + 0.5, |_| sprite.mip)?;
                let among = |(near, _)| before(fragment, near, depth, sprite.half_depth_m);
                Some(model.map_or(fragment, among))
            });
            let over = |behind, fragment| bytes.blended(fragment, behind, frame.now.exposure);
            let behind = model.map_or_else(|| background(x, y), |(_, color)| color) * frame.now.exposure;
            shown.chain([frame.veil]).fold(bytes.stored(behind), over) * (1.0 / frame.now.exposure)
        };
        (0..rect.width * rect.height).map(pixel).collect()
    });
    LinearPicture { width, height, pixels: assemble(&tiles, width, height, Rgb::BLACK) }
}

/// What eight bits hold: the linear light of each byte of sRGB, and where rounding goes on to the next byte.
struct Bytes {
    linear: [f32; 256],
    steps: [f32; 255],
}

impl Bytes {
    fn new() -> Self {
        Self {
            linear: std::array::from_fn(|byte| linear_from_srgb(byte as f32 / 255.0)),
            steps: std::array::from_fn(|byte| linear_from_srgb((byte as f32 + 0.5) / 255.0)),
        }
    }

    fn stored(&self, color: Rgb) -> Rgb {
        let store = |linear: f32| self.linear[self.steps.partition_point(|step| *step <= linear)];
        Rgb::new(store(color.r), store(color.g), store(color.b))
    }

    fn blended(&self, fragment: Premultiplied, behind: Rgb, exposure: f32) -> Rgb {
        let Premultiplied { r, g, b, a } = fragment;
        self.stored(Rgb::new(r, g, b) * exposure + behind * (1.0 - a))
    }
}
