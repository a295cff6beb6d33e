//! In what order one view draws sprites from frame to frame.
//!
//! Sorting each frame is right for each frame, and sprites that change places pop. W names the mend: keep the old order
//! for a while and cross-fade to the new one, at the price of drawing twice while it fades. Whatever the way, an order
//! is the place of every sprite, those out of view included: the head may turn before the next one is made.

use super::{DrawList, LastSort, Sorting};
use crate::camera::View;
use crate::sprites::PlacedCloud;
use crate::version::Version;
use std::sync::Arc;

/// Steps from one order to the next: half a second.
pub const FADE_STEPS: u32 = 30;

/// The place of every sprite from far to near, cloud by cloud.
#[derive(Debug, Clone, PartialEq)]
pub struct Ranks {
    pub(crate) of_cloud: Vec<Vec<u32>>,
}

/// The order that a view draws in, and the one that it comes from.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OrderMemory {
    version: Option<Version>,
    newest: Option<Arc<Ranks>>,
    /// Fades out.
    older: Option<Arc<Ranks>>,
    /// Steps since the newest was made.
    age: u32,
    last: LastSort,
}

impl OrderMemory {
    /// Goes on to `view` by `sorting`.
    pub fn step(&mut self, sorting: &Sorting, clouds: &[PlacedCloud], version: Version, view: &View) {
        if *sorting == Sorting::EachFrame {
            return;
        }
        let known = self.version == Some(version);
        let Some(newest) = self.newest.as_mut().filter(|_| known) else {
            let newest = Some(Arc::new(Ranks::from_afar(clouds, view)));
            *self = Self { version: Some(version), newest, last: LastSort::at(view), ..Self::default() };
            return;
        };
        self.age += 1;
        match sorting {
            Sorting::EachFrame => {}
            Sorting::Crossfade if self.age < FADE_STEPS => {}
            Sorting::Crossfade => {
                let next = Arc::new(Ranks::from_afar(clouds, view));
                self.older = Some(std::mem::replace(newest, next));
                self.age = 0;
            }
            Sorting::Lazy(lazy) => (lazy.step)(&mut self.last, Arc::make_mut(newest), clouds, view),
        }
    }

    /// The orders to draw in, the second with its share of the picture; none to sort by distance now.
    pub fn orders(&self) -> (Option<&Ranks>, Option<(&Ranks, f32)>) {
        let share = 1.0 - self.age as f32 / FADE_STEPS as f32;
        let older = self.older.as_deref().filter(|older| share > 0.0 && Some(*older) != self.newest.as_deref());
        (self.newest.as_deref(), older.map(|older| (older, share)))
    }
}

impl Ranks {
    /// All sprites by their distance from the eye.
    pub fn from_afar(clouds: &[PlacedCloud], view: &View) -> Self {
        let list = DrawList::of_all(clouds, view);
        let mut of_cloud: Vec<Vec<u32>> = clouds.iter().map(|cloud| vec![0; cloud.sprites.len()]).collect();
        for (drawn, place) in list.sprites.iter().zip(0..) {
            of_cloud[drawn.cloud as usize][drawn.sprite as usize] = place;
        }
        Self { of_cloud }
    }

    /// The place of a sprite; last for one that was not there.
    pub(super) fn of(&self, cloud: u32, sprite: u32) -> u32 {
        self.of_cloud.get(cloud as usize).and_then(|places| places.get(sprite as usize)).copied().unwrap_or(u32::MAX)
    }
}
