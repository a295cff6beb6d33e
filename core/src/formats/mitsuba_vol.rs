//! A grid of extinction as Mitsuba reads it (`.vol`, version 3): the path tracer's `gridvolume`.
//!
//! Little-endian: `VOL`, u8 3, i32 1 for f32 values, i32 voxels along x, y and z, i32 channels (1), f32 the least and the
//! greatest corner, then the values, x fastest (Mitsuba 3's manual, *Grid-based volume data source*). Corners count from
//! where the caller says, so that f32 holds them.

use crate::density::DensityGrid;
use glam::DVec3;
use std::io::{self, Write};

/// Writes the file of a grid; its corners count from `origin`, metres in the world.
///
/// # Errors
/// Those of `out`.
pub fn write(out: &mut dyn Write, grid: &DensityGrid, origin: DVec3) -> io::Result<()> {
    out.write_all(b"VOL\x03")?;
    let [x, y, z] = grid.size.to_array();
    for number in [1, x, y, z, 1] {
        out.write_all(&number.to_le_bytes())?;
    }
    let low = grid.corner - origin;
    let high = low + grid.size.as_dvec3() * f64::from(grid.voxel_m);
    for number in low.to_array().into_iter().chain(high.to_array()) {
        out.write_all(&(number as f32).to_le_bytes())?;
    }
    for some in grid.extinction.chunks(4096) {
        let bytes: Vec<u8> = some.iter().flat_map(|value| value.to_le_bytes()).collect();
        out.write_all(&bytes)?;
    }
    Ok(())
}
