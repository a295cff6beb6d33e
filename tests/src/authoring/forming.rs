//! Cumulus that come and go: one forms, one dissolves, and three stay, while the eye drifts past.

use super::Sketch;
use super::cumulus::{Cumulus, cumulus};
use cloudwright_core::scene::{Category, Formation, FormationChange, Scene};
use glam::DVec3;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Cumulus forming and dissolving", 31);
    let kinds = [
        (
            "mediocris",
            Category::CumulusCongestus,
            Cumulus {
                base: [500.0, 400.0],
                height: 560.0,
                heaps: 8,
                heap_radius: [115.0, 210.0],
                peak: 0.6,
                wisps: 2,
                crowns: 2,
                ..Cumulus::default()
            },
        ),
        (
            "humilis",
            Category::CumulusHumilis,
            Cumulus {
                base: [400.0, 280.0],
                height: 260.0,
                heaps: 7,
                heap_radius: [85.0, 150.0],
                peak: 0.45,
                wisps: 3,
                ..Cumulus::default()
            },
        ),
    ];
    let [mediocris, humilis] = kinds.map(|(name, category, kind)| cumulus(&mut sketch, name, category, &kind));
    let base = 1050.0;
    let forms = Formation { start_s: 2.0, core_s: 8.0, edges_s: 6.0, ..Formation::default() };
    let dissolves =
        Formation { change: FormationChange::Dissipating, start_s: 4.0, core_s: 7.0, edges_s: 7.0, ..forms };
    for (name, model, east, south, heading, scale, formation) in [
        ("dissolving", mediocris, -620.0, -1350.0, 25.0, 1.0, Some(dissolves)),
        ("forming", mediocris, 760.0, -1250.0, 200.0, 1.05, Some(forms)),
        ("between", humilis, 60.0, -2500.0, 80.0, 1.1, None),
        ("far left", humilis, -2300.0, -4200.0, 310.0, 1.3, None),
        ("far right", humilis, 2050.0, -4700.0, 140.0, 1.35, None),
    ] {
        let seed = Some(sketch.scene.clouds.len() as u64 + 1);
        sketch.place(model, name, DVec3::new(east, base, south), heading, scale, seed);
        if let Some(cloud) = sketch.scene.clouds.last_mut() {
            cloud.formation = formation;
        }
    }
    sketch.scene.time_of_day_h = 15.0;
    sketch.camera("main", DVec3::new(0.0, 900.0, 1150.0), DVec3::new(90.0, 1240.0, -1400.0), 38.0);
    sketch.camera("dissolving", DVec3::new(-900.0, 1000.0, 200.0), DVec3::new(-620.0, 1300.0, -1350.0), 50.0);
    sketch.camera("forming", DVec3::new(1100.0, 1450.0, 300.0), DVec3::new(760.0, 1260.0, -1250.0), 48.0);
    let keys = [
        (0.0, DVec3::new(-150.0, 900.0, 1300.0), [0.0, 8.0]),
        (8.0, DVec3::new(0.0, 930.0, 980.0), [2.0, 9.0]),
        (16.0, DVec3::new(120.0, 960.0, 660.0), [3.0, 10.0]),
    ];
    sketch.path("watch", 40.0, &keys);
    sketch.scene
}
