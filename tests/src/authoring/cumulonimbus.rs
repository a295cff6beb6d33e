//! A thunder cloud at dusk: a broad dark base, a tower of stacked heaps 7 km high, an anvil spread by the wind aloft,
//! and a congestus beside it.

use super::Sketch;
use super::cumulus::{Cumulus, cumulus};
use super::look::levels;
use super::sketch::Strew;
use cloudwright_core::scene::{Category, CloudModel, Scene};
use glam::DVec3;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("Cumulonimbus at dusk", 67);
    let tower = tower(&mut sketch);
    let congestus = Cumulus {
        base: [1500.0, 1100.0],
        height: 2300.0,
        heaps: 11,
        heap_radius: [420.0, 620.0],
        sprite: [330.0, 560.0],
        peak: 0.66,
    };
    let congestus = cumulus(&mut sketch, "congestus", Category::CumulusCongestus, &congestus);
    let small = Cumulus {
        base: [620.0, 480.0],
        height: 420.0,
        heaps: 7,
        heap_radius: [170.0, 250.0],
        sprite: [150.0, 260.0],
        peak: 0.5,
    };
    let small = cumulus(&mut sketch, "mediocris", Category::CumulusHumilis, &small);
    let [tower_id, congestus_id, small_id] = [tower.id, congestus.id, small.id];
    sketch.scene.models.extend([tower, congestus, small]);
    let base = 1000.0;
    sketch.place(tower_id, "cumulonimbus", DVec3::new(0.0, base, 0.0), 0.0, 1.0, None);
    sketch.place(congestus_id, "congestus south", DVec3::new(-5200.0, base, 2600.0), 40.0, 1.0, None);
    sketch.place(congestus_id, "congestus north", DVec3::new(5600.0, base, -3800.0), 200.0, 1.15, Some(2));
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
            small_id,
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
    sketch.camera("main", DVec3::new(-4500.0, 1500.0, 15500.0), DVec3::new(600.0, 4300.0, 0.0), 46.0);
    sketch.camera("anvil", DVec3::new(-9000.0, 7600.0, 9000.0), DVec3::new(1000.0, 6800.0, 0.0), 50.0);
    sketch.camera("base", DVec3::new(-2500.0, 500.0, 6500.0), DVec3::new(300.0, 1900.0, 0.0), 60.0);
    sketch.camera("sunward", DVec3::new(9500.0, 2500.0, 8500.0), DVec3::new(0.0, 4400.0, 0.0), 52.0);
    sketch.scene
}

/// Bodies are balls of one or two kilometres: sprites of half a kilometre read at ten.
fn tower(sketch: &mut Sketch) -> CloudModel {
    let levels = levels([
        (0.0, 0.17, 0.19, 0.25, 0.96),
        (0.08, 0.22, 0.25, 0.31, 1.0),
        (0.30, 0.44, 0.47, 0.53, 1.0),
        (0.70, 0.64, 0.66, 0.70, 1.0),
        (1.0, 0.72, 0.73, 0.76, 1.0),
    ]);
    let mut model = sketch.model("cumulonimbus", Category::Cumulonimbus, 1.0 / 4.5, levels);
    sketch.strew(
        &mut model,
        "base",
        Strew {
            center: DVec3::new(-200.0, 130.0, 0.0),
            size: DVec3::new(5400.0, 40.0, 4500.0),
            count: 100,
            sprite: [560.0, 800.0],
            category: Category::FlatBase,
            light: [0.0, 0.05, 0.16],
            pull: 0.0,
            lumps: [3, 1, 2],
            ..Strew::default()
        },
    );
    sketch.strew(
        &mut model,
        "rain-dark belly",
        Strew {
            center: DVec3::new(-100.0, 420.0, 0.0),
            size: DVec3::new(5200.0, 180.0, 4300.0),
            count: 95,
            sprite: [500.0, 720.0],
            category: Category::Nimbostratus,
            light: [0.0, 0.12, 0.35],
            lumps: [3, 1, 2],
            ..Strew::default()
        },
    );
    // Height of the middle, half width, how many balls around, how far they stand from the axis.
    let storeys = [
        (1100.0, 2150.0, 8, 0.64),
        (1950.0, 2150.0, 8, 0.60),
        (2900.0, 1950.0, 7, 0.60),
        (3900.0, 1750.0, 6, 0.58),
        (4900.0, 1700.0, 6, 0.56),
        (5900.0, 1900.0, 6, 0.52),
    ];
    for (storey, (y, width, around, out)) in storeys.into_iter().enumerate() {
        let turn = sketch.roll(0.0, 90.0);
        for i in 0..around {
            let angle = (turn + 360.0 / f64::from(around) * f64::from(i) + sketch.roll(-18.0, 18.0)).to_radians();
            // Some balls swell out of the wall, others stay behind: that breaks the column's outline.
            let swell = sketch.roll(0.72, 1.22);
            let reach = width * out * swell;
            let ball = width * sketch.roll(0.38, 0.56) * (0.6 + 0.4 * swell);
            let lean = y * 0.12;
            let rise = sketch.roll(-330.0, 380.0).max(650.0 + 0.6 * ball - y);
            let middle = DVec3::new(angle.cos() * reach + lean, y + rise, angle.sin() * reach * 0.85);
            let name = format!("tower {}.{}", storey + 1, i + 1);
            knob(sketch, &mut model, &name, middle, ball, Category::Cumulonimbus, [16, 0]);
            for head in 0..3 {
                let swing = angle + sketch.roll(-0.9, 0.9);
                let small = ball * sketch.roll(0.30, 0.58);
                let up = sketch.roll(-0.25, 0.7) * ball;
                let at = middle + DVec3::new(swing.cos() * ball * 0.66, up, swing.sin() * ball * 0.66);
                knob(
                    sketch,
                    &mut model,
                    &format!("knob {}.{}.{}", storey + 1, i + 1, head + 1),
                    at,
                    small,
                    Category::SolidCumulus,
                    [9, 1],
                );
            }
        }
        // The core, so that no sky shows between the balls.
        knob(
            sketch,
            &mut model,
            &format!("core {}", storey + 1),
            DVec3::new(y * 0.12, y, 0.0),
            width * 0.75,
            Category::Cumulonimbus,
            [16, 0],
        );
    }
    anvil(sketch, &mut model);
    model
}

/// A ball of sprites under one light: `count` of them, and how much smaller than usual they are.
fn knob(
    sketch: &mut Sketch,
    model: &mut CloudModel,
    name: &str,
    center: DVec3,
    radius: f64,
    category: Category,
    [count, small]: [u32; 2],
) {
    let shrink = 1.0 - 0.08 * f64::from(small);
    let sunlit = ((center.y - 700.0) / 2600.0).clamp(0.0, 1.0);
    sketch.strew(
        model,
        name,
        Strew {
            center,
            size: DVec3::new(radius * 1.15, radius * 1.05, radius * 1.15),
            count,
            sprite: [radius * 0.85 * shrink, radius * 1.75 * shrink],
            category,
            // Low down the tower stands in the shade of its own shelves.
            light: [0.0, 0.10 + 0.22 * sunlit, 0.45 + 0.70 * sunlit],
            pull: 0.72,
            turn_deg: sketch.roll(0.0, 90.0).round(),
            ..Strew::default()
        },
    );
}

/// A flat spread of soft tiles, thick above the tower, thin and torn downwind.
fn anvil(sketch: &mut Sketch, model: &mut CloudModel) {
    sketch.strew(
        model,
        "dome",
        Strew {
            center: DVec3::new(800.0, 6850.0, 0.0),
            size: DVec3::new(3200.0, 520.0, 2600.0),
            count: 34,
            sprite: [620.0, 980.0],
            category: Category::Cumulonimbus,
            light: [0.0, 0.42, 1.0],
            lumps: [2, 1, 1],
            ..Strew::default()
        },
    );
    // East, half length, half width, sprites' side, thickness.
    let sheets = [
        (300.0, 3600.0, 3200.0, 1500.0, 330.0),
        (3000.0, 3200.0, 3100.0, 1600.0, 260.0),
        (5900.0, 2900.0, 2700.0, 1700.0, 190.0),
        (8600.0, 2400.0, 2000.0, 1600.0, 120.0),
    ];
    for (i, (east, half_length, half_width, side, thickness)) in sheets.into_iter().enumerate() {
        let share = i as f64 / 3.0;
        sketch.strew(
            model,
            &format!("anvil {}", i + 1),
            Strew {
                center: DVec3::new(east, 6900.0 + 60.0 * share, sketch.roll(-200.0, 200.0)),
                size: DVec3::new(half_length * 1.6, thickness, half_width * 1.6),
                count: 130 - 14 * i as u32,
                sprite: [side * 0.7, side * 1.15],
                squash: 0.45,
                category: if i < 3 { Category::Nimbostratus } else { Category::Wisps },
                light: [0.05, 0.40, 0.90],
                pull: 0.0,
                lumps: [3, 1, 2],
                ..Strew::default()
            },
        );
    }
}
