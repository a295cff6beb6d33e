//! Heaps: a level base, swelling heaps upon it with smaller heads, and a few torn wisps.
//!
//! Each heap is a box and a shading group, so each takes the sun as a ball of its own: that is the cauliflower. The
//! base is laid under each heap for itself, so that none of it sticks out. No sprite of a heap reaches below it.

use super::Sketch;
use super::ball::{BODY, Ball, ball, heads};
use super::look::heap;
use super::sketch::Strew;
use cloudwright_core::scene::{Category, CloudModel};
use glam::DVec3;

/// The measures of one kind of heap cloud, metres.
pub struct Cumulus {
    /// Half extent of the base along x and z.
    pub base: [f64; 2],
    /// Height of the highest heap's top.
    pub height: f64,
    /// How many heaps.
    pub heaps: usize,
    /// Half width of a heap.
    pub heap_radius: [f64; 2],
    /// How far the middle towers over the edges: 0 a level top, 1 a cone.
    pub peak: f64,
    /// How many wisps are torn off.
    pub wisps: usize,
}

/// A model of that kind, with its base at y = 0.
pub fn cumulus(sketch: &mut Sketch, name: &str, category: Category, c: &Cumulus) -> CloudModel {
    let mut model = sketch.model(name, category, 1.0 / 4.5, heap());
    // Everything is lit as if it bulged out from here; low, so that crowns face the sky and skirts face away.
    let form = DVec3::new(0.0, c.height * 0.35, 0.0);
    let golden_deg = 137.507_764;
    let mut stacks = Vec::new();
    for i in 0..c.heaps {
        // A sunflower's spiral strews the heaps evenly; the dice keeps it from looking laid out.
        let share = ((i as f64 + 0.3) / c.heaps as f64).sqrt() * sketch.roll(0.84, 1.10);
        let angle = (i as f64 * golden_deg + sketch.roll(-30.0, 30.0)).to_radians();
        let (x, z) = (share * angle.cos() * c.base[0] * 0.79, share * angle.sin() * c.base[1] * 0.79);
        let radius = sketch.roll(c.heap_radius[0], c.heap_radius[1]) * (1.14 - 0.34 * share);
        let top = (c.height * (1.0 - c.peak * share.min(1.0)) * sketch.roll(0.74, 1.06)).max(radius * 1.25);
        stacks.push((DVec3::new(x, top, z), radius));
    }
    belly(sketch, &mut model, c, form);
    for (i, (top, radius)) in stacks.iter().enumerate() {
        base_under(sketch, &mut model, i, *top, *radius, form);
    }
    for (i, (top, radius)) in stacks.into_iter().enumerate() {
        heap_at(sketch, &mut model, i, top, radius, form, c.height);
    }
    let big = c.heap_radius[1];
    for i in 0..c.wisps {
        let angle = sketch.roll(0.0, std::f64::consts::TAU);
        let out = sketch.roll(0.78, 0.94);
        let center =
            DVec3::new(angle.cos() * out * c.base[0], sketch.roll(0.4, 1.1) * big, angle.sin() * out * c.base[1]);
        sketch.strew(
            &mut model,
            &format!("wisp {}", i + 1),
            Strew {
                center,
                size: DVec3::new(big * 1.3, big * 0.4, big * 0.45),
                count: 13,
                sprite: [big * 0.3, big * 0.8],
                category: Category::Wisps,
                light: [0.05, 0.30, 0.62],
                heart: Some(center.lerp(form, 0.5)),
                turn_deg: -angle.to_degrees().round(),
                ..Strew::default()
            },
        );
    }
    model
}

/// What lies between the heaps' undersides, so that from below they are one.
fn belly(sketch: &mut Sketch, model: &mut CloudModel, c: &Cumulus, form: DVec3) {
    let side = 0.5 * (c.base[0] + c.base[1]) * 0.62;
    let center = DVec3::new(0.0, 0.22 * side, 0.0);
    sketch.strew(
        model,
        "belly",
        Strew {
            center,
            size: DVec3::new(c.base[0] * 0.9, side * 0.08, c.base[1] * 0.9),
            count: 26,
            sprite: [side * 0.75, side * 1.15],
            squash: 0.45,
            category: Category::Stratocumulus,
            light: [0.0, 0.06, 0.28],
            heart: Some(center.lerp(form, 0.8)),
            ..Strew::default()
        },
    );
}

/// The underside of one heap: soft tiles for the eye below, a few flat ones in the middle for the eye abreast.
fn base_under(sketch: &mut Sketch, model: &mut CloudModel, i: usize, top: DVec3, radius: f64, form: DVec3) {
    let under = |y: f64| DVec3::new(top.x, y, top.z);
    // The flat tile's edge lies a fifth of its side below its middle.
    let flat = [radius * 0.95, radius * 1.25];
    sketch.strew(
        model,
        &format!("base {}", i + 1),
        Strew {
            center: under(0.2 * flat[1]),
            size: DVec3::new(radius * 0.7, radius * 0.04, radius * 0.7),
            count: 6,
            sprite: flat,
            category: Category::FlatBase,
            light: [0.0, 0.05, 0.40],
            heart: Some(under(0.2 * flat[1]).lerp(form, 0.48)),
            ..Strew::default()
        },
    );
    let soft = [radius * 0.95, radius * 1.5];
    sketch.strew(
        model,
        &format!("underside {}", i + 1),
        Strew {
            center: under(0.19 * soft[1]),
            size: DVec3::new(radius * 1.1, radius * 0.06, radius * 1.1),
            count: 14,
            sprite: soft,
            squash: 0.5,
            category: Category::Nimbostratus,
            light: [0.0, 0.05, 0.40],
            heart: Some(under(0.19 * soft[1]).lerp(form, 0.48)),
            ..Strew::default()
        },
    );
}

/// One heap: a stack of balls that narrow upwards and wander, with smaller heads on their shoulders.
fn heap_at(sketch: &mut Sketch, model: &mut CloudModel, i: usize, top: DVec3, radius: f64, form: DVec3, height: f64) {
    let storeys = ((top.y - radius * 0.6) / (radius * 0.95)).round().max(1.0) as usize;
    let mut lean = DVec3::ZERO;
    for storey in 0..storeys {
        let share = (storey as f64 + 1.0) / storeys as f64;
        let narrow = radius * (1.14 - 0.30 * share) * sketch.roll(0.9, 1.1);
        let y = (narrow * 1.1).max(share * (top.y - narrow * 0.9));
        lean += DVec3::new(sketch.roll(-0.22, 0.22), 0.0, sketch.roll(-0.22, 0.22)) * radius;
        // The skirt stands in the shade of the crowns.
        let sunlit = ((y / height - 0.13) / 0.38).clamp(0.0, 1.0);
        let body = Ball {
            center: DVec3::new(top.x, y, top.z) + lean,
            radius: narrow,
            squash: 0.85,
            count: 15,
            grain: BODY,
            category: Category::Cumulonimbus,
            light: [0.0, 0.15 + 0.15 * sunlit, 0.66 + 0.46 * sunlit],
            heart: (form, 0.42),
        };
        let name = format!("heap {}.{}", i + 1, storey + 1);
        let crown = storey + 1 == storeys;
        heads(sketch, model, &name, &body, if crown { 5 } else { 3 }, [0.34, 0.58], radius * 0.1);
        ball(sketch, model, &name, body);
    }
}
