//! Heap clouds: the small one of a fine day, the towering one, one of puffs alone, and the thunder cloud. What they
//! consist of stands in heaps.rhai.

use super::{Shot, one_cloud};
use crate::authoring::{Sketch, by_plugin};
use cloudwright_core::scene::{CloudModel, Scene};

fn model(sketch: &mut Sketch, function: &str) -> CloudModel {
    let source = include_str!("heaps.rhai");
    by_plugin::model(sketch, &["cumulus", "boxes"], source, &format!("{function}(dice)"))
}

/// Wider than high: a level base and low heads.
pub(super) fn humilis() -> Scene {
    let mut sketch = Sketch::new("Cumulus humilis", 31);
    let model = model(&mut sketch, "humilis");
    sketch.scene.time_of_day_h = 15.5;
    let shot = Shot { eye: [-260.0, -10.0, 1200.0], target: [0.0, 105.0, 0.0], field_of_view_deg: 28.0 };
    one_cloud(sketch, model, 900.0, &shot)
}

/// Higher than wide: a tower of heaps like a cauliflower.
pub(super) fn congestus() -> Scene {
    let mut sketch = Sketch::new("Cumulus congestus", 47);
    let model = model(&mut sketch, "congestus");
    sketch.scene.time_of_day_h = 16.5;
    let shot = Shot { eye: [-800.0, 40.0, 3100.0], target: [0.0, 650.0, 0.0], field_of_view_deg: 30.0 };
    one_cloud(sketch, model, 900.0, &shot)
}

/// Puffs alone: the hardest outline, round all over, with no torn edge.
pub(super) fn solid() -> Scene {
    let mut sketch = Sketch::new("Solid cumulus", 59);
    let model = model(&mut sketch, "solid");
    sketch.scene.time_of_day_h = 16.5;
    let shot = Shot { eye: [-500.0, 60.0, 1800.0], target: [0.0, 255.0, 0.0], field_of_view_deg: 30.0 };
    one_cloud(sketch, model, 900.0, &shot)
}

/// The thunder cloud: a dark base with rain, a tower of great heaps, an anvil drawn out by the wind aloft.
pub(super) fn cumulonimbus() -> Scene {
    let mut sketch = Sketch::new("Cumulonimbus", 67);
    let model = model(&mut sketch, "thunder_cloud");
    sketch.scene.time_of_day_h = 18.8;
    sketch.scene.sky.haze_length_m = 70_000.0;
    let shot = Shot { eye: [-4200.0, -500.0, 17_500.0], target: [1700.0, 3400.0, 0.0], field_of_view_deg: 33.0 };
    one_cloud(sketch, model, 1000.0, &shot)
}
