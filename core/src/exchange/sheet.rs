//! The sheet of tiles as other tools have it: sRGB, straight alpha. Clear texels have the mean colour of their tile, so that
//! no rim darkens where it is filtered.

use crate::color::srgb_from_linear;
use crate::sprites::{Atlas, TILE_SIZE, TILES};

const SIDE: usize = 4 * TILE_SIZE;

/// The sheet as a PNG.
pub(super) fn png(atlas: &Atlas) -> Vec<u8> {
    let mut texels = vec![[0_u8; 4]; SIDE * SIDE];
    for (tile, mean) in means(atlas).into_iter().enumerate() {
        let level = atlas.level(tile, 0);
        for (i, texel) in level.texels.iter().enumerate() {
            let (x, y) = (tile % 4 * TILE_SIZE + i % TILE_SIZE, tile / 4 * TILE_SIZE + i / TILE_SIZE);
            texels[y * SIDE + x] = straight(*texel, mean);
        }
    }
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, SIDE as u32, SIDE as u32);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    // A vector takes every write.
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(texels.as_flattened()));
    debug_assert!(written.is_ok());
    bytes
}

/// What each tile leaves of light in the mean, linear.
pub(super) fn means(atlas: &Atlas) -> [[f32; 3]; TILES] {
    std::array::from_fn(|tile| mean(&atlas.level(tile, 0).texels))
}

/// The colour that light has through a whole tile, linear.
fn mean(texels: &[[u8; 4]]) -> [f32; 3] {
    let sum = texels.iter().fold([0.0_f32; 4], |sum, texel| std::array::from_fn(|i| sum[i] + f32::from(texel[i])));
    [0, 1, 2].map(|i| if sum[3] > 0.0 { sum[i] / sum[3] } else { 1.0 })
}

/// A premultiplied texel of linear light as sRGB with straight alpha.
fn straight(texel: [u8; 4], mean: [f32; 3]) -> [u8; 4] {
    let alpha = f32::from(texel[3]);
    let channel = |i: usize| {
        let linear = if texel[3] == 0 { mean[i] } else { (f32::from(texel[i]) / alpha).min(1.0) };
        (srgb_from_linear(linear) * 255.0).round() as u8
    };
    [channel(0), channel(1), channel(2), texel[3]]
}
