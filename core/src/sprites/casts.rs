//! What a cloud casts shadows with: how deep its sprites are to light, and few balls that stand for all of them.
//!
//! Made of the sprites at rest, once and when first asked for: a scene without shadows has none of it.

use super::bake::halves_of;
use super::{Atlas, Sprite};
use crate::baked::{Ball, gathered};
use std::sync::{Arc, OnceLock};

/// How many balls stand for a cloud at most, where it shades another: a power of two.
const FEW: usize = 32;

/// Of a cloud at rest, metres from its origin.
#[derive(Debug, Clone, PartialEq)]
pub struct Casts {
    /// Each sprite's optical depth through its middle, in their order.
    pub depths: Box<[f32]>,
    /// Balls that let through about what the sprites do, at most 32.
    pub few: Box<[Ball]>,
}

/// Those of a cloud, shared by its copies.
#[derive(Debug, Clone, Default)]
pub(crate) struct CastsOnce(Arc<OnceLock<Casts>>);

impl PartialEq for CastsOnce {
    /// They follow from the sprites and the levels, whether or not they have been made.
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl CastsOnce {
    /// They, made if they have not been.
    pub(super) fn get_or_make(&self, make: impl FnOnce() -> Casts) -> &Casts {
        self.0.get_or_init(make)
    }
}

impl Casts {
    /// Of sprites, of which `opacity` tells how opaque their levels have them, 0 to 1.
    pub(super) fn new(sprites: &[Sprite], opacity: impl Fn(&Sprite) -> f32) -> Self {
        // Of the built-in sheet, as what is baked is.
        let tiles = Atlas::built_in();
        let ball = |sprite: &Sprite| {
            let halves = halves_of([sprite.width, sprite.height], sprite.rotation);
            Ball::new(sprite.position, halves, tiles.mean_opacity(sprite.tile.into()) * opacity(sprite))
        };
        let balls: Vec<Ball> = sprites.iter().map(ball).collect();
        Self { depths: balls.iter().map(|ball| ball.depth).collect(), few: gathered(&balls, FEW).into() }
    }
}
