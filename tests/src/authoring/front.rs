//! A front passes in a minute and a half, as the plugin that ships has it (scripts/plugins/frontal_passage.rhai).

use super::{Sketch, by_plugin};
use cloudwright_core::scene::Scene;
use glam::DVec3;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("A front passes", 91);
    by_plugin::run(&mut sketch, "frontal_passage", &[("seed", "3"), ("center_z_m", "-1800")]);
    sketch.camera("main", DVec3::new(1800.0, 350.0, 3600.0), DVec3::new(-1500.0, 1650.0, -1800.0), 58.0);
    sketch.camera("east", DVec3::new(-2500.0, 500.0, 2500.0), DVec3::new(3500.0, 1600.0, 300.0), 58.0);
    sketch.camera("above", DVec3::new(2500.0, 3300.0, 5200.0), DVec3::new(-800.0, 1500.0, -800.0), 52.0);
    sketch.scene
}
