//! Morning stratus in a basin: a thin, soft sheet some 120 m thick with a ragged edge and scraps beneath, an hour
//! after sunrise.

use super::{Sketch, by_plugin};
use cloudwright_core::color::{Rgb, Rgba};
use cloudwright_core::scene::{DailyTable, Scene};
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
    scene.sky.ambient = september_ambient();
    scene.sky.directional = september_sun();
    scene.site.date.month = 9;
    sketch.camera("main", DVec3::new(-2700.0, 760.0, 2500.0), DVec3::new(600.0, 330.0, -1500.0), 52.0);
    sketch.camera("below", DVec3::new(-1500.0, 90.0, 1900.0), DVec3::new(200.0, 330.0, -600.0), 62.0);
    sketch.camera("sunward", DVec3::new(-2200.0, 560.0, 600.0), DVec3::new(2500.0, 420.0, 300.0), 55.0);
    sketch.scene
}

/// The sun rises at a quarter to seven: an hour and a half later than in the midsummer of the default tables.
fn september_sun() -> DailyTable<Rgb> {
    DailyTable::new([
        (0.0, Rgb::new(0.050, 0.060, 0.085)),
        (6.3, Rgb::new(0.010, 0.012, 0.018)),
        (6.9, Rgb::new(1.10, 0.42, 0.188)),
        (7.8, Rgb::new(1.42, 0.85, 0.47)),
        (10.0, Rgb::new(1.15, 1.00, 0.81)),
        (13.0, Rgb::new(1.02, 0.95, 0.84)),
        (16.5, Rgb::new(1.12, 0.96, 0.75)),
        (18.4, Rgb::new(1.33, 0.75, 0.39)),
        (19.2, Rgb::new(1.12, 0.44, 0.188)),
        (19.8, Rgb::new(0.010, 0.012, 0.018)),
    ])
}

/// The sky's light of the same days.
fn september_ambient() -> DailyTable<Rgba> {
    DailyTable::new([
        (0.0, Rgba::new(0.030, 0.036, 0.060, 1.0)),
        (5.8, Rgba::new(0.030, 0.036, 0.060, 1.0)),
        (6.7, Rgba::new(0.16, 0.16, 0.23, 1.0)),
        (7.8, Rgba::new(0.31, 0.34, 0.43, 1.0)),
        (10.0, Rgba::new(0.45, 0.51, 0.62, 1.0)),
        (13.0, Rgba::new(0.49, 0.55, 0.66, 1.0)),
        (16.5, Rgba::new(0.45, 0.50, 0.62, 1.0)),
        (18.6, Rgba::new(0.30, 0.31, 0.43, 1.0)),
        (19.6, Rgba::new(0.16, 0.16, 0.26, 1.0)),
        (20.8, Rgba::new(0.030, 0.036, 0.060, 1.0)),
    ])
}
