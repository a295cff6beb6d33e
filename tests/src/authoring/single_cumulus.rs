//! One well-grown summer cumulus, to look at from all sides.

use super::Sketch;
use super::cumulus::{Cumulus, cumulus};
use cloudwright_core::scene::{Category, Scene};
use glam::DVec3;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Single cumulus", 20);
    let kind = Cumulus {
        base: [640.0, 470.0],
        height: 860.0,
        heaps: 10,
        heap_radius: [165.0, 255.0],
        peak: 0.66,
        wisps: 3,
        crowns: 2,
        lean: 0.12,
        decay: 0.0,
    };
    let id = cumulus(&mut sketch, "cumulus", Category::CumulusCongestus, &kind);
    let base = 900.0;
    sketch.place(id, "cumulus", DVec3::new(0.0, base, 0.0), 20.0, 1.0, None);
    sketch.scene.time_of_day_h = 16.5;
    let middle = DVec3::new(0.0, base + 360.0, 0.0);
    sketch.camera("main", DVec3::new(-700.0, 820.0, 2300.0), middle, 30.0);
    sketch.camera("east", DVec3::new(2500.0, 1150.0, 300.0), middle, 30.0);
    sketch.camera("below", DVec3::new(-250.0, 350.0, 900.0), DVec3::new(0.0, base, 0.0), 55.0);
    sketch.camera("above", DVec3::new(1100.0, 2500.0, 1500.0), middle, 32.0);
    sketch.camera("close", DVec3::new(-520.0, 1300.0, 760.0), DVec3::new(0.0, base + 420.0, 0.0), 50.0);
    sketch.scene
}
