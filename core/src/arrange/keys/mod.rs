//! Keys of tracks, many at a time: set, moved, rippled, scaled, mirrored, copied, deleted.
//!
//! Each is a pure function of tracks and of the keys that are chosen to [`Rekeyed`]: whole tracks in place of the old
//! ones, and where the chosen keys stand in them. A drag starts anew from the tracks as they were when it began, so that
//! keys which it passes over come back.

mod clip;
mod order;
mod owned;
mod reshape;
mod ripple;
mod set;
mod slopes;
#[cfg(test)]
mod tests;

pub use clip::{copied, duplicated, pasted};
pub use order::{MOST_S, SAME_S, to_step};
pub use owned::cleared_of;
pub(super) use owned::{doomed, of_copies};
pub use reshape::{deleted, mirrored, moved, reshaped, scaled};
pub use ripple::{rippled, with_later};
pub use set::{cleared, keyed, next_key_s, removed};
pub use slopes::{Ease, eased, slopes_at};

use crate::document::{Edit, ListEdit};
use crate::scene::{Track, TrackId, TrackKey};
use std::collections::BTreeSet;

/// A key of a track, by its index.
pub type KeyPlace = (TrackId, usize);

/// Edits of tracks, and where what was chosen stands after them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Rekeyed {
    /// To be applied in order, as one transaction.
    pub edits: Vec<Edit>,
    /// The keys that were changed or made.
    pub chosen: BTreeSet<KeyPlace>,
}

impl Rekeyed {
    /// `track` is to have those keys, of which the marked ones are chosen.
    fn replace(&mut self, track: &Track, keys: Vec<(bool, TrackKey)>) {
        let (keys, chosen) = order::in_order(keys);
        self.chosen.extend(chosen.into_iter().map(|index| (track.id, index)));
        if keys.is_empty() {
            self.edits.push(Edit::Track(ListEdit::Remove(track.id)));
        } else if keys != track.keys {
            self.edits.push(Edit::Track(ListEdit::Replace(Track { keys, ..track.clone() })));
        }
    }
}

/// The track's keys, each with whether it is chosen.
fn marked(track: &Track, chosen: &BTreeSet<KeyPlace>) -> Vec<(bool, TrackKey)> {
    let keys = track.keys.iter().cloned().enumerate();
    keys.map(|(index, key)| (chosen.contains(&(track.id, index)), key)).collect()
}

/// Those of `tracks` that a chosen key is of.
fn touched<'t>(
    tracks: impl IntoIterator<Item = &'t Track>,
    chosen: &BTreeSet<KeyPlace>,
) -> impl Iterator<Item = &'t Track> {
    tracks.into_iter().filter(|track| chosen.range((track.id, 0)..=(track.id, usize::MAX)).next().is_some())
}
