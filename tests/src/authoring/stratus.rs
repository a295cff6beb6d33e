//! Morning stratus in a basin: a thin, soft sheet some 120 m thick with a ragged edge and scraps beneath, an hour
//! after sunrise.

use super::Sketch;
use super::look::levels;
use super::sketch::Strew;
use cloudwright_core::color::{Rgb, Rgba};
use cloudwright_core::scene::{Category, CloudModel, DailyTable, ModelId, Scene};
use glam::DVec3;

const BASE_M: f64 = 330.0;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Morning stratus", 5);
    let sheets: Vec<_> = (0..4).map(|i| add(&mut sketch, |sketch| sheet(sketch, i))).collect();
    let edge = add(&mut sketch, fringe);
    let rags = add(&mut sketch, scraps);
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

/// Puts a model into the scene and gives its id.
fn add(sketch: &mut Sketch, make: impl FnOnce(&mut Sketch) -> CloudModel) -> ModelId {
    let model = make(sketch);
    let id = model.id;
    sketch.scene.models.push(model);
    id
}

/// The sun rises at a quarter to seven: an hour and a half later than in the midsummer of the default tables.
fn september_sun() -> DailyTable<Rgb> {
    DailyTable::new([
        (0.0, Rgb::new(0.010, 0.012, 0.018)),
        (6.3, Rgb::new(0.010, 0.012, 0.018)),
        (6.9, Rgb::new(0.88, 0.34, 0.15)),
        (7.8, Rgb::new(1.14, 0.68, 0.38)),
        (10.0, Rgb::new(0.92, 0.80, 0.65)),
        (13.0, Rgb::new(0.82, 0.76, 0.67)),
        (16.5, Rgb::new(0.90, 0.77, 0.60)),
        (18.4, Rgb::new(1.06, 0.60, 0.31)),
        (19.2, Rgb::new(0.90, 0.35, 0.15)),
        (19.8, Rgb::new(0.010, 0.012, 0.018)),
    ])
}

/// The sky's light of the same days.
fn september_ambient() -> DailyTable<Rgba> {
    DailyTable::new([
        (0.0, Rgba::new(0.016, 0.021, 0.036, 1.0)),
        (5.8, Rgba::new(0.030, 0.036, 0.060, 1.0)),
        (6.7, Rgba::new(0.20, 0.20, 0.29, 1.0)),
        (7.8, Rgba::new(0.39, 0.42, 0.54, 1.0)),
        (10.0, Rgba::new(0.56, 0.64, 0.78, 1.0)),
        (13.0, Rgba::new(0.61, 0.69, 0.83, 1.0)),
        (16.5, Rgba::new(0.56, 0.63, 0.77, 1.0)),
        (18.6, Rgba::new(0.38, 0.39, 0.54, 1.0)),
        (19.6, Rgba::new(0.20, 0.20, 0.32, 1.0)),
        (20.8, Rgba::new(0.030, 0.036, 0.060, 1.0)),
    ])
}

/// A piece of the sheet, 1.7 km across: a grey base of wisps, a paler top, and long low rolls on it.
fn sheet(sketch: &mut Sketch, i: usize) -> CloudModel {
    let levels = levels([
        (0.0, 0.34, 0.37, 0.44, 0.55),
        (0.25, 0.38, 0.41, 0.48, 0.80),
        (0.5, 0.44, 0.47, 0.53, 0.90),
        (0.8, 0.52, 0.54, 0.58, 0.92),
        (1.0, 0.58, 0.59, 0.62, 0.80),
    ]);
    let mut model = sketch.model(&format!("sheet {}", i + 1), Category::Stratus, 1.0 / 5.0, levels);
    let strew = Strew { squash: 0.40, pull: 0.0, lumps: [3, 1, 4], ..Strew::default() };
    let layers = [
        ("base", 30.0, 20.0, 90, [300.0, 520.0], Category::Stratus, [0.0, 0.10, 0.34]),
        ("top", 80.0, 24.0, 100, [260.0, 480.0], Category::Nimbostratus, [0.0, 0.22, 0.62]),
    ];
    for (name, y, thickness, count, sprite, category, light) in layers {
        let (center, size) = (DVec3::new(0.0, y, 0.0), DVec3::new(1600.0, thickness, 1500.0));
        sketch.strew(&mut model, name, Strew { center, size, count, sprite, category, light, ..strew });
    }
    for roll in 0..4 {
        let x = (f64::from(roll) - 1.5) * 400.0 + sketch.roll(-70.0, 70.0);
        let swell = sketch.roll(0.75, 1.2);
        let center = DVec3::new(x, 88.0 + 42.0 * swell, sketch.roll(-90.0, 90.0));
        sketch.strew(
            &mut model,
            &format!("roll {}", roll + 1),
            Strew {
                center,
                size: DVec3::new(120.0, 26.0, 1450.0),
                count: 56,
                sprite: [150.0 * swell, 330.0 * swell],
                squash: 0.42,
                category: Category::Nimbostratus,
                light: [0.0, 0.26, 1.12],
                lumps: [1, 1, 5],
                turn_deg: sketch.roll(-6.0, 6.0).round(),
                ..strew
            },
        );
    }
    model
}

/// Where the sheet ends: veils that let the ground through, drawn out along the edge.
fn fringe(sketch: &mut Sketch) -> CloudModel {
    let levels = levels([
        (0.0, 0.36, 0.39, 0.46, 0.25),
        (0.25, 0.40, 0.43, 0.50, 0.42),
        (0.5, 0.46, 0.49, 0.54, 0.50),
        (0.75, 0.52, 0.54, 0.58, 0.46),
        (1.0, 0.56, 0.58, 0.61, 0.36),
    ]);
    let mut model = sketch.model("fringe", Category::Wisps, 1.0 / 6.0, levels);
    for i in 0..4 {
        sketch.strew(
            &mut model,
            &format!("veil {}", i + 1),
            Strew {
                center: DVec3::new(sketch.roll(-500.0, 500.0), sketch.roll(30.0, 80.0), sketch.roll(-450.0, 450.0)),
                size: DVec3::new(900.0, 24.0, 380.0),
                count: 26,
                sprite: [190.0, 420.0],
                squash: 0.45,
                light: [0.0, 0.24, 0.85],
                category: Category::Wisps,
                pull: 0.0,
                lumps: [2, 1, 1],
                turn_deg: sketch.roll(-40.0, 40.0).round(),
                ..Strew::default()
            },
        );
    }
    model
}

/// Stratus fractus: torn scraps below the sheet.
fn scraps(sketch: &mut Sketch) -> CloudModel {
    let levels = levels([
        (0.0, 0.40, 0.43, 0.49, 0.35),
        (0.25, 0.44, 0.47, 0.53, 0.55),
        (0.5, 0.50, 0.53, 0.58, 0.65),
        (0.75, 0.55, 0.58, 0.62, 0.6),
        (1.0, 0.58, 0.60, 0.64, 0.5),
    ]);
    let mut model = sketch.model("scraps", Category::Wisps, 1.0 / 5.0, levels);
    for i in 0..3 {
        sketch.strew(
            &mut model,
            &format!("scrap {}", i + 1),
            Strew {
                center: DVec3::new(sketch.roll(-300.0, 300.0), sketch.roll(0.0, 50.0), sketch.roll(-300.0, 300.0)),
                size: DVec3::new(420.0, 30.0, 90.0),
                count: 11,
                sprite: [110.0, 200.0],
                squash: 0.6,
                category: Category::Wisps,
                light: [0.0, 0.3, 0.8],
                turn_deg: sketch.roll(-30.0, 30.0).round(),
                ..Strew::default()
            },
        );
    }
    model
}
