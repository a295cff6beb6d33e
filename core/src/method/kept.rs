//! Drawing a share of the sprites: those of each cloud that cover most.
//!
//! A sprite counts by its area times its tile's mean opacity. What is dropped is dropped in every view, so nothing pops;
//! what stays is drawn as it was, neither larger nor more opaque, so a cloud gets thinner. Its centre, height and
//! shading groups stay those of all its sprites, so its colours don't change. (Growing what stays, as Cook, Halstead,
//! Planck and Ryu do in *Stochastic Simplification of Aggregate Detail*, 2007, would blend as many fragments as before,
//! and fragments are what clouds cost.)

use crate::derived::Derived;
use crate::sprites::{Atlas, PlacedCloud, Sprite};
use std::sync::Arc;

/// The clouds with `share` (0 to 1) of each one's sprites, rounded up. Of equal ones the first stay. Always the same for
/// the same clouds.
pub fn keep(derived: &Derived, atlas: &Atlas, share: f32) -> Derived {
    derived.with_sprites(|cloud| largest(cloud, atlas, share))
}

fn largest(cloud: &PlacedCloud, atlas: &Atlas, share: f32) -> Arc<[Sprite]> {
    let count = (cloud.sprites.len() as f64 * f64::from(share.clamp(0.0, 1.0))).ceil() as usize;
    let covers = |sprite: &Sprite| sprite.width * sprite.height * atlas.mean_opacity(sprite.tile.into());
    let mut by_cover: Vec<(usize, f32)> = cloud.sprites.iter().map(covers).enumerate().collect();
    by_cover.sort_by(|a, b| b.1.total_cmp(&a.1));
    by_cover.truncate(count);
    by_cover.sort_unstable_by_key(|(index, _)| *index);
    by_cover.into_iter().map(|(index, _)| cloud.sprites[index]).collect()
}
