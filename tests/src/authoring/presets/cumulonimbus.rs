//! The thunder cloud: a dark base with rain, a tower of great heaps, an anvil drawn out by the wind aloft.

use super::pile::{Pile, heap, pile};
use super::{Shot, one_cloud};
use crate::authoring::Sketch;
use crate::authoring::look::levels;
use crate::authoring::sketch::Strew;
use cloudwright_core::scene::{Category, Scene};
use glam::DVec3;

/// Where the anvil lies above the base.
const ANVIL_M: f64 = 6600.0;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Cumulonimbus", 67);
    // The lowest tenth is the rain.
    let levels = levels([
        (0.0, 0.21, 0.23, 0.28, 0.22),
        (0.10, 0.16, 0.18, 0.23, 0.75),
        (0.17, 0.19, 0.21, 0.27, 1.0),
        (0.42, 0.41, 0.44, 0.50, 1.0),
        (1.0, 0.58, 0.60, 0.64, 1.0),
    ]);
    let mut model = sketch.model("cumulonimbus", Category::Cumulonimbus, 1.0 / 4.5, levels);
    let rain = Strew {
        center: DVec3::new(200.0, -260.0, 100.0),
        size: DVec3::new(4000.0, 400.0, 2200.0),
        count: 26,
        sprite: [800.0, 1200.0],
        squash: 1.3,
        category: Category::Wisps,
        light: [0.0, 0.03, 0.10],
        pull: 0.0,
        lumps: [2, 1, 1],
        ..Strew::default()
    };
    sketch.strew(&mut model, "rain", rain);
    let underside = Strew {
        center: DVec3::Y * 430.0,
        size: DVec3::new(5700.0, 360.0, 3200.0),
        count: 48,
        sprite: [900.0, 1400.0],
        squash: 0.6,
        category: Category::Nimbostratus,
        light: [0.0, 0.05, 0.22],
        lumps: [4, 1, 2],
        pull: 0.5,
        ..Strew::default()
    };
    sketch.strew(&mut model, "underside", underside);
    let flat = Strew {
        center: DVec3::Y * 200.0,
        size: DVec3::new(5600.0, 30.0, 2800.0),
        count: 26,
        sprite: [900.0, 1050.0],
        squash: 1.0,
        category: Category::FlatBase,
        ..underside
    };
    sketch.strew(&mut model, "flat base", flat);
    let kind = Pile { height: 6500.0, squash: 0.92, category: Category::Cumulonimbus, count: 11 };
    // Three columns of unlike height that lean on one another, and turrets at their feet.
    let heaps = [
        heap([-700.0, 1050.0, 700.0], 1100.0, 2),
        heap([-1150.0, 2150.0, 300.0], 1350.0, 3),
        heap([-650.0, 3300.0, 400.0], 1200.0, 3),
        heap([-550.0, 4550.0, 150.0], 1250.0, 3),
        heap([-100.0, 5750.0, 0.0], 1300.0, 3),
        heap([700.0, 1650.0, 900.0], 1150.0, 3),
        heap([1700.0, 2300.0, 100.0], 1200.0, 3),
        heap([900.0, 2900.0, 500.0], 1100.0, 2),
        heap([1150.0, 4050.0, 250.0], 1250.0, 3),
        heap([1150.0, 5400.0, 100.0], 1250.0, 2),
        heap([200.0, 1800.0, -1000.0], 1500.0, 1),
        heap([300.0, 3600.0, -800.0], 1400.0, 1),
        heap([400.0, 5300.0, -700.0], 1400.0, 1),
        heap([-2350.0, 1150.0, 0.0], 1100.0, 3),
        heap([2600.0, 1050.0, 200.0], 1000.0, 3),
        heap([-3050.0, 600.0, 300.0], 600.0, 2),
        heap([1200.0, 750.0, 1100.0], 750.0, 1),
        heap([-1500.0, 720.0, 600.0], 780.0, 1),
    ];
    pile(&mut sketch, &mut model, &kind, &heaps);
    anvil(&mut sketch, &mut model);
    sketch.scene.time_of_day_h = 18.8;
    sketch.scene.sky.haze_length_m = 70_000.0;
    let shot = Shot { eye: [-4200.0, -500.0, 17_500.0], target: [1700.0, 3400.0, 0.0], field_of_view_deg: 33.0 };
    one_cloud(sketch, model, 1000.0, &shot)
}

/// A broad sheet of large, soft, flat tiles: thick above the tower, thin and torn downwind.
fn anvil(sketch: &mut Sketch, model: &mut cloudwright_core::scene::CloudModel) {
    // East, half width, thickness, count.
    let stations = [
        (-2700.0, 1900.0, 350.0, 16),
        (-700.0, 2700.0, 700.0, 22),
        (1400.0, 2900.0, 700.0, 22),
        (3500.0, 2700.0, 520.0, 22),
        (5600.0, 2300.0, 320.0, 20),
        (7600.0, 1700.0, 160.0, 16),
    ];
    for (i, (east, half_width, thickness, count)) in stations.into_iter().enumerate() {
        let share = i as f64 / 5.0;
        let side = 1900.0 + 300.0 * share;
        let center = DVec3::new(east, ANVIL_M + 120.0 * share, 0.0);
        sketch.strew(
            model,
            &format!("anvil {}", i + 1),
            Strew {
                center,
                size: DVec3::new(2200.0, thickness, half_width * 1.5),
                count,
                sprite: [side * 0.85, side * 1.35],
                squash: 0.46 - 0.14 * share,
                category: if i < 5 { Category::Nimbostratus } else { Category::Wisps },
                light: [0.03, 0.25, 0.92],
                // Seen from far below its middle, the whole sheet turns its side to a low sun alike: smooth.
                heart: Some(DVec3::new(1200.0, ANVIL_M - 1600.0, 0.0).lerp(center, 0.35)),
                lumps: [1, 1, 3],
                ..Strew::default()
            },
        );
    }
}
