//! Thinning: a candidate too close to one already kept is dropped (W).
//!
//! Candidates are walked in order, hand-moved ones first; those are never dropped. Each asks within *its own* radius.
//! Kept centres stand in an octree. A question passes over cubes that lie beyond the radius, and is answered at once by
//! one that lies within it, since no cube is empty; so time grows nearly with the number of candidates, not with its
//! square, whatever the mix of sizes. [`cull_slow`] asks all pairs and is the fast way's oracle.

use super::Candidate;
use crate::watch::Watch;
use glam::DVec3;

/// For each candidate whether it is kept. `radii` has one radius, in metres, for each candidate.
pub fn cull(candidates: &[Candidate], radii: &[f64]) -> Vec<bool> {
    cull_watched(candidates, radii, &Watch::default())
}

pub(super) fn cull_watched(candidates: &[Candidate], radii: &[f64], watch: &Watch) -> Vec<bool> {
    let mut kept = Octree::around(candidates.iter().map(|candidate| candidate.position));
    walk(candidates, radii, watch, |question| match question {
        Question::IsOneCloser(position, radius) => kept.any_closer(position, radius),
        Question::Keep(position) => {
            kept.insert(position);
            false
        }
    })
}

/// The same by asking all pairs: quadratic, plain, for tests.
pub fn cull_slow(candidates: &[Candidate], radii: &[f64]) -> Vec<bool> {
    let mut kept: Vec<DVec3> = Vec::new();
    walk(candidates, radii, &Watch::default(), |question| match question {
        Question::IsOneCloser(position, radius) => kept.iter().any(|other| is_closer(position, *other, radius)),
        Question::Keep(position) => {
            kept.push(position);
            false
        }
    })
}

enum Question {
    /// Is one that is kept closer to this point than this?
    IsOneCloser(DVec3, f64),
    /// One more is kept, here.
    Keep(DVec3),
}

fn walk(candidates: &[Candidate], radii: &[f64], watch: &Watch, mut ask: impl FnMut(Question) -> bool) -> Vec<bool> {
    let mut keep = vec![false; candidates.len()];
    for moved_ones in [true, false] {
        let of_this_turn = candidates.iter().enumerate().filter(|(_, c)| c.moved == moved_ones);
        for (i, candidate) in watch.along(super::CULLING, of_this_turn) {
            if moved_ones || !ask(Question::IsOneCloser(candidate.position, radii[i])) {
                keep[i] = true;
                ask(Question::Keep(candidate.position));
            }
        }
    }
    keep
}

/// Nothing is closer than 0, nor than what is no number.
fn is_closer(a: DVec3, b: DVec3, radius: f64) -> bool {
    a.distance_squared(b) < radius * radius
}

/// Points in cubes of powers of two at whole multiples of their size, so that a cube's bounds are exact.
struct Octree {
    points: Vec<DVec3>,
    /// For each point the next in its leaf.
    next: Vec<u32>,
    nodes: Vec<Node>,
    center: DVec3,
    half: f64,
}

/// A cube that holds at least one point.
#[derive(Clone, Copy)]
enum Node {
    /// Its first point, and how many.
    Leaf(u32, u32),
    /// The cubes of its octants, or [`NONE`].
    Split([u32; 8]),
}

const NONE: u32 = u32::MAX;
/// A leaf with more points is split.
const LEAF: u32 = 6;
/// No cube is split to a smaller half side, metres: points so close share a leaf.
const SMALLEST_HALF: f64 = 1.0 / 1024.0;

impl Octree {
    /// An empty tree for points within the bounds of these.
    fn around(points: impl Iterator<Item = DVec3>) -> Self {
        let reach = points.map(|point| point.abs().max_element()).fold(SMALLEST_HALF, f64::max);
        // Far beyond what a scene may hold; without an end, splitting would have none either.
        let half = libm::exp2(libm::ceil(libm::log2(reach.min(1e15))));
        Self { points: Vec::new(), next: Vec::new(), nodes: Vec::new(), center: DVec3::ZERO, half }
    }

    fn insert(&mut self, point: DVec3) {
        let index = self.points.len() as u32;
        self.points.push(point);
        self.next.push(NONE);
        if self.nodes.is_empty() {
            self.nodes.push(Node::Leaf(index, 1));
            return;
        }
        let (mut node, mut center, mut half) = (0, self.center, self.half);
        loop {
            match self.nodes[node] {
                Node::Leaf(first, count) if count < LEAF || half <= SMALLEST_HALF => {
                    self.next[index as usize] = first;
                    self.nodes[node] = Node::Leaf(index, count + 1);
                    return;
                }
                Node::Leaf(first, _) => self.split(node, first, center),
                Node::Split(mut children) => {
                    let octant = octant(point, center);
                    half *= 0.5;
                    center = child_center(center, half, octant);
                    if children[octant] == NONE {
                        children[octant] = self.nodes.len() as u32;
                        self.nodes.push(Node::Leaf(index, 1));
                        self.nodes[node] = Node::Split(children);
                        return;
                    }
                    node = children[octant] as usize;
                }
            }
        }
    }

    /// Deals a leaf's points out to its octants.
    fn split(&mut self, node: usize, first: u32, center: DVec3) {
        let mut children = [NONE; 8];
        let mut point = first;
        while point != NONE {
            let rest = self.next[point as usize];
            let octant = octant(self.points[point as usize], center);
            let (before, count) = match children[octant] {
                NONE => {
                    children[octant] = self.nodes.len() as u32;
                    self.nodes.push(Node::Leaf(NONE, 0));
                    (NONE, 0)
                }
                child => match self.nodes[child as usize] {
                    Node::Leaf(before, count) => (before, count),
                    Node::Split(_) => (NONE, 0),
                },
            };
            self.next[point as usize] = before;
            self.nodes[children[octant] as usize] = Node::Leaf(point, count + 1);
            point = rest;
        }
        self.nodes[node] = Node::Split(children);
    }

    fn any_closer(&self, position: DVec3, radius: f64) -> bool {
        !self.nodes.is_empty() && radius > 0.0 && self.any_closer_in(0, self.center, self.half, position, radius)
    }

    fn any_closer_in(&self, node: usize, center: DVec3, half: f64, position: DVec3, radius: f64) -> bool {
        let apart = (position - center).abs();
        if (apart - half).max(DVec3::ZERO).length_squared() >= radius * radius {
            return false;
        }
        if (apart + half).length_squared() < radius * radius {
            return true;
        }
        match self.nodes[node] {
            Node::Leaf(first, _) => {
                let mut point = first;
                while point != NONE {
                    if is_closer(position, self.points[point as usize], radius) {
                        return true;
                    }
                    point = self.next[point as usize];
                }
                false
            }
            Node::Split(children) => {
                let half = half * 0.5;
                let near = octant(position, center);
                // The octant that the point lies in first, then its neighbours.
                (0..8).map(|turn| near ^ turn).any(|octant| {
                    children[octant] != NONE
                        && self.any_closer_in(
                            children[octant] as usize,
                            child_center(center, half, octant),
                            half,
                            position,
                            radius,
                        )
                })
            }
        }
    }
}

/// Bits 0, 1 and 2: whether the point lies on the upper side of `center` along x, y and z.
fn octant(point: DVec3, center: DVec3) -> usize {
    usize::from(point.x >= center.x) | usize::from(point.y >= center.y) << 1 | usize::from(point.z >= center.z) << 2
}

fn child_center(center: DVec3, half: f64, octant: usize) -> DVec3 {
    let side = |bit: usize| if octant >> bit & 1 == 1 { half } else { -half };
    center + DVec3::new(side(0), side(1), side(2))
}
