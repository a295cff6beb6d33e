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
    fn filter_row<'b>(&mut self, row: usize, channels: &'b [Vec<f32>; 3]) {
        let (filters, width) = (self.filters, self.width);
        let along = |numbers: &'b [f32], k: isize| &numbers[filters.reach.wrapping_add_signed(k)..][..width];
        let of = row * width..(row + 1) * width;
        for (channel, planes) in self.opponent.iter_mut().enumerate() {
            for (plane, half) in planes.iter_mut().zip(&filters.sensitivity[channel]) {
                add_even(&mut plane[of.clone()], half, &|k| along(&channels[channel], k));
            }
        }
        add_even(&mut self.smooth[of.clone()], &filters.smooth, &|k| along(&channels[0], k));
        add_odd(&mut self.slope[of.clone()], &filters.slope, &|k| along(&channels[0], k));
        add_even(&mut self.bend[of], &filters.bend, &|k| along(&channels[0], k));
    }

    /// Some columns of some of the band's own rows, which count as the picture's do; row by row.
    pub fn see(&self, rows: &Range<usize>, columns: &Range<usize>) -> Seen {
        let Filters { sensitivity, smooth, slope, bend, .. } = self.filters;
        let none = || vec![0.0; rows.len() * columns.len()];
        // All rows for one filter, then for the next: what rows have in common stays in the cache.
        let add = |sums: &mut [f32], adds: Adds, half: &Half, plane: &[f32]| {
            for (row, sums) in rows.clone().zip(sums.chunks_exact_mut(columns.len())) {
                let start = |k: isize| (row.saturating_add_signed(k).min(self.height - 1) - self.first) * self.width;
                adds(sums, half, &|k| &plane[start(k)..][columns.clone()]);
            }
        };
        let mut opponent = [none(), none(), none()];
        for (channel, sums) in opponent.iter_mut().enumerate() {
            for (plane, half) in self.opponent[channel].iter().zip(&sensitivity[channel]) {
                add(sums, add_even, half, plane);
            }
        }
        let [mut across, mut upright, mut across_twice, mut upright_twice] = [none(), none(), none(), none()];
        add(&mut across, add_even, smooth, &self.slope);
        add(&mut upright, add_odd, slope, &self.smooth);
        add(&mut across_twice, add_even, smooth, &self.bend);
        add(&mut upright_twice, add_even, bend, &self.smooth);
        Seen { opponent, edge: length(across, &upright), point: length(across_twice, &upright_twice) }
    }
}

/// A row's opponent colours, its first and last going on for `reach` pixels.
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

/// How a filter's sums are added to others.
type Adds = for<'a> fn(&mut [f32], &Half, &dyn Fn(isize) -> &'a [f32]);

/// Adds to `sums` what a filter makes of the numbers around them: `at` gives those so many steps on.
fn add_even<'a>(sums: &mut [f32], half: &Half, at: &dyn Fn(isize) -> &'a [f32]) {
    let Some((middle, sides)) = half.split_first() else { return };
    for (sum, value) in sums.iter_mut().zip(at(0)) {
        *sum += middle * value;
    }
    for (k, weight) in (1..).zip(sides) {
        for ((sum, before), after) in sums.iter_mut().zip(at(-k)).zip(at(k)) {
            *sum += weight * (before + after);
        }
    }
}

/// As [`add_even`] with the weights before the middle negative, and none for it.
fn add_odd<'a>(sums: &mut [f32], half: &Half, at: &dyn Fn(isize) -> &'a [f32]) {
    for (k, weight) in (0..).zip(half).skip(1) {
        for ((sum, before), after) in sums.iter_mut().zip(at(-k)).zip(at(k)) {
            *sum += weight * (after - before);
        }
    }
}

fn length(mut a: Vec<f32>, b: &[f32]) -> Vec<f32> {
    for (a, b) in a.iter_mut().zip(b) {
        *a = (*a * *a + b * b).sqrt();
    }
    a
}
