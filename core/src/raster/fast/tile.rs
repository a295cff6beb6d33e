//! A tile of the picture in planes, and the brush that draws sprites into it.

use super::super::{Linear, ScreenSprite};
use super::bins::{TILE, TileRect};
use crate::camera::NEAR_M;
use crate::sprites::Atlas;

/// Pixels that are drawn at once.
pub const LANES: usize = 8;

/// Colour and transmittance of 32 × 32 pixels, each channel a plane of its own.
#[repr(align(64))]
pub struct Tile {
    /// Red, green, blue, and what still gets through.
    pub planes: [[[f32; LANES]; TILE * TILE / LANES]; 4],
}

/// A row of a tile: red, green, blue, and what still gets through.
pub type TileRow = [[f32; TILE]; 4];

impl Tile {
    /// No colour, all gets through.
    pub fn clear() -> Self {
        let mut planes = [[[0.0; LANES]; TILE * TILE / LANES]; 4];
        planes[3] = [[1.0; LANES]; TILE * TILE / LANES];
        Self { planes }
    }

    /// One row.
    pub fn row(&self, row: usize) -> TileRow {
        let groups = row * TILE / LANES..(row + 1) * TILE / LANES;
        std::array::from_fn(|c| {
            let mut line = [0.0; TILE];
            line.copy_from_slice(self.planes[c][groups.clone()].as_flattened());
            line
        })
    }

    /// The most that gets through any pixel of the part within the picture.
    pub fn most_through(&self, rect: TileRect) -> f32 {
        let rows = self.planes[3].chunks(TILE / LANES).take(rect.height as usize);
        let groups = rows.flat_map(|row| &row[..(rect.width as usize).div_ceil(LANES)]);
        let most = groups.fold([0.0_f32; LANES], |most, group| std::array::from_fn(|i| most[i].max(group[i])));
        most.into_iter().fold(0.0, f32::max)
    }
}

/// Draws sprites with one atlas, in the way that this processor does fastest.
pub struct Brush<'a> {
    atlas: &'a Atlas,
    #[cfg(target_arch = "x86_64")]
    avx2: Option<super::avx2::Avx2Brush<'a>>,
}

impl<'a> Brush<'a> {
    pub fn new(atlas: &'a Atlas) -> Self {
        Self {
            #[cfg(target_arch = "x86_64")]
            avx2: super::avx2::Avx2Brush::new(atlas),
            ..Self::one_by_one(atlas)
        }
    }

    /// The brush that any processor has.
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
        for (row, span) in spans(sprite, rect) {
            for x in span {
                let (group, lane) = ((row * TILE + x) / LANES, x % LANES);
                let through = tile.planes[3][group][lane];
                if through < stop_below {
                    continue;
                }
                let (pixel_x, pixel_y) = (rect.left as f32 + x as f32 + 0.5, rect.top as f32 + row as f32 + 0.5);
                let Some((fragment, _)) = sprite.fragment(self.atlas, pixel_x, pixel_y, |_| sprite.mip) else {
                    continue;
                };
                for (c, value) in [fragment.r, fragment.g, fragment.b, -fragment.a].into_iter().enumerate() {
                    tile.planes[c][group][lane] += through * value;
                }
            }
        }
    }
}

/// The rows of a tile in which a sprite shows, each with the pixels from first to last whose centres lie in the covered
/// part of its quad and beyond the near plane.
///
/// Every side of that part is a line on the screen where a linear function changes sign, so a row's span is the
/// intersection of half-lines.
pub fn spans(sprite: &ScreenSprite, rect: TileRect) -> impl Iterator<Item = (usize, std::ops::Range<usize>)> {
    let Linear { at_anchor, dx, dy } = sprite.denominator;
    // Coordinate ≥ edge, or ≤ edge, times the positive denominator; depth / denominator ≥ NEAR likewise.
    let from = |a: Linear, edge: f32| Linear {
        at_anchor: a.at_anchor - edge * at_anchor,
        dx: a.dx - edge * dx,
        dy: a.dy - edge * dy,
    };
    let upto = |a: Linear, edge: f32| Linear {
        at_anchor: edge * at_anchor - a.at_anchor,
        dx: edge * dx - a.dx,
        dy: edge * dy - a.dy,
    };
    let depth = Linear { at_anchor: sprite.depth, dx: 0.0, dy: 0.0 };
    let [left, top, right, bottom] = sprite.covered;
    let always = Linear { at_anchor: 0.0, dx: 0.0, dy: 0.0 };
    let whole = sprite.outline.is_some();
    let sides = [
        from(sprite.u, left),
        upto(sprite.u, right),
        from(sprite.v, top),
        upto(sprite.v, bottom),
        if whole { always } else { sprite.denominator },
        if whole { always } else { from(depth, NEAR_M) },
    ];
    let inverse_dx = sides.map(|side| 1.0 / side.dx);
    let (first_x, first_y) = (rect.left as f32 + 0.5 - sprite.anchor.x, rect.top as f32 + 0.5 - sprite.anchor.y);
    let first_row = (sprite.bounds[1] - rect.top as f32 - 0.5).max(0.0) as usize;
    let last_row = ((sprite.bounds[3] - rect.top as f32 + 0.5).max(0.0) as usize).min(rect.height as usize);
    (first_row..last_row).filter_map(move |row| {
        let y = first_y + row as f32;
        let (mut from, mut to) = (0.0_f32, rect.width as f32 - 1.0);
        for (side, inverse_dx) in sides.iter().zip(inverse_dx) {
            let here = side.at(first_x, y);
            if side.dx > 0.0 {
                from = from.max(-here * inverse_dx);
            } else if side.dx < 0.0 {
                to = to.min(-here * inverse_dx);
            } else if here < 0.0 {
                return None;
            }
        }
        (from <= to).then(|| (row, from.ceil() as usize..to as usize + 1)).filter(|(_, span)| !span.is_empty())
    })
}
