//! Model no more than a scene needs: sprites that nobody would miss are dropped.
//!
//! A scene is looked at from its cameras, along its paths and from around each cloud, that one alone (`vantages.rs`, which
//! says whence where there are many), by the light of its hour, with every cloud whole and at rest: what hides a sprite then may have left it in weather.
//! Sprites are sorted by the most that they add to any of these
//! pictures (`losses.rs`), and as many of the least are dropped as leave each picture's mean FLIP against the scene as it
//! was within the tolerance (`judge.rs`). Then what is left is weighed again, for what stood behind the dropped ones shows
//! now. Where even a few can't be spared although they show little (they moved the light of others, say), they stay, and
//! the next ones are tried.
//!
//! Dropped sprites are edits of their boxes, as if by hand (`trial.rs`); a candidate that the cull had left out in favour
//! of one that is gone is dropped too. Clouds of one model share their boxes, and so what is dropped.

mod judge;
mod losses;
mod trial;
mod vantages;

use crate::arrange::sprites::SpriteId;
use crate::document::Edit;
use crate::scene::{ModelId, Scene};
use crate::sprites::Atlas;
use crate::watch::Watch;
use judge::Judge;
use rustc_hash::FxHashSet;
use trial::Trial;

/// Of the sprites, the smallest share that is worth another try.
const FINEST: usize = 128;
/// So many such shares may turn out to be missed before it ends.
const MISSED: usize = 16;

/// What a scene can do without.
#[derive(Debug, Clone, PartialEq)]
pub struct Thinned {
    /// Drop the sprites; one transaction.
    pub edits: Vec<Edit>,
    /// Sprites drawn, over all clouds, before.
    pub before: u64,
    /// And after.
    pub after: u64,
    /// The largest mean FLIP of any view.
    pub error: f64,
    /// Which view that is.
    pub worst_view: String,
    /// How many views there are.
    pub views: usize,
    /// How many models keep all their sprites, because there are so many that no view is around any of their clouds.
    pub models_left: usize,
}

/// Why a scene is not thinned.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ThinError {
    /// Not above 0 and at most 1.
    #[error("a tolerance is a mean FLIP above 0 and at most 1, not {0}")]
    Tolerance(f64),
    /// Nothing to drop.
    #[error("the scene has no sprites")]
    NoSprites,
    /// The first step is too much already.
    #[error("dropping as few as {sprites} of the sprites that show least puts a view further off than {tolerance}")]
    CannotHold {
        /// How many were tried.
        sprites: usize,
        /// As asked for.
        tolerance: f64,
    },
    /// The watch was cancelled.
    #[error("cancelled")]
    Cancelled,
}

/// A sprite of a model, in whichever clouds show it.
type Key = (ModelId, SpriteId);

/// Finds what `scene`, drawn with `atlas`, can do without: no view's mean FLIP exceeds `tolerance`.
///
/// # Errors
/// If the tolerance is none, there are no sprites, nothing can be dropped within it, or `watch` was cancelled.
pub fn thin(scene: &Scene, atlas: &Atlas, tolerance: f64, watch: &Watch) -> Result<Thinned, ThinError> {
    if !(tolerance > 0.0 && tolerance <= 1.0) {
        return Err(ThinError::Tolerance(tolerance));
    }
    let mut trial = Trial::new(scene, watch).ok_or(ThinError::Cancelled)?;
    let before = trial.sprite_count();
    if before == 0 {
        return Err(ThinError::NoSprites);
    }
    let judge = Judge::new(&trial, atlas, tolerance, watch);
    let keys_at_first = judge.key_count(&trial);
    let finest = (keys_at_first / FINEST).max(1);
    let (mut held, mut step, mut missed) = (None, usize::MAX, FxHashSet::default());
    let mut ranked = Vec::new();
    while missed.len() < MISSED * finest && !watch.is_cancelled() {
        if ranked.len() < step {
            ranked = judge.ranked(&trial);
            ranked.retain(|key| !missed.contains(key));
            step = step.min(ranked.len() / 2);
        }
        if step < finest {
            break;
        }
        watch.reach(progress(step, missed.len(), keys_at_first));
        trial.drop_sprites(&ranked[..step]);
        match judge.worst(&trial) {
            Some(worst) => (held, ranked) = (Some(worst), Vec::new()),
            None => {
                trial.take_back();
                if step == finest {
                    // Some of them matter more than was guessed. Others may not.
                    missed.extend(ranked.drain(..step));
                }
                step = (step / 2).max(finest);
            }
        }
    }
    match held {
        _ if watch.is_cancelled() => Err(ThinError::Cancelled),
        None => Err(ThinError::CannotHold { sprites: finest, tolerance }),
        Some((error, view)) => Ok(Thinned {
            edits: trial.edits(scene),
            before,
            after: trial.sprite_count(),
            error,
            worst_view: judge.vantages[view].name.clone(),
            views: judge.vantages.len(),
            models_left: judge.kept_models(&trial),
        }),
    }
}

/// Steps halve from half of all sprites to the finest: so many times of how many; that is half of the way. The other
/// half are the sprites that turn out to be missed.
fn progress(step: usize, missed: usize, all: usize) -> f32 {
    let halvings = |times: usize| (times.max(1) as f32).log2();
    let halved = 1.0 - halvings(step * FINEST / all.max(1)) / halvings(FINEST);
    0.5 * halved.clamp(0.0, 1.0) + 0.5 * (missed * FINEST) as f32 / (all.max(1) * MISSED) as f32
}
