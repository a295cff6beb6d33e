//! A binary glTF file while it is made: one buffer with its views and accessors, and the JSON's lists.

use serde_json::{Value, json};

const FLOAT: u32 = 5126;
const SHORT: u32 = 5122;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
/// Of vertices, and of their indices: what a view's bytes are for.
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// What a view's bytes are for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    /// A mesh's corners.
    Vertices,
    /// Instances and animations, which have no name for it.
    Other,
}

/// The binary chunk, with the JSON that says what stands where in it.
#[derive(Debug, Default)]
pub(super) struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Numbers as they are, `N` an item. With their least and greatest, as positions and times of keys must have them.
    pub(super) fn floats<const N: usize>(&mut self, items: &[[f32; N]], what: Use, ranged: bool) -> usize {
        let mut accessor = json!({ "componentType": FLOAT, "count": items.len(), "type": kind(N) });
        if ranged && !items.is_empty() {
            let of = |choose: fn(f32, f32) -> f32| {
                let ends: [f32; N] =
                    std::array::from_fn(|i| items.iter().map(|item| item[i]).reduce(choose).unwrap_or(0.0));
                ends.to_vec()
            };
            accessor["min"] = json!(of(f32::min));
            accessor["max"] = json!(of(f32::max));
        }
        self.accessor(accessor, bytemuck::cast_slice(items.as_flattened()), target(what))
    }

    /// Numbers from −1 to 1 in steps of 1/32767.
    pub(super) fn signed_shares(&mut self, items: &[[f32; 4]], what: Use) -> usize {
        let steps: Vec<i16> =
            items.as_flattened().iter().map(|x| (x.clamp(-1.0, 1.0) * 32767.0).round() as i16).collect();
        let accessor = json!({ "componentType": SHORT, "normalized": true, "count": items.len(), "type": kind(4) });
        self.accessor(accessor, bytemuck::cast_slice(&steps), target(what))
    }

    /// Numbers from 0 to 1 in steps of 1/65535.
    pub(super) fn shares<const N: usize>(&mut self, items: &[[f32; N]], what: Use) -> usize {
        let steps: Vec<u16> =
            items.as_flattened().iter().map(|x| (x.clamp(0.0, 1.0) * 65535.0).round() as u16).collect();
        let accessor =
            json!({ "componentType": UNSIGNED_SHORT, "normalized": true, "count": items.len(), "type": kind(N) });
        self.accessor(accessor, bytemuck::cast_slice(&steps), target(what))
    }

    /// Which corners make triangles.
    pub(super) fn indices(&mut self, indices: &[u32]) -> usize {
        let accessor = json!({ "componentType": UNSIGNED_INT, "count": indices.len(), "type": "SCALAR" });
        self.accessor(accessor, bytemuck::cast_slice(indices), Some(INDICES))
    }

    /// A file within the file: its view.
    pub(super) fn file(&mut self, bytes: &[u8]) -> usize {
        self.view(bytes, None)
    }

    fn accessor(&mut self, mut accessor: Value, bytes: &[u8], target: Option<u32>) -> usize {
        accessor["bufferView"] = json!(self.view(bytes, target));
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn view(&mut self, bytes: &[u8], target: Option<u32>) -> usize {
        let mut view = json!({ "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len() });
        if let Some(target) = target {
            view["target"] = json!(target);
        }
        self.bytes.extend_from_slice(bytes);
        // Each view begins at a multiple of the largest number's size.
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.views.push(view);
        self.views.len() - 1
    }

    /// The whole file: `root` with this buffer, its views and accessors (glTF 2.0, §4.4: chunks are multiples of four
    /// bytes long, text padded by blanks).
    pub(super) fn into_glb(self, mut root: Value) -> Vec<u8> {
        root["buffers"] = json!([{ "byteLength": self.bytes.len() }]);
        root["bufferViews"] = Value::Array(self.views);
        root["accessors"] = Value::Array(self.accessors);
        let mut text = root.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let length = 12 + 8 + text.len() + 8 + self.bytes.len();
        let mut file = Vec::with_capacity(length);
        file.extend_from_slice(b"glTF");
        for number in [2, length as u32, text.len() as u32] {
            file.extend_from_slice(&number.to_le_bytes());
        }
        file.extend_from_slice(b"JSON");
        file.append(&mut text);
        file.extend_from_slice(&(self.bytes.len() as u32).to_le_bytes());
        file.extend_from_slice(b"BIN\0");
        file.extend_from_slice(&self.bytes);
        file
    }
}

fn target(what: Use) -> Option<u32> {
    (what == Use::Vertices).then_some(VERTICES)
}

fn kind(numbers: usize) -> &'static str {
    match numbers {
        1 => "SCALAR",
        2 => "VEC2",
        3 => "VEC3",
        _ => "VEC4",
    }
}
