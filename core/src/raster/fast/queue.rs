//! Fragments that cross, put in order pixel by pixel before they are blended.
//!
//! They come in the tile's order. Each sinks past those behind it, lane by lane, until it stands where its own depth puts
//! it; once [`LENGTH`] of them wait, the nearest is blended. So what is out of place by less than that comes out in order,
//! and where nothing crosses a fragment costs one comparison. What gets through doesn't depend on the order, so a tile
//! knows it before they are blended, and stops as early as without a queue.

use super::super::bins::TILE;
use super::fragments::{Fragments, LANES, Lanes};
use super::tile::{Tile, bits};

/// Fragments that wait at each pixel, at most.
pub const LENGTH: usize = 4;

/// What waits at eight pixels.
#[derive(Debug, Clone, Copy)]
struct Waiting<const G: usize> {
    /// A ring, nearest first.
    slots: [Fragments<G>; LENGTH],
    first: usize,
    count: usize,
    /// What gets through to the first.
    before: Lanes,
}

/// A queue for each eight pixels of a tile.
#[derive(Debug)]
pub struct Queue<const G: usize> {
    groups: Vec<Waiting<G>>,
    /// For each row a bit for each group at which something waits.
    waiting: [u8; TILE],
}

impl<const G: usize> Default for Queue<G> {
    fn default() -> Self {
        let empty = Waiting { slots: [Fragments::NONE; LENGTH], first: 0, count: 0, before: [0.0; LANES] };
        Self { groups: vec![empty; TILE * TILE / LANES], waiting: [0; TILE] }
    }
}

impl<const G: usize> Queue<G> {
    /// Adds fragments at a group of a row behind what the tile shows already; gives what still gets through.
    #[inline(always)]
    pub fn push(&mut self, tile: &mut Tile<G>, (row, group): (usize, usize), mut fragments: Fragments<G>) -> Lanes {
        let at = row * TILE / LANES + group;
        let queue = &mut self.groups[at];
        if queue.count == 0 {
            queue.before = tile.through[at];
            self.waiting[row] |= 1 << group;
        }
        fragments.take(&mut tile.through[at]);
        let mut place = queue.count;
        while place > 0 {
            let before = &mut queue.slots[(queue.first + place - 1) % LENGTH];
            let nearer: [bool; LANES] = std::array::from_fn(|lane| fragments.nearness[lane] > before.nearness[lane]);
            if !nearer.iter().fold(false, |any, nearer| any | nearer) {
                break;
            }
            let mut behind = fragments;
            fragments = *before;
            // Where the new one is nearer it goes on, and what stood there goes behind it.
            fragments.swap(&mut behind, nearer);
            queue.slots[(queue.first + place) % LENGTH] = behind;
            place -= 1;
        }
        queue.slots[(queue.first + place) % LENGTH] = fragments;
        queue.count += 1;
        if queue.count == LENGTH {
            queue.blend_first(tile, at);
        }
        tile.through[at]
    }

    /// Blends all that waits at a group.
    #[inline(always)]
    pub fn flush(&mut self, tile: &mut Tile<G>, (row, group): (usize, usize)) {
        let at = row * TILE / LANES + group;
        self.waiting[row] &= !(1 << group);
        let queue = &mut self.groups[at];
        while queue.count > 0 {
            queue.blend_first(tile, at);
        }
    }

    /// Blends all that waits.
    pub fn flush_all(&mut self, tile: &mut Tile<G>) {
        for row in 0..TILE {
            for group in bits(self.waiting[row].into()) {
                self.flush(tile, (row, group));
            }
        }
    }
}

impl<const G: usize> Waiting<G> {
    #[inline(always)]
    fn blend_first(&mut self, tile: &mut Tile<G>, at: usize) {
        self.slots[self.first].blend(&mut tile.lights, at, &mut self.before);
        self.first = (self.first + 1) % LENGTH;
        self.count -= 1;
    }
}
