//! The sheet of tiles as glTF has it: sRGB, straight alpha; and the material that shows it.

use super::container::Buffer;
use crate::color::srgb_from_linear;
use crate::sprites::{Atlas, TILE_SIZE, TILES};
use serde_json::{Value, json};

const SIDE: usize = 4 * TILE_SIZE;

/// Adds texture 0 and material 0.
pub(super) fn write(root: &mut Value, buffer: &mut Buffer, atlas: &Atlas) {
    let view = buffer.file(&png(atlas));
    root["images"] = json!([{ "name": "sprite tiles", "mimeType": "image/png", "bufferView": view }]);
    // Linear, its mip levels too; clamped at the edges.
    root["samplers"] = json!([{ "magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071 }]);
    root["textures"] = json!([{ "source": 0, "sampler": 0 }]);
    root["materials"] = json!([material("sprites", 1.0)]);
}

/// What sprites are made of; their alpha is multiplied with `alpha`.
pub(super) fn material(name: &str, alpha: f64) -> Value {
    json!({
        "name": name,
        "pbrMetallicRoughness": {
            "baseColorTexture": { "index": 0 },
            "baseColorFactor": [1.0, 1.0, 1.0, alpha],
            "metallicFactor": 0.0,
            "roughnessFactor": 1.0,
        },
        "alphaMode": "BLEND",
        "doubleSided": true,
        "extensions": { "KHR_materials_unlit": {} },
    })
}

/// Left, top, right and bottom of a tile, shares of the sheet.
pub(super) fn tile_rectangle(tile: u8) -> [f32; 4] {
    let [column, row] = [tile % 4, tile / 4].map(|place| f32::from(place) * 0.25);
    [column, row, column + 0.25, row + 0.25]
}

fn png(atlas: &Atlas) -> Vec<u8> {
    let mut texels = vec![[0_u8; 4]; SIDE * SIDE];
    for tile in 0..TILES {
        let level = atlas.level(tile, 0);
        let mean = mean(&level.texels);
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
