//! Morning stratus in a basin: a thin, soft sheet some 120 m thick with a ragged edge and scraps beneath, an hour
//! after sunrise.

use super::far::{self, Far, Ring};
use super::{Sketch, by_plugin};
use cloudwright_core::scene::Scene;
use glam::DVec3;

const BASE_M: f64 = 330.0;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Morning stratus", 5);
    let mut add = |call: &str| by_plugin::model(&mut sketch, &["stratus", "boxes"], "", call);
    let sheets = [1, 2, 3, 4].map(|i| add(&format!("sheet(dice, \"sheet {i}\", 1.0)")));
    let edge = add("fringe(dice, \"fringe\")");
    let rags = add("scraps(dice, \"scraps\")");
    let mut number = 0;
    for row in -1..7 {
        for column in -1..6 {
            // A bay without cloud in the south-west lets the ground show.
            let bay = (f64::from(row) - 6.2).hypot((f64::from(column) + 0.6) * 0.9);
            if bay < 2.6 {
                continue;
            }
            number += 1;
            let at = DVec3::new(
                f64::from(column - 2) * 1400.0 + f64::from(row % 2) * 300.0 + sketch.roll(-140.0, 140.0),
                BASE_M + sketch.roll(-10.0, 10.0),
                f64::from(row - 4) * 1320.0 + sketch.roll(-140.0, 140.0),
            );
            // The rolls lie across the wind, all nearly alike: they run on from sheet to sheet.
            let heading = sketch.roll(4.0, 22.0) + if number % 2 == 0 { 0.0 } else { 180.0 };
            let name = format!("sheet {number}");
            sketch.place(sheets[number % sheets.len()], &name, at, heading, 1.0, Some(number as u64));
            if bay < 4.1 {
                // Towards the bay the sheet thins out.
                let shore = at + DVec3::new(-900.0, -25.0, 900.0) * sketch.roll(0.5, 0.9);
                let turn = sketch.roll(-30.0, 30.0);
                sketch.place(edge, &format!("fringe {number}"), shore, turn, 1.0, Some(number as u64));
            }
        }
    }
    beyond(&mut sketch);
    let places = [(-1900.0, 300.0), (-900.0, 1500.0), (600.0, 900.0), (1700.0, 1900.0), (-2600.0, -900.0)];
    for (i, (x, z)) in places.into_iter().enumerate() {
        let heading = sketch.roll(0.0, 360.0);
        let at = DVec3::new(x, BASE_M - 80.0, z);
        sketch.place(rags, &format!("scraps {}", i + 1), at, heading, 1.0, Some(i as u64 + 1));
    }
    let scene = &mut sketch.scene;
    scene.time_of_day_h = 7.8;
    scene.sky.turbidity = 3.0;
    scene.sky.haze_length_m = 9_000.0;
    scene.site.date.month = 9;
    sketch.camera("main", DVec3::new(-2700.0, 760.0, 2500.0), DVec3::new(600.0, 330.0, -1500.0), 52.0);
    sketch.camera("below", DVec3::new(-1500.0, 90.0, 1900.0), DVec3::new(200.0, 330.0, -600.0), 62.0);
    sketch.camera("sunward", DVec3::new(-2200.0, 560.0, 600.0), DVec3::new(2500.0, 420.0, 300.0), 55.0);
    sketch.scene
}

/// The sheet as it goes on to 14 km, with bays of its own.
fn beyond(sketch: &mut Sketch) {
    let far = Far {
        category: "stratus",
        levels: "[[0.0, 0.34, 0.37, 0.44, 0.55], [0.25, 0.38, 0.41, 0.48, 0.80], [0.5, 0.44, 0.47, 0.53, 0.90], \
                 [0.8, 0.52, 0.54, 0.58, 0.92], [1.0, 0.58, 0.59, 0.62, 0.80]]",
        size: [4200.0, 3200.0],
        rolls: [5, 15],
        floor: 34,
        sprite: [520.0, 1050.0],
        squash: 0.17,
        up: [100.0, 30.0],
        tiles: "nimbostratus",
    };
    let middle = DVec3::new(0.0, BASE_M, -1300.0);
    far::lay(sketch, &far, &Ring { middle, inner_m: 5600.0, outer_m: 14_000.0, heading_deg: 103.0, gaps: 0.2 });
}
