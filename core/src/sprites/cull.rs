//! Thinning: a candidate too close to one already kept is dropped (W).
//!
//! Candidates are walked in order, hand-moved ones first; those are never dropped. Each asks within *its own* radius.
//! Kept centres are filed in grids whose cells are powers of two, one grid for each power that some radius needs, so a
//! question looks into at most 27 cells: time grows with the number of candidates, not with its square, whatever the
//! mix of sizes. [`cull_slow`] asks all pairs and is the fast way's oracle.

use super::Candidate;
use glam::DVec3;
use rustc_hash::FxHashMap;

/// For each candidate whether it is kept. `radii` has one radius, in metres, for each candidate.
pub fn cull(candidates: &[Candidate], radii: &[f64]) -> Vec<bool> {
    let mut grids = Grids::new(radii);
    walk(candidates, radii, |position, radius, kept| match kept {
        None => grids.any_closer(position, radius),
        Some(index) => {
            grids.insert(position, index);
            false
        }
    })
}

/// The same by asking all pairs: quadratic, plain, for tests.
pub fn cull_slow(candidates: &[Candidate], radii: &[f64]) -> Vec<bool> {
    let mut kept_positions: Vec<DVec3> = Vec::new();
    walk(candidates, radii, |position, radius, kept| match kept {
        None => kept_positions.iter().any(|other| closer(position, *other, radius)),
        Some(_) => {
            kept_positions.push(position);
            false
        }
    })
}

/// The walk itself. `ask(position, radius, None)`: is one kept already closer? `ask(position, _, Some(n))`: the n-th
/// is kept now.
fn walk(candidates: &[Candidate], radii: &[f64], mut ask: impl FnMut(DVec3, f64, Option<u32>) -> bool) -> Vec<bool> {
    let mut keep = vec![false; candidates.len()];
    let mut count = 0;
    for moved_ones in [true, false] {
        for (i, candidate) in candidates.iter().enumerate().filter(|(_, c)| c.moved == moved_ones) {
            if moved_ones || !ask(candidate.position, radii[i], None) {
                keep[i] = true;
                ask(candidate.position, radii[i], Some(count));
                count += 1;
            }
        }
    }
    keep
}

fn closer(a: DVec3, b: DVec3, radius: f64) -> bool {
    a.distance_squared(b) < radius * radius
}

/// No entry: the end of a cell's chain.
const END: u32 = u32::MAX;

struct Grids {
    positions: Vec<DVec3>,
    /// Rising sizes.
    levels: Vec<Level>,
}

/// With radii over more powers of two than this, neighbours share a grid: memory stays bounded.
const MOST_LEVELS: usize = 8;

/// One grid: cells of side `size`, each the head of a chain through `next`.
struct Level {
    size: f64,
    heads: FxHashMap<[i64; 3], u32>,
    next: Vec<u32>,
}

impl Grids {
    fn new(radii: &[f64]) -> Self {
        let mut sizes: Vec<f64> = radii.iter().filter(|r| **r > 0.0 && r.is_finite()).map(|&r| cell_size(r)).collect();
        sizes.sort_unstable_by(f64::total_cmp);
        sizes.dedup();
        // The largest of each run of neighbours serves them all.
        let run = sizes.len().div_ceil(MOST_LEVELS).max(1);
        let level =
            |sizes: &[f64]| Level { size: sizes[sizes.len() - 1], heads: FxHashMap::default(), next: Vec::new() };
        Self { positions: Vec::new(), levels: sizes.chunks(run).map(level).collect() }
    }

    fn any_closer(&self, position: DVec3, radius: f64) -> bool {
        // Nothing is closer than 0; and a radius that is no number drops nothing.
        if !(radius > 0.0 && radius.is_finite()) {
            return false;
        }
        let Some(level) = self.levels.iter().find(|level| level.size >= cell_size(radius)) else {
            return false;
        };
        let low = cell(position - DVec3::splat(radius), level.size);
        let high = cell(position + DVec3::splat(radius), level.size);
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let mut entry = level.heads.get(&[x, y, z]).copied().unwrap_or(END);
                    while entry != END {
                        if closer(position, self.positions[entry as usize], radius) {
                            return true;
                        }
                        entry = level.next[entry as usize];
                    }
                }
            }
        }
        false
    }

    fn insert(&mut self, position: DVec3, index: u32) {
        debug_assert_eq!(self.positions.len(), index as usize);
        self.positions.push(position);
        for level in &mut self.levels {
            let head = level.heads.entry(cell(position, level.size)).or_insert(END);
            level.next.push(*head);
            *head = index;
        }
    }
}

/// The power of two at or above twice the radius: a question then touches 8 cells, not 27. No cell is smaller than a
/// millimetre, so that cells have numbers wherever a sprite may lie.
fn cell_size(radius: f64) -> f64 {
    libm::exp2(libm::ceil(libm::log2(radius.max(1e-3) * 2.0)))
}

fn cell(position: DVec3, size: f64) -> [i64; 3] {
    let p = position / size;
    [libm::floor(p.x) as i64, libm::floor(p.y) as i64, libm::floor(p.z) as i64]
}
