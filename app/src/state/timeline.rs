//! What of the timeline is worked on: chosen keys and tracks, what was copied, and values changed since they were keyed.
//! View state: never saved, never undone.

use super::selection::Choose;
use cloudwright_core::arrange::keys::{KeyPlace, Rekeyed};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::Target;
use cloudwright_core::scene::{Scene, TrackId};
use std::collections::BTreeSet;

/// The timeline as it is worked on.
#[derive(Debug, Clone, Default)]
pub struct TimelineView {
    /// Keys that are worked on.
    pub chosen: BTreeSet<KeyPlace>,
    /// Tracks that are worked on: those of chosen keys, and those chosen by their rows.
    pub tracks: BTreeSet<TrackId>,
    /// Whether what a hand changes about a keyed property sets a key.
    pub auto_key: bool,
    /// Whether curves are shown in place of rows of keys.
    pub curves: bool,
    /// Whether dragged keys take all later ones of their tracks along.
    pub ripple: bool,
    /// What dragged keys snap to.
    pub snap: TimeSnap,
    /// Counts how often all keys, or the chosen ones, were to be brought into sight.
    pub fit: u64,
    /// Counts how often the chosen tracks' rows were to be brought into sight.
    pub reveal: u64,
    /// Values that hands have changed beside their keys.
    unkeyed: Unkeyed,
}

/// What times snap to, besides keys and the clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TimeSnap {
    /// To nothing at all.
    Off,
    /// To 24 frames a second.
    #[default]
    Frames,
    /// To whole seconds.
    Seconds,
}

impl TimeSnap {
    /// From one to the next, and round.
    pub(crate) fn next(self) -> Self {
        match self {
            Self::Off => Self::Frames,
            Self::Frames => Self::Seconds,
            Self::Seconds => Self::Off,
        }
    }
}

/// Keyed properties whose value in the scene was changed without a key. They show it until the clock moves.
#[derive(Debug, Clone, Default)]
struct Unkeyed {
    clock_s: f64,
    targets: Vec<Target>,
}

/// What is asked of the timeline's view.
#[derive(Debug, Clone)]
pub(crate) enum TimelineChange {
    /// Choose keys.
    Keys(Vec<KeyPlace>, Choose),
    /// Choose tracks, and no keys of others.
    Tracks(Vec<TrackId>, Choose),
    /// A hand has changed keyed properties in the scene, not in their tracks.
    Unkeyed(Vec<Target>),
    /// What times snap to.
    Snap(TimeSnap),
    /// Bring the tracks of those properties into sight.
    Show(Vec<Target>),
}

impl TimelineView {
    /// Chooses keys, and with them their tracks.
    pub(crate) fn choose(&mut self, keys: &[KeyPlace], how: Choose) {
        if how == Choose::Only {
            self.chosen.clear();
        }
        for key in keys {
            if !self.chosen.insert(*key) && how == Choose::Toggle {
                self.chosen.remove(key);
            }
        }
        // Who works on curves keeps them in sight.
        if !self.curves {
            self.tracks.clear();
        }
        self.tracks.extend(self.chosen.iter().map(|(track, _)| *track));
    }

    /// No key and no track.
    pub(crate) fn choose_none(&mut self) {
        self.chosen.clear();
        self.tracks.clear();
    }

    /// Chooses tracks with none of their keys.
    pub(crate) fn choose_tracks(&mut self, tracks: &[TrackId], how: Choose) {
        if how == Choose::Only {
            self.tracks.clear();
        }
        for track in tracks {
            if !self.tracks.insert(*track) && how == Choose::Toggle {
                self.tracks.remove(track);
            }
        }
        self.chosen.retain(|(track, _)| self.tracks.contains(track));
    }

    /// A hand has changed those in the scene alone, with the clock there.
    pub(crate) fn changed_by_hand(&mut self, targets: Vec<Target>, clock_s: f64) {
        if self.unkeyed.clock_s != clock_s {
            self.unkeyed = Unkeyed { clock_s, targets: Vec::new() };
        }
        for target in targets {
            if !self.unkeyed.targets.contains(&target) {
                self.unkeyed.targets.push(target);
            }
        }
    }

    /// The tracks of what hands have changed beside them, with the clock there: by their properties' addresses.
    pub(crate) fn muted(&self, clock_s: f64) -> BTreeSet<String> {
        let targets = self.unkeyed.targets.iter().filter(|_| self.unkeyed.clock_s == clock_s);
        targets.map(Target::to_string).collect()
    }

    /// Whether the scene's own value of `target` is shown in place of its track's.
    pub(crate) fn is_unkeyed(&self, target: &Target, clock_s: f64) -> bool {
        self.unkeyed.clock_s == clock_s && self.unkeyed.targets.contains(target)
    }

    /// What is keyed is no longer changed since.
    pub(crate) fn was_keyed(&mut self, rekeyed: &Rekeyed) {
        let properties: BTreeSet<&str> = rekeyed.edits.iter().filter_map(property_of).collect();
        if !properties.is_empty() {
            self.unkeyed.targets.retain(|target| !properties.contains(target.to_string().as_str()));
        }
    }

    /// All show what their tracks say.
    pub(crate) fn forget_changes(&mut self) {
        self.unkeyed = Unkeyed::default();
    }

    /// Leaves out what the scene has no longer.
    pub(crate) fn keep_what_is_in(&mut self, scene: &Scene) {
        let count = |id: TrackId| scene.tracks.with_id(id).map_or(0, |track| track.keys.len());
        self.tracks.retain(|id| count(*id) > 0);
        self.chosen.retain(|(id, index)| *index < count(*id));
    }
}

fn property_of(edit: &Edit) -> Option<&str> {
    match edit {
        Edit::Track(ListEdit::Insert { value, .. } | ListEdit::Replace(value)) => Some(&value.property),
        _ => None,
    }
}
