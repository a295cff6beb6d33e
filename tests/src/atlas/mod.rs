//! The built-in sheet of cloud tiles: 4x4 tiles in grey and alpha, made from a seed.
//!
//! Row 0: three wisps and a flat base. Row 1: general tiles. Rows 2 and 3: swelling puffs.
//! Floats see only + - * / sqrt and `libm`, and each tile is made by one thread from its own seed:
//! the bytes are the same on every machine and on any number of threads.

mod bleed;
mod blur;
mod density;
mod finish;
mod light;
mod lobes;
mod noise;
mod recipes;
mod wisp;

use rayon::prelude::*;

use finish::finish;
use recipes::{Recipe, recipe};

/// The built-in sheet's seed, chosen by eye.
pub const BUILT_IN_SEED: u32 = 1;
/// One tile: 128x128 texels, row 0 at the top, straight-alpha RGBA8.
pub const TILE_SIZE: usize = 128;
const TILES_A_SIDE: usize = 4;
const SHEET_SIZE: usize = TILES_A_SIDE * TILE_SIZE;

/// A tile before it becomes bytes: row 0 at the top.
struct Texels {
    alpha: Vec<f32>,
    /// How open to the light what is seen there is, in any range: it is remapped.
    openness: Vec<f32>,
    /// How near to the viewer it is.
    nearness: Vec<f32>,
}

/// The whole 512x512 sheet, 4x4 tiles row by row from the top left, straight-alpha RGBA8,
/// the same bytes on every machine and thread count.
pub fn generate_sheet(seed: u32) -> Vec<u8> {
    let tiles: Vec<Vec<u8>> = (0..(TILES_A_SIDE * TILES_A_SIDE) as u32)
        .into_par_iter()
        .with_max_len(1)
        .map(|tile| finish(tile, &make(tile, seed)))
        .collect();
    let mut sheet = vec![0; SHEET_SIZE * SHEET_SIZE * 4];
    for (tile, bytes) in tiles.iter().enumerate() {
        let left = tile % TILES_A_SIDE * TILE_SIZE;
        let top = tile / TILES_A_SIDE * TILE_SIZE;
        for (row, line) in bytes.chunks_exact(TILE_SIZE * 4).enumerate() {
            let start = ((top + row) * SHEET_SIZE + left) * 4;
            sheet[start..start + line.len()].copy_from_slice(line);
        }
    }
    sheet
}

fn make(tile: u32, seed: u32) -> Texels {
    match recipe(tile, seed) {
        Recipe::Wisp(wisp) => wisp.draw(),
        Recipe::Puff(puff) => puff.march(),
    }
}
