//! Morning stratus in a basin: a thin, soft sheet some 120 m thick with a ragged edge and scraps beneath, an hour
//! after sunrise.

use super::Sketch;
use super::look::levels;
use super::sketch::Strew;
use cloudwright_core::scene::{Category, CloudModel, Scene};
use glam::DVec3;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Morning stratus", 5);
    let sheets: Vec<_> = (0..3)
        .map(|i| {
            let model = sheet(&mut sketch, i);
            let id = model.id;
            sketch.scene.models.push(model);
            id
        })
        .collect();
    let scraps = scraps(&mut sketch);
    let scraps_id = scraps.id;
    sketch.scene.models.push(scraps);
    let base = 330.0;
    for row in 0..6 {
        for column in 0..5 {
            // A bay without cloud in the south-west lets the ground show.
            if row >= 4 && column <= 1 {
                continue;
            }
            let (x, z) = (f64::from(column - 2) * 1450.0, f64::from(row - 4) * 1350.0);
            let number = row * 5 + column;
            let position = DVec3::new(
                x + sketch.roll(-160.0, 160.0),
                base + sketch.roll(-14.0, 14.0),
                z + sketch.roll(-160.0, 160.0),
            );
            let heading = sketch.roll(0.0, 360.0);
            let name = format!("sheet {}", number + 1);
            sketch.place(sheets[number as usize % 3], &name, position, heading, 1.0, Some(number as u64 + 1));
        }
    }
    for (i, (x, z)) in [(-1900.0, 300.0), (-900.0, 1500.0), (600.0, 900.0), (1700.0, 1900.0), (-2600.0, -900.0)]
        .into_iter()
        .enumerate()
    {
        let heading = sketch.roll(0.0, 360.0);
        sketch.place(
            scraps_id,
            &format!("scraps {}", i + 1),
            DVec3::new(x, base - 95.0, z),
            heading,
            1.0,
            Some(i as u64 + 1),
        );
    }
    let scene = &mut sketch.scene;
    scene.time_of_day_h = 7.9;
    scene.sky.turbidity = 3.0;
    scene.sky.haze_length_m = 9_000.0;
    scene.place.date.month = 9;
    scene.sky.exposure_ev = -0.3;
    sketch.camera("main", DVec3::new(-2700.0, 760.0, 2500.0), DVec3::new(600.0, 330.0, -1500.0), 52.0);
    sketch.camera("below", DVec3::new(-1500.0, 90.0, 1900.0), DVec3::new(200.0, 330.0, -600.0), 62.0);
    sketch.camera("sunward", DVec3::new(-2200.0, 560.0, 600.0), DVec3::new(2500.0, 420.0, 300.0), 55.0);
    sketch.scene
}

/// A piece of the sheet, 1.7 km across: a grey base of wisps, and a paler top that rolls a little.
fn sheet(sketch: &mut Sketch, i: usize) -> CloudModel {
    let levels = levels([
        (0.0, 0.42, 0.45, 0.51, 0.55),
        (0.25, 0.47, 0.50, 0.56, 0.80),
        (0.5, 0.55, 0.58, 0.63, 0.92),
        (0.8, 0.64, 0.66, 0.70, 0.96),
        (1.0, 0.70, 0.71, 0.74, 0.90),
    ]);
    let mut model = sketch.model(&format!("sheet {}", i + 1), Category::Stratus, 1.0 / 5.0, levels);
    let strew = Strew { squash: 0.42, pull: 0.0, lumps: [4, 1, 4], ..Strew::default() };
    sketch.strew(
        &mut model,
        "base",
        Strew {
            center: DVec3::new(0.0, 30.0, 0.0),
            size: DVec3::new(1650.0, 26.0, 1550.0),
            count: 130,
            sprite: [240.0, 380.0],
            light: [0.0, 0.14, 0.40],
            ..strew
        },
    );
    sketch.strew(
        &mut model,
        "top",
        Strew {
            center: DVec3::new(0.0, 95.0, 0.0),
            size: DVec3::new(1600.0, 44.0, 1500.0),
            count: 150,
            sprite: [200.0, 330.0],
            category: Category::Nimbostratus,
            light: [0.0, 0.36, 0.9],
            ..strew
        },
    );
    for roll in 0..4 {
        let z = (f64::from(roll) - 1.5) * 380.0 + sketch.roll(-60.0, 60.0);
        sketch.strew(
            &mut model,
            &format!("roll {}", roll + 1),
            Strew {
                center: DVec3::new(sketch.roll(-150.0, 150.0), 128.0, z),
                size: DVec3::new(1250.0, 26.0, 120.0),
                count: 34,
                sprite: [130.0, 220.0],
                squash: 0.5,
                category: Category::Nimbostratus,
                light: [0.0, 0.40, 1.0],
                lumps: [5, 1, 1],
                ..strew
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
