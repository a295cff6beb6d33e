//! What a change touched, so that only that is computed and checked again.

use crate::scene::{CloudId, ModelId, Thing};
use std::collections::BTreeSet;

/// The things that one or more edits touched.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Change {
    pub(crate) everything: bool,
    pub(crate) ground: bool,
    /// Name, hour, place, sun, sky, weather or atlas.
    pub(crate) head: bool,
    /// What moves the clouds with the clock: the air, or a track.
    pub(crate) weather: bool,
    /// A list has more things or fewer, or the counter of ids was set.
    pub(crate) lists: bool,
    /// What stands in lists of the scene.
    pub(crate) things: BTreeSet<Thing>,
}

impl Change {
    /// For a scene that is new.
    pub fn everything() -> Self {
        Self { everything: true, ..Self::default() }
    }

    /// Of these models, and of nothing else.
    pub(crate) fn of_models(models: impl IntoIterator<Item = ModelId>) -> Self {
        Self { things: models.into_iter().map(Thing::Model).collect(), ..Self::default() }
    }

    /// Whether anything that is computed on the edit clock changed.
    pub fn touches_derived(&self) -> bool {
        self.touches_ground()
            || self.touches_models()
            || self.touches_clouds()
            || self.touches_folders()
            || self.touches_weather()
    }

    /// Whether what moves with the clock changed: the air, or a track.
    pub fn touches_weather(&self) -> bool {
        self.everything || self.weather
    }

    /// Whether the cloud's placement changed.
    pub fn touches_cloud(&self, id: CloudId) -> bool {
        self.touches(Thing::Cloud(id))
    }

    /// Whether the model changed.
    pub fn touches_model(&self, id: ModelId) -> bool {
        self.touches(Thing::Model(id))
    }

    /// Whether the ground changed, on which sprites may stand.
    pub fn touches_ground(&self) -> bool {
        self.everything || self.ground
    }

    /// Whether the scene's own values changed: name, hour, place, sun, sky, weather, atlas.
    pub fn touches_head(&self) -> bool {
        self.everything || self.head
    }

    /// Whether there may be things that were not there before, or some no longer.
    pub fn touches_lists(&self) -> bool {
        self.everything || self.lists
    }

    /// Whether `thing` changed, which stands in a list of the scene.
    pub fn touches(&self, thing: Thing) -> bool {
        self.everything || self.things.contains(&thing)
    }

    /// Whether any cloud changed.
    pub fn touches_clouds(&self) -> bool {
        self.everything || self.things.iter().any(|thing| matches!(thing, Thing::Cloud(_)))
    }

    /// Whether any folder changed, by which clouds are hidden.
    pub fn touches_folders(&self) -> bool {
        self.everything || self.things.iter().any(|thing| matches!(thing, Thing::Folder(_)))
    }

    /// Whether any model changed.
    pub fn touches_models(&self) -> bool {
        self.everything || self.things.iter().any(|thing| matches!(thing, Thing::Model(_)))
    }

    /// Adds what `other` touched.
    pub fn join(&mut self, other: Self) {
        let Self { everything, ground, head, weather, lists, things } = other;
        self.everything |= everything;
        self.ground |= ground;
        self.head |= head;
        self.weather |= weather;
        self.lists |= lists;
        self.things.extend(things);
    }
}
