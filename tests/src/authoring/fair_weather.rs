//! A summer afternoon: two dozen heaps of several kinds under one base altitude.

use super::Sketch;
use super::cumulus::{Cumulus, cumulus};
use cloudwright_core::scene::{Aircraft, AircraftId, Category, Scene};
use glam::DVec3;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Fair-weather cumulus", 28);
    let kinds = [
        ("humilis", Category::CumulusHumilis, cumulus_of([330.0, 250.0], 230.0, 6, [80.0, 135.0], 0.45, 2)),
        (
            "broad humilis",
            Category::CumulusHumilis,
            twin(cumulus_of([600.0, 330.0], 270.0, 10, [85.0, 165.0], 0.40, 3)),
        ),
        ("mediocris", Category::CumulusCongestus, twin(cumulus_of([540.0, 420.0], 540.0, 9, [115.0, 215.0], 0.62, 2))),
        ("towering", Category::CumulusCongestus, twin(cumulus_of([680.0, 520.0], 1080.0, 11, [150.0, 265.0], 0.74, 2))),
        ("scrap", Category::CumulusHumilis, cumulus_of([200.0, 130.0], 120.0, 4, [50.0, 85.0], 0.3, 2)),
        (
            "leaning congestus",
            Category::CumulusCongestus,
            Cumulus { lean: 0.4, ..cumulus_of([520.0, 330.0], 760.0, 8, [120.0, 220.0], 0.70, 3) },
        ),
        (
            "decaying",
            Category::CumulusHumilis,
            Cumulus { decay: 0.7, ..cumulus_of([480.0, 330.0], 420.0, 8, [110.0, 190.0], 0.55, 3) },
        ),
    ];
    let models: Vec<_> =
        kinds.iter().map(|(name, category, kind)| cumulus(&mut sketch, name, *category, kind)).collect();
    let base = 1100.0;
    // Kind, east, south, scale: hand-placed, so that the main view has a foreground, a hero and a far row.
    let placements = [
        (3, 350.0, -1900.0, 1.0),
        (2, -1750.0, -1500.0, 1.0),
        (1, 1900.0, -900.0, 1.05),
        (4, -650.0, -650.0, 1.1),
        (0, 900.0, 150.0, 1.0),
        (6, 1550.0, -1750.0, 0.9),
        (0, -2700.0, -300.0, 1.1),
        (1, -900.0, -3600.0, 1.15),
        (5, 2700.0, -3300.0, 1.1),
        (0, -3600.0, -2600.0, 1.2),
        (6, -2300.0, -2700.0, 1.0),
        (5, -2900.0, -5200.0, 1.2),
        (3, 3900.0, -5600.0, 0.95),
        (1, 900.0, -5600.0, 1.2),
        (0, 4600.0, -2600.0, 1.2),
        (4, 3400.0, -1500.0, 1.2),
        (1, -5200.0, -4700.0, 1.2),
        (5, -1100.0, -7800.0, 1.3),
        (6, 2500.0, -8300.0, 1.3),
        (3, -5200.0, -8000.0, 1.05),
        (0, -1500.0, 1500.0, 1.1),
        (1, 2000.0, 1700.0, 1.0),
        (2, -3200.0, 2400.0, 1.0),
        (0, 200.0, 2900.0, 1.2),
        (1, 6200.0, -7600.0, 1.3),
        (2, 400.0, -11200.0, 1.4),
    ];
    for (i, (kind, east, south, scale)) in placements.into_iter().enumerate() {
        // The tallest shows its crowns side by side to the main camera.
        let heading = if i == 0 { 215.0 } else { sketch.roll(0.0, 360.0) };
        let drop = sketch.roll(-25.0, 25.0);
        let name = format!("{} {}", kinds[kind].0, i + 1);
        sketch.place(models[kind], &name, DVec3::new(east, base + drop, south), heading, scale, Some(i as u64 + 1));
    }
    sketch.scene.time_of_day_h = 16.0;
    sketch.camera("main", DVec3::new(-150.0, 820.0, 1350.0), DVec3::new(50.0, 1390.0, -2000.0), 46.0);
    sketch.camera("beneath", DVec3::new(900.0, 500.0, 900.0), DVec3::new(-300.0, 1100.0, -900.0), 60.0);
    sketch.camera("above", DVec3::new(-1500.0, 3000.0, 3600.0), DVec3::new(300.0, 1150.0, -2500.0), 50.0);
    sketch.camera("abreast", DVec3::new(-3300.0, 1450.0, -200.0), DVec3::new(400.0, 1500.0, -2100.0), 45.0);
    through(&mut sketch);
    sketch.scene
}

/// From the south through the middle of the towering cloud and out, at 95 to 107 m/s and climbing a little, behind an
/// aircraft that is 40 m ahead.
fn through(sketch: &mut Sketch) {
    let keys = [
        (0.0, DVec3::new(240.0, 1430.0, -1010.0), [2.0, 1.0]),
        (3.0, DVec3::new(280.0, 1450.0, -1292.0), [-3.0, 2.0]),
        (6.0, DVec3::new(330.0, 1480.0, -1590.0), [3.0, 0.0]),
        (9.0, DVec3::new(375.0, 1510.0, -1900.0), [-2.0, -2.0]),
        (12.0, DVec3::new(400.0, 1530.0, -2220.0), [0.0, -1.0]),
    ];
    let path = sketch.path("through", 55.0, &keys);
    let id = AircraftId::new(&mut sketch.scene.next_id);
    sketch.scene.aircraft.push(Aircraft { ahead_s: 0.4, ..Aircraft::new(id, "leader", path) });
}

/// A kind of heap: half extent of the base, height, number of heaps and their half width, peak, wisps.
fn cumulus_of(base: [f64; 2], height: f64, heaps: usize, heap_radius: [f64; 2], peak: f64, wisps: usize) -> Cumulus {
    Cumulus { base, height, heaps, heap_radius, peak, wisps, ..Cumulus::default() }
}

/// The same with a second, lower crown.
fn twin(one: Cumulus) -> Cumulus {
    Cumulus { crowns: 2, ..one }
}
