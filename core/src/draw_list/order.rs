//! In what order one view draws sprites from frame to frame.
//!
//! Sorting each frame is right for each frame, and sprites that change places pop. W names the mend: keep the old order
//! for a while and cross-fade to the new one, at the price of drawing twice while it fades. Whatever the way, an order
//! is the place of every sprite, those out of view included: the head may turn before the next one is made.

use super::{LastSort, Ranks, Sorting};
use crate::camera::View;
use crate::sprites::{Known, Shapes};
use crate::weather::CloudNow;
use std::sync::Arc;

/// Steps from one order to the next: half a second.
pub const FADE_STEPS: u32 = 30;

/// The order that a view draws in, and the one that it comes from.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OrderMemory {
    shapes: Option<Shapes>,
    newest: Option<Arc<Ranks>>,
    /// Fades out.
    older: Option<Arc<Ranks>>,
    /// Steps since the newest was made.
    age: u32,
    last: LastSort,
}

impl OrderMemory {
    /// Goes on to `view` by `sorting`; it sees `clouds`, whose `shapes` are. The order holds through whatever leaves the
    /// clouds' sprites as they are, and through the loss of some; new ones have no place in it, so all are then sorted anew.
    pub fn step(&mut self, sorting: &Sorting, clouds: &[CloudNow<'_>], shapes: &Shapes, view: &View) {
        if *sorting == Sorting::EachFrame {
            return;
        }
        self.keep_to(shapes, clouds.len());
        let Some(newest) = self.newest.as_mut() else {
            let newest = Some(Arc::new(Ranks::from_afar(clouds, view)));
            *self = Self { shapes: Some(shapes.clone()), newest, last: LastSort::at(view), ..Self::default() };
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

    /// Forgets what is not of these clouds.
    fn keep_to(&mut self, shapes: &Shapes, cloud_count: usize) {
        let known = shapes.known_from(self.shapes.as_ref());
        if !matches!(known, Known::All) {
            let of_known = |ranks: Option<Arc<Ranks>>| Some(Arc::new(ranks?.of_known(&known, cloud_count)?));
            (self.newest, self.older) = (of_known(self.newest.take()), of_known(self.older.take()));
            self.shapes = Some(shapes.clone());
        }
    }

    /// The orders to draw in, the second with its share of the picture; none to sort by distance now.
    pub fn orders(&self) -> (Option<&Ranks>, Option<(&Ranks, f32)>) {
        let share = 1.0 - self.age as f32 / FADE_STEPS as f32;
        let older = self.older.as_deref().filter(|older| share > 0.0 && Some(*older) != self.newest.as_deref());
        (self.newest.as_deref(), older.map(|older| (older, share)))
    }
}
