//! Torn rags of cloud (fractus): veils that let the sky through.

use super::{Shot, one_cloud};
use crate::authoring::Sketch;
use crate::authoring::look::levels;
use crate::authoring::sketch::Strew;
use cloudwright_core::scene::{Category, Scene};
use glam::DVec3;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Wisps", 71);
    let levels = levels([
        (0.0, 0.42, 0.45, 0.51, 0.45),
        (0.25, 0.46, 0.49, 0.54, 0.70),
        (0.5, 0.52, 0.54, 0.58, 0.80),
        (0.75, 0.57, 0.58, 0.61, 0.72),
        (1.0, 0.60, 0.61, 0.63, 0.55),
    ]);
    let mut model = sketch.model("wisps", Category::Wisps, 1.0 / 5.0, levels);
    // East, up, south, length, turn.
    let rags = [
        (-190.0, 150.0, 0.0, 360.0, 12.0),
        (130.0, 190.0, 40.0, 330.0, -12.0),
        (30.0, 70.0, 90.0, 300.0, 22.0),
        (330.0, 110.0, -40.0, 260.0, -8.0),
        (-380.0, 70.0, 40.0, 230.0, 18.0),
        (-90.0, 250.0, -60.0, 230.0, -20.0),
        (250.0, 20.0, 60.0, 170.0, 10.0),
    ];
    for (i, (east, up, south, length, turn_deg)) in rags.into_iter().enumerate() {
        let rag = Strew {
            center: DVec3::new(east, up, south),
            size: DVec3::new(length, length * 0.24, length * 0.4),
            count: 16,
            sprite: [length * 0.3, length * 0.75],
            squash: 0.62,
            category: Category::Wisps,
            light: [0.05, 0.36, 0.95],
            lumps: [2, 1, 1],
            turn_deg,
            ..Strew::default()
        };
        sketch.strew(&mut model, &format!("rag {}", i + 1), rag);
    }
    sketch.scene.time_of_day_h = 16.0;
    let shot = Shot { eye: [-150.0, -150.0, 1350.0], target: [0.0, 125.0, 0.0], field_of_view_deg: 28.0 };
    one_cloud(sketch, model, 800.0, &shot)
}
