//! Phase 1, on the edit clock: from boxes to sprites.
//!
//! [`populate`] strews a model's sprites and culls them, in the model's space and in f64; [`place`] puts a cloud's
//! copy of them into the world. Sampling uses integer random numbers, `libm` functions and fixed orders of sums only,
//! so every machine gets the same bytes.

mod atlas;
mod candidates;
mod cull;
mod place;

pub use atlas::{Atlas, AtlasError, MIP_LEVELS, TILE_SIZE, TILES, TileLevel};
pub(crate) use atlas::{FootprintTable, LEVEL_START, TABLE};
pub use candidates::{Candidate, candidates, cull_radii};
pub use cull::{cull, cull_slow};
pub(crate) use place::heading_turn;
pub use place::{Group, GroupKey, PlacedCloud, Sprite, place};

use crate::scene::CloudModel;

/// A model's sprites in its own space.
#[derive(Debug, Clone, PartialEq)]
pub struct PopulatedModel {
    /// How many sprites were tried, hand-dropped ones left out.
    pub candidate_count: usize,
    /// What was kept, box by box and in order of index.
    pub sprites: Vec<Candidate>,
}

/// Strews and culls the sprites of `model` under `seed`.
pub fn populate(model: &CloudModel, seed: u64) -> PopulatedModel {
    let candidates = candidates(model, seed);
    let radii = cull_radii(model.cull_radius, &candidates);
    let kept = cull(&candidates, &radii);
    let candidate_count = candidates.len();
    let sprites = candidates.into_iter().zip(kept).filter_map(|(candidate, keep)| keep.then_some(candidate)).collect();
    PopulatedModel { candidate_count, sprites }
}
