//! The sheet of tiles, and the material that shows it.

use super::container::Buffer;
use crate::exchange::sheet;
use crate::sprites::Atlas;
use serde_json::{Value, json};

/// Adds texture 0 and material 0.
pub(super) fn write(root: &mut Value, buffer: &mut Buffer, atlas: &Atlas) {
    let view = buffer.file(&sheet::png(atlas));
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
