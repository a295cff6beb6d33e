//! ꟻLIP's sums over rows and columns, sixteen pixels at a time.
//!
//! A band of a picture is filtered along its rows as soon as its colours are known; what comes out stands in planes,
//! from which any sixteen pixels in a row can be filtered down their columns. Both directions are one sum: of blocks
//! of sixteen numbers, a pixel or a row apart. Its order is fixed, so the number of threads changes nothing.

use super::color::Colors;
use super::filters::{Filters, Half};
use crate::image::Picture;
use std::ops::Range;

/// Pixels that are filtered at once: what a processor's registers hold.
pub const BLOCK: usize = 16;
/// A number for each of them.
pub type Block = [f32; BLOCK];

/// What an eye makes of sixteen pixels.
pub struct Seen {
    /// Luminance, red against green, blue against yellow: as [`Colors::opponent`], as sharp as the eye sees them.
    pub opponent: [Block; 3],
    /// Strength of edges.
    pub edge: Block,
    /// Strength of points.
    pub point: Block,
}

/// Rows of a picture, filtered along the rows.
pub struct Band<'a> {
    filters: &'a Filters,
    /// The rows that there are in the picture.
    height: usize,
    /// The first of those that are kept: as many before and after the band's own as the filters reach.
    first: usize,
    /// Numbers from row to row of a plane.
    stride: usize,
    /// For luminance, red against green, blue against yellow: a plane for each of their Gaussians.
    opponent: [Vec<Vec<f32>>; 3],
    smooth: Vec<f32>,
    slope: Vec<f32>,
    bend: Vec<f32>,
}

impl<'a> Band<'a> {
    /// Filters `rows` of a picture, and those around them, along the rows.
    pub fn new(filters: &'a Filters, colors: &Colors, picture: &Picture, rows: Range<usize>) -> Self {
        let (width, height, reach) = (picture.width as usize, picture.height as usize, filters.reach);
        let kept = rows.start.saturating_sub(reach)..(rows.end + reach).min(height);
        let stride = width.next_multiple_of(BLOCK);
        let plane = || Vec::with_capacity(kept.len() * stride);
        let mut band = Self {
            filters,
            height,
            first: kept.start,
            stride,
            opponent: filters.sensitivity.each_ref().map(|gaussians| gaussians.iter().map(|_| plane()).collect()),
            smooth: plane(),
            slope: plane(),
            bend: plane(),
        };
        for line in picture.pixels.chunks(width.max(1)).take(kept.end).skip(kept.start) {
            band.push(&padded(colors, line, stride, reach));
        }
        band
    }

    /// Adds a row, given as its three channels with the filters' reach before and after it.
    fn push(&mut self, channels: &[Vec<f32>; 3]) {
        let Self { filters, stride, .. } = *self;
        for start in (0..stride).step_by(BLOCK) {
            let middle = start + filters.reach;
            for ((planes, halves), channel) in self.opponent.iter_mut().zip(&filters.sensitivity).zip(channels) {
                for (plane, half) in planes.iter_mut().zip(halves) {
                    plane.extend_from_slice(&even(half, along(channel, middle)));
                }
            }
            self.smooth.extend_from_slice(&even(&filters.smooth, along(&channels[0], middle)));
            self.slope.extend_from_slice(&odd(&filters.slope, along(&channels[0], middle)));
            self.bend.extend_from_slice(&even(&filters.bend, along(&channels[0], middle)));
        }
    }

    /// Sixteen pixels from `column` on in a row of the picture that is one of the band's own.
    pub fn see(&self, row: usize, column: usize) -> Seen {
        let (filters, at) = (self.filters, [row, column]);
        let opponent = std::array::from_fn(|channel| {
            let gaussians = self.opponent[channel].iter().zip(&filters.sensitivity[channel]);
            gaussians.fold([0.0; BLOCK], |sum, (plane, half)| add(sum, even(half, self.down(plane, at))))
        });
        let across = even(&filters.smooth, self.down(&self.slope, at));
        let upright = odd(&filters.slope, self.down(&self.smooth, at));
        let across_twice = even(&filters.smooth, self.down(&self.bend, at));
        let upright_twice = even(&filters.bend, self.down(&self.smooth, at));
        Seen { opponent, edge: length(across, upright), point: length(across_twice, upright_twice) }
    }

    /// The blocks of a plane above and below a place: so many rows down, or the last that there is.
    #[inline(always)]
    fn down<'b>(&'b self, plane: &'b [f32], [row, column]: [usize; 2]) -> impl Fn(isize) -> &'b Block {
        move |k| {
            let row = row.saturating_add_signed(k).min(self.height - 1);
            block(plane, (row - self.first) * self.stride + column)
        }
    }
}

/// A row's opponent colours, its first and last going on for `reach` pixels, and up to whole blocks.
fn padded(colors: &Colors, line: &[[u8; 4]], stride: usize, reach: usize) -> [Vec<f32>; 3] {
    let mut channels = [const { Vec::new() }; 3];
    channels.iter_mut().for_each(|channel| channel.reserve(stride + 2 * reach));
    let after = stride + reach - line.len();
    let before = std::iter::repeat_n(line.first(), reach).flatten();
    for pixel in before.chain(line).chain(std::iter::repeat_n(line.last(), after).flatten()) {
        for (channel, value) in channels.iter_mut().zip(colors.opponent(*pixel)) {
            channel.push(value);
        }
    }
    channels
}

/// The blocks of a row around a place: so many numbers on.
#[inline(always)]
fn along<'a>(row: &'a [f32], middle: usize) -> impl Fn(isize) -> &'a Block {
    move |k| block(row, middle.wrapping_add_signed(k))
}

/// The block that begins at `start`.
#[inline(always)]
fn block(numbers: &[f32], start: usize) -> &Block {
    numbers.get(start..).and_then(|rest| rest.first_chunk()).unwrap_or(&[0.0; BLOCK])
}

/// Weights a block and those on both sides of it: `at` gives the block so many steps on.
#[inline(always)]
fn even<'a>(half: &Half, at: impl Fn(isize) -> &'a Block) -> Block {
    let middle = half.first().copied().unwrap_or(0.0);
    let mut sum = at(0).map(|value| middle * value);
    for (k, weight) in (1..).zip(&half[1..]) {
        let (before, after) = (at(-k), at(k));
        for i in 0..BLOCK {
            sum[i] += weight * (before[i] + after[i]);
        }
    }
    sum
}

/// As [`even`] with the weights before the middle negative.
#[inline(always)]
fn odd<'a>(half: &Half, at: impl Fn(isize) -> &'a Block) -> Block {
    let mut sum = [0.0; BLOCK];
    for (k, weight) in (1..).zip(&half[1..]) {
        let (before, after) = (at(-k), at(k));
        for i in 0..BLOCK {
            sum[i] += weight * (after[i] - before[i]);
        }
    }
    sum
}

fn add(a: Block, b: Block) -> Block {
    std::array::from_fn(|i| a[i] + b[i])
}

fn length(a: Block, b: Block) -> Block {
    std::array::from_fn(|i| (a[i] * a[i] + b[i] * b[i]).sqrt())
}
