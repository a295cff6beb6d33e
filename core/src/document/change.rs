//! What a change touched, so that only that is computed and checked again.

use crate::scene::{AircraftId, CameraId, CloudId, ModelId, PathId};
use std::collections::BTreeSet;

/// The things that one or more edits touched.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Change {
    pub(super) everything: bool,
    pub(super) ground: bool,
    /// Name, hour, place, sun, sky or atlas.
    pub(super) head: bool,
    /// A list has more things or fewer, or the counter of ids was set.
    pub(super) lists: bool,
    pub(super) cameras: BTreeSet<CameraId>,
    pub(super) models: BTreeSet<ModelId>,
    pub(super) clouds: BTreeSet<CloudId>,
    pub(super) paths: BTreeSet<PathId>,
    pub(super) aircraft: BTreeSet<AircraftId>,
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

    /// Whether the scene's own values changed: name, hour, place, sun, sky, atlas.
    pub fn touches_head(&self) -> bool {
        self.everything || self.head
    }

    /// Whether there may be things that were not there before, or some no longer.
    pub fn touches_lists(&self) -> bool {
        self.everything || self.lists
    }

    /// Whether the camera changed.
    pub fn touches_camera(&self, id: CameraId) -> bool {
        self.everything || self.cameras.contains(&id)
    }

    /// Whether the path changed.
    pub fn touches_path(&self, id: PathId) -> bool {
        self.everything || self.paths.contains(&id)
    }

    /// Whether the aircraft changed.
    pub fn touches_aircraft(&self, id: AircraftId) -> bool {
        self.everything || self.aircraft.contains(&id)
    }

    /// Whether any cloud changed.
    pub fn touches_clouds(&self) -> bool {
        self.everything || !self.clouds.is_empty()
    }

    /// Whether any model changed.
    pub fn touches_models(&self) -> bool {
        self.everything || !self.models.is_empty()
    }

    /// Adds what `other` touched.
    pub fn join(&mut self, other: Self) {
        let Self { everything, ground, head, lists, cameras, models, clouds, paths, aircraft } = other;
        self.everything |= everything;
        self.ground |= ground;
        self.head |= head;
        self.lists |= lists;
        self.cameras.extend(cameras);
        self.models.extend(models);
        self.clouds.extend(clouds);
        self.paths.extend(paths);
        self.aircraft.extend(aircraft);
    }
}
