//! The page's numbers as one block of bytes, little-endian, in sections.

use flate2::Compression;
use flate2::write::ZlibEncoder;
use serde::Serialize;
use std::io::{self, Write};

/// A section of the block.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Section {
    name: &'static str,
    /// Its first byte.
    from: usize,
    bytes: usize,
}

/// The bytes, and what stands where.
#[derive(Debug, Default)]
pub(super) struct Block {
    bytes: Vec<u8>,
    pub(super) sections: Vec<Section>,
}

impl Block {
    /// Adds a section. Each begins at a multiple of four bytes, as all consist of such.
    pub(super) fn add<T: bytemuck::NoUninit>(&mut self, name: &'static str, items: &[T]) {
        let bytes: &[u8] = bytemuck::cast_slice(items);
        self.sections.push(Section { name, from: self.bytes.len(), bytes: bytes.len() });
        self.bytes.extend_from_slice(bytes);
    }

    /// As zlib has it (RFC 1950).
    pub(super) fn packed(&self) -> io::Result<Vec<u8>> {
        let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(&self.bytes)?;
        encoder.finish()
    }
}
