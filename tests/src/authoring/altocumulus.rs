//! Altocumulus stratiformis towards evening: flakes in ranks across the sky at 3,800 m, thin and torn at the field's
//! edges.

use super::far::{self, Far, Ring};
use super::{Sketch, by_plugin};
use cloudwright_core::scene::{ModelId, Scene};
use glam::DVec3;

const BASE_M: f64 = 3800.0;

/// Half extent of the field, east and south, and where its middle lies.
const FIELD_M: [f64; 2] = [8200.0, 8600.0];
const MIDDLE_M: [f64; 2] = [-700.0, -2300.0];

/// What a rank is like, full in the field's middle, thinner outwards: its name, and how the plugin's part makes it
/// (scripts/plugins/parts/altocumulus.rhai).
const GRADES: [(&str, &str); 3] = [
    ("full", r#"share: 0.97, length: [170, 340], category: "nimbostratus", count: 7, kernel: 5"#),
    ("thin", r#"share: 0.80, length: [130, 270], category: "nimbostratus", count: 6, kernel: 0"#),
    ("torn", r#"share: 0.60, length: [150, 300], category: "stratus", count: 5, kernel: 0"#),
];

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Altocumulus", 83);
    let ranks: Vec<Vec<ModelId>> = GRADES
        .iter()
        .map(|(name, grade)| {
            let call = |i| format!("rank(dice, \"{name} rank {i}\", #{{ {grade}, up: 0.0, flat: 1.0 }})");
            (1..=3).map(|i| by_plugin::model(&mut sketch, &["altocumulus", "boxes"], "", &call(i))).collect()
        })
        .collect();
    place_ranks(&mut sketch, &ranks);
    beyond(&mut sketch);
    let scene = &mut sketch.scene;
    scene.time_of_day_h = 19.0;
    scene.sky.haze_length_m = 60_000.0;
    sketch.camera("main", DVec3::new(1500.0, 300.0, 5200.0), DVec3::new(-600.0, 3700.0, -1200.0), 58.0);
    sketch.camera("sunward", DVec3::new(3000.0, 1200.0, 1500.0), DVec3::new(-3500.0, 3700.0, -600.0), 60.0);
    sketch.camera("above", DVec3::new(-2500.0, 5200.0, 4500.0), DVec3::new(300.0, 3800.0, -800.0), 50.0);
    sketch.scene
}

/// Where the ranks go on, up to 21 km away.
fn beyond(sketch: &mut Sketch) {
    let far = Far {
        category: "altocumulus",
        levels: "[[0.0, 0.40, 0.43, 0.50, 0.42], [0.3, 0.44, 0.47, 0.53, 0.56], [0.5, 0.50, 0.53, 0.58, 0.64], \
                 [0.75, 0.56, 0.58, 0.62, 0.64], [1.0, 0.60, 0.61, 0.64, 0.55]]",
        size: [5000.0, 2500.0],
        rolls: [4, 14],
        floor: 0,
        sprite: [280.0, 640.0],
        squash: 0.5,
        up: [20.0, 30.0],
        tiles: "altocumulus",
    };
    let middle = DVec3::new(MIDDLE_M[0], BASE_M, MIDDLE_M[1]);
    far::lay(sketch, &far, &Ring { middle, inner_m: 6600.0, outer_m: 21_000.0, heading_deg: 0.0, gaps: 0.35 });
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
