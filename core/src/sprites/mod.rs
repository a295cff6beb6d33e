//! Phase 1, on the edit clock: from boxes to sprites.
//!
//! [`populate`] strews a model's sprites and culls them, in the model's space and in f64; [`place`] puts a cloud's
//! copy of them into the world. Sampling uses integer random numbers, `libm` functions and fixed orders of sums only,
//! so every machine gets the same bytes.

mod atlas;
mod bake;
mod candidates;
mod casts;
mod cull;
mod merge;
mod place;
mod shapes;
mod sprite;
mod stir;

pub use atlas::{Atlas, AtlasError, MIP_LEVELS, TILE_SIZE, TILES, TileLevel};
pub(crate) use atlas::{FootprintTable, LEVEL_START, TABLE};
pub use bake::balls_of;
pub(crate) use bake::{Bake, halves_of};
pub use candidates::{Candidate, candidates, cull_radii};
pub use casts::Casts;
pub(crate) use casts::CastsOnce;
pub use cull::{cull, cull_slow};
pub use merge::{Merged, Merging};
pub use place::{Group, GroupKey, PlacedCloud, SoftLight, place};
pub(crate) use place::{dress, heading_turn, place_watched, stand_alike};
pub(crate) use shapes::Known;
pub use shapes::Shapes;
pub use sprite::{Cover, Sprite, Sprites};
pub use stir::Stir;

use crate::scene::CloudModel;
use crate::watch::Watch;
use std::sync::Arc;

/// What a sprite costs in each step, in a unit of work: about 10 ns.
const DRAWING: u64 = 4;
const CULLING: u64 = 44;
/// Of a sprite that is tried.
pub(crate) const STREWING: u64 = DRAWING + CULLING;
/// Of a sprite that is kept.
pub(crate) const PLACING: u64 = 3;

/// A model's sprites in its own space.
#[derive(Debug, Clone, PartialEq)]
pub struct PopulatedModel {
    /// How many sprites were tried, hand-dropped ones left out.
    pub candidate_count: usize,
    /// What was kept, box by box and in order of index.
    pub sprites: Vec<Candidate>,
    /// What stands for them where they are too small to tell apart.
    pub merging: Arc<Merging>,
}

/// Strews and culls the sprites of `model` under `seed`.
pub fn populate(model: &CloudModel, seed: u64) -> PopulatedModel {
    populate_watched(model, seed, &Watch::default())
}

/// The same under a watch; some sprites are missing if that is cancelled.
pub(crate) fn populate_watched(model: &CloudModel, seed: u64, watch: &Watch) -> PopulatedModel {
    let candidates = candidates::candidates_watched(model, seed, watch);
    let radii = cull_radii(model.cull_radius, &candidates);
    let kept = cull::cull_watched(&candidates, &radii, watch);
    let candidate_count = candidates.len();
    let sprites: Vec<Candidate> =
        candidates.into_iter().zip(kept).filter_map(|(candidate, keep)| keep.then_some(candidate)).collect();
    let merging = Arc::new(Merging::watched(&sprites, watch));
    PopulatedModel { candidate_count, sprites, merging }
}
