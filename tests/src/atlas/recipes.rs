//! What each of the sixteen tiles is: its lobes by hand, and the substance it is made of.

use super::density::{Puff, Substance};
use super::lobes::{Growth, grow};
use super::noise::hash3;
use super::wisp::Wisp;

pub enum Recipe {
    Wisp(Wisp),
    Puff(Puff),
}

/// `[x, y, half width, half height, strength]`: a bank drawn out, a feather, a torn sheet of fog.
const WISPS: [&[[f32; 5]]; 3] = [
    &[
        [-0.12, 0.16, 1.08, 0.50, 0.85],
        [0.22, -0.12, 1.03, 0.46, 0.85],
        [-0.30, -0.40, 0.74, 0.34, 0.60],
        [0.32, 0.44, 0.68, 0.32, 0.50],
    ],
    &[
        [-0.36, -0.22, 0.85, 0.57, 0.80],
        [0.10, 0.06, 1.08, 0.50, 0.80],
        [0.44, 0.34, 0.68, 0.39, 0.60],
        [0.14, -0.44, 0.68, 0.32, 0.45],
    ],
    &[
        [-0.22, 0.20, 0.97, 0.75, 0.80],
        [0.30, -0.08, 0.82, 0.64, 0.80],
        [-0.06, -0.44, 0.75, 0.43, 0.60],
        [0.16, 0.50, 0.64, 0.36, 0.50],
    ],
];

/// `[x, y, radius]`. The flat base: a broad ball with unequal crowns, cut below.
const FLAT_BASE: &[[f32; 3]] = &[
    [-0.04, 0.02, 0.68],
    [-0.60, -0.14, 0.40],
    [0.56, -0.10, 0.44],
    [-0.34, 0.34, 0.40],
    [0.24, 0.44, 0.40],
    [0.82, -0.22, 0.24],
];

const GENERAL: [&[[f32; 3]]; 4] = [
    // A lopsided mound.
    &[[-0.10, 0.02, 0.60], [0.38, -0.16, 0.46], [0.18, 0.38, 0.38], [-0.45, -0.28, 0.36]],
    // Two masses leaning together.
    &[[-0.32, 0.14, 0.52], [0.32, -0.12, 0.54], [0.0, -0.20, 0.44], [0.40, 0.34, 0.32]],
    // A broad bank.
    &[[-0.48, -0.04, 0.44], [-0.06, 0.10, 0.54], [0.42, -0.02, 0.48], [0.10, -0.24, 0.42]],
    // A wedge with a trailing end.
    &[[0.26, 0.22, 0.56], [-0.10, -0.05, 0.52], [-0.42, -0.36, 0.38], [0.42, -0.25, 0.40]],
];

const CUMULUS: [&[[f32; 3]]; 8] = [
    // A leaning tower with a head.
    &[[-0.12, -0.32, 0.54], [0.02, 0.05, 0.48], [0.14, 0.40, 0.40], [0.30, -0.34, 0.42], [-0.34, 0.02, 0.30]],
    // Two heads on one body.
    &[[0.0, -0.24, 0.50], [-0.36, 0.30, 0.38], [0.42, 0.20, 0.34], [-0.44, -0.22, 0.34]],
    // A broad bank.
    &[[-0.52, -0.08, 0.40], [-0.18, 0.10, 0.50], [0.25, 0.04, 0.52], [0.56, -0.08, 0.38], [0.05, -0.22, 0.40]],
    // A comma: all its weight on one side.
    &[[-0.20, 0.12, 0.62], [0.26, -0.10, 0.48], [0.46, -0.38, 0.32], [0.14, 0.44, 0.34]],
    // Three heads.
    &[[0.0, 0.0, 0.54], [0.04, 0.42, 0.38], [-0.38, -0.24, 0.44], [0.40, -0.22, 0.40]],
    // An arch with a bay in its flank.
    &[[-0.36, -0.24, 0.44], [-0.24, 0.20, 0.48], [0.20, 0.26, 0.50], [0.44, -0.08, 0.40], [0.02, -0.02, 0.40]],
    // The fullest: one great head with crowns.
    &[[0.02, -0.05, 0.68], [-0.32, 0.32, 0.42], [0.42, 0.22, 0.40], [0.18, -0.42, 0.40], [-0.48, -0.14, 0.36]],
    // A chain from large to small.
    &[[-0.30, -0.26, 0.54], [0.05, 0.04, 0.50], [0.32, 0.32, 0.38], [0.54, 0.50, 0.22], [0.20, -0.30, 0.36]],
];

pub fn recipe(tile: u32, seed: u32) -> Recipe {
    let own = hash3(tile, seed, 0xC10D)[0];
    match tile {
        0..=2 => Recipe::Wisp(wisp(tile, own)),
        3 => Recipe::Puff(flat_base(own)),
        4..=7 => Recipe::Puff(general(GENERAL[(tile % 4) as usize], own)),
        _ => Recipe::Puff(cumulus(CUMULUS[(tile % 8) as usize], own)),
    }
}

fn wisp(tile: u32, seed: u32) -> Wisp {
    let common = Wisp {
        patches: WISPS[(tile % 3) as usize],
        heading: 0.05,
        swirl: 0.3,
        comb: 0.5,
        frequency: 10.0,
        tear: 0.6,
        thickness: 1.1,
        seed,
    };
    match tile {
        0 => common,
        1 => Wisp { heading: 0.45, swirl: 0.35, comb: 0.65, frequency: 11.0, tear: 0.7, ..common },
        _ => Wisp { heading: -0.2, swirl: 0.9, comb: 0.3, frequency: 9.0, tear: 0.7, thickness: 1.15, ..common },
    }
}

fn flat_base(seed: u32) -> Puff {
    let growth = Growth { children: 8, child_size: 0.46, grandchildren: 3, grandchild_size: 0.45 };
    Puff {
        lobes: grow(FLAT_BASE, growth, 0.90, seed),
        substance: Substance {
            swell: 0.10,
            frequency: 3.4,
            haze: 0.25,
            edge: 0.09,
            tear: 0.3,
            extinction: 5.0,
            base: Some(-0.44),
            seed,
        },
    }
}

fn general(placed: &[[f32; 3]], seed: u32) -> Puff {
    let growth = Growth { children: 7, child_size: 0.54, grandchildren: 4, grandchild_size: 0.46 };
    Puff {
        lobes: grow(placed, growth, 0.94, seed),
        substance: Substance {
            swell: 0.16,
            frequency: 3.4,
            haze: 0.35,
            edge: 0.15,
            tear: 0.9,
            extinction: 5.0,
            base: None,
            seed,
        },
    }
}

fn cumulus(placed: &[[f32; 3]], seed: u32) -> Puff {
    let growth = Growth { children: 8, child_size: 0.56, grandchildren: 6, grandchild_size: 0.54 };
    Puff {
        lobes: grow(placed, growth, 0.88, seed),
        substance: Substance {
            swell: 0.11,
            frequency: 4.6,
            haze: 0.1,
            edge: 0.055,
            tear: 0.6,
            extinction: 10.0,
            base: None,
            seed,
        },
    }
}
