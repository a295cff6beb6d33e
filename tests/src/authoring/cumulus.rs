//! Heaps: a level base, swelling heaps upon it with smaller heads, and a few torn wisps.
//!
//! Each heap is a box and a shading group, so each takes the sun as a ball of its own: that is the cauliflower. No
//! sprite of a heap reaches below the base.

use super::Sketch;
use super::look::heap;
use super::sketch::Strew;
use cloudwright_core::scene::{Category, CloudModel};
use glam::DVec3;

/// The measures of one kind of heap cloud, metres.
pub struct Cumulus {
    /// Half extent of the base along x and z.
    pub base: [f64; 2],
    /// Height of the highest heap's middle.
    pub height: f64,
    /// How many heaps.
    pub heaps: usize,
    /// Half width of a heap.
    pub heap_radius: [f64; 2],
    /// Sides of the heaps' sprites.
    pub sprite: [f64; 2],
    /// How far the middle towers over the edges: 0 a level top, 1 a cone.
    pub peak: f64,
}

/// A model of that kind, with its base at y = 0.
pub fn cumulus(sketch: &mut Sketch, name: &str, category: Category, c: &Cumulus) -> CloudModel {
    let mut model = sketch.model(name, category, 1.0 / 4.5, heap());
    let big = c.sprite[1];
    // The flat tile's edge lies a fifth of its side below its middle.
    let base_sprite = [big * 1.0, big * 1.35];
    let lift = 0.2 * base_sprite[1];
    let per_area = |sprites: f64, most: u32| ((c.base[0] * c.base[1] / (big * big) * sprites) as u32).clamp(24, most);
    sketch.strew(
        &mut model,
        "base",
        Strew {
            center: DVec3::new(0.0, lift, 0.0),
            size: DVec3::new(c.base[0] * 1.4, big * 0.06, c.base[1] * 1.4),
            count: per_area(8.0, 90),
            sprite: base_sprite,
            category: Category::FlatBase,
            light: [0.0, 0.08, 0.26],
            pull: 0.0,
            lumps: [4, 1, 3],
            ..Strew::default()
        },
    );
    // Seen from below, soft tiles close the gaps between the flat ones; squashed, they don't reach below their edge.
    sketch.strew(
        &mut model,
        "underside",
        Strew {
            center: DVec3::new(0.0, big * 0.42, 0.0),
            size: DVec3::new(c.base[0] * 1.4, big * 0.10, c.base[1] * 1.4),
            count: per_area(9.0, 100),
            sprite: [big * 1.0, big * 1.4],
            squash: 0.55,
            category: Category::Stratocumulus,
            light: [0.0, 0.12, 0.36],
            pull: 0.0,
            lumps: [4, 1, 3],
            ..Strew::default()
        },
    );
    sketch.strew(
        &mut model,
        "belly",
        Strew {
            center: DVec3::new(0.0, big * 0.62, 0.0),
            size: DVec3::new(c.base[0] * 1.45, big * 0.25, c.base[1] * 1.45),
            count: ((c.base[0] * c.base[1] / (big * big) * 4.0) as u32).clamp(12, 50),
            sprite: [big * 0.8, big * 1.1],
            category: Category::Stratocumulus,
            light: [0.0, 0.26, 0.62],
            pull: 0.2,
            lumps: [4, 1, 3],
            ..Strew::default()
        },
    );
    let golden_deg = 137.507_764;
    for i in 0..c.heaps {
        // A sunflower's spiral strews the heaps evenly; the dice keeps it from looking laid out.
        let share = ((i as f64 + 0.4) / c.heaps as f64).sqrt() * sketch.roll(0.86, 1.08);
        let angle = (i as f64 * golden_deg + sketch.roll(-28.0, 28.0)).to_radians();
        let (x, z) = (share * angle.cos() * c.base[0] * 0.78, share * angle.sin() * c.base[1] * 0.78);
        let radius = sketch.roll(c.heap_radius[0], c.heap_radius[1]) * (1.12 - 0.35 * share);
        let height = c.height * (1.0 - c.peak * share.min(1.0)) * sketch.roll(0.80, 1.06);
        let y = height.max(radius * 0.6 + big * 0.45);
        heap_at(sketch, &mut model, i, DVec3::new(x, y, z), radius, big * 0.65);
    }
    for i in 0..2 + c.heaps / 5 {
        let angle = sketch.roll(0.0, std::f64::consts::TAU);
        let out = sketch.roll(0.85, 1.1);
        sketch.strew(
            &mut model,
            &format!("wisp {}", i + 1),
            Strew {
                center: DVec3::new(
                    angle.cos() * out * c.base[0],
                    sketch.roll(0.3, 0.8) * big,
                    angle.sin() * out * c.base[1],
                ),
                size: DVec3::new(big * 1.6, big * 0.4, big * 0.8),
                count: 5,
                sprite: [big * 0.7, big * 1.2],
                category: Category::Wisps,
                light: [0.1, 0.4, 0.7],
                pull: 0.5,
                turn_deg: -angle.to_degrees().round(),
                ..Strew::default()
            },
        );
    }
    model
}

/// One heap: a stack of balls that narrow upwards and wander, and smaller heads on the shoulders of the last.
fn heap_at(sketch: &mut Sketch, model: &mut CloudModel, i: usize, top: DVec3, radius: f64, floor: f64) {
    let body_height = (top.y - floor).max(radius * 0.7);
    let storeys = (body_height / (radius * 1.1)).round().max(1.0) as usize;
    let mut middle = DVec3::new(top.x, floor, top.z);
    let mut width = radius;
    for storey in 0..storeys {
        let share = (storey as f64 + 0.5) / storeys as f64;
        middle.y = floor + share * body_height;
        middle += DVec3::new(sketch.roll(-0.2, 0.2), 0.0, sketch.roll(-0.2, 0.2)) * radius;
        width = radius * (1.2 - 0.45 * share);
        let turn_deg = sketch.roll(0.0, 90.0).round();
        sketch.strew(
            model,
            &format!("heap {}.{}", i + 1, storey + 1),
            Strew {
                center: middle,
                size: DVec3::new(width * 1.25, body_height / storeys as f64, width * 1.25),
                count: 18,
                sprite: [radius * 0.8, radius * 1.3],
                category: Category::CumulusCongestus,
                light: [0.0, 0.36, 0.75 + 0.25 * share],
                turn_deg,
                ..Strew::default()
            },
        );
    }
    let first_deg = sketch.roll(0.0, 120.0);
    for head in 0..4 {
        let (sin, cos) = (first_deg + 90.0 * f64::from(head) + sketch.roll(-25.0, 25.0)).to_radians().sin_cos();
        let reach = width * sketch.roll(0.35, 0.7);
        let small = width * sketch.roll(0.30, 0.50);
        let rise = sketch.roll(-0.30, 0.35) * width + 0.2 * body_height / storeys as f64;
        sketch.strew(
            model,
            &format!("head {}.{}", i + 1, head + 1),
            Strew {
                center: middle + DVec3::new(cos * reach, rise.max(floor - middle.y), sin * reach),
                size: DVec3::new(small, small * 0.9, small) * 1.3,
                count: 9,
                sprite: [small * 1.0, small * 1.7],
                light: [0.0, 0.40, 1.0],
                ..Strew::default()
            },
        );
    }
}
