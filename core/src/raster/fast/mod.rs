//! The fast CPU renderer: sorted sprites, tiles on all cores, front to back, early stop.
//!
//! The picture falls into tiles of 32 × 32 pixels whose colour and transmittance stay in the first-level cache. Each
//! tile draws the sprites that may touch it, nearest first, and stops when what still gets through no longer shows.
//! Within a tile the order is fixed, so the bytes don't depend on the number of threads.
//! [`super::plain`] is its oracle; without the AVX2 instructions the tiles are drawn fragment by fragment as there.

#[cfg(target_arch = "x86_64")]
mod avx2;
mod bins;
mod tile;

use super::{ScreenSprite, prepare};
use crate::color::{Premultiplied, Rgb};
use crate::frame::Frame;
use crate::image::{Layer, LinearPicture, Picture};
use crate::sky::BackgroundRows;
use crate::tone::encode;
use bins::{Bins, TileRect};
use rayon::prelude::*;
use tile::{Brush, Tile};

/// A tile is done when less than this gets through each of its pixels. What still does shows the background.
pub const STOP_BELOW: f32 = 1.0 / 1024.0;
/// For [`clouds`]: draw to the last sprite.
pub const NEVER_STOP: f32 = 0.0;

/// The frame as a display shows it, one sample at each pixel's centre.
pub fn picture(frame: &Frame<'_>) -> Picture {
    picture_stopping(frame, STOP_BELOW)
}

/// As [`picture`], with tiles done when less than `stop_below` gets through ([`NEVER_STOP`]: never).
pub fn picture_stopping(frame: &Frame<'_>, stop_below: f32) -> Picture {
    let background = BackgroundRows::new(&frame.background, &frame.view);
    let finish = |rect: TileRect, row: u32, clouds: &[Premultiplied], out: &mut [[u8; 4]]| {
        let y = rect.top + row;
        let mut behind = [Rgb::BLACK; bins::TILE];
        background.row(rect.left, y, &mut behind[..clouds.len()]);
        for (x, (pixel, (cloud, behind))) in (rect.left..).zip(out.iter_mut().zip(clouds.iter().zip(behind))) {
            *pixel = encode(cloud.over(behind) * frame.exposure, x, y);
        }
    };
    let pixels = draw(frame, stop_below, [0; 4], finish);
    Picture { width: frame.view.width, height: frame.view.height, pixels }
}

/// The frame in linear light, before exposure.
pub fn linear_picture(frame: &Frame<'_>) -> LinearPicture {
    let background = BackgroundRows::new(&frame.background, &frame.view);
    let finish = |rect: TileRect, row: u32, clouds: &[Premultiplied], out: &mut [Rgb]| {
        background.row(rect.left, rect.top + row, out);
        for (pixel, cloud) in out.iter_mut().zip(clouds) {
            *pixel = cloud.over(*pixel);
        }
    };
    let pixels = draw(frame, STOP_BELOW, Rgb::BLACK, finish);
    LinearPicture { width: frame.view.width, height: frame.view.height, pixels }
}

/// The clouds alone.
pub fn clouds(frame: &Frame<'_>, stop_below: f32) -> Layer {
    let finish = |_, _, clouds: &[Premultiplied], out: &mut [Premultiplied]| out.copy_from_slice(clouds);
    let pixels = draw(frame, stop_below, Premultiplied::CLEAR, finish);
    Layer { width: frame.view.width, height: frame.view.height, pixels }
}

/// Draws all tiles and turns each row of each into pixels: `finish(tile, row in the tile, the row's clouds, out)`.
fn draw<P: Copy + Send + Sync>(
    frame: &Frame<'_>,
    stop_below: f32,
    empty: P,
    finish: impl Fn(TileRect, u32, &[Premultiplied], &mut [P]) + Sync,
) -> Vec<P> {
    let sprites = prepare(frame);
    let bins = Bins::new(&sprites, frame.view.width, frame.view.height);
    let brush = Brush::new(frame.atlas);
    let tiles: Vec<(TileRect, Vec<P>)> = bins
        .tiles()
        .into_par_iter()
        .with_max_len(1)
        .map(|(rect, members)| {
            let tile = draw_tile(&brush, &sprites, rect, members, stop_below);
            let mut out = vec![empty; (rect.width * rect.height) as usize];
            for (row, line) in (0..).zip(out.chunks_mut(rect.width as usize)) {
                finish(rect, row, &tile.row(row as usize)[..rect.width as usize], line);
            }
            (rect, out)
        })
        .collect();
    assemble(&tiles, frame.view.width, frame.view.height, empty)
}

fn draw_tile(brush: &Brush<'_>, sprites: &[ScreenSprite], rect: TileRect, members: &[u32], stop_below: f32) -> Tile {
    let mut tile = Tile::clear();
    // Looking whether a tile is opaque costs a pass over it: every eighth sprite is often enough.
    for batch in members.chunks(8) {
        for &member in batch {
            brush.draw(&mut tile, rect, &sprites[member as usize]);
        }
        if tile.most_through(rect) < stop_below {
            break;
        }
    }
    tile
}

fn assemble<P: Copy + Send + Sync>(tiles: &[(TileRect, Vec<P>)], width: u32, height: u32, empty: P) -> Vec<P> {
    let mut pixels = vec![empty; width as usize * height as usize];
    for (rect, tile) in tiles {
        for (row, line) in tile.chunks(rect.width as usize).enumerate() {
            let start = (rect.top as usize + row) * width as usize + rect.left as usize;
            pixels[start..start + line.len()].copy_from_slice(line);
        }
    }
    pixels
}
