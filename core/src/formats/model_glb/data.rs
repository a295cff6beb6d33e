//! The numbers of a glTF file: buffers, the views into them, and the accessors that say what a view's bytes are.
//!
//! Every length is checked before a byte is read. Sparse accessors, mostly used for morph targets, are refused.

use super::{ModelError, broken};
use crate::formats::base64;
use glam::Vec3;
use gltf::json::accessor::{ComponentType, Type};
use gltf::json::validation::Checked;
use gltf::json::{Accessor, Index, Root};
use std::borrow::Cow;

/// A file's buffers, in memory.
pub(super) struct Data<'a> {
    root: &'a Root,
    buffers: Vec<Cow<'a, [u8]>>,
}

/// An accessor's bytes: `count` elements, each at a multiple of `stride`.
struct Elements<'a> {
    bytes: &'a [u8],
    count: usize,
    stride: usize,
    component: ComponentType,
    normalized: bool,
}

impl<'a> Data<'a> {
    /// `blob` is a binary file's own buffer.
    pub(super) fn new(root: &'a Root, blob: Option<Vec<u8>>) -> Result<Self, ModelError> {
        let mut blob = blob;
        let buffer = |(i, buffer): (usize, &'a gltf::json::Buffer)| match &buffer.uri {
            None => blob.take().map(Cow::Owned).ok_or_else(|| broken(format!("buffer {i} has no data"))),
            Some(uri) => match uri.strip_prefix("data:").and_then(|rest| rest.split_once(";base64,")) {
                Some((_, text)) => {
                    base64::decode(text).map(Cow::Owned).ok_or_else(|| broken(format!("buffer {i} is no base64")))
                }
                None => Err(ModelError::NeedsFile(uri.chars().take(200).collect())),
            },
        };
        let buffers = root.buffers.iter().enumerate().map(buffer).collect::<Result<_, _>>()?;
        Ok(Self { root, buffers })
    }

    fn accessor(&self, index: Index<Accessor>) -> Result<&'a Accessor, ModelError> {
        self.root.get(index).ok_or_else(|| broken(format!("it has no accessor {index}")))
    }

    /// How many elements an accessor says it has.
    pub(super) fn count(&self, index: Index<Accessor>) -> Result<usize, ModelError> {
        // One too large for the machine is too large for the limits as well.
        Ok(usize::try_from(self.accessor(index)?.count.0).unwrap_or(usize::MAX))
    }

    /// Vectors of three or more numbers, of which the first three are read; whole numbers that are `normalized` as
    /// shares of their largest.
    pub(super) fn vectors(&self, index: Index<Accessor>) -> Result<Vec<Vec3>, ModelError> {
        let accessor = self.accessor(index)?;
        if !matches!(accessor.type_, Checked::Valid(Type::Vec3 | Type::Vec4)) {
            return Err(broken(format!("accessor {index} has no vectors of three numbers")));
        }
        let elements = self.elements(index, accessor)?;
        let size = elements.component.size();
        let number = |i: usize, k: usize| {
            let number = elements.number(i, k * size).unwrap_or(f64::NAN);
            (if elements.normalized { number / largest(elements.component) } else { number }) as f32
        };
        Ok((0..elements.count).map(|i| Vec3::new(number(i, 0), number(i, 1), number(i, 2))).collect())
    }

    /// Whole numbers, one an element.
    pub(super) fn indices(&self, index: Index<Accessor>) -> Result<Vec<u32>, ModelError> {
        let accessor = self.accessor(index)?;
        let elements = self.elements(index, accessor)?;
        let whole = matches!(elements.component, ComponentType::U8 | ComponentType::U16 | ComponentType::U32);
        if !whole || !matches!(accessor.type_, Checked::Valid(Type::Scalar)) {
            return Err(broken(format!("accessor {index} has no indices")));
        }
        Ok((0..elements.count).map(|i| elements.number(i, 0).map_or(u32::MAX, |number| number as u32)).collect())
    }

    fn elements(&self, index: Index<Accessor>, accessor: &Accessor) -> Result<Elements<'_>, ModelError> {
        let (Checked::Valid(component), Checked::Valid(shape)) = (&accessor.component_type, &accessor.type_) else {
            return Err(broken(format!("accessor {index} is of no known type")));
        };
        if accessor.sparse.is_some() {
            return Err(broken(format!("accessor {index} is sparse, which is not read")));
        }
        let view = accessor.buffer_view.and_then(|view| self.root.get(view));
        let view = view.ok_or_else(|| broken(format!("accessor {index} has no data")))?;
        let size = component.0.size() * shape.multiplicity();
        let stride = view.byte_stride.map_or(0, |stride| stride.0);
        let stride = if stride == 0 { size } else { stride };
        let beyond = || broken(format!("accessor {index} reaches beyond its data"));
        let [view_start, view_length, start] =
            [view.byte_offset.unwrap_or_default(), view.byte_length, accessor.byte_offset.unwrap_or_default()]
                .map(|number| usize::try_from(number.0).unwrap_or(usize::MAX));
        let count = self.count(index)?;
        let bytes = self.buffers.get(view.buffer.value()).and_then(|buffer| buffer.get(view_start..));
        let bytes = bytes.and_then(|bytes| bytes.get(..view_length)).and_then(|bytes| bytes.get(start..));
        let bytes = bytes.ok_or_else(beyond)?;
        let needed = count.checked_sub(1).map_or(Some(0), |last| last.checked_mul(stride)?.checked_add(size));
        if stride < size || needed.is_none_or(|needed| needed > bytes.len()) {
            return Err(beyond());
        }
        Ok(Elements { bytes, count, stride, component: component.0, normalized: accessor.normalized })
    }
}

impl Elements<'_> {
    /// The number `offset` bytes into element `i`.
    fn number(&self, i: usize, offset: usize) -> Option<f64> {
        let bytes = self.bytes.get(i * self.stride + offset..)?;
        Some(match self.component {
            ComponentType::I8 => f64::from(i8::from_le_bytes(*bytes.first_chunk()?)),
            ComponentType::U8 => f64::from(u8::from_le_bytes(*bytes.first_chunk()?)),
            ComponentType::I16 => f64::from(i16::from_le_bytes(*bytes.first_chunk()?)),
            ComponentType::U16 => f64::from(u16::from_le_bytes(*bytes.first_chunk()?)),
            ComponentType::U32 => f64::from(u32::from_le_bytes(*bytes.first_chunk()?)),
            ComponentType::F32 => f64::from(f32::from_le_bytes(*bytes.first_chunk()?)),
        })
    }
}

/// What a normalized number of that type is divided by.
fn largest(component: ComponentType) -> f64 {
    match component {
        ComponentType::I8 => f64::from(i8::MAX),
        ComponentType::U8 => f64::from(u8::MAX),
        ComponentType::I16 => f64::from(i16::MAX),
        ComponentType::U16 => f64::from(u16::MAX),
        ComponentType::U32 => f64::from(u32::MAX),
        ComponentType::F32 => 1.0,
    }
}
