//! A thunder cloud at dusk: a broad dark base, a tower of stacked heaps 7 km high, an anvil spread by the wind aloft,
//! and a congestus beside it.

use super::Sketch;
use super::ball::{BODY, Ball, ball, heads};
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
        peak: 0.66,
        wisps: 2,
    };
    let congestus = cumulus(&mut sketch, "congestus", Category::CumulusCongestus, &congestus);
    let small =
        Cumulus { base: [620.0, 480.0], height: 420.0, heaps: 7, heap_radius: [170.0, 250.0], peak: 0.5, wisps: 1 };
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
    sketch.camera("main", DVec3::new(-4500.0, 750.0, 15500.0), DVec3::new(900.0, 4300.0, 0.0), 46.0);
    sketch.camera("anvil", DVec3::new(-9000.0, 7600.0, 9000.0), DVec3::new(1000.0, 6800.0, 0.0), 50.0);
    sketch.camera("base", DVec3::new(-2500.0, 500.0, 6500.0), DVec3::new(300.0, 1900.0, 0.0), 60.0);
    sketch.camera("sunward", DVec3::new(9500.0, 2500.0, 8500.0), DVec3::new(0.0, 4400.0, 0.0), 52.0);
    sketch.scene
}

/// The tower leans with the wind: metres east for each metre up.
const LEAN: f64 = 0.12;

/// Where the anvil lies above the base.
const ANVIL_M: f64 = 6900.0;

/// The axis at a height: what stands on its sunny side is lit, what stands beyond it is in the shade.
fn axis(y: f64) -> DVec3 {
    DVec3::new(y * LEAN, y, 0.0)
}

/// Bodies are balls of about a kilometre, so that their lobes still read at fifteen.
fn tower(sketch: &mut Sketch) -> CloudModel {
    // The lowest tenth is the rain.
    let levels = levels([
        (0.0, 0.20, 0.22, 0.27, 0.10),
        (0.10, 0.13, 0.15, 0.20, 0.60),
        (0.17, 0.17, 0.19, 0.25, 1.0),
        (0.42, 0.40, 0.43, 0.49, 1.0),
        (1.0, 0.58, 0.60, 0.64, 1.0),
    ]);
    let mut model = sketch.model("cumulonimbus", Category::Cumulonimbus, 1.0 / 4.5, levels);
    underside(sketch, &mut model);
    // Height of the middle, how far the balls stand from the axis, their half width, how many.
    let storeys = [
        (950.0, 1850.0, 1000.0, 9),
        (1850.0, 1500.0, 1050.0, 7),
        (2850.0, 1250.0, 1050.0, 6),
        (3850.0, 1050.0, 1000.0, 6),
        (4850.0, 1000.0, 1000.0, 5),
        (5750.0, 1250.0, 1050.0, 6),
        (6500.0, 1900.0, 950.0, 8),
    ];
    for (storey, (y, out, size, around)) in storeys.into_iter().enumerate() {
        let name = format!("tower {}", storey + 1);
        core(sketch, &mut model, &format!("{name}, core"), y, out);
        let turn = sketch.roll(0.0, 90.0);
        for i in 0..around {
            let angle = (turn + 360.0 / f64::from(around) * f64::from(i) + sketch.roll(-16.0, 16.0)).to_radians();
            // Some balls swell out of the wall, others stay behind: that breaks the column's outline.
            let swell = sketch.roll(0.75, 1.25);
            let rise = sketch.roll(-300.0, 300.0).max(950.0 - y);
            let at = axis(y + rise) + DVec3::new(angle.cos(), 0.0, angle.sin() * 0.88) * out * swell;
            let radius = size * sketch.roll(0.72, 1.05);
            let heads = if storey == 6 { 2 } else { 4 };
            swelling(sketch, &mut model, &format!("{name}.{}", i + 1), at, radius, heads);
        }
    }
    // East, south, height, half width: the flanking line, in steps up to the tower.
    let turrets: [(f64, f64, f64, f64); 8] = [
        (-2300.0, 1000.0, 4000.0, 880.0),
        (-3500.0, 300.0, 2500.0, 760.0),
        (-4300.0, 1100.0, 1600.0, 620.0),
        (2500.0, 1300.0, 3000.0, 800.0),
        (2900.0, -700.0, 4100.0, 850.0),
        (400.0, 2300.0, 2500.0, 800.0),
        (3700.0, 500.0, 2300.0, 780.0),
        (-900.0, -2100.0, 3600.0, 850.0),
    ];
    for (i, (east, south, height, radius)) in turrets.into_iter().enumerate() {
        let foot = DVec3::new(east, 0.0, south);
        patch(sketch, &mut model, &format!("of turret {}", i + 1), foot, radius * 0.66);
        let storeys = (height / (radius * 1.05)).round() as u32;
        for storey in 0..storeys {
            let share = f64::from(storey + 1) / f64::from(storeys);
            let narrow = radius * (1.15 - 0.35 * share);
            let at = DVec3::new(
                east + sketch.roll(-0.2, 0.2) * radius,
                (share * height - narrow * 0.8).max(narrow * 0.85),
                south + sketch.roll(-0.2, 0.2) * radius,
            );
            swelling(sketch, &mut model, &format!("turret {}.{}", i + 1, storey + 1), at, narrow, 4);
        }
    }
    anvil(sketch, &mut model);
    model
}

/// A ball of the tower with heads on it. Low down it stands in the shade of what is above.
fn swelling(sketch: &mut Sketch, model: &mut CloudModel, name: &str, center: DVec3, radius: f64, count: u32) {
    let sunlit = ((center.y - 600.0) / 1900.0).clamp(0.0, 1.0);
    let body = Ball {
        center,
        radius,
        squash: 0.9,
        count: 15,
        grain: BODY,
        category: Category::Cumulonimbus,
        light: [0.0, 0.07 + 0.13 * sunlit, 0.50 + 0.72 * sunlit],
        heart: (axis(center.y - 250.0), 0.5),
    };
    heads(sketch, model, name, &body, count, [0.32, 0.58], 150.0);
    ball(sketch, model, name, body);
}

/// Fills the middle of a storey, so that no sky shows between the balls.
fn core(sketch: &mut Sketch, model: &mut CloudModel, name: &str, y: f64, out: f64) {
    sketch.strew(
        model,
        name,
        Strew {
            center: axis(y),
            size: DVec3::new(out * 1.3, 700.0, out * 1.2),
            count: 16,
            sprite: [900.0, 1300.0],
            category: Category::Cumulonimbus,
            light: [0.0, 0.06, 0.45],
            heart: Some(axis(y - 400.0)),
            ..Strew::default()
        },
    );
}

/// The rain-dark base and the rain that falls from it.
fn underside(sketch: &mut Sketch, model: &mut CloudModel) {
    let rain = Strew {
        center: DVec3::new(500.0, -260.0, -200.0),
        size: DVec3::new(3000.0, 260.0, 2300.0),
        count: 60,
        sprite: [620.0, 900.0],
        squash: 1.35,
        category: Category::Wisps,
        light: [0.0, 0.03, 0.10],
        pull: 0.0,
        lumps: [2, 1, 2],
        ..Strew::default()
    };
    sketch.strew(model, "rain", rain);
    for i in 0..10 {
        let (out, angle) = if i == 0 { (0.0, 0.0) } else { (1.0, f64::from(i) * 40.0 + sketch.roll(-9.0, 9.0)) };
        let (sin, cos) = angle.to_radians().sin_cos();
        let at = DVec3::new(cos * 2000.0, 0.0, sin * 1700.0) * out * sketch.roll(0.9, 1.08);
        patch(sketch, model, &format!("{}", i + 1), at, 900.0);
    }
}

/// A piece of the level base: soft tiles for the eye below, flat ones for the eye abreast.
fn patch(sketch: &mut Sketch, model: &mut CloudModel, name: &str, at: DVec3, radius: f64) {
    let soft = Strew {
        center: at + DVec3::Y * radius * 0.28,
        size: DVec3::new(1.8, 0.08, 1.6) * radius,
        count: 26,
        sprite: [radius * 0.9, radius * 1.35],
        squash: 0.5,
        category: Category::Nimbostratus,
        light: [0.0, 0.05, 0.20],
        heart: Some(DVec3::new(0.0, 2500.0, 0.0)),
        ..Strew::default()
    };
    let flat = Strew {
        center: at + DVec3::Y * radius * 0.23,
        size: DVec3::new(1.4, 0.04, 1.2) * radius,
        count: 9,
        sprite: [radius * 0.95, radius * 1.15],
        squash: 1.0,
        category: Category::FlatBase,
        ..soft
    };
    sketch.strew(model, &format!("base {name}"), flat);
    sketch.strew(model, &format!("underside {name}"), soft);
}

/// A broad sheet of large, soft, flat tiles: thick above the tower, thin and torn downwind.
fn anvil(sketch: &mut Sketch, model: &mut CloudModel) {
    let dome = axis(ANVIL_M + 350.0);
    swelling(sketch, model, "overshooting dome", dome, 900.0, 5);
    const STATIONS: u32 = 9;
    for i in 0..STATIONS {
        let share = f64::from(i) / f64::from(STATIONS - 1);
        let east = -2500.0 + 13_700.0 * share;
        // Round upwind, widest beyond the tower, a tongue downwind.
        let half_width =
            3900.0 * (1.0 - (2.0 * share - 0.62).powi(2) / 2.2).max(0.05).sqrt() * (0.45 + 5.0 * share).min(1.0);
        let thickness = 760.0 * (1.0 - share).powi(2) * (0.35 + 4.0 * share).min(1.0) + 60.0;
        let side = 1650.0 + 450.0 * share;
        let center = DVec3::new(east, ANVIL_M + 120.0 * share - 0.2 * thickness, sketch.roll(-150.0, 150.0));
        sketch.strew(
            model,
            &format!("anvil {}", i + 1),
            Strew {
                center,
                size: DVec3::new(2100.0, thickness, half_width * 1.6),
                count: 96 - 5 * i,
                sprite: [side * 0.85, side * 1.35],
                squash: 0.52 - 0.24 * share,
                category: if share < 0.75 { Category::Nimbostratus } else { Category::Wisps },
                light: [0.03, 0.25, 0.88],
                // Seen from far below its middle, the whole sheet turns its side to a low sun alike: smooth.
                heart: Some(DVec3::new(1500.0, ANVIL_M - 1600.0, 0.0).lerp(center, 0.35)),
                lumps: [2, 1, 3],
                ..Strew::default()
            },
        );
    }
}
