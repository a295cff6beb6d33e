//! Altocumulus stratiformis towards evening: flakes in ranks across the sky at 3,800 m, thin and torn at the field's
//! edges.

use super::Sketch;
use super::look::levels;
use super::sketch::Strew;
use cloudwright_core::scene::{Category, CloudModel, ModelId, Scene};
use glam::DVec3;

const BASE_M: f64 = 3800.0;

/// Half extent of the field, east and south, and where its middle lies.
const FIELD_M: [f64; 2] = [8200.0, 8600.0];
const MIDDLE_M: [f64; 2] = [-700.0, -2300.0];

/// What a rank is like: full in the field's middle, thinner outwards.
#[derive(Clone, Copy)]
struct Grade {
    name: &'static str,
    /// Share of the flakes that are there.
    cover: f64,
    /// Length of a flake, metres.
    flake: [f64; 2],
    category: Category,
    /// Sprites tried for each flake.
    count: u32,
    /// Harder ones in its middle.
    kernel: u32,
}

const GRADES: [Grade; 3] = [
    Grade { name: "full", cover: 0.97, flake: [170.0, 340.0], category: Category::Nimbostratus, count: 7, kernel: 5 },
    Grade { name: "thin", cover: 0.80, flake: [130.0, 270.0], category: Category::Nimbostratus, count: 6, kernel: 0 },
    Grade { name: "torn", cover: 0.60, flake: [150.0, 300.0], category: Category::Stratus, count: 5, kernel: 0 },
];

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Altocumulus", 83);
    let ranks: Vec<Vec<ModelId>> = GRADES
        .iter()
        .map(|&grade| {
            let variants = 0..3;
            variants
                .map(|i| {
                    let model = rank(&mut sketch, i, grade);
                    let id = model.id;
                    sketch.scene.models.push(model);
                    id
                })
                .collect()
        })
        .collect();
    place_ranks(&mut sketch, &ranks);
    let scene = &mut sketch.scene;
    scene.time_of_day_h = 19.0;
    scene.sky.haze_length_m = 60_000.0;
    sketch.camera("main", DVec3::new(1500.0, 300.0, 5200.0), DVec3::new(-600.0, 3700.0, -1200.0), 58.0);
    sketch.camera("sunward", DVec3::new(3000.0, 1200.0, 1500.0), DVec3::new(-3500.0, 3700.0, -600.0), 60.0);
    sketch.camera("above", DVec3::new(-2500.0, 5200.0, 4500.0), DVec3::new(300.0, 3800.0, -800.0), 50.0);
    sketch.scene
}

/// Ranks side by side over an oval field, bent a little, each moved along itself so that no columns show.
fn place_ranks(sketch: &mut Sketch, ranks: &[Vec<ModelId>]) {
    let mut number = 0;
    for row in 0..21 {
        let slide = sketch.roll(-1100.0, 1100.0);
        for column in 0..8 {
            let x = (f64::from(column) - 3.5) * 2150.0 + slide;
            let z = (f64::from(row) - 10.0) * 840.0 + (x / 2600.0).sin() * 170.0 + sketch.roll(-70.0, 70.0);
            // Here and there the middle is thin as well.
            let patchy = 0.16 * ((x / 1500.0).sin() + (z / 1900.0 + x / 4100.0).cos());
            let out = (x / FIELD_M[0]).hypot(z / FIELD_M[1]) + patchy + sketch.roll(-0.14, 0.14);
            let grade = match out {
                o if o > 1.08 => continue,
                o if o > 0.90 => 2,
                o if o > 0.66 => 1,
                _ => 0,
            };
            number += 1;
            let position = DVec3::new(x + MIDDLE_M[0], BASE_M + sketch.roll(-30.0, 30.0), z + MIDDLE_M[1]);
            let heading = sketch.roll(-5.0, 5.0) + if sketch.roll(0.0, 1.0) < 0.5 { 0.0 } else { 180.0 };
            let variants = &ranks[grade];
            let name = format!("rank {}.{}", row + 1, column + 1);
            let scale = sketch.roll(0.9, 1.12);
            sketch.place(variants[number % variants.len()], &name, position, heading, scale, Some(number as u64));
        }
    }
}

/// A rank of flakes, some 2.2 km long, in two rows. A flake is a few tiles nearly as large as itself that let light
/// through: only where they lie on one another is it dense, so its edge is thin.
fn rank(sketch: &mut Sketch, i: usize, grade: Grade) -> CloudModel {
    let levels = levels([
        (0.0, 0.40, 0.43, 0.50, 0.42),
        (0.3, 0.44, 0.47, 0.53, 0.56),
        (0.5, 0.50, 0.53, 0.58, 0.64),
        (0.75, 0.56, 0.58, 0.62, 0.64),
        (1.0, 0.60, 0.61, 0.64, 0.55),
    ]);
    let mut model = sketch.model(&format!("{} rank {}", grade.name, i + 1), Category::Altocumulus, 1.0 / 5.5, levels);
    for flake in 0..10 {
        for side in 0..2 {
            let there = sketch.roll(0.0, 1.0) < grade.cover;
            let length = sketch.roll(grade.flake[0], grade.flake[1]);
            let center = DVec3::new(
                (f64::from(flake) - 4.5) * 225.0 + sketch.roll(-60.0, 60.0),
                sketch.roll(0.0, 22.0),
                (f64::from(side) - 0.5) * 340.0 + sketch.roll(-60.0, 60.0) + f64::from(flake % 2) * 80.0,
            );
            let turn_deg = sketch.roll(-24.0, 24.0).round();
            if !there {
                continue;
            }
            let flake_box = Strew {
                center,
                size: DVec3::new(length * 1.0, 18.0, length * 0.5),
                count: grade.count,
                sprite: [length * 0.6, length * 1.15],
                squash: 0.64,
                category: grade.category,
                light: [0.0, 0.24, 0.98],
                pull: 0.0,
                turn_deg,
                ..Strew::default()
            };
            let name = format!("flake {}.{}", flake + 1, side + 1);
            sketch.strew(&mut model, &name, flake_box);
            // Every other one, so that some flakes are dense and some are not.
            if grade.kernel > 0 && (flake + side) % 2 == 0 {
                let kernel = Strew {
                    center: center + DVec3::Y * 12.0,
                    size: flake_box.size * 0.62,
                    count: grade.kernel,
                    sprite: [length * 0.34, length * 0.62],
                    category: Category::Altocumulus,
                    ..flake_box
                };
                sketch.strew(&mut model, &format!("kernel {}.{}", flake + 1, side + 1), kernel);
            }
        }
    }
    for veil in 0..2 {
        sketch.strew(
            &mut model,
            &format!("veil {}", veil + 1),
            Strew {
                center: DVec3::new((f64::from(veil) - 0.5) * 1100.0, -12.0, sketch.roll(-120.0, 120.0)),
                size: DVec3::new(1150.0, 16.0, 620.0),
                count: 9,
                sprite: [320.0, 560.0],
                squash: 0.7,
                category: Category::Wisps,
                light: [0.03, 0.26, 0.7],
                pull: 0.0,
                ..Strew::default()
            },
        );
    }
    model
}
