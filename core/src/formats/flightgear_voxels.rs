//! A cloud as voxels for FlightGear after 2024: a PNG of W × W × H voxels, cut into H slices of W × W side by side.
//!
//! As its wiki has it (*3D clouds*): height W, width W·H; green is the kind, from 0 for wispy to 255 for billowy; blue the
//! density, from 0 for none to 255 for opaque. The simulator works red (how near the middle) and alpha (how far from the
//! cloud) out itself. Slices go up, from the west within each and from the north down, as on a map.

use std::io::{self, Write};

/// Voxels; x to the east runs fastest, then z to the south, then y up.
#[derive(Debug, Clone, PartialEq)]
pub struct Voxels {
    /// Voxels of a slice's side: W.
    pub side: u32,
    /// Slices: H.
    pub slices: u32,
    /// Of each voxel, how billowy and how dense it is.
    pub voxels: Vec<[u8; 2]>,
}

impl Voxels {
    /// Clear ones.
    pub fn clear(side: u32, slices: u32) -> Self {
        Self { side, slices, voxels: vec![[0, 0]; side as usize * side as usize * slices as usize] }
    }

    /// Where a voxel stands among them.
    pub fn index(&self, x: u32, y: u32, z: u32) -> usize {
        let side = self.side as usize;
        (y as usize * side + z as usize) * side + x as usize
    }

    /// Writes the PNG.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut pixels = Vec::with_capacity(4 * self.voxels.len());
        for z in 0..self.side {
            for y in 0..self.slices {
                for x in 0..self.side {
                    let [billowy, dense] = self.voxels[self.index(x, y, z)];
                    pixels.extend([0, billowy, dense, 255]);
                }
            }
        }
        let mut encoder = png::Encoder::new(out, self.side * self.slices, self.side);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&pixels));
        written.map_err(|error| match error {
            png::EncodingError::IoError(error) => error,
            other => io::Error::other(other),
        })
    }
}
