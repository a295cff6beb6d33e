//! In which order a tile blends its sprites.
//!
//! Sprites are planes, and a list orders them by their centres, so where planes cross no such order holds. A tile puts its
//! own in the order in which the ray through its middle meets them; what crosses within the tile is told by how near and
//! how far each plane comes there, and only that is left to a queue a pixel ([`super::queue`]) (after Radl et al.,
//! *StopThePop*, ACM Transactions on Graphics 43(4), 2024: tile, then pixel).

use super::super::ScreenSprite;
use super::super::bins::TileRect;

/// A sprite that a tile is to blend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Member {
    /// Which of the frame's.
    pub index: u32,
    /// Whether its plane may cross another's in the tile, so that its fragments have to be queued.
    pub crosses: bool,
    /// Whether all before it lie before it at every pixel of the tile: what is queued can go.
    pub begins: bool,
}

/// One over the view depth, 1/m, of a sprite's plane in a tile: at its middle, and the least and the greatest.
#[derive(Debug, Clone, Copy)]
struct Nearness {
    middle: f32,
    least: f32,
    greatest: f32,
    index: u32,
}

impl Nearness {
    /// It is linear in the pixel.
    fn of(sprite: &ScreenSprite, index: u32, rect: TileRect) -> Self {
        let [left, top, right, bottom] = sprite.bounds;
        let within = |low: f32, high: f32, from: u32, length: u32| {
            let (from, to) = (from as f32, (from + length) as f32);
            (low.clamp(from, to), high.clamp(from, to))
        };
        let (left, right) = within(left, right, rect.left, rect.width);
        let (top, bottom) = within(top, bottom, rect.top, rect.height);
        let half = 0.5
            * sprite.nearness_of_one().abs()
            * (sprite.denominator.dx.abs() * (right - left) + sprite.denominator.dy.abs() * (bottom - top));
        let shown = sprite.nearness(0.5 * (left + right), 0.5 * (top + bottom));
        let middle =
            sprite.nearness(rect.left as f32 + 0.5 * rect.width as f32, rect.top as f32 + 0.5 * rect.height as f32);
        Self { middle: middle.max(shown - half).min(shown + half), least: shown - half, greatest: shown + half, index }
    }
}

/// `members`, nearest first by the list, in the tile's own order.
pub fn in_tile(sprites: &[ScreenSprite], members: &[u32], rect: TileRect) -> Vec<Member> {
    let mut planes: Vec<Nearness> =
        members.iter().map(|index| Nearness::of(&sprites[*index as usize], *index, rect)).collect();
    // All but sorted already; equally near ones stay as the list has them.
    planes.sort_by(|a, b| b.middle.total_cmp(&a.middle));
    let mut nearest_behind = f32::NEG_INFINITY;
    let mut behind: Vec<f32> = planes
        .iter()
        .rev()
        .map(|plane| {
            let behind = nearest_behind;
            nearest_behind = nearest_behind.max(plane.greatest);
            behind
        })
        .collect();
    behind.reverse();
    let (mut farthest, mut begins) = (f32::INFINITY, true);
    let in_order = planes.iter().zip(behind).map(|(plane, nearest_behind)| {
        farthest = if begins { plane.least } else { farthest.min(plane.least) };
        let ends = nearest_behind <= farthest;
        let member = Member { index: plane.index, crosses: !(begins && ends), begins };
        begins = ends;
        member
    });
    in_order.collect()
}
