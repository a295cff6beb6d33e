//! Shadows that frames share: where nothing moves, none is worked out again.

use super::ShadowMap;
use crate::version::Version;
use crate::weather::Shade;
use std::sync::{Arc, Mutex, PoisonError};

/// The shadows of the last frame of some clouds, shared by all copies.
#[derive(Debug, Clone, Default)]
pub struct KeptShadows {
    /// Theirs on the ground.
    pub map: Kept<Option<Arc<ShadowMap>>>,
    /// Of each cloud what the others take of its light.
    pub between: Kept<Arc<[Option<Shade>]>>,
}

/// What was made last, of what.
#[derive(Debug, Clone)]
pub struct Kept<T>(Arc<Mutex<Option<(Of, T)>>>);

/// Of which clouds, and in what state they are.
type Of = (Version, u64);

impl<T> Default for Kept<T> {
    fn default() -> Self {
        Self(Arc::default())
    }
}

impl<T: Clone> Kept<T> {
    /// That of what has such a version and state: the kept one, or what `make` makes.
    pub fn of(&self, of: Of, make: impl FnOnce() -> T) -> T {
        let kept = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, made)) = kept().as_ref().filter(|(made_of, _)| *made_of == of) {
            return made.clone();
        }
        // Made by all threads, none of which may wait for the lock.
        let made = make();
        *kept() = Some((of, made.clone()));
        made
    }
}
