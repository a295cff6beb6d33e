//! A stratocumulus deck: the scene that speed is measured on.
//!
//! Two hundred boxes in forty clouds over 4 km × 4 km, a hundred sprites each after culling, and from there on to 14 km a
//! seventh as many in large flat tiles. The deck is some 300 m thick: a level grey
//! base, rolls along the wind, and flattened heads on top with narrow gaps between the rolls.

use super::far::{self, Far, Ring};
use super::{Sketch, by_plugin};
use cloudwright_core::scene::Scene;
use glam::DVec3;

/// Forty cells: 8 rolls of 5.
const ROLLS: usize = 8;
const CELLS: usize = 5;
const EXTENT_M: f64 = 4000.0;
/// Models of cells within the deck, and of cells at its edge.
const INNER: usize = 7;
const EDGE: usize = 3;
const BASE_M: f64 = 900.0;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Stratocumulus overcast", 41);
    let models: Vec<_> = (0..INNER + EDGE)
        .map(|i| {
            let (kind, edge) = if i < INNER { ("cell", false) } else { ("edge cell", true) };
            let call = format!("cell(dice, \"{kind} {}\", 1.0, {edge})", i + 1);
            by_plugin::model(&mut sketch, &["deck", "boxes"], "", &call)
        })
        .collect();
    let (roll_width, cell_length) = (EXTENT_M / ROLLS as f64, EXTENT_M / CELLS as f64);
    for roll in 0..ROLLS {
        let slip = sketch.roll(-0.3, 0.3);
        for cell in 0..CELLS {
            let x = (cell as f64 + 0.5 + slip * 0.5) * cell_length - 0.5 * EXTENT_M;
            let z = (roll as f64 + 0.5) * roll_width - 0.5 * EXTENT_M + sketch.roll(-40.0, 40.0);
            let position = DVec3::new(x, BASE_M + sketch.roll(-20.0, 20.0), z);
            let heading = if sketch.roll(0.0, 1.0) < 0.5 { 0.0 } else { 180.0 } + sketch.roll(-8.0, 8.0);
            let number = roll * CELLS + cell;
            let at_edge = roll == 0 || roll == ROLLS - 1 || cell == 0 || cell == CELLS - 1;
            let model = if at_edge { models[INNER + number % EDGE] } else { models[(number * 3 + roll) % INNER] };
            sketch.place(
                model,
                &format!("roll {}, cell {}", roll + 1, cell + 1),
                position,
                heading,
                1.0,
                Some(number as u64 + 1),
            );
        }
    }
    beyond(&mut sketch);
    let scene = &mut sketch.scene;
    scene.time_of_day_h = 9.5;
    scene.sky.exposure_ev = -0.15;
    scene.sky.turbidity = 4.0;
    scene.sky.haze_length_m = 14_000.0;
    sketch.camera("main", DVec3::new(-1900.0, 1650.0, 2300.0), DVec3::new(300.0, 1050.0, -400.0), 50.0);
    sketch.camera("below", DVec3::new(-600.0, 420.0, 1300.0), DVec3::new(200.0, 900.0, -400.0), 62.0);
    sketch.camera("deck", DVec3::new(-300.0, 1330.0, 1500.0), DVec3::new(150.0, 1180.0, -900.0), 58.0);
    sketch.camera("within", DVec3::new(0.0, 1050.0, 200.0), DVec3::new(400.0, 1080.0, -900.0), 60.0);
    down(&mut sketch);
    sketch.scene
}

/// The deck as it goes on: in pieces of 2.6 km, and from 6 km on of 5 km.
fn beyond(sketch: &mut Sketch) {
    let levels = "[[0.0, 0.27, 0.31, 0.38, 0.85], [0.18, 0.32, 0.36, 0.43, 0.97], [0.45, 0.42, 0.46, 0.53, 1.0], \
                  [0.7, 0.49, 0.52, 0.57, 1.0], [1.0, 0.54, 0.56, 0.60, 0.95]]";
    let near = Far {
        category: "stratocumulus",
        levels,
        size: [2600.0, 2000.0],
        rolls: [4, 13],
        floor: 22,
        sprite: [380.0, 720.0],
        squash: 0.5,
        up: [170.0, 80.0],
        tiles: "stratocumulus",
    };
    let wide = Far { size: [5000.0, 3900.0], rolls: [4, 12], floor: 16, sprite: [760.0, 1400.0], squash: 0.28, ..near };
    let middle = DVec3::Y * BASE_M;
    let ring = Ring { middle, inner_m: 2150.0, outer_m: 7000.0, heading_deg: 0.0, gaps: 0.12 };
    far::lay(sketch, &near, &Ring { inner_m: 1800.0, ..ring });
    far::lay(sketch, &wide, &Ring { inner_m: 6000.0, outer_m: 14_000.0, gaps: 0.22, ..ring });
}

/// Over the tops, into the deck and out below it, at 90 to 100 m/s.
fn down(sketch: &mut Sketch) {
    let keys = [
        (0.0, DVec3::new(-300.0, 1330.0, 1500.0), [0.0, -2.0]),
        (4.0, DVec3::new(-200.0, 1270.0, 1140.0), [3.0, -1.0]),
        (8.0, DVec3::new(-90.0, 1130.0, 780.0), [-2.0, 4.0]),
        (12.0, DVec3::new(10.0, 960.0, 430.0), [2.0, 6.0]),
        (16.0, DVec3::new(90.0, 790.0, 80.0), [0.0, 10.0]),
    ];
    sketch.path("down", 58.0, &keys);
}
