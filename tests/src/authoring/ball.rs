//! A ball of cloud: one box, one shading group, few large sprites. Heaps, turrets and heads are balls of balls.

use super::Sketch;
use super::sketch::Strew;
use cloudwright_core::scene::{Category, CloudModel};
use glam::DVec3;

/// A ball in few words.
#[derive(Clone, Copy)]
pub struct Ball {
    /// Middle, metres in the model.
    pub center: DVec3,
    /// Half width as seen, metres.
    pub radius: f64,
    /// Height over width.
    pub squash: f64,
    /// Sprites tried.
    pub count: u32,
    /// Sides of the sprites over the radius, and extent of the box over the radius.
    pub grain: Grain,
    /// Tiles.
    pub category: Category,
    /// Share of the sun away from it, across, towards it.
    pub light: [f64; 3],
    /// The point of the greater form that the ball is part of, and how far the group's centre goes towards it.
    pub heart: (DVec3, f64),
}

/// How a ball is filled. A puff shows two thirds of its tile, so that a ball of few sprites nearly as large as itself
/// looks like one swelling and not like a heap of peas.
#[derive(Clone, Copy)]
pub struct Grain {
    /// Smallest and largest side over the radius.
    pub sprite: [f64; 2],
    /// Extent of the box over the radius.
    pub extent: f64,
}

/// Many lobes: the body of a heap.
pub const BODY: Grain = Grain { sprite: [1.15, 1.95], extent: 0.95 };

/// One or two lobes: a head upon it.
pub const HEAD: Grain = Grain { sprite: [1.55, 2.4], extent: 0.6 };

/// Adds the ball to `model`.
pub fn ball(sketch: &mut Sketch, model: &mut CloudModel, name: &str, ball: Ball) {
    let turn_deg = sketch.roll(0.0, 90.0).round();
    let (form, share) = ball.heart;
    let size = DVec3::new(1.0, ball.squash, 1.0) * ball.radius * ball.grain.extent;
    sketch.strew(
        model,
        name,
        Strew {
            center: ball.center,
            size,
            count: ball.count,
            sprite: ball.grain.sprite.map(|side| side * ball.radius),
            category: ball.category,
            light: ball.light,
            heart: Some(ball.center.lerp(form, share)),
            turn_deg,
            ..Strew::default()
        },
    );
}

/// Adds `count` smaller balls that swell out of the upper side of the ball `parent`. `size` is
/// their radius over the parent's; none reaches below `lowest`.
pub fn heads(
    sketch: &mut Sketch,
    model: &mut CloudModel,
    name: &str,
    parent: &Ball,
    count: u32,
    size: [f64; 2],
    lowest: f64,
) {
    let first_deg = sketch.roll(0.0, 360.0);
    for head in 0..count {
        let around = (first_deg + 360.0 / f64::from(count) * f64::from(head) + sketch.roll(-22.0, 22.0)).to_radians();
        let up = sketch.roll(-0.15, 0.95);
        let out = (1.0 - up * up).max(0.0).sqrt();
        let radius = parent.radius * sketch.roll(size[0], size[1]);
        let reach = parent.radius * 0.95 - radius * 0.35;
        let toward = DVec3::new(around.cos() * out, up * parent.squash, around.sin() * out);
        let mut center = parent.center + toward * reach;
        center.y = center.y.max(lowest + radius * 0.9);
        let (form, share) = parent.heart;
        ball(
            sketch,
            model,
            &format!("{name}.{}", head + 1),
            Ball {
                center,
                radius,
                squash: 0.95,
                count: 6,
                grain: HEAD,
                category: Category::SolidCumulus,
                light: parent.light,
                heart: (parent.center.lerp(form, share), 0.62),
            },
        );
    }
}
