//! A painted solid as a glTF 2.0 binary file (Khronos 2021, chapter 4): a head, a JSON chunk, a binary chunk.
//!
//! A primitive for each paint; positions and normals interleaved in one view, 16-bit indices in another.

use super::solid::{Paint, Solid, Vertex};
use serde_json::{Value, json};
use std::collections::HashMap;

const FLOATS: u32 = 5126;
const SHORTS: u32 = 5123;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;
/// Position and normal, bytes.
const STRIDE: usize = 24;

/// The file's bytes.
pub fn write(solid: &Solid) -> Vec<u8> {
    let (mut vertices, mut indices) = (Vec::new(), Vec::new());
    let (mut accessors, mut primitives, mut materials) = (Vec::new(), Vec::new(), Vec::new());
    for paint in Paint::ALL {
        let of_paint = solid.triangles.iter().filter(|(its, _)| *its == paint).flat_map(|(_, corners)| corners);
        let (own, order) = shared(of_paint);
        if own.is_empty() {
            continue;
        }
        let (name, [r, g, b], roughness) = paint.material();
        primitives.push(json!({
            "attributes": { "POSITION": accessors.len(), "NORMAL": accessors.len() + 1 },
            "indices": accessors.len() + 2,
            "material": materials.len(),
        }));
        materials.push(json!({
            "name": name,
            "pbrMetallicRoughness": { "baseColorFactor": [r, g, b, 1.0], "metallicFactor": 0.0, "roughnessFactor": roughness },
        }));
        let [least, greatest] = [f32::min, f32::max].map(|choose| {
            own.iter().map(|v| v.position.to_array()).reduce(|a, b| std::array::from_fn(|k| choose(a[k], b[k])))
        });
        accessors.push(json!({
            "bufferView": 0, "byteOffset": vertices.len(), "componentType": FLOATS, "count": own.len(), "type": "VEC3",
            "min": least, "max": greatest,
        }));
        accessors.push(json!({
            "bufferView": 0, "byteOffset": vertices.len() + STRIDE / 2, "componentType": FLOATS, "count": own.len(),
            "type": "VEC3",
        }));
        accessors.push(json!({
            "bufferView": 1, "byteOffset": indices.len(), "componentType": SHORTS, "count": order.len(),
            "type": "SCALAR",
        }));
        let numbers = own.iter().flat_map(|v| v.position.to_array().into_iter().chain(v.normal.to_array()));
        vertices.extend(numbers.flat_map(f32::to_le_bytes));
        indices.extend(order.into_iter().flat_map(u16::to_le_bytes));
    }
    let views = json!([
        { "buffer": 0, "byteLength": vertices.len(), "byteStride": STRIDE, "target": VERTICES },
        { "buffer": 0, "byteOffset": vertices.len(), "byteLength": indices.len(), "target": INDICES },
    ]);
    let binary = [vertices, indices].concat();
    let document = json!({
        "asset": { "version": "2.0", "generator": "Cloudwright", "copyright": "Cloudwright's authors, MIT OR Apache-2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "name": "aircraft", "mesh": 0 }],
        "meshes": [{ "name": "aircraft", "primitives": primitives }],
        "materials": materials,
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{ "byteLength": binary.len() }],
    });
    container(&document, binary)
}

/// Vertices, each once, and which of them every corner is.
fn shared<'a>(corners: impl Iterator<Item = &'a Vertex>) -> (Vec<Vertex>, Vec<u16>) {
    let (mut vertices, mut order, mut places) = (Vec::new(), Vec::new(), HashMap::new());
    for vertex in corners {
        let key = [vertex.position.to_array(), vertex.normal.to_array()].map(|v| v.map(f32::to_bits));
        let place = *places.entry(key).or_insert_with(|| {
            vertices.push(*vertex);
            vertices.len() - 1
        });
        order.push(place as u16);
    }
    (vertices, order)
}

fn container(document: &Value, mut binary: Vec<u8>) -> Vec<u8> {
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);
    let length = 12 + 8 + text.len() + 8 + binary.len();
    let mut file = Vec::with_capacity(length);
    file.extend(b"glTF");
    for number in [2, length as u32, text.len() as u32] {
        file.extend(number.to_le_bytes());
    }
    file.extend(b"JSON");
    file.extend(text);
    file.extend((binary.len() as u32).to_le_bytes());
    file.extend(b"BIN\0");
    file.extend(binary);
    file
}
