//! The atlas as the fast CPU renderer reads it: one load fetches a whole bilinear footprint.
//!
//! Each entry holds two channels of a texel and of the one below it, four bytes; so the eight bytes from an entry on are
//! two by two texels of two channels. Half the size of entries with all four neighbours: what counts here is how much of
//! a tile the nearest cache holds. Tables have one length, a power of two and one, so that a masked index needs no bounds
//! check.

use super::{Atlas, MIP_LEVELS, TILE_SIZE, TILES, TileLevel};

/// Texels of all levels of a tile: 128² + 64² + 32² + 16² + 8², rounded up to a power of two.
pub const TABLE: usize = 32_768;
/// From the lowest byte: the first channel of a texel and of the one below it, the second channel of both. One entry more
/// than [`TABLE`], for the right neighbour of the last.
pub type FootprintTable = [u32; TABLE + 1];

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
        let tables = |channels| (0..TILES).map(|tile| table(atlas, tile, channels)).collect();
        Self { alpha_red: tables([3, 0]), green_blue: if atlas.is_grey() { Vec::new() } else { tables([1, 2]) } }
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

fn table(atlas: &Atlas, tile: usize, [first, second]: [usize; 2]) -> Box<FootprintTable> {
    let mut entries = vec![0; TABLE + 1];
    for (mip, start) in LEVEL_START.into_iter().enumerate() {
        let level = atlas.level(tile, mip);
        for i in 0..level.size * level.size {
            entries[start + i] = footprint(level, i, [first, second]);
        }
    }
    entries.into_boxed_slice().try_into().unwrap_or_else(|_| Box::new([0; TABLE + 1]))
}

fn footprint(level: &TileLevel, i: usize, [first, second]: [usize; 2]) -> u32 {
    let here = level.texels[i];
    // Below the last row there is nothing; what is read there is weighed with 0.
    let below = level.texels.get(i + level.size).copied().unwrap_or_default();
    u32::from_le_bytes([here[first], below[first], here[second], below[second]])
}
