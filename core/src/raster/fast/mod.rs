//! The fast CPU renderer: sorted sprites, tiles on all cores, front to back, early stop.
//!
//! The picture falls into tiles of 32 × 32 pixels whose colour and transmittance stay in the first-level cache. Each
//! tile draws the sprites that may touch it, nearest first, and stops when what still gets through no longer shows.
//! Where their planes cross, each pixel's fragments are put in their own order on the way (`order`, `queue`). Within a
//! tile the order is fixed, so the bytes don't depend on the number of threads.
//! [`super::plain`] is its oracle in the order of sprites, [`super::truth`] in that of fragments; without the AVX2
//! instructions the tiles are drawn fragment by fragment as there.

#[cfg(target_arch = "x86_64")]
mod avx2;
mod blender;
mod fragments;
mod order;
mod queue;
mod tile;

use super::bins::{TILE, TileRect, assemble, map_tiles};
use super::models::{ModelTile, Models};
use super::{Glow, ScreenSprite, develop, faded, prepare};
use crate::color::{Premultiplied, Rgb};
use crate::frame::Frame;
use crate::image::{Layer, LinearPicture, Picture};
use crate::rules::{Blending, FragmentOrder};
use crate::sky::BackgroundRows;
use crate::tone::{Planes, encode_row};
use blender::Blender;
use order::{Member, in_tile};
use queue::Queue;
use std::sync::Mutex;
use tile::Tile;

pub(super) use tile::TileRow;

/// The frame as a display shows it, one sample at each pixel's centre.
pub fn picture(frame: &Frame<'_>) -> Picture {
    picture_by(frame, Blending::SHIPPED)
}

/// As [`picture`], blended as it says.
pub fn picture_by(frame: &Frame<'_>, blending: Blending) -> Picture {
    if frame.fading.is_some() {
        return develop(&linear_picture_by(frame, blending), frame.now.exposure);
    }
    let behind = frame.behind();
    let background = BackgroundRows::new(&behind, &frame.view);
    let finish = |rect: TileRect, row: u32, clouds: &TileRow<'_, 1>, out: &mut [[u8; 4]]| {
        let exposed = over_background(&background, (rect, row), clouds, blending.stop_below, frame.now.exposure);
        encode_row(&exposed, rect.left, rect.top + row, out);
    };
    let among = Models::new(frame);
    let pixels = draw(&Blender::new(frame.atlas), (frame, among.as_ref()), blending, [0; 4], finish);
    Picture { width: frame.view.width, height: frame.view.height, pixels }
}

/// The frame in linear light, before exposure.
pub fn linear_picture(frame: &Frame<'_>) -> LinearPicture {
    linear_picture_by(frame, Blending::SHIPPED)
}

/// As [`linear_picture`], blended as it says.
pub fn linear_picture_by(frame: &Frame<'_>, blending: Blending) -> LinearPicture {
    linear_by(&Blender::new(frame.atlas), frame, blending)
}

/// The same, as a processor without wide instructions draws it.
pub fn linear_picture_one_by_one(frame: &Frame<'_>, blending: Blending) -> LinearPicture {
    linear_by(&Blender::one_by_one(frame.atlas), frame, blending)
}

fn linear_by(blender: &Blender<'_>, frame: &Frame<'_>, blending: Blending) -> LinearPicture {
    faded(frame, |frame| linear_in_order(blender, frame, blending), LinearPicture::mix)
}

fn linear_in_order(blender: &Blender<'_>, frame: &Frame<'_>, blending: Blending) -> LinearPicture {
    let behind = frame.behind();
    let background = BackgroundRows::new(&behind, &frame.view);
    let finish = |rect: TileRect, row: u32, clouds: &TileRow<'_, 1>, out: &mut [Rgb]| {
        let [r, g, b] = over_background(&background, (rect, row), clouds, blending.stop_below, 1.0);
        for (x, pixel) in out.iter_mut().enumerate() {
            *pixel = Rgb::new(r[x], g[x], b[x]);
        }
    };
    let among = Models::new(frame);
    let pixels = draw(blender, (frame, among.as_ref()), blending, Rgb::BLACK, finish);
    LinearPicture { width: frame.view.width, height: frame.view.height, pixels }
}

/// The clouds alone.
pub fn clouds(frame: &Frame<'_>, blending: Blending) -> Layer {
    clouds_by(&Blender::new(frame.atlas), frame, blending)
}

/// The clouds alone, as a processor without wide instructions draws them.
pub fn clouds_one_by_one(frame: &Frame<'_>, blending: Blending) -> Layer {
    clouds_by(&Blender::one_by_one(frame.atlas), frame, blending)
}

fn clouds_by(blender: &Blender<'_>, frame: &Frame<'_>, blending: Blending) -> Layer {
    let draw_one = |frame: &Frame<'_>| clouds_in_order(blender, frame, blending);
    faded(frame, draw_one, Layer::mix)
}

fn clouds_in_order(blender: &Blender<'_>, frame: &Frame<'_>, blending: Blending) -> Layer {
    let finish = |_, _, TileRow { lights: [[r, g, b]], through, .. }: &TileRow<'_, 1>, out: &mut [Premultiplied]| {
        for (x, pixel) in out.iter_mut().enumerate() {
            *pixel = Premultiplied { r: r[x], g: g[x], b: b[x], a: 1.0 - through[x] };
        }
    };
    let pixels = draw(blender, (frame, None), blending, Premultiplied::CLEAR, finish);
    Layer { width: frame.view.width, height: frame.view.height, pixels }
}

/// A tile's row over what lies behind it, models too, times `gain`. Where all pixels of the row let less than `stop_below`
/// through, nothing is put behind, but for the sun.
fn over_background(
    background: &BackgroundRows<'_>,
    (rect, row): (TileRect, u32),
    clouds: &TileRow<'_, 1>,
    stop_below: f32,
    gain: f32,
) -> Planes<TILE> {
    let (width, y) = (rect.width as usize, rect.top + row);
    let TileRow { lights: [[r, g, b]], through, .. } = clouds;
    let mut behind = [[0.0; TILE]; 3];
    let shows = |through: &f32| *through >= stop_below;
    if through[..width].iter().any(shows) || background.dazzles(rect.left, y, width) {
        background.row(rect.left, y, width, &mut behind);
    }
    if clouds.has_models() {
        for (x, color) in (0..width).filter_map(|x| Some((x, clouds.model(x)?))) {
            [behind[0][x], behind[1][x], behind[2][x]] = color.to_array();
        }
    }
    for (behind, color) in behind.iter_mut().zip([r, g, b]) {
        for x in 0..TILE {
            behind[x] = (color[x] + through[x] * behind[x]) * gain;
        }
    }
    behind
}

/// Draws all tiles, among models if there are any, and turns each row of each into pixels: `finish(tile, row in the tile,
/// the row's clouds, out)`.
fn draw<P: Copy + Send + Sync>(
    blender: &Blender<'_>,
    (frame, models): (&Frame<'_>, Option<&Models<'_>>),
    blending: Blending,
    empty: P,
    finish: impl Fn(TileRect, u32, &TileRow<'_, 1>, &mut [P]) + Sync,
) -> Vec<P> {
    let sprites = &prepare(frame);
    let Premultiplied { r, g, b, a } = frame.veil;
    let lit = Lit { sprites, lights: |index: usize| [sprites[index].glow()], veil: ([Rgb::new(r, g, b)], a) };
    draw_lit(blender, (frame, models), &lit, blending, empty, finish)
}

/// Sprites on the screen in `G` lights that are kept apart.
pub(super) struct Lit<'a, const G: usize, L: Fn(usize) -> [Glow; G]> {
    /// Back to front.
    pub sprites: &'a [ScreenSprite],
    /// Those of the sprite of an index.
    pub lights: L,
    /// Each light's colour of the veil, and its alpha.
    pub veil: ([Rgb; G], f32),
}

/// As [`draw`], of any lights, among the frame's models, with what any processor does fastest.
pub(super) fn draw_lights<P: Copy + Send + Sync, const G: usize>(
    frame: &Frame<'_>,
    lit: &Lit<'_, G, impl Fn(usize) -> [Glow; G] + Sync>,
    blending: Blending,
    empty: P,
    finish: impl Fn(TileRect, u32, &TileRow<'_, G>, &mut [P]) + Sync,
) -> Vec<P> {
    let models = Models::new(frame);
    draw_lit(&Blender::new(frame.atlas), (frame, models.as_ref()), lit, blending, empty, finish)
}

fn draw_lit<P: Copy + Send + Sync, const G: usize>(
    blender: &Blender<'_>,
    (frame, models): (&Frame<'_>, Option<&Models<'_>>),
    lit: &Lit<'_, G, impl Fn(usize) -> [Glow; G] + Sync>,
    blending: Blending,
    empty: P,
    finish: impl Fn(TileRect, u32, &TileRow<'_, G>, &mut [P]) + Sync,
) -> Vec<P> {
    // Of those that tiles have done with.
    let queues = Mutex::default();
    let tiles = map_tiles(lit.sprites, frame.view.width, frame.view.height, |rect, members| {
        let models = models.and_then(|models| models.tile(rect, 1));
        let tile = draw_tile(blender, lit, (rect, models), members, blending, &queues);
        let mut out = vec![empty; (rect.width * rect.height) as usize];
        for (row, line) in (0..).zip(out.chunks_mut(rect.width as usize)) {
            finish(rect, row, &tile.row(row as usize), line);
        }
        out
    });
    assemble(&tiles, frame.view.width, frame.view.height, empty)
}

fn draw_tile<const G: usize>(
    blender: &Blender<'_>,
    lit: &Lit<'_, G, impl Fn(usize) -> [Glow; G] + Sync>,
    (rect, models): (TileRect, Option<ModelTile>),
    members: &[u32],
    blending: Blending,
    queues: &Mutex<Vec<Queue<G>>>,
) -> Tile<G> {
    let mut tile = Tile::veiled(rect, lit.veil, models);
    let members = match blending.order {
        FragmentOrder::OfSprites => {
            members.iter().map(|index| Member { index: *index, crosses: false, begins: false }).collect()
        }
        FragmentOrder::OfTheirOwn => in_tile(lit.sprites, members, rect),
    };
    let mut queue = None;
    for member in members {
        let index = member.index as usize;
        if member.begins
            && let Some(queue) = &mut queue
        {
            Queue::flush_all(queue, &mut tile);
        }
        if member.crosses && queue.is_none() {
            queue = Some(queues.lock().ok().and_then(|mut queues| queues.pop()).unwrap_or_default());
        }
        let waits = if member.crosses { queue.as_mut() } else { None };
        blender.draw((&mut tile, waits), rect, (&lit.sprites[index], &(lit.lights)(index)), blending.stop_below);
        if tile.is_done() {
            break;
        }
    }
    if let Some(mut queue) = queue {
        queue.flush_all(&mut tile);
        if let Ok(mut queues) = queues.lock() {
            queues.push(queue);
        }
    }
    tile
}
