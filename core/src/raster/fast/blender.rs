//! How sprites are drawn into a tile: eight pixels at once where the processor can, else one by one.

use super::super::bins::{TILE, TileRect};
use super::super::models::share_before;
use super::super::{Glow, Hit, ScreenSprite};
use super::fragments::{Fragments, LANES};
use super::queue::Queue;
use super::tile::{Spans, Tile, bits};
use crate::sprites::Atlas;

/// Blends sprites of one atlas into tiles, in the way that this processor does fastest.
pub struct Blender<'a> {
    atlas: &'a Atlas,
    #[cfg(target_arch = "x86_64")]
    avx2: Option<super::avx2::Avx2Blender<'a>>,
}

impl<'a> Blender<'a> {
    pub fn new(atlas: &'a Atlas) -> Self {
        Self {
            #[cfg(target_arch = "x86_64")]
            avx2: super::avx2::Avx2Blender::new(atlas),
            ..Self::one_by_one(atlas)
        }
    }

    /// The blender that any processor has.
    pub fn one_by_one(atlas: &'a Atlas) -> Self {
        Self {
            atlas,
            #[cfg(target_arch = "x86_64")]
            avx2: None,
        }
    }

    /// Adds `sprite` in these lights behind what `tile` shows already, or to the `queue`. Pixels
    /// that let less than `stop_below` through may be left as they are.
    pub fn draw<const G: usize>(
        &self,
        (tile, queue): (&mut Tile<G>, Option<&mut Queue<G>>),
        rect: TileRect,
        (sprite, lights): (&ScreenSprite, &[Glow; G]),
        stop_below: f32,
    ) {
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = &self.avx2 {
            return avx2.draw((tile, queue), rect, (sprite, lights), stop_below);
        }
        self.draw_one_by_one((tile, queue), rect, (sprite, lights), stop_below);
    }

    fn draw_one_by_one<const G: usize>(
        &self,
        (tile, mut queue): (&mut Tile<G>, Option<&mut Queue<G>>),
        rect: TileRect,
        (sprite, lights): (&ScreenSprite, &[Glow; G]),
        stop_below: f32,
    ) {
        for (row, span) in Spans::new(sprite, rect).rows() {
            for group in bits(tile.open_groups(row, &span)) {
                let (first_x, pixel_y) =
                    (rect.left as f32 + (group * LANES) as f32 + 0.5, rect.top as f32 + row as f32 + 0.5);
                let mut fragments = Fragments::NONE;
                // Of the plane, also where the sprite does not show: what is clear must not keep others waiting.
                fragments.nearness = std::array::from_fn(|lane| sprite.nearness(first_x + lane as f32, pixel_y));
                for x in (group * LANES..(group + 1) * LANES).filter(|x| span.contains(x)) {
                    let pixel_x = rect.left as f32 + x as f32 + 0.5;
                    let Some(Hit { u, v, depth }) = sprite.hit(pixel_x, pixel_y) else { continue };
                    let shown = sprite.shown_by(lights, self.atlas, (u, v), sprite.mip);
                    let Some((colors, alpha)) = shown else { continue };
                    let model = tile.models.as_ref().and_then(|models| models.at(x, row));
                    let share = model.map_or(1.0, |(near, _)| share_before(near, depth, sprite.half_depth_m));
                    fragments.set(x % LANES, alpha * share, &colors.map(|color| color.map(|c| c * share)));
                }
                let through = match &mut queue {
                    None => tile.blend(row * TILE / LANES + group, &fragments),
                    Some(queue) => queue.push(tile, (row, group), fragments),
                };
                if through.iter().all(|through| *through < stop_below) {
                    if let Some(queue) = &mut queue {
                        queue.flush(tile, (row, group));
                    }
                    tile.close(row, group);
                }
            }
        }
    }
}
