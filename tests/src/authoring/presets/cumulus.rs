//! Heap clouds: the small one of a fine day, the towering one, and one of puffs alone.

use super::pile::{Pile, base, heap, pile, wisp};
use super::{Shot, one_cloud};
use crate::authoring::Sketch;
use crate::authoring::look::levels;
use cloudwright_core::scene::{Category, Scene};

/// Wider than high: a level base and low heads.
pub(super) fn humilis() -> Scene {
    let mut sketch = Sketch::new("Cumulus humilis", 31);
    let levels = levels([
        (0.0, 0.29, 0.33, 0.40, 0.94),
        (0.18, 0.34, 0.38, 0.45, 0.98),
        (0.4, 0.46, 0.49, 0.54, 1.0),
        (0.7, 0.55, 0.57, 0.60, 1.0),
        (1.0, 0.62, 0.63, 0.65, 1.0),
    ]);
    let mut model = sketch.model("cumulus humilis", Category::CumulusHumilis, 1.0 / 4.5, levels);
    base(&mut sketch, &mut model, [340.0, 220.0], 150.0, [34, 14]);
    let kind = Pile { height: 260.0, squash: 0.8, category: Category::CumulusHumilis, count: 13 };
    let heaps = [
        heap([-40.0, 150.0, -20.0], 130.0, 4),
        heap([140.0, 120.0, 50.0], 105.0, 3),
        heap([-200.0, 105.0, 40.0], 100.0, 3),
        heap([50.0, 110.0, 120.0], 95.0, 2),
        heap([260.0, 85.0, -50.0], 85.0, 2),
        heap([-300.0, 75.0, -30.0], 70.0, 1),
        heap([60.0, 110.0, -150.0], 95.0, 1),
    ];
    pile(&mut sketch, &mut model, &kind, &heaps);
    wisp(&mut sketch, &mut model, "wisp east", [330.0, 95.0, 60.0], 170.0);
    wisp(&mut sketch, &mut model, "wisp west", [-350.0, 85.0, 30.0], 170.0);
    sketch.scene.time_of_day_h = 15.5;
    let shot = Shot { eye: [-260.0, -10.0, 1200.0], target: [0.0, 105.0, 0.0], field_of_view_deg: 28.0 };
    one_cloud(sketch, model, 900.0, &shot)
}

/// Higher than wide: a tower of heaps like a cauliflower.
pub(super) fn congestus() -> Scene {
    let mut sketch = Sketch::new("Cumulus congestus", 47);
    let levels = levels([
        (0.0, 0.21, 0.25, 0.32, 0.97),
        (0.10, 0.26, 0.30, 0.37, 1.0),
        (0.32, 0.41, 0.45, 0.50, 1.0),
        (0.65, 0.52, 0.54, 0.57, 1.0),
        (1.0, 0.61, 0.62, 0.64, 1.0),
    ]);
    let mut model = sketch.model("cumulus congestus", Category::CumulusCongestus, 1.0 / 4.5, levels);
    base(&mut sketch, &mut model, [720.0, 440.0], 290.0, [38, 22]);
    let kind = Pile { height: 1350.0, squash: 0.9, category: Category::Cumulonimbus, count: 13 };
    let heaps = [
        heap([60.0, 1180.0, -20.0], 255.0, 5),
        heap([-150.0, 960.0, 60.0], 280.0, 4),
        heap([190.0, 860.0, 30.0], 300.0, 4),
        heap([-230.0, 640.0, -60.0], 300.0, 3),
        heap([140.0, 520.0, 190.0], 300.0, 3),
        heap([-150.0, 310.0, 230.0], 290.0, 3),
        heap([130.0, 230.0, 240.0], 250.0, 2),
        heap([450.0, 310.0, -40.0], 280.0, 4),
        heap([-450.0, 290.0, 30.0], 270.0, 4),
        heap([40.0, 620.0, -240.0], 320.0, 2),
        heap([0.0, 260.0, -260.0], 300.0, 1),
        heap([-650.0, 150.0, -40.0], 150.0, 2),
        heap([640.0, 160.0, 60.0], 160.0, 2),
    ];
    pile(&mut sketch, &mut model, &kind, &heaps);
    wisp(&mut sketch, &mut model, "wisp", [560.0, 240.0, -120.0], 330.0);
    sketch.scene.time_of_day_h = 16.5;
    let shot = Shot { eye: [-800.0, 40.0, 3100.0], target: [0.0, 650.0, 0.0], field_of_view_deg: 30.0 };
    one_cloud(sketch, model, 900.0, &shot)
}

/// Puffs alone: the hardest outline, round all over, with no torn edge.
pub(super) fn solid() -> Scene {
    let mut sketch = Sketch::new("Solid cumulus", 59);
    let levels = levels([
        (0.0, 0.24, 0.28, 0.36, 1.0),
        (0.12, 0.30, 0.34, 0.41, 1.0),
        (0.34, 0.45, 0.48, 0.53, 1.0),
        (0.6, 0.56, 0.58, 0.60, 1.0),
        (1.0, 0.64, 0.65, 0.66, 1.0),
    ]);
    let mut model = sketch.model("solid cumulus", Category::SolidCumulus, 1.0 / 4.5, levels);
    base(&mut sketch, &mut model, [490.0, 320.0], 200.0, [34, 20]);
    let kind = Pile { height: 560.0, squash: 0.92, category: Category::SolidCumulus, count: 14 };
    let heaps = [
        heap([-190.0, 350.0, -20.0], 210.0, 4),
        heap([160.0, 390.0, -10.0], 225.0, 5),
        heap([-10.0, 240.0, 170.0], 215.0, 4),
        heap([-400.0, 170.0, 40.0], 170.0, 3),
        heap([390.0, 180.0, 10.0], 185.0, 3),
        heap([-230.0, 170.0, 190.0], 150.0, 2),
        heap([250.0, 160.0, 200.0], 150.0, 2),
        heap([30.0, 240.0, -220.0], 230.0, 2),
    ];
    pile(&mut sketch, &mut model, &kind, &heaps);
    sketch.scene.time_of_day_h = 16.5;
    let shot = Shot { eye: [-500.0, 60.0, 1800.0], target: [0.0, 255.0, 0.0], field_of_view_deg: 30.0 };
    one_cloud(sketch, model, 900.0, &shot)
}
