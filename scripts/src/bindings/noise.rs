//! Smooth noise: random values at the corners of a lattice of unit cubes, and Perlin's quintic between them.

use super::convert::{count, list, vector};
use super::{Answer, Usage};
use crate::error::Said;
use cloudwright_core::random::{draw, unit};
use rhai::{Array, Dynamic, Engine};

pub(super) const USAGE: &[Usage] = &[
    (
        "noise",
        "noise(seed, [x, y, z])",
        "From 0 to 1, smooth over about 1: divide places by the size of what you want.",
    ),
    ("noises", "noises(seed, places)", "The same for each of a list of places."),
];

/// Beyond, f64 has no room between the lattice's points.
const REACH: f64 = 1e9;

fn noise(seed: u64, place: [f64; 3]) -> Result<f64, Said> {
    if place.iter().any(|x| x.abs() > REACH) {
        return Err(Said::script("noise has no place so far out", "divide places by the size of what you want"));
    }
    let cell = place.map(f64::floor);
    let [x, y, z] = [0, 1, 2].map(|i| {
        let t = place[i] - cell[i];
        t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
    });
    let [i, j, k] = cell.map(|x| x as i64);
    let corner = |dx: i64, dy: i64, dz: i64| {
        let row = u64::from((i + dx) as u32) | u64::from((j + dy) as u32) << 32;
        unit(draw(seed, row, (k + dz) as u32, 0)[0])
    };
    let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
    let edge = |dy, dz| mix(corner(0, dy, dz), corner(1, dy, dz), x);
    let face = |dz| mix(edge(0, dz), edge(1, dz), y);
    Ok(mix(face(0), face(1), z))
}

pub(super) fn register(engine: &mut Engine) {
    engine.register_fn("noise", |seed: Dynamic, place: Dynamic| -> Answer<f64> {
        Ok(noise(count("the seed", &seed)?, vector("the place", &place)?)?)
    });
    engine.register_fn("noises", |seed: Dynamic, places: Dynamic| -> Answer<Array> {
        let seed = count("the seed", &seed)?;
        let each = |place: &Dynamic| noise(seed, vector("a place", place)?).map(Dynamic::from_float);
        Ok(list("the places", &places)?.iter().map(each).collect::<Result<_, _>>()?)
    });
}
