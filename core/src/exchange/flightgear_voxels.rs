//! Clouds as FlightGear's voxels after 2024: a PNG each, of how dense they are and of which kind.
//!
//! Voxels are cubes; the cloud stands in the middle of W × W of them, on the lowest slice. Density 255 is that of the
//! densest thousandth of what holds any. The simulator has its own noise for each kind; which a voxel has follows from the
//! tiles of the sprites that make it dense: a puff is opaque all over with a hard outline, a wisp is faint, so how billowy
//! a tile is, is the mean alpha of the light that it stops: the sum of alpha's squares over the sum of alpha. Of the
//! sheet that ships that is 0.43 to 0.47 for the wisps, 0.80 to 0.85 for the general tiles and 0.93 for the puffs; it is
//! stretched so that these are 0 and 1.

use super::volume::with_sprites;
use super::{ExportError, Files, Leaving, Note, OptionKind, OptionRow, numbered};
use crate::density::{Density, DensityError, DensityGrid, Fineness, Vapour};
use crate::formats::flightgear_voxels::Voxels;
use crate::property::Number;
use crate::sprites::{Atlas, TILES};
use crate::weather::CloudNow;
use glam::UVec3;

const SIDE: Number = Number::new("Side", &(8.0..=256.0), "voxels", "Of a slice.");

pub(super) const WRITE_OPTIONS: &[OptionRow] = &[OptionRow {
    name: "side",
    kind: OptionKind::Number(SIDE, 64.0),
    doc: "How many voxels a slice is wide and deep; as many slices as the cloud is high:",
}];

/// What is no more billowy is wispy; what is no less, all billowy.
const WISPY: f32 = 0.45;
const BILLOWY: f32 = 0.93;
/// Of what holds any density, the share that is cut to the densest that is told.
const DENSEST: f32 = 0.001;
/// The most slices: what stands higher is shown in larger voxels.
const MOST_SLICES: u32 = 256;

/// Each cloud into a file of its own: the first into the one that was asked for.
pub(super) fn write(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let clouds: Vec<&CloudNow<'_>> = with_sprites(leaving.now).collect();
    let of_tile = billowy(leaving.atlas);
    let (mut notes, mut place) = (Vec::new(), 0);
    for (at, cloud) in clouds.iter().enumerate() {
        let vapour = Vapour { clouds: &[*cloud], atlas: leaving.atlas, light: &leaving.now.light };
        if let Some((voxels, voxel_m, densest)) = voxels(leaving, &vapour, of_tile)? {
            place += 1;
            files.add(&numbered(leaving.name, place), &mut |out| voxels.write(out))?;
            let Voxels { side, slices, .. } = voxels;
            let (wide, high) = (f64::from(side) * voxel_m, f64::from(slices) * voxel_m);
            let how = format!(
                "{side} × {side} × {slices} voxels: {wide:.0} m wide, {high:.0} m high; blue 255 is an extinction of \
                 {densest:.4} m⁻¹"
            );
            notes.push(Note::changed(format!("“{}”", cloud.placed.name), how));
        }
        leaving.watch.reach((at + 1) as f32 / clouds.len() as f32);
    }
    if place == 0 {
        return Err(ExportError::Nothing("sprites that show"));
    }
    notes.push(Note::assumed("wispy or billowy", "by how opaque the sprites' tiles are where they cover anything"));
    notes.push(Note::left_out("where clouds stand", "the simulator places them"));
    Ok(notes)
}

/// A cloud's voxels, their side in metres, and the extinction that is told as full; none if nothing shows.
fn voxels(
    leaving: &Leaving<'_>,
    vapour: &Vapour<'_>,
    of_tile: [f32; TILES],
) -> Result<Option<(Voxels, f64, f32)>, ExportError> {
    let side = leaving.options.number("side") as u32;
    let Some([low, high]) = vapour.bounds() else { return Ok(None) };
    let span = high - low;
    let voxel_m = (span.x.max(span.z) / f64::from(side)).max(span.y / f64::from(MOST_SLICES)) * 1.000_001;
    let watch = leaving.watch.part();
    let made = vapour.density(Fineness::VoxelM(voxel_m as f32), &watch).and_then(|Density { grid, .. }| {
        let kinds = vapour.mean_of_tiles(&grid, of_tile, &watch)?;
        Ok((grid, kinds))
    });
    let (grid, kinds) = match made {
        Ok(made) => made,
        Err(DensityError::Cancelled) => return Err(ExportError::Cancelled),
        Err(_) => return Ok(None),
    };
    let densest = densest(&grid);
    let UVec3 { x: width, y: slices, z: depth } = grid.size;
    let side = side.max(width).max(depth);
    let mut voxels = Voxels::clear(side, slices);
    let byte = |share: f32| (share.clamp(0.0, 1.0) * 255.0).round() as u8;
    let (left, back) = ((side - width) / 2, (side - depth) / 2);
    for (at, (extinction, kind)) in grid.extinction.iter().zip(&kinds).enumerate() {
        let (x, y, z) = (at as u32 % width, at as u32 / width % slices, at as u32 / width / slices);
        let index = voxels.index(left + x, y, back + z);
        voxels.voxels[index] = [byte(*kind), byte(extinction / densest)];
    }
    Ok(Some((voxels, f64::from(grid.voxel_m), densest)))
}

/// How billowy each tile is, 0 to 1.
fn billowy(atlas: &Atlas) -> [f32; TILES] {
    std::array::from_fn(|tile| {
        let alphas = || atlas.level(tile, 0).texels.iter().map(|texel| f32::from(texel[3]) / 255.0);
        let (sum, squares) = (alphas().sum::<f32>(), alphas().map(|alpha| alpha * alpha).sum::<f32>());
        let share = if sum > 0.0 { squares / sum } else { 0.0 };
        ((share - WISPY) / (BILLOWY - WISPY)).clamp(0.0, 1.0)
    })
}

/// What only a share of [`DENSEST`] of the voxels that hold any is denser than.
fn densest(grid: &DensityGrid) -> f32 {
    let mut held: Vec<f32> = grid.extinction.iter().copied().filter(|value| *value > 0.0).collect();
    held.sort_unstable_by(|a, b| b.total_cmp(a));
    let at = (held.len() as f32 * DENSEST) as usize;
    held.get(at).copied().unwrap_or(1.0)
}
