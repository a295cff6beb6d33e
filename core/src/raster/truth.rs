//! The truth that error figures are measured against: every ray's own fragments, in their own order.
//!
//! Sprites that face the eye cross one another, so no order of whole sprites is right for every pixel. Here each pixel
//! has `side` × `side` samples; at each, the fragments are sorted by their own depth along the ray (ties by the
//! sprite's place in the scene) and blended in f32, all that a f32 can tell. Of a list's runs it takes the sprites, unfaded. Texels are filtered for the sample's footprint.

use super::bins::{TILE, TileRect, assemble, map_tiles};
use super::models::{ModelTile, Models, before};
use super::plain::put_behind;
use super::{Hit, ScreenSprite, prepare_alone};
use crate::color::{Premultiplied, Rgb};
use crate::draw_list::SpritesAlone;
use crate::frame::Frame;
use crate::image::{Layer, LinearPicture};
use crate::sky::{Background, haze_share};
use crate::watch::Watch;
use glam::Vec3;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Where less than this gets through, what lies behind is lost in the rounding of what lies before.
const LOST: f32 = 1.0 / (1 << 24) as f32;

/// Fragments that are put in order together; then twice as many, and so on, so that thousands of thin ones don't take
/// the square of their number.
const AT_ONCE: usize = 24;

/// Samples a pixel that error figures use: 4 × 4.
pub const SIDE: u32 = 4;

/// The frame in linear light, before exposure; as [`picture_and_clouds`].
pub fn linear_picture(frame: &Frame<'_>, side: u32, watch: &Watch) -> LinearPicture {
    picture_and_clouds(frame, side, watch).0
}

/// The frame in linear light, before exposure, and its clouds alone, with `side` × `side` samples a pixel (at least
/// one). Once `watch` is cancelled, the rest stays black.
pub fn picture_and_clouds(frame: &Frame<'_>, side: u32, watch: &Watch) -> (LinearPicture, Layer) {
    let (width, height) = (frame.view.width, frame.view.height);
    let alone = frame.list.sprites_alone();
    let (sprites, places) = (prepare_alone(frame, alone), places_in_scene(alone));
    let (models, behind) = (Models::new(frame), frame.behind());
    let (done, count) =
        (AtomicUsize::new(0), width.div_ceil(TILE as u32) as usize * height.div_ceil(TILE as u32) as usize);
    let drawn = map_tiles(&sprites, width, height, |rect, members| {
        if watch.is_cancelled() {
            return vec![Pixel::default(); (rect.width * rect.height) as usize];
        }
        let side = side.max(1);
        let models = models.as_ref().and_then(|models| models.tile(rect, side));
        let tile = Tile { frame, behind: &behind, sprites: &sprites, places: &places, members, side, rect, models };
        let pixels = (0..rect.width * rect.height)
            .map(|i| tile.pixel(rect.left + i % rect.width, rect.top + i / rect.width))
            .collect();
        watch.reach((done.fetch_add(1, Ordering::Relaxed) + 1) as f32 / count as f32);
        pixels
    });
    let pixels = assemble(&drawn, width, height, Pixel::default());
    let picture = LinearPicture { width, height, pixels: pixels.iter().map(|pixel| pixel.color).collect() };
    (picture, Layer { width, height, pixels: pixels.into_iter().map(|pixel| pixel.clouds).collect() })
}

/// Before the fragments of one ray.
#[derive(Clone, Copy)]
struct Haze {
    color: Rgb,
    length_m: f32,
    /// Of the ray, for each metre of view depth.
    metres: f32,
}

impl Haze {
    fn along(ray: Vec3, behind: &Background) -> Self {
        Self { color: behind.dome.horizon(ray), length_m: behind.haze_length_m, metres: ray.length() }
    }

    fn before(&self, Premultiplied { r, g, b, a }: Premultiplied, depth: f32) -> Premultiplied {
        let share = haze_share(depth * self.metres, self.length_m);
        let color = Rgb::new(r, g, b) * (1.0 - share) + self.color * (share * a);
        Premultiplied { r: color.r, g: color.g, b: color.b, a }
    }
}

/// What a sample or a pixel shows.
#[derive(Clone, Copy)]
struct Pixel {
    color: Rgb,
    clouds: Premultiplied,
}

impl Default for Pixel {
    fn default() -> Self {
        Self { color: Rgb::BLACK, clouds: Premultiplied::CLEAR }
    }
}

impl Pixel {
    fn plus(self, other: Self) -> Self {
        Self { color: self.color + other.color, clouds: self.clouds + other.clouds }
    }

    fn times(self, share: f32) -> Self {
        Self { color: self.color * share, clouds: self.clouds * share }
    }
}

/// Of each sprite in the list: its cloud and its number within it, which order fragments at one depth.
fn places_in_scene(sprites: SpritesAlone<'_>) -> Vec<[u32; 2]> {
    sprites.in_order().iter().map(|drawn| [drawn.cloud, drawn.sprite]).collect()
}

/// What a tile's pixels are made from.
struct Tile<'a> {
    frame: &'a Frame<'a>,
    behind: &'a Background,
    sprites: &'a [ScreenSprite],
    places: &'a [[u32; 2]],
    members: &'a [u32],
    side: u32,
    rect: TileRect,
    models: Option<ModelTile>,
}

impl Tile<'_> {
    fn pixel(&self, x: u32, y: u32) -> Pixel {
        let Self { side, .. } = *self;
        let spacing = 1.0 / side as f32;
        let at = |pixel: u32, i: u32| pixel as f32 + (i as f32 + 0.5) * spacing;
        let touches = |member: &&u32| {
            let [left, top, right, bottom] = self.sprites[**member as usize].bounds;
            let [x, y] = [x as f32, y as f32];
            left <= x + 1.0 && right >= x && top <= y + 1.0 && bottom >= y
        };
        let members: Vec<u32> = self.members.iter().filter(touches).copied().collect();
        let mut hits = Vec::new();
        let samples = (0..side * side).map(|i| {
            let place = |pixel: u32, start: u32, i: u32| ((pixel - start) * side + i) as usize;
            let (column, row) = (place(x, self.rect.left, i % side), place(y, self.rect.top, i / side));
            let model = self.models.as_ref().and_then(|models| models.at(column, row));
            self.sample(&members, [at(x, i % side), at(y, i / side)], spacing, model, &mut hits)
        });
        samples.fold(Pixel::default(), Pixel::plus).times(spacing * spacing)
    }

    fn sample(
        &self,
        members: &[u32],
        [x, y]: [f32; 2],
        spacing: f32,
        model: Option<(f32, Rgb)>,
        hits: &mut Vec<(Hit, u32)>,
    ) -> Pixel {
        let view = &self.frame.view;
        hits.clear();
        hits.extend(members.iter().filter_map(|&member| Some((self.sprites[member as usize].hit(x, y)?, member))));
        let haze =
            (self.frame.rules.hazes_fragments() && !hits.is_empty()).then(|| Haze::along(view.ray(x, y), self.behind));
        let clouds = self.blended(hits, (spacing, haze), None);
        let Some((nearness, color)) = model else {
            let behind = self.behind.color(view.ray(x, y), view.pixel() * spacing);
            return Pixel { color: clouds.over(behind), clouds };
        };
        Pixel { color: self.blended(hits, (spacing, haze), Some(nearness)).over(color), clouds }
    }

    /// The fragments that a ray `hits`, over one another; as far as they lie before a model, if there is one.
    fn blended(
        &self,
        hits: &mut [(Hit, u32)],
        (spacing, haze): (f32, Option<Haze>),
        model_nearness: Option<f32>,
    ) -> Premultiplied {
        // Nearest first; of equally near ones the list draws the later one over the earlier.
        let place = |member: u32| self.places[member as usize];
        let compare = |(a, i): &(Hit, u32), (b, j): &(Hit, u32)| {
            a.depth.total_cmp(&b.depth).then_with(|| place(*j).cmp(&place(*i)))
        };
        let mut clouds = self.frame.veil;
        let (mut rest, mut at_once) = (hits, AT_ONCE);
        // Of hundreds, a few dozen mostly hide all others: only those are put in order.
        while !rest.is_empty() && 1.0 - clouds.a >= LOST {
            let count = at_once.min(rest.len());
            if count < rest.len() {
                rest.select_nth_unstable_by(count, compare);
            }
            let (nearest, farther) = rest.split_at_mut(count);
            nearest.sort_unstable_by(compare);
            for (Hit { u, v, depth }, member) in nearest.iter() {
                let sprite = &self.sprites[*member as usize];
                let shown = sprite.shown(self.frame.atlas, *u, *v, sprite.mip_at(*depth, spacing));
                let Some(fragment) = shown else { continue };
                let fragment = haze.map_or(fragment, |haze| haze.before(fragment, *depth));
                let among = |near| before(fragment, near, *depth, sprite.half_depth_m);
                put_behind(&mut clouds, model_nearness.map_or(fragment, among));
            }
            (rest, at_once) = (farther, 2 * at_once);
        }
        clouds
    }
}
