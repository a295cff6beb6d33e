//! Layer clouds: rolls, flakes, the grey sheet and the rain sheet.

use super::{Shot, one_cloud};
use crate::authoring::Sketch;
use crate::authoring::look::levels;
use crate::authoring::sketch::Strew;
use cloudwright_core::scene::{Category, Scene};
use glam::DVec3;

/// Three rolls of flattened heaps with gaps between them.
pub(super) fn stratocumulus() -> Scene {
    let mut sketch = Sketch::new("Stratocumulus", 43);
    let levels = levels([
        (0.0, 0.26, 0.30, 0.37, 0.90),
        (0.2, 0.31, 0.35, 0.42, 0.97),
        (0.45, 0.44, 0.48, 0.54, 1.0),
        (0.7, 0.54, 0.57, 0.61, 1.0),
        (1.0, 0.62, 0.64, 0.67, 1.0),
    ]);
    let mut model = sketch.model("stratocumulus", Category::Stratocumulus, 1.0 / 5.5, levels);
    // South, from and to along the roll.
    let rolls = [
        (-1000.0, -1050.0, 150.0),
        (-960.0, 420.0, 1150.0),
        (-430.0, -1350.0, -400.0),
        (-380.0, -150.0, 1300.0),
        (160.0, -1150.0, 480.0),
        (230.0, 760.0, 1350.0),
        (760.0, -700.0, 120.0),
        (740.0, 380.0, 1050.0),
    ];
    for (i, (south, from, to)) in rolls.into_iter().enumerate() {
        let length: f64 = to - from;
        let lumps = (length / 260.0).round().max(2.0);
        let base = Strew {
            center: DVec3::new((from + to) * 0.5, 60.0, south),
            size: DVec3::new(length, 30.0, 240.0),
            count: (lumps * 5.0) as u32,
            sprite: [250.0, 400.0],
            squash: 0.55,
            category: Category::Nimbostratus,
            light: [0.0, 0.10, 0.40],
            lumps: [lumps as u32, 1, 1],
            turn_deg: sketch.roll(-9.0, 9.0).round(),
            pull: 0.0,
            ..Strew::default()
        };
        sketch.strew(&mut model, &format!("roll {} base", i + 1), base);
        let body = Strew {
            center: base.center + DVec3::Y * 85.0,
            size: DVec3::new(length * 0.95, 100.0, 170.0),
            count: (lumps * 8.0) as u32,
            sprite: [170.0, 330.0],
            squash: 0.82,
            category: Category::Stratocumulus,
            light: [0.0, 0.26, 1.06],
            ..base
        };
        sketch.strew(&mut model, &format!("roll {} body", i + 1), body);
    }
    sketch.scene.time_of_day_h = 16.5;
    let shot = Shot { eye: [-700.0, -520.0, 2600.0], target: [0.0, 60.0, 0.0], field_of_view_deg: 41.0 };
    one_cloud(sketch, model, 1100.0, &shot)
}

/// Flakes in ranks, high up and seen from below.
pub(super) fn altocumulus() -> Scene {
    let mut sketch = Sketch::new("Altocumulus", 83);
    let levels = levels([
        (0.0, 0.44, 0.47, 0.54, 0.55),
        (0.3, 0.48, 0.51, 0.57, 0.72),
        (0.5, 0.53, 0.56, 0.60, 0.80),
        (0.75, 0.58, 0.60, 0.63, 0.78),
        (1.0, 0.62, 0.63, 0.65, 0.65),
    ]);
    let mut model = sketch.model("altocumulus", Category::Altocumulus, 1.0 / 5.5, levels);
    for rank in 0..7 {
        let south = (f64::from(rank) - 3.0) * 330.0;
        for flake in 0..7 {
            let east = (f64::from(flake) - 3.0) * 340.0 + f64::from(rank % 2) * 150.0 + sketch.roll(-60.0, 60.0);
            let length = sketch.roll(200.0, 340.0);
            // The patch is an oval.
            if (east / 1300.0).hypot(south / 1250.0) > 0.98 {
                continue;
            }
            let center = DVec3::new(east, sketch.roll(0.0, 25.0), south + sketch.roll(-60.0, 60.0));
            let flake_box = Strew {
                center,
                size: DVec3::new(length, 20.0, length * 0.55),
                count: 9,
                sprite: [length * 0.5, length * 1.0],
                squash: 0.66,
                category: Category::Altocumulus,
                light: [0.0, 0.26, 1.05],
                pull: 0.0,
                turn_deg: sketch.roll(-24.0, 24.0).round(),
                ..Strew::default()
            };
            sketch.strew(&mut model, &format!("flake {}.{}", rank + 1, flake + 1), flake_box);
        }
    }
    sketch.scene.time_of_day_h = 18.5;
    let shot = Shot { eye: [-300.0, -1500.0, 2300.0], target: [0.0, 0.0, 210.0], field_of_view_deg: 44.0 };
    one_cloud(sketch, model, 3400.0, &shot)
}

/// A soft grey sheet without form.
pub(super) fn stratus() -> Scene {
    let mut sketch = Sketch::new("Stratus", 5);
    let levels = levels([
        (0.0, 0.36, 0.39, 0.45, 0.55),
        (0.25, 0.40, 0.43, 0.49, 0.82),
        (0.5, 0.46, 0.49, 0.54, 0.92),
        (0.8, 0.54, 0.56, 0.59, 0.92),
        (1.0, 0.59, 0.60, 0.63, 0.78),
    ]);
    let mut model = sketch.model("stratus", Category::Stratus, 1.0 / 5.0, levels);
    let strew = Strew { squash: 0.4, pull: 0.0, lumps: [4, 1, 3], ..Strew::default() };
    let layers = [
        ("base", 30.0, 20.0, [2700.0, 1700.0], 120, [420.0, 700.0], Category::Stratus, [0.0, 0.10, 0.34]),
        ("top", 85.0, 24.0, [2500.0, 1500.0], 120, [380.0, 640.0], Category::Nimbostratus, [0.0, 0.22, 0.66]),
    ];
    for (name, y, thickness, [east, south], count, sprite, category, light) in layers {
        let (center, size) = (DVec3::Y * y, DVec3::new(east, thickness, south));
        sketch.strew(&mut model, name, Strew { center, size, count, sprite, category, light, ..strew });
    }
    for (name, at, turn_deg) in [
        ("edge east", [1500.0, 50.0, 100.0], 80.0),
        ("edge west", [-1500.0, 45.0, -100.0], -84.0),
        ("edge south", [100.0, 40.0, 980.0], 4.0),
        ("edge north", [-100.0, 40.0, -980.0], -3.0),
    ] {
        let edge = Strew {
            center: DVec3::from(at),
            size: DVec3::new(1700.0, 20.0, 260.0),
            count: 22,
            sprite: [300.0, 560.0],
            category: Category::Wisps,
            light: [0.0, 0.20, 0.7],
            lumps: [3, 1, 1],
            turn_deg,
            ..strew
        };
        sketch.strew(&mut model, name, edge);
    }
    sketch.scene.time_of_day_h = 9.0;
    sketch.scene.sky.turbidity = 3.5;
    sketch.scene.sky.haze_length_m = 12_000.0;
    let shot = Shot { eye: [-300.0, -270.0, 2300.0], target: [0.0, 20.0, 0.0], field_of_view_deg: 40.0 };
    one_cloud(sketch, model, 380.0, &shot)
}

/// A thick dark sheet with rain beneath and rags before it.
pub(super) fn nimbostratus() -> Scene {
    let mut sketch = Sketch::new("Nimbostratus", 19);
    let levels = levels([
        (0.0, 0.22, 0.24, 0.29, 0.10),
        (0.35, 0.17, 0.19, 0.24, 0.45),
        (0.55, 0.19, 0.21, 0.26, 0.98),
        (0.75, 0.27, 0.30, 0.35, 1.0),
        (1.0, 0.40, 0.42, 0.46, 1.0),
    ]);
    let mut model = sketch.model("nimbostratus", Category::Nimbostratus, 1.0 / 5.0, levels);
    let strew = Strew { squash: 0.5, pull: 0.1, lumps: [4, 1, 3], ..Strew::default() };
    let layers = [
        ("base", 60.0, 40.0, 110, [480.0, 800.0], Category::Nimbostratus, [0.0, 0.04, 0.14]),
        ("body", 230.0, 120.0, 100, [500.0, 820.0], Category::Nimbostratus, [0.0, 0.10, 0.34]),
        ("top", 390.0, 60.0, 60, [460.0, 820.0], Category::Nimbostratus, [0.0, 0.16, 0.6]),
    ];
    for (name, y, thickness, count, sprite, category, light) in layers {
        let (center, size) = (DVec3::Y * y, DVec3::new(2700.0, thickness, 1700.0));
        sketch.strew(&mut model, name, Strew { center, size, count, sprite, category, light, ..strew });
    }
    for (name, at) in [("rain west", [-560.0, -150.0, 100.0]), ("rain east", [640.0, -130.0, -150.0])] {
        let rain = Strew {
            center: DVec3::from(at),
            size: DVec3::new(1100.0, 260.0, 800.0),
            count: 30,
            sprite: [340.0, 520.0],
            squash: 1.5,
            category: Category::Wisps,
            light: [0.0, 0.02, 0.06],
            pull: 0.0,
            lumps: [2, 1, 1],
            ..strew
        };
        sketch.strew(&mut model, name, rain);
    }
    for (i, (at, length)) in
        [([-900.0, -60.0, 700.0], 420.0), ([300.0, -80.0, 800.0], 500.0), ([1000.0, -50.0, 600.0], 380.0)]
            .into_iter()
            .enumerate()
    {
        let rag = Strew {
            center: DVec3::from(at),
            size: DVec3::new(length, 40.0, 160.0),
            count: 12,
            sprite: [length * 0.3, length * 0.6],
            squash: 0.55,
            category: Category::Wisps,
            light: [0.0, 0.04, 0.10],
            lumps: [1, 1, 1],
            ..strew
        };
        sketch.strew(&mut model, &format!("rag {}", i + 1), rag);
    }
    sketch.scene.time_of_day_h = 11.0;
    sketch.scene.sky.turbidity = 6.0;
    sketch.scene.sky.haze_length_m = 9_000.0;
    let shot = Shot { eye: [-300.0, -420.0, 2700.0], target: [0.0, -10.0, 0.0], field_of_view_deg: 40.0 };
    one_cloud(sketch, model, 750.0, &shot)
}
