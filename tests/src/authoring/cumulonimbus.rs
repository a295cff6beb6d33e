//! A thunder cloud at dusk: a broad dark base, a tower of stacked heaps 7 km high, an anvil spread by the wind aloft,
//! and a congestus beside it.

use super::cumulus::{Cumulus, cumulus};
use super::{Sketch, by_plugin};
use cloudwright_core::scene::{Category, Scene};
use glam::DVec3;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Cumulonimbus at dusk", 67);
    let parts = ["cumulonimbus", "cumulus", "boxes"];
    let tower = by_plugin::model(&mut sketch, &parts, "", "cumulonimbus(dice, \"cumulonimbus\", 1.0, 1.0)");
    let congestus = Cumulus {
        base: [1500.0, 1100.0],
        height: 2300.0,
        heaps: 11,
        heap_radius: [420.0, 620.0],
        peak: 0.66,
        wisps: 2,
    };
    let congestus = cumulus(&mut sketch, "congestus", Category::CumulusCongestus, &congestus);
    let small =
        Cumulus { base: [620.0, 480.0], height: 420.0, heaps: 7, heap_radius: [170.0, 250.0], peak: 0.5, wisps: 1 };
    let small = cumulus(&mut sketch, "mediocris", Category::CumulusHumilis, &small);
    let base = 1000.0;
    sketch.place(tower, "cumulonimbus", DVec3::new(0.0, base, 0.0), 0.0, 1.0, None);
    sketch.place(congestus, "congestus south", DVec3::new(-5200.0, base, 2600.0), 40.0, 1.0, None);
    sketch.place(congestus, "congestus north", DVec3::new(5600.0, base, -3800.0), 200.0, 1.15, Some(2));
    for (i, (east, south, scale)) in [
        (-3300.0, 5200.0, 1.1),
        (-8200.0, 5200.0, 1.3),
        (3600.0, 4400.0, 1.0),
        (-7600.0, -600.0, 1.2),
        (8800.0, 1500.0, 1.3),
    ]
    .into_iter()
    .enumerate()
    {
        let heading = sketch.roll(0.0, 360.0);
        sketch.place(
            small,
            &format!("mediocris {}", i + 1),
            DVec3::new(east, base, south),
            heading,
            scale,
            Some(i as u64 + 1),
        );
    }
    sketch.scene.time_of_day_h = 20.4;
    sketch.scene.sky.haze_length_m = 90_000.0;
    sketch.scene.sky.turbidity = 3.0;
    sketch.camera("main", DVec3::new(-4500.0, 750.0, 15500.0), DVec3::new(900.0, 4300.0, 0.0), 46.0);
    sketch.camera("anvil", DVec3::new(-9000.0, 7600.0, 9000.0), DVec3::new(1000.0, 6800.0, 0.0), 50.0);
    sketch.camera("base", DVec3::new(-2500.0, 500.0, 6500.0), DVec3::new(300.0, 1900.0, 0.0), 60.0);
    sketch.camera("sunward", DVec3::new(9500.0, 2500.0, 8500.0), DVec3::new(0.0, 4400.0, 0.0), 52.0);
    sketch.scene
}
