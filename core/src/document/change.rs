//! What a change touched, so that only that is computed again.

use crate::scene::{CloudId, ModelId};
use std::collections::BTreeSet;

/// The things that one or more edits touched.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Change {
    pub(super) everything: bool,
    pub(super) ground: bool,
    pub(super) models: BTreeSet<ModelId>,
    pub(super) clouds: BTreeSet<CloudId>,
}

impl Change {
    /// For a scene that is new.
    pub fn everything() -> Self {
        Self { everything: true, ..Self::default() }
    }

    /// Whether anything that sprites are made from changed.
    pub fn touches_sprites(&self) -> bool {
        self.everything || self.ground || !self.models.is_empty() || !self.clouds.is_empty()
    }

    /// Whether the cloud's placement changed.
    pub fn touches_cloud(&self, id: CloudId) -> bool {
        self.everything || self.clouds.contains(&id)
    }

    /// Whether the model changed.
    pub fn touches_model(&self, id: ModelId) -> bool {
        self.everything || self.models.contains(&id)
    }

    /// Whether the ground changed, on which sprites may stand.
    pub fn touches_ground(&self) -> bool {
        self.everything || self.ground
    }

    /// Adds what `other` touched.
    pub fn join(&mut self, other: Self) {
        self.everything |= other.everything;
        self.ground |= other.ground;
        self.models.extend(other.models);
        self.clouds.extend(other.clouds);
    }
}
