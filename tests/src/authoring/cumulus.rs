//! Heaps, as the plugins make them (scripts/plugins/parts/cumulus.rhai).

use super::{Sketch, by_plugin};
use cloudwright_core::scene::{Category, ModelId};

/// The measures of one kind of heap cloud, metres.
pub struct Cumulus {
    /// Half extent of the base along x and z.
    pub base: [f64; 2],
    /// Height of the highest heap's top.
    pub height: f64,
    /// How many heaps.
    pub heaps: usize,
    /// Half width of a heap.
    pub heap_radius: [f64; 2],
    /// How far the middle towers over the edges: 0 a level top, 1 a cone.
    pub peak: f64,
    /// How many wisps are torn off.
    pub wisps: usize,
}

/// Adds a model of that kind, with its base at y = 0.
pub fn cumulus(sketch: &mut Sketch, name: &str, category: Category, c: &Cumulus) -> ModelId {
    let Cumulus { base, height, heaps, heap_radius, peak, wisps } = c;
    let category = category.name();
    let call = format!(
        "cumulus(dice, \"{name}\", \"{category}\", #{{ base: {base:?}, height: {height:?}, heaps: {heaps}, \
         radius: {heap_radius:?}, peak: {peak:?}, wisps: {wisps} }})"
    );
    by_plugin::model(sketch, &["cumulus", "boxes"], "", &call)
}
