//! How sprites are drawn into a tile: eight pixels at once where the processor can, else one by one.

use super::super::ScreenSprite;
use super::super::bins::{TILE, TileRect};
use super::tile::{LANES, Spans, Tile, bits};
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

    /// Adds `sprite` behind what `tile` shows already. Pixels that let less than `stop_below` through may be left as they
    /// are.
    pub fn draw(&self, tile: &mut Tile, rect: TileRect, sprite: &ScreenSprite, stop_below: f32) {
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = &self.avx2 {
            return avx2.draw(tile, rect, sprite, stop_below);
        }
        self.draw_one_by_one(tile, rect, sprite, stop_below);
    }

    fn draw_one_by_one(&self, tile: &mut Tile, rect: TileRect, sprite: &ScreenSprite, stop_below: f32) {
        for (row, span) in Spans::new(sprite, rect).rows() {
            for group in bits(tile.open_groups(row, &span)) {
                for x in (group * LANES..(group + 1) * LANES).filter(|x| span.contains(x)) {
                    let (pixel_x, pixel_y) = (rect.left as f32 + x as f32 + 0.5, rect.top as f32 + row as f32 + 0.5);
                    let fragment = sprite.fragment(self.atlas, pixel_x, pixel_y, |_| sprite.mip);
                    let Some((fragment, _)) = fragment else { continue };
                    let at = row * TILE / LANES + group;
                    let through = tile.planes[3][at][x % LANES];
                    for (c, value) in [fragment.r, fragment.g, fragment.b, -fragment.a].into_iter().enumerate() {
                        tile.planes[c][at][x % LANES] += through * value;
                    }
                }
                if tile.planes[3][row * TILE / LANES + group].iter().all(|through| *through < stop_below) {
                    tile.close(row, group);
                }
            }
        }
    }
}
