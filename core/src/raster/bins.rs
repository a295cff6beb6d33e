//! Which sprites may touch which tile.

use super::ScreenSprite;
use glam::Vec2;
use rayon::prelude::*;

/// Side of a tile, pixels: four planes of f32 fill half of a usual first-level cache.
pub const TILE: usize = 32;

/// A tile's place in the picture, pixels; narrower or lower than [`TILE`] at the right and lower edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TileRect {
    pub left: u32,
    pub top: u32,
    pub width: u32,
    pub height: u32,
}

/// Draws all tiles on all cores: `draw(tile, its sprites' indices, nearest first)` gives the tile's pixels.
///
/// `sprites` stand back to front. Sprites are binned a row of tiles at a time, by the task that then draws the row: a
/// crowd of sprites that fill the screen would need gigabytes for all tiles at once.
pub fn map_tiles<P: Send>(
    sprites: &[ScreenSprite],
    width: u32,
    height: u32,
    draw: impl Fn(TileRect, &[u32]) -> Vec<P> + Sync,
) -> Vec<(TileRect, Vec<P>)> {
    let side = TILE as u32;
    let tops: Vec<u32> = (0..height).step_by(TILE).collect();
    let row = |top: u32| -> Vec<(TileRect, Vec<P>)> {
        let rect = |left| TileRect { left, top, width: side.min(width - left), height: side.min(height - top) };
        let mut tiles: Vec<_> = (0..width).step_by(TILE).map(|left| (rect(left), Vec::new())).collect();
        for (index, sprite) in sprites.iter().enumerate().rev() {
            bin(sprite, index as u32, top as f32, &mut tiles);
        }
        tiles.into_par_iter().with_max_len(1).map(|(rect, members)| (rect, draw(rect, &members))).collect()
    };
    tops.into_par_iter().with_max_len(1).flat_map_iter(row).collect()
}

/// Adds a sprite to those tiles of the row at `row_top` that its bounds and outline touch.
fn bin(sprite: &ScreenSprite, index: u32, row_top: f32, tiles: &mut [(TileRect, Vec<u32>)]) {
    let [left, top, right, bottom] = sprite.bounds;
    if bottom <= row_top || top >= row_top + TILE as f32 || right <= left {
        return;
    }
    let first = left as usize / TILE;
    let last = (right as usize / TILE).min(tiles.len().saturating_sub(1));
    for (rect, members) in tiles.iter_mut().take(last + 1).skip(first) {
        if sprite.outline.is_none_or(|outline| touches(&outline, *rect)) {
            members.push(index);
        }
    }
}

/// False only if an edge of the convex outline has the whole tile on its outer side.
fn touches(outline: &[Vec2; 4], rect: TileRect) -> bool {
    let center = Vec2::new(rect.left as f32, rect.top as f32) + TILE as f32 * 0.5;
    // Top left, top right, bottom right, bottom left run clockwise on a screen whose y points down.
    (0..4).all(|i| {
        let (from, to) = (outline[i], outline[(i + 1) % 4]);
        let inward = Vec2::new(from.y - to.y, to.x - from.x);
        let nearest_corner = (center - from).dot(inward) + (inward.x.abs() + inward.y.abs()) * (TILE as f32 * 0.5);
        nearest_corner >= 0.0
    })
}

/// The picture from its tiles' pixels.
pub fn assemble<P: Copy>(tiles: &[(TileRect, Vec<P>)], width: u32, height: u32, empty: P) -> Vec<P> {
    let mut pixels = vec![empty; width as usize * height as usize];
    for (rect, tile) in tiles {
        for (row, line) in tile.chunks(rect.width as usize).enumerate() {
            let start = (rect.top as usize + row) * width as usize + rect.left as usize;
            pixels[start..start + line.len()].copy_from_slice(line);
        }
    }
    pixels
}
