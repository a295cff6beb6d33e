//! The atlas as the fast CPU renderer reads it: one load fetches a whole bilinear footprint.
//!
//! Each texel of a channel is stored with its right, lower and diagonal neighbours in one u32, and two channels lie
//! side by side in one u64. Tables have one length, a power of two, so that a masked index needs no bounds check.

use super::{Atlas, MIP_LEVELS, TILE_SIZE, TILES, TileLevel};

/// Texels of all levels of a tile: 128² + 64² + 32² + 16² + 8², rounded up to a power of two.
pub const TABLE: usize = 32_768;
/// Low half alpha and high half red, or low half green and high half blue; in each half, from the lowest byte: the
/// texel, its right, its lower, its diagonal neighbour.
pub type FootprintTable = [u64; TABLE];

/// Where each level begins in a table.
pub const LEVEL_START: [usize; MIP_LEVELS] = level_starts();

const fn level_starts() -> [usize; MIP_LEVELS] {
    let mut starts = [0; MIP_LEVELS];
    let mut mip = 1;
    while mip < MIP_LEVELS {
        let side = TILE_SIZE >> (mip - 1);
        starts[mip] = starts[mip - 1] + side * side;
        mip += 1;
    }
    starts
}

/// All tiles' tables.
#[derive(Debug)]
pub struct Footprints {
    alpha_red: Vec<Box<FootprintTable>>,
    /// Empty for a grey atlas, whose green and blue are its red.
    green_blue: Vec<Box<FootprintTable>>,
}

impl Footprints {
    pub(super) fn new(atlas: &Atlas) -> Self {
        let tables = |low: usize, high: usize| (0..TILES).map(|tile| table(atlas, tile, low, high)).collect();
        Self { alpha_red: tables(3, 0), green_blue: if atlas.is_grey() { Vec::new() } else { tables(1, 2) } }
    }

    /// Alpha and red of a tile.
    pub fn alpha_red(&self, tile: u8) -> &FootprintTable {
        &self.alpha_red[tile as usize % TILES]
    }

    /// Green and blue of a tile; none if they are as red.
    pub fn green_blue(&self, tile: u8) -> Option<&FootprintTable> {
        self.green_blue.get(tile as usize % TILES).map(|table| &**table)
    }
}

fn table(atlas: &Atlas, tile: usize, low: usize, high: usize) -> Box<FootprintTable> {
    let mut entries = vec![0_u64; TABLE];
    for (mip, start) in LEVEL_START.into_iter().enumerate() {
        let level = atlas.level(tile, mip);
        for i in 0..level.size * level.size {
            entries[start + i] = u64::from(footprint(level, i, low)) | (u64::from(footprint(level, i, high)) << 32);
        }
    }
    entries.into_boxed_slice().try_into().unwrap_or_else(|_| Box::new([0; TABLE]))
}

fn footprint(level: &TileLevel, i: usize, channel: usize) -> u32 {
    let last = level.size - 1;
    let (x, y) = (i % level.size, i / level.size);
    let at = |x: usize, y: usize| level.texels[y.min(last) * level.size + x.min(last)][channel];
    u32::from_le_bytes([at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)])
}
