//! A heap cloud laid out by hand: balls with heads on them, over a level base.

use crate::authoring::Sketch;
use crate::authoring::ball::{BODY, Ball, ball, heads};
use crate::authoring::sketch::Strew;
use cloudwright_core::scene::{Category, CloudModel};
use glam::DVec3;

/// A ball of a pile.
pub struct Heap {
    /// Middle: east, up, south, metres.
    pub at: [f64; 3],
    /// Half width, metres.
    pub radius: f64,
    /// Smaller balls that swell out of it.
    pub heads: u32,
}

/// A heap in one line.
pub const fn heap(at: [f64; 3], radius: f64, heads: u32) -> Heap {
    Heap { at, radius, heads }
}

/// What all heaps of a pile share.
pub struct Pile {
    /// Height of the top, metres: the skirt stands in the shade of the crown.
    pub height: f64,
    /// Height over width of the balls.
    pub squash: f64,
    /// Tiles of the balls.
    pub category: Category,
    /// Sprites tried in each ball.
    pub count: u32,
}

/// Adds `heaps` to `model`, each a box and a shading group with its heads.
pub fn pile(sketch: &mut Sketch, model: &mut CloudModel, pile: &Pile, heaps: &[Heap]) {
    // Everything is lit as if it bulged out from here; low, so that crowns face the sky and skirts face away.
    let form = DVec3::new(0.0, pile.height * 0.33, 0.0);
    for (i, heap) in heaps.iter().enumerate() {
        let center = DVec3::from(heap.at);
        let sunlit = ((center.y / pile.height - 0.1) / 0.4).clamp(0.0, 1.0);
        let body = Ball {
            center,
            radius: heap.radius,
            squash: pile.squash,
            count: pile.count,
            grain: BODY,
            category: pile.category,
            light: [0.0, 0.14 + 0.16 * sunlit, 0.68 + 0.46 * sunlit],
            heart: (form, 0.42),
        };
        let name = format!("heap {}", i + 1);
        ball(sketch, model, &name, body);
        heads(sketch, model, &name, &body, heap.heads, [0.40, 0.62], heap.radius * 0.1);
    }
}

/// The level underside: soft tiles for the eye below, flat ones for the eye abreast. `half` is the base's half extent
/// along x and z, `side` that of the tiles, metres.
pub fn base(sketch: &mut Sketch, model: &mut CloudModel, half: [f64; 2], side: f64, counts: [u32; 2]) {
    let [soft, flat] = counts;
    let lumps = [3, 1, 2];
    sketch.strew(
        model,
        "underside",
        Strew {
            center: DVec3::Y * side * 0.26,
            size: DVec3::new(half[0] * 1.6, side * 0.05, half[1] * 1.6),
            count: soft,
            sprite: [side * 0.95, side * 1.5],
            squash: 0.5,
            category: Category::Nimbostratus,
            light: [0.0, 0.05, 0.36],
            pull: 0.5,
            lumps,
            ..Strew::default()
        },
    );
    // The flat tile's edge lies a fifth of its side below its middle.
    sketch.strew(
        model,
        "flat base",
        Strew {
            center: DVec3::Y * side * 0.2,
            size: DVec3::new(half[0] * 1.45, side * 0.03, half[1] * 1.45),
            count: flat,
            sprite: [side * 0.9, side * 1.1],
            category: Category::FlatBase,
            light: [0.0, 0.05, 0.40],
            pull: 0.5,
            lumps,
            ..Strew::default()
        },
    );
}

/// A torn wisp at the cloud's edge; `at` as seen from its middle.
pub fn wisp(sketch: &mut Sketch, model: &mut CloudModel, name: &str, at: [f64; 3], length: f64) {
    let center = DVec3::from(at);
    sketch.strew(
        model,
        name,
        Strew {
            center,
            size: DVec3::new(length, length * 0.3, length * 0.35),
            count: 12,
            sprite: [length * 0.25, length * 0.6],
            category: Category::Wisps,
            light: [0.05, 0.30, 0.62],
            pull: 0.5,
            turn_deg: (-center.z).atan2(center.x).to_degrees().round(),
            ..Strew::default()
        },
    );
}
