//! Heaps, as the plugins make them (scripts/plugins/parts/cumulus.rhai).

use super::{Sketch, by_plugin};
use cloudwright_core::scene::{Category, ModelId};

/// The measures of one kind of heap cloud, metres.
#[derive(Clone, Copy)]
pub struct Cumulus {
    /// Half extent of the base along x and z.
    pub base: [f64; 2],
    /// Height of the highest heap's top.
    pub height: f64,
    /// How many heaps.
    pub heaps: usize,
    /// Half width of a heap.
    pub heap_radius: [f64; 2],
    /// How far the crowns tower over the edges: 0 a level top, 1 cones.
    pub peak: f64,
    /// How many wisps are torn off.
    pub wisps: usize,
    /// How many crowns there are.
    pub crowns: usize,
    /// Metres that it leans along x for each metre up.
    pub lean: f64,
    /// How far it has dried up: 0 grown, 1 without a base and in rags.
    pub decay: f64,
}

impl Default for Cumulus {
    /// A small upright heap.
    fn default() -> Self {
        Self {
            base: [330.0, 250.0],
            height: 230.0,
            heaps: 6,
            heap_radius: [80.0, 135.0],
            peak: 0.45,
            wisps: 2,
            crowns: 1,
            lean: 0.0,
            decay: 0.0,
        }
    }
}

/// Adds a model of that kind, with its base at y = 0.
pub fn cumulus(sketch: &mut Sketch, name: &str, category: Category, c: &Cumulus) -> ModelId {
    let Cumulus { base, height, heaps, heap_radius, peak, wisps, crowns, lean, decay } = c;
    let category = category.name();
    let call = format!(
        "cumulus(dice, \"{name}\", \"{category}\", #{{ base: {base:?}, height: {height:?}, heaps: {heaps}, \
         radius: {heap_radius:?}, peak: {peak:?}, wisps: {wisps}, crowns: {crowns}, lean: {lean:?}, decay: {decay:?} }})"
    );
    by_plugin::model(sketch, &["cumulus", "boxes"], "", &call)
}
