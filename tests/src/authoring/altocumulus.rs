//! Altocumulus stratiformis towards evening: flakes in ranks across the sky at 3,800 m, thinning to one side.

use super::Sketch;
use super::look::levels;
use super::sketch::Strew;
use cloudwright_core::scene::{Category, CloudModel, Scene};
use glam::DVec3;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Altocumulus", 83);
    let ranks: Vec<_> = (0..4)
        .map(|i| {
            let model = rank(&mut sketch, i);
            let id = model.id;
            sketch.scene.models.push(model);
            id
        })
        .collect();
    let base = 3800.0;
    for row in 0..16 {
        for column in 0..6 {
            let number = row * 6 + column;
            // The field frays towards the east and the south.
            let edge = f64::from(column) / 5.0 + (f64::from(row) - 9.0).abs() / 14.0;
            if sketch.roll(0.0, 1.0) < edge - 0.75 {
                continue;
            }
            let x = (f64::from(column) - 3.0) * 2300.0 + sketch.roll(-260.0, 260.0) + f64::from(row) * 130.0;
            let z = (f64::from(row) - 10.0) * 760.0 + sketch.roll(-90.0, 90.0);
            let position = DVec3::new(x, base + sketch.roll(-40.0, 40.0), z);
            let heading = sketch.roll(-7.0, 7.0) + if sketch.roll(0.0, 1.0) < 0.5 { 0.0 } else { 180.0 };
            let name = format!("rank {}.{}", row + 1, column + 1);
            sketch.place(
                ranks[number as usize % 4],
                &name,
                position,
                heading,
                sketch.roll(0.9, 1.1),
                Some(number as u64 + 1),
            );
        }
    }
    let scene = &mut sketch.scene;
    scene.time_of_day_h = 19.0;
    scene.sky.haze_length_m = 70_000.0;
    sketch.camera("main", DVec3::new(1500.0, 300.0, 5200.0), DVec3::new(-600.0, 3700.0, -1200.0), 58.0);
    sketch.camera("sunward", DVec3::new(3000.0, 1200.0, 1500.0), DVec3::new(-3500.0, 3700.0, -600.0), 60.0);
    sketch.camera("above", DVec3::new(-2500.0, 5200.0, 4500.0), DVec3::new(300.0, 3800.0, -800.0), 50.0);
    sketch.scene
}

/// A rank of flakes, some 2.2 km long: each a small box, so each takes the sun by itself.
fn rank(sketch: &mut Sketch, i: usize) -> CloudModel {
    let levels = levels([
        (0.0, 0.46, 0.49, 0.55, 0.70),
        (0.25, 0.52, 0.55, 0.61, 0.85),
        (0.5, 0.60, 0.63, 0.67, 0.92),
        (0.8, 0.67, 0.69, 0.72, 0.92),
        (1.0, 0.71, 0.72, 0.74, 0.85),
    ]);
    let mut model = sketch.model(&format!("rank {}", i + 1), Category::Altocumulus, 1.0 / 5.0, levels);
    for flake in 0..9 {
        for side in 0..2 {
            let size = sketch.roll(150.0, 280.0);
            let center = DVec3::new(
                (f64::from(flake) - 4.0) * 250.0 + sketch.roll(-70.0, 70.0),
                sketch.roll(0.0, 30.0),
                (f64::from(side) - 0.5) * 380.0 + sketch.roll(-70.0, 70.0) + f64::from(flake % 2) * 90.0,
            );
            sketch.strew(
                &mut model,
                &format!("flake {}.{}", flake + 1, side + 1),
                Strew {
                    center,
                    size: DVec3::new(size, 36.0, size * 0.72),
                    count: 9,
                    sprite: [size * 0.42, size * 0.72],
                    squash: 0.85,
                    category: Category::Altocumulus,
                    light: [0.02, 0.36, 0.85],
                    pull: 0.0,
                    turn_deg: sketch.roll(0.0, 90.0).round(),
                    ..Strew::default()
                },
            );
        }
    }
    for veil in 0..2 {
        sketch.strew(
            &mut model,
            &format!("veil {}", veil + 1),
            Strew {
                center: DVec3::new((f64::from(veil) - 0.5) * 1100.0, -10.0, sketch.roll(-120.0, 120.0)),
                size: DVec3::new(1100.0, 20.0, 560.0),
                count: 12,
                sprite: [280.0, 460.0],
                squash: 0.5,
                category: Category::Wisps,
                light: [0.05, 0.3, 0.7],
                pull: 0.0,
                ..Strew::default()
            },
        );
    }
    model
}
