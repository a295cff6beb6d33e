//! A thunder cloud at dusk: a broad dark base, a tower of stacked heaps 7 km high, an anvil spread by the wind aloft,
//! and heaps of several ages beside it.

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
        heaps: 12,
        heap_radius: [420.0, 620.0],
        peak: 0.55,
        wisps: 2,
        crowns: 2,
        lean: 0.15,
        decay: 0.0,
    };
    let congestus = cumulus(&mut sketch, "congestus", Category::CumulusCongestus, &congestus);
    let mut small = |name, base, height, heap_radius, crowns, decay| {
        let kind = Cumulus { base, height, heaps: 7, heap_radius, peak: 0.5, wisps: 2, crowns, lean: 0.1, decay };
        cumulus(&mut sketch, name, Category::CumulusHumilis, &kind)
    };
    let small = [
        ("mediocris", small("mediocris", [680.0, 500.0], 620.0, [180.0, 270.0], 2, 0.0)),
        ("humilis", small("humilis", [900.0, 460.0], 300.0, [130.0, 210.0], 1, 0.0)),
        ("decaying", small("decaying", [760.0, 420.0], 480.0, [150.0, 250.0], 1, 0.75)),
    ];
    let base = 1000.0;
    sketch.place(tower, "cumulonimbus", DVec3::new(0.0, base, 0.0), 0.0, 1.0, None);
    sketch.place(congestus, "congestus south", DVec3::new(-5200.0, base, 2600.0), 40.0, 1.0, None);
    sketch.place(congestus, "congestus north", DVec3::new(5600.0, base, -3800.0), 200.0, 1.15, Some(2));
    for (i, (kind, east, south, scale)) in [
        (2, -3000.0, 6300.0, 0.9),
        (1, -8600.0, 4200.0, 1.25),
        (2, 4100.0, 2900.0, 1.1),
        (0, -7900.0, -1900.0, 1.35),
        (0, 9300.0, -400.0, 1.0),
        (1, 7100.0, 4700.0, 0.9),
    ]
    .into_iter()
    .enumerate()
    {
        let heading = sketch.roll(0.0, 360.0);
        let (name, model) = small[kind];
        let at = DVec3::new(east, base, south);
        sketch.place(model, &format!("{name} {}", i + 1), at, heading, scale, Some(i as u64 + 1));
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
