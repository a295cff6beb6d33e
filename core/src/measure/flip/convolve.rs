//! ꟻLIP's sums over rows and columns.
//!
//! A band of a picture is filtered along its rows as soon as its colours are known; what comes out stands in planes,
//! from which any piece can be filtered down its columns. Both directions are one sum: of pieces of rows, a
//! pixel or a row apart, so that the same weight meets many numbers side by side. Its order is fixed, so the number of
//! threads changes nothing.

use super::color::Colors;
use super::filters::{Filters, Half};
use crate::image::Picture;
use std::ops::Range;

/// What an eye makes of a piece of a picture, row by row.
pub struct Seen {
    /// Luminance, red against green, blue against yellow: as [`Colors::opponent`], as sharp as the eye sees them.
    pub opponent: [Vec<f32>; 3],
    /// Strength of edges.
    pub edge: Vec<f32>,
    /// Strength of points.
    pub point: Vec<f32>,
}

/// Rows of a picture, filtered along the rows.
pub struct Band<'a> {
    filters: &'a Filters,
    /// Pixels a row.
    width: usize,
    /// The rows that there are in the picture.
    height: usize,
    /// The first of those that are kept: as many before and after the band's own as the filters reach.
    first: usize,
    /// For luminance, red against green, blue against yellow: a plane for each of their Gaussians.
    opponent: [Vec<Vec<f32>>; 3],
    smooth: Vec<f32>,
    slope: Vec<f32>,
    bend: Vec<f32>,
}

impl<'a> Band<'a> {
    /// Filters `rows` of a picture, and those around them, along the rows.
    #[inline(always)]
    pub fn new(filters: &'a Filters, colors: &Colors, picture: &Picture, rows: Range<usize>) -> Self {
        let (width, height, reach) = (picture.width as usize, picture.height as usize, filters.reach);
        let kept = rows.start.saturating_sub(reach)..(rows.end + reach).min(height);
        let plane = || vec![0.0; kept.len() * width];
        let mut band = Self {
            filters,
            width,
            height,
            first: kept.start,
            opponent: filters.sensitivity.each_ref().map(|gaussians| gaussians.iter().map(|_| plane()).collect()),
            smooth: plane(),
            slope: plane(),
            bend: plane(),
        };
        let lines = picture.pixels.chunks_exact(width.max(1)).take(kept.end).skip(kept.start);
        for (row, line) in lines.enumerate() {
            band.filter_row(row, &padded(colors, line, reach));
        }
        band
    }

    /// Filters one of the rows kept, given as its three channels with as much before and after it as the filters reach.
    #[inline(always)]
    fn filter_row<'b>(&mut self, row: usize, channels: &'b [Vec<f32>; 3]) {
        let (filters, width) = (self.filters, self.width);
        let along = |numbers: &'b [f32], k: isize| &numbers[filters.reach.wrapping_add_signed(k)..][..width];
        let of = row * width..(row + 1) * width;
        for (channel, planes) in self.opponent.iter_mut().enumerate() {
            for (plane, half) in planes.iter_mut().zip(&filters.sensitivity[channel]) {
                add_even(&mut plane[of.clone()], half, |k| along(&channels[channel], k));
            }
        }
        add_even(&mut self.smooth[of.clone()], &filters.smooth, |k| along(&channels[0], k));
        add_odd(&mut self.slope[of.clone()], &filters.slope, |k| along(&channels[0], k));
        add_even(&mut self.bend[of], &filters.bend, |k| along(&channels[0], k));
    }

    /// Some columns of some of the band's own rows, which count as the picture's do; row by row.
    #[inline(always)]
    pub fn see(&self, rows: &Range<usize>, columns: &Range<usize>) -> Seen {
        let Filters { sensitivity, smooth, slope, bend, .. } = self.filters;
        let none = || vec![0.0; rows.len() * columns.len()];
        let mut opponent = [none(), none(), none()];
        for (channel, sums) in opponent.iter_mut().enumerate() {
            for (plane, half) in self.opponent[channel].iter().zip(&sensitivity[channel]) {
                self.add_down::<false>(sums, half, plane, rows, columns);
            }
        }
        let [mut across, mut upright, mut across_twice, mut upright_twice] = [none(), none(), none(), none()];
        self.add_down::<false>(&mut across, smooth, &self.slope, rows, columns);
        self.add_down::<true>(&mut upright, slope, &self.smooth, rows, columns);
        self.add_down::<false>(&mut across_twice, smooth, &self.bend, rows, columns);
        self.add_down::<false>(&mut upright_twice, bend, &self.smooth, rows, columns);
        Seen { opponent, edge: length(across, &upright), point: length(across_twice, &upright_twice) }
    }

    /// Adds to `sums` what an even or odd filter makes of a plane's columns: all rows for one filter, then for the next,
    /// since what rows have in common stays in the cache.
    #[inline(always)]
    fn add_down<const ODD: bool>(
        &self,
        sums: &mut [f32],
        half: &Half,
        plane: &[f32],
        rows: &Range<usize>,
        columns: &Range<usize>,
    ) {
        for (row, sums) in rows.clone().zip(sums.chunks_exact_mut(columns.len())) {
            let start = |k: isize| (row.saturating_add_signed(k).min(self.height - 1) - self.first) * self.width;
            let at = |k: isize| &plane[start(k)..][columns.clone()];
            if ODD { add_odd(sums, half, at) } else { add_even(sums, half, at) }
        }
    }
}

/// A row's opponent colours, its first and last going on for `reach` pixels.
#[inline(always)]
fn padded(colors: &Colors, line: &[[u8; 4]], reach: usize) -> [Vec<f32>; 3] {
    let mut channels = [const { Vec::new() }; 3];
    channels.iter_mut().for_each(|channel: &mut Vec<f32>| channel.resize(reach + line.len() + reach, 0.0));
    let end = reach + line.len();
    for (x, pixel) in (reach..).zip(line) {
        [channels[0][x], channels[1][x], channels[2][x]] = colors.opponent(*pixel);
    }
    for channel in &mut channels {
        let (first, last) = (channel[reach], channel[end - 1]);
        channel[..reach].fill(first);
        channel[end..].fill(last);
    }
    channels
}

/// Adds to `sums` what a filter makes of the numbers around them: `at` gives those so many steps on.
#[inline(always)]
fn add_even<'a>(sums: &mut [f32], half: &Half, at: impl Fn(isize) -> &'a [f32]) {
    let Some((middle, sides)) = half.split_first() else { return };
    for (sum, value) in sums.iter_mut().zip(at(0)) {
        *sum += middle * value;
    }
    add_pairs(sums, sides, at, |before, after| before + after);
}

/// As [`add_even`] with the weights before the middle negative, and none for it.
#[inline(always)]
fn add_odd<'a>(sums: &mut [f32], half: &Half, at: impl Fn(isize) -> &'a [f32]) {
    add_pairs(sums, half.get(1..).unwrap_or_default(), at, |before, after| after - before);
}

/// Adds what lies 1, 2, 3, … steps before and after each number, paired and weighted: several steps in one go, since sums
/// that stay in registers are neither stored nor loaded, always in the same order.
#[inline(always)]
fn add_pairs<'a>(
    sums: &mut [f32],
    sides: &[f32],
    at: impl Fn(isize) -> &'a [f32],
    pair: impl Fn(f32, f32) -> f32 + Copy,
) {
    const AT_ONCE: usize = 4;
    let (fours, rest) = sides.as_chunks::<AT_ONCE>();
    for (first, weights) in (1..).step_by(AT_ONCE).zip(fours) {
        add_at_once(sums, first, weights, &at, pair);
    }
    for (k, weight) in (1 + (fours.len() * AT_ONCE) as isize..).zip(rest) {
        add_at_once(sums, k, &[*weight], &at, pair);
    }
}

#[inline(always)]
fn add_at_once<'a, const N: usize>(
    sums: &mut [f32],
    first: isize,
    weights: &[f32; N],
    at: &impl Fn(isize) -> &'a [f32],
    pair: impl Fn(f32, f32) -> f32,
) {
    let count = sums.len();
    let before: [&[f32]; N] = std::array::from_fn(|i| &at(-first - i as isize)[..count]);
    let after: [&[f32]; N] = std::array::from_fn(|i| &at(first + i as isize)[..count]);
    for (x, sum) in sums.iter_mut().enumerate() {
        for i in 0..N {
            *sum += weights[i] * pair(before[i][x], after[i][x]);
        }
    }
}

#[inline(always)]
fn length(mut a: Vec<f32>, b: &[f32]) -> Vec<f32> {
    for (a, b) in a.iter_mut().zip(b) {
        *a = (*a * *a + b * b).sqrt();
    }
    a
}
