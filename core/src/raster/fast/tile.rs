//! A tile of the picture in planes, and where in it a sprite may show.

use super::super::bins::{TILE, TileRect};
use super::super::models::ModelTile;
use super::super::{Linear, ScreenSprite};
use super::fragments::{Fragments, LANES, Lanes, Plane};
use crate::camera::NEAR_M;
use crate::color::Rgb;

/// Colours of `G` lights and transmittance of 32 × 32 pixels, each channel a plane of its own.
#[repr(align(64))]
pub struct Tile<const G: usize> {
    /// Red, green and blue of each light.
    pub lights: [[Plane; 3]; G],
    /// What still gets through.
    pub through: Plane,
    /// For each row a bit for each group of [`LANES`] pixels that something still gets through.
    pub open: [u8; TILE],
    /// What the sprites are among.
    pub models: Option<ModelTile>,
}

/// A row of a tile.
pub struct TileRow<'a, const G: usize> {
    /// Red, green and blue of each light.
    pub lights: [[[f32; TILE]; 3]; G],
    /// What still gets through.
    pub through: [f32; TILE],
    models: Option<(&'a ModelTile, usize)>,
}

impl<const G: usize> TileRow<'_, G> {
    /// The model at a pixel, in linear light.
    pub fn model(&self, x: usize) -> Option<Rgb> {
        let (models, row) = self.models?;
        models.at(x, row).map(|(_, color)| color)
    }

    /// Whether there may be models.
    pub fn has_models(&self) -> bool {
        self.models.is_some()
    }
}

impl<const G: usize> Tile<G> {
    /// Behind a veil of these colours and that alpha, which for clear air is nothing; outside the picture nothing gets
    /// through.
    pub fn veiled(rect: TileRect, (veil, alpha): ([Rgb; G], f32), models: Option<ModelTile>) -> Self {
        let [width, height] = [rect.width as usize, rect.height as usize];
        let lights = veil.map(|color| color.to_array().map(|value| [[value; LANES]; TILE * TILE / LANES]));
        let mut through = [[0.0; LANES]; TILE * TILE / LANES];
        for row in through.chunks_mut(TILE / LANES).take(height) {
            row.as_flattened_mut()[..width].fill(1.0 - alpha);
        }
        let groups = ((1_u32 << width.div_ceil(LANES)) - 1) as u8;
        Self { lights, through, open: std::array::from_fn(|row| if row < height { groups } else { 0 }), models }
    }

    /// One row.
    pub fn row(&self, row: usize) -> TileRow<'_, G> {
        let groups = row * TILE / LANES..(row + 1) * TILE / LANES;
        let line_of = |plane: &Plane| {
            let mut line = [0.0; TILE];
            line.copy_from_slice(plane[groups.clone()].as_flattened());
            line
        };
        let lights = self.lights.each_ref().map(|light| light.each_ref().map(line_of));
        TileRow { lights, through: line_of(&self.through), models: self.models.as_ref().map(|models| (models, row)) }
    }

    /// Whether nothing more would show.
    pub fn is_done(&self) -> bool {
        self.open == [0; TILE]
    }

    /// The bits of the row's groups that hold some of these pixels and are open.
    #[inline(always)]
    pub fn open_groups(&self, row: usize, span: &std::ops::Range<usize>) -> u32 {
        let (first, last) = (span.start / LANES, (span.end - 1) / LANES);
        u32::from(self.open[row]) & (u32::MAX << first) & !(u32::MAX << (last + 1))
    }

    /// Adds fragments behind what the group of pixels shows already; gives what still gets through.
    #[inline(always)]
    pub fn blend(&mut self, group: usize, fragments: &Fragments<G>) -> Lanes {
        fragments.blend(&mut self.lights, group, &mut self.through[group]);
        self.through[group]
    }

    /// Nothing more gets through a group.
    #[inline(always)]
    pub fn close(&mut self, row: usize, group: usize) {
        self.open[row] &= !(1 << group);
    }
}

/// The numbers of the bits that are set, lowest first.
#[inline(always)]
pub fn bits(mut set: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = set.trailing_zeros();
        set &= set.wrapping_sub(1);
        (bit < 32).then_some(bit as usize)
    })
}

/// Where in each row of a tile a sprite may show: the pixels whose centres lie in the covered part of its quad and
/// beyond the near plane.
///
/// Every side of that part is a line on the screen where a linear function changes sign, so a row's span is the
/// intersection of half-lines, and each end moves evenly from row to row.
pub struct Spans {
    from: [f32; TILE],
    to: [f32; TILE],
    rows: std::ops::Range<usize>,
}

impl Spans {
    #[inline(always)]
    pub fn new(sprite: &ScreenSprite, rect: TileRect) -> Self {
        let (first_x, first_y) = (rect.left as f32 + 0.5 - sprite.anchor.x, rect.top as f32 + 0.5 - sprite.anchor.y);
        let row_at = |y: f32| ((y - rect.top as f32).max(0.0) as usize).min(rect.height as usize);
        let rows = row_at(sprite.bounds[1] - 0.5)..row_at(sprite.bounds[3] + 0.5);
        let mut spans = Self { from: [0.0; TILE], to: [rect.width as f32 - 1.0; TILE], rows };

        let Linear { at_anchor, dx, dy } = sprite.denominator;
        // Coordinate ≥ edge, or ≤ edge, times the positive denominator; depth / denominator ≥ NEAR likewise.
        let least = |a: Linear, edge: f32| Linear {
            at_anchor: a.at_anchor - edge * at_anchor,
            dx: a.dx - edge * dx,
            dy: a.dy - edge * dy,
        };
        let most = |a: Linear, edge: f32| {
            let Linear { at_anchor, dx, dy } = least(a, edge);
            Linear { at_anchor: -at_anchor, dx: -dx, dy: -dy }
        };
        let both = |sign: f32| Linear {
            at_anchor: sprite.u.at_anchor + sign * sprite.v.at_anchor,
            dx: sprite.u.dx + sign * sprite.v.dx,
            dy: sprite.u.dy + sign * sprite.v.dy,
        };
        for (coordinate, [from, to]) in [sprite.u, sprite.v, both(1.0), both(-1.0)].into_iter().zip(sprite.covered) {
            spans.cut(least(coordinate, from), first_x, first_y);
            spans.cut(most(coordinate, to), first_x, first_y);
        }
        if sprite.outline.is_none() {
            spans.cut(sprite.denominator, first_x, first_y);
            spans.cut(least(Linear { at_anchor: sprite.depth, dx: 0.0, dy: 0.0 }, NEAR_M), first_x, first_y);
        }
        spans
    }

    /// Keeps what lies where `side` is not negative.
    #[inline(always)]
    fn cut(&mut self, side: Linear, first_x: f32, first_y: f32) {
        let at_first = side.at(first_x, first_y);
        let inverse = -1.0 / side.dx;
        let (start, step) = (at_first * inverse, side.dy * inverse);
        for row in 0..TILE {
            let end = start + row as f32 * step;
            if side.dx > 0.0 {
                self.from[row] = self.from[row].max(end);
            } else if side.dx < 0.0 {
                self.to[row] = self.to[row].min(end);
            } else if at_first + row as f32 * side.dy < 0.0 {
                self.to[row] = -1.0;
            }
        }
    }

    /// The rows in which something shows, each with its pixels.
    #[inline(always)]
    pub fn rows(&self) -> impl Iterator<Item = (usize, std::ops::Range<usize>)> {
        self.rows.clone().filter_map(|row| {
            let (from, to) = (self.from[row], self.to[row]);
            let span = from.ceil() as usize..(to + 1.0) as usize;
            (from <= to && !span.is_empty()).then_some((row, span))
        })
    }
}
