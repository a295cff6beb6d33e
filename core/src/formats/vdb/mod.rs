//! A grid of extinction as OpenVDB (`.vdb`, file version 224): one grid `density` of class fog volume.
//!
//! As the library writes them (openvdb/io/Archive.cc, tree/RootNode.h and so on): a header, each grid's name and where its
//! parts lie, what is said of it, its transform, its tree's nodes without values, then the values. The tree has leaves of
//! 8³ voxels (`tree.rs`); only those that hold something are written, and of a leaf only the voxels that do
//! (`COMPRESS_ACTIVE_MASK`), uncompressed otherwise. All numbers are little-endian. The file's identifier is made of what
//! stands in it, so that the same grid has the same bytes.
//!
//! Here and not by a crate: vdb-rs reads alone, and OpenVDB-rs is a whole library, in its first release.

mod tree;

use crate::density::DensityGrid;
use glam::DVec3;
use std::io::{self, Write};
use tree::Tree;

/// `COMPRESS_ACTIVE_MASK`.
const ACTIVE_MASK: u32 = 2;
const MAGIC: u64 = 0x5644_4220;
const FILE_VERSION: u32 = 224;
/// Of the library that wrote such files first.
const LIBRARY_VERSION: [u32; 2] = [10, 0];
const TREE: &str = "Tree_float_5_4_3";
const NAME: &str = "density";

/// Writes the file of a grid; positions count from `origin`, metres in the world. With `z_up`, z is up and y forward.
///
/// # Errors
/// Those of `out`.
pub fn write(out: &mut dyn Write, grid: &DensityGrid, origin: DVec3, z_up: bool) -> io::Result<()> {
    let tree = Tree::of(grid, z_up);
    let mut own = Vec::new();
    own.extend(ACTIVE_MASK.to_le_bytes());
    metadata(&mut own, &tree);
    transform(&mut own, first_voxel(grid, origin, z_up), f64::from(grid.voxel_m));
    tree.write_nodes(&mut own);
    let mut head = Vec::new();
    head.extend(MAGIC.to_le_bytes());
    head.extend([FILE_VERSION, LIBRARY_VERSION[0], LIBRARY_VERSION[1]].map(u32::to_le_bytes).as_flattened());
    // Grids say where their parts lie.
    head.push(1);
    head.extend(identifier(&own, &tree).bytes());
    // Nothing is said of the file; one grid.
    head.extend([0_u32, 1].map(u32::to_le_bytes).as_flattened());
    text(&mut head, NAME);
    text(&mut head, TREE);
    text(&mut head, "");
    let begin = (head.len() + 3 * size_of::<u64>()) as u64;
    let values = begin + own.len() as u64;
    head.extend([begin, values, values + tree.values_len()].map(u64::to_le_bytes).as_flattened());
    out.write_all(&head)?;
    out.write_all(&own)?;
    tree.write_values(out)
}

/// The middle of the first voxel.
fn first_voxel(grid: &DensityGrid, origin: DVec3, z_up: bool) -> DVec3 {
    let voxel_m = f64::from(grid.voxel_m);
    let low = grid.corner - origin;
    let high = low + grid.size.as_dvec3() * voxel_m;
    let corner = if z_up { DVec3::new(low.x, -high.z, low.y) } else { low };
    corner + 0.5 * voxel_m
}

fn text(out: &mut Vec<u8>, text: &str) {
    out.extend((text.len() as u32).to_le_bytes());
    out.extend(text.bytes());
}

fn metadata(out: &mut Vec<u8>, tree: &Tree<'_>) {
    let vector = |numbers: [i32; 3]| numbers.map(i32::to_le_bytes).as_flattened().to_vec();
    let [low, high] = tree.bounds();
    let all: [(&str, &str, Vec<u8>); 5] = [
        ("class", "string", b"fog volume".to_vec()),
        ("file_bbox_max", "vec3i", vector(high)),
        ("file_bbox_min", "vec3i", vector(low)),
        ("file_voxel_count", "int64", (tree.voxels() as i64).to_le_bytes().to_vec()),
        ("name", "string", NAME.into()),
    ];
    out.extend((all.len() as u32).to_le_bytes());
    for (name, kind, value) in all {
        text(out, name);
        text(out, kind);
        out.extend((value.len() as u32).to_le_bytes());
        out.extend(value);
    }
}

fn transform(out: &mut Vec<u8>, at: DVec3, voxel_m: f64) {
    text(out, "UniformScaleTranslateMap");
    let inverse = 1.0 / voxel_m;
    let scales = [voxel_m, voxel_m, inverse, inverse * inverse, 0.5 * inverse].map(DVec3::splat);
    let numbers = [at].into_iter().chain(scales).flat_map(|vector| vector.to_array());
    out.extend(numbers.flat_map(f64::to_le_bytes));
}

/// An identifier of the form that others have (a UUID of version 8), of 64 bits of hash twice (FNV-1a).
fn identifier(own: &[u8], tree: &Tree<'_>) -> String {
    let hash = |basis: u64| {
        let add = |hash: u64, number: u64| (hash ^ number).wrapping_mul(0x0100_0000_01B3);
        let hash = own.iter().fold(basis, |hash, byte| add(hash, u64::from(*byte)));
        tree.values().fold(hash, |hash, value| add(hash, u64::from(value.to_bits())))
    };
    let (high, low) = (hash(0xCBF2_9CE4_8422_2325), hash(0x8422_2325_CBF2_9CE4));
    let high = high & 0xFFFF_FFFF_FFFF_0FFF | 0x8000;
    let low = low & 0x3FFF_FFFF_FFFF_FFFF | 0x8000_0000_0000_0000;
    let (high, low) = (format!("{high:016x}"), format!("{low:016x}"));
    format!("{}-{}-{}-{}-{}", &high[..8], &high[8..12], &high[12..], &low[..4], &low[4..])
}
