//! OpenVDB's tree over a grid: a root, nodes of 32³ and of 16³ places, leaves of 8³ voxels. What holds nothing is not in it.

use crate::density::DensityGrid;
use glam::UVec3;
use rayon::prelude::*;
use std::io::{self, Write};

/// Side of a leaf, voxels; the logarithms of the sides of the nodes above it, in what they hold.
const LEAF: u32 = 8;
const LOWER_LOG: u32 = 4;
const UPPER_LOG: u32 = 5;
/// Sides of the nodes, voxels.
const LOWER: u32 = LEAF << LOWER_LOG;
const UPPER: u32 = LOWER << UPPER_LOG;
/// `NO_MASK_OR_INACTIVE_VALS`: what a mask does not name is the background, 0.
const BACKGROUND_ELSEWHERE: u8 = 0;
/// How many bytes stand before a leaf's values.
const LEAF_HEAD: u64 = 64 + 1;

/// The nodes that hold something.
pub(super) struct Tree<'a> {
    grid: &'a DensityGrid,
    z_up: bool,
    /// In the order of the file.
    leaves: Vec<Leaf>,
}

struct Leaf {
    /// Its first voxel, in the tree's axes.
    first: UVec3,
    /// The voxels that hold something, x slowest, z fastest.
    mask: [u64; 8],
}

impl Leaf {
    fn upper(&self) -> UVec3 {
        self.first / UPPER * UPPER
    }

    fn lower(&self) -> UVec3 {
        self.first / LOWER * LOWER
    }

    /// Where it stands in the file.
    fn order(&self) -> ([u32; 3], u32, u32) {
        (self.upper().to_array(), place(self.lower() % UPPER / LOWER, UPPER_LOG), self.place())
    }

    fn place(&self) -> u32 {
        place(self.first % LOWER / LEAF, LOWER_LOG)
    }
}

/// The number of a place in a node whose side is 2 to the power of `log`: x slowest, z fastest.
fn place(UVec3 { x, y, z }: UVec3, log: u32) -> u32 {
    (x << log | y) << log | z
}

impl<'a> Tree<'a> {
    pub(super) fn of(grid: &'a DensityGrid, z_up: bool) -> Self {
        let mut tree = Self { grid, z_up, leaves: Vec::new() };
        let count = tree.size().map(|side| side.div_ceil(LEAF));
        let leaf = |x: u32, y: u32, z: u32| {
            let first = UVec3::new(x, y, z) * LEAF;
            let mask = std::array::from_fn(|x| {
                let holds = |at: u32| tree.value(first + UVec3::new(x as u32, at / LEAF, at % LEAF)) > 0.0;
                (0..u64::BITS).fold(0, |mask, at| mask | u64::from(holds(at)) << at)
            });
            (mask != [0; 8]).then_some(Leaf { first, mask })
        };
        let row = |x: u32| {
            let rows = (0..count[1]).flat_map(|y| (0..count[2]).map(move |z| (y, z)));
            rows.filter_map(|(y, z)| leaf(x, y, z)).collect::<Vec<Leaf>>()
        };
        let mut leaves: Vec<Leaf> = (0..count[0]).into_par_iter().flat_map_iter(row).collect();
        leaves.sort_unstable_by_key(Leaf::order);
        tree.leaves = leaves;
        tree
    }

    /// Voxels along the tree's axes.
    fn size(&self) -> [u32; 3] {
        let UVec3 { x, y, z } = self.grid.size;
        if self.z_up { [x, z, y] } else { [x, y, z] }
    }

    /// A voxel's value; nothing beyond the grid.
    fn value(&self, voxel: UVec3) -> f32 {
        let UVec3 { x, y, z } = self.grid.size;
        if voxel.cmpge(UVec3::from(self.size())).any() {
            return 0.0;
        }
        let at = if self.z_up { UVec3::new(voxel.x, voxel.z, z - 1 - voxel.y) } else { voxel };
        self.grid.extinction[(at.z as usize * y as usize + at.y as usize) * x as usize + at.x as usize]
    }

    fn values_of<'b>(&'b self, leaf: &'b Leaf) -> impl Iterator<Item = f32> + 'b {
        let voxel = |at: u32| leaf.first + UVec3::new(at / 64, at / 8 % 8, at % 8);
        let holds = |at: &u32| leaf.mask[*at as usize / 64] >> (at % 64) & 1 == 1;
        (0..512).filter(holds).map(move |at| self.value(voxel(at)))
    }

    /// What voxels hold, in the order of the file.
    pub(super) fn values(&self) -> impl Iterator<Item = f32> + '_ {
        self.leaves.iter().flat_map(|leaf| self.values_of(leaf))
    }

    /// How many voxels hold something.
    pub(super) fn voxels(&self) -> u64 {
        self.leaves.iter().flat_map(|leaf| leaf.mask).map(|mask| u64::from(mask.count_ones())).sum()
    }

    /// The least and greatest voxel of all leaves; of none, nothing as the library says it.
    pub(super) fn bounds(&self) -> [[i32; 3]; 2] {
        let firsts = || self.leaves.iter().map(|leaf| leaf.first);
        let (Some(low), Some(high)) = (firsts().reduce(UVec3::min), firsts().reduce(UVec3::max)) else {
            return [[i32::MAX; 3], [i32::MIN; 3]];
        };
        [low, high + (LEAF - 1)].map(|corner| corner.as_ivec3().to_array())
    }

    /// The nodes without voxels' values.
    pub(super) fn write_nodes(&self, out: &mut Vec<u8>) {
        // One buffer of values.
        out.extend(1_u32.to_le_bytes());
        let uppers: Vec<&[Leaf]> = self.leaves.chunk_by(|a, b| a.upper() == b.upper()).collect();
        // The background, and how many tiles and nodes are below the root.
        out.extend(0.0_f32.to_le_bytes());
        out.extend([0, uppers.len() as u32].map(u32::to_le_bytes).as_flattened());
        for upper in uppers {
            out.extend(upper[0].upper().to_array().map(u32::to_le_bytes).as_flattened());
            let lowers: Vec<&[Leaf]> = upper.chunk_by(|a, b| a.lower() == b.lower()).collect();
            let places = lowers.iter().map(|lower| place(lower[0].lower() % UPPER / LOWER, UPPER_LOG));
            write_node::<{ 1 << (3 * UPPER_LOG - 6) }>(out, places);
            for lower in lowers {
                write_node::<{ 1 << (3 * LOWER_LOG - 6) }>(out, lower.iter().map(Leaf::place));
                for leaf in lower {
                    out.extend(leaf.mask.map(u64::to_le_bytes).as_flattened());
                }
            }
        }
    }

    /// How many bytes [`Self::write_values`] writes.
    pub(super) fn values_len(&self) -> u64 {
        self.leaves.len() as u64 * LEAF_HEAD + self.voxels() * size_of::<f32>() as u64
    }

    /// The leaves' values.
    pub(super) fn write_values(&self, out: &mut dyn Write) -> io::Result<()> {
        for leaf in &self.leaves {
            let mut bytes = leaf.mask.map(u64::to_le_bytes).as_flattened().to_vec();
            bytes.push(BACKGROUND_ELSEWHERE);
            bytes.extend(self.values_of(leaf).flat_map(f32::to_le_bytes));
            out.write_all(&bytes)?;
        }
        Ok(())
    }
}

/// A node whose places are nodes or nothing: which are nodes, that none has a value of its own, and those values.
fn write_node<const WORDS: usize>(out: &mut Vec<u8>, places: impl Iterator<Item = u32>) {
    let mut mask = [0_u64; WORDS];
    for place in places {
        mask[place as usize / 64] |= 1 << (place % 64);
    }
    out.extend(mask.map(u64::to_le_bytes).as_flattened());
    out.extend([0; WORDS].map(u64::to_le_bytes).as_flattened());
    out.push(BACKGROUND_ELSEWHERE);
}
