//! The heaps of balls that give a puff its silhouette.
//!
//! A cumulus grows by thermals pushing out of thermals, so a puff is built the same way:
//! a few lobes placed by hand (the tile's character), smaller ones sprouting from
//! their outward sides, and again smaller ones from those. It is the self-similarity that
//! reads as cauliflower; noise alone gives a rough ball, and a lone sprite then reads as a disc.

use super::noise::{Vec3, hash3, unit};

#[derive(Clone, Copy)]
pub struct Lobe {
    pub centre: Vec3,
    pub radius: f32,
    /// 0 for a lobe placed by hand, 1 to 3 for what sprouted from it.
    pub generation: u32,
}

/// How many lobes sprout from each, and how large they are relative to it.
#[derive(Clone, Copy)]
pub struct Growth {
    pub children: u32,
    pub child_size: f32,
    pub grandchildren: u32,
    pub grandchild_size: f32,
}

/// `[x, y, radius]` of the lobes placed by hand, in any unit: the whole is fitted to `extent`.
pub fn grow(placed: &[[f32; 3]], growth: Growth, extent: f32, seed: u32) -> Vec<Lobe> {
    let mut lobes: Vec<Lobe> = placed
        .iter()
        .zip(0_u32..)
        .map(|(&[x, y, radius], index)| {
            // A little depth apart, so that one lobe's flank passes before another's.
            let depth = unit(hash3(index, 17, seed)[0]) - 0.5;
            Lobe { centre: [x, y, 0.7 * radius * depth], radius, generation: 0 }
        })
        .collect();
    let middle = centre_of_mass(&lobes);
    for (generation, count, size) in [
        (1, growth.children, growth.child_size),
        (2, growth.grandchildren, growth.grandchild_size),
        (3, growth.grandchildren / 2, growth.grandchild_size),
    ] {
        let parents: Vec<Lobe> = lobes.iter().copied().filter(|lobe| lobe.generation + 1 == generation).collect();
        for (parent, index) in parents.iter().zip(0_u32..) {
            for child in 0..count {
                let key = index.wrapping_mul(64).wrapping_add(child);
                lobes.push(sprout(parent, size, middle, generation, key, seed));
            }
        }
    }
    fit(&mut lobes, extent);
    lobes
}

fn sprout(parent: &Lobe, size: f32, middle: Vec3, generation: u32, key: u32, seed: u32) -> Lobe {
    let [a, b, c] = hash3(key, 101 + generation, seed);
    let [_, e, _] = hash3(key, 202 + generation, seed);
    let random = on_sphere(unit(a), unit(b));
    // Towards the outside of the whole puff: sprouts inside the mass would be wasted.
    let outward = normalise(sub(parent.centre, middle));
    // The smaller ones only a little, else they line up into horns.
    let pull = if generation == 1 { 0.55 } else { 0.2 };
    let direction =
        normalise([random[0] + pull * outward[0], random[1] + pull * outward[1], random[2] + pull * outward[2] + 0.15]);
    // Very unequal sizes: equal knobs read as popcorn.
    let t = unit(c);
    let radius = parent.radius * size * (0.5 + 1.2 * t * t * t);
    let sunk = if generation == 1 { 0.0 } else { 0.1 };
    let distance = parent.radius - radius * (0.4 * unit(e) + sunk);
    Lobe {
        centre: [
            parent.centre[0] + direction[0] * distance,
            parent.centre[1] + direction[1] * distance,
            parent.centre[2] + direction[2] * distance,
        ],
        radius,
        generation,
    }
}

/// Moves and scales the lobes so that the longer side of their outline just fills the extent.
fn fit(lobes: &mut [Lobe], extent: f32) {
    let mut low = [f32::MAX; 2];
    let mut high = [f32::MIN; 2];
    for lobe in lobes.iter() {
        for axis in 0..2 {
            low[axis] = low[axis].min(lobe.centre[axis] - lobe.radius);
            high[axis] = high[axis].max(lobe.centre[axis] + lobe.radius);
        }
    }
    let longest = (high[0] - low[0]).max(high[1] - low[1]).max(1e-3);
    let scale = 2.0 * extent / longest;
    for lobe in lobes.iter_mut() {
        for axis in 0..2 {
            let middle = 0.5 * (low[axis] + high[axis]);
            lobe.centre[axis] = (lobe.centre[axis] - middle) * scale;
        }
        lobe.centre[2] *= scale;
        lobe.radius *= scale;
    }
}

fn centre_of_mass(lobes: &[Lobe]) -> Vec3 {
    let (mut sum, mut weight) = ([0.0_f32; 3], 1e-6_f32);
    for lobe in lobes {
        let mass = lobe.radius * lobe.radius;
        for (total, coordinate) in sum.iter_mut().zip(lobe.centre) {
            *total += mass * coordinate;
        }
        weight += mass;
    }
    sum.map(|total| total / weight)
}

fn on_sphere(a: f32, b: f32) -> Vec3 {
    let z = 2.0 * a - 1.0;
    let ring = (1.0 - z * z).max(0.0).sqrt();
    let turn = b * (2.0 * core::f32::consts::PI);
    [ring * libm::cosf(turn), ring * libm::sinf(turn), z]
}

fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn normalise(v: Vec3) -> Vec3 {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    if length < 1e-5 {
        return [0.0; 3];
    }
    v.map(|coordinate| coordinate / length)
}
