//! How far two pictures lie apart in linear light, and two layers of clouds in opacity.
//!
//! Sums run in f64 over each row, then over the rows, so that they are the same on any number of threads. What is no
//! number in one picture alone lies infinitely far off: a fault must not hide in a comparison that is never true.

use super::PixelMap;
use crate::color::Rgb;
use crate::image::{Layer, LinearPicture};
use rayon::prelude::*;
use thiserror::Error;

/// Two pictures that have no pixels in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error(
    "pictures of {} × {} and {} × {} pixels can't be compared: draw both in one size",
    sizes[0][0], sizes[0][1], sizes[1][0], sizes[1][1]
)]
pub struct SizesDiffer {
    /// Width and height of both.
    pub sizes: [[u32; 2]; 2],
}

impl SizesDiffer {
    pub(super) fn check(a: [u32; 2], b: [u32; 2]) -> Result<(), Self> {
        if a == b { Ok(()) } else { Err(Self { sizes: [a, b] }) }
    }
}

/// How far a picture lies from another in linear light, before exposure.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LinearError {
    /// Root of the mean square difference over all pixels' three channels.
    pub rmse: f64,
    /// Largest difference of any channel of any pixel.
    pub largest: f32,
    /// What the largest channel's difference does not exceed in 99.9 % of all pixels.
    pub p999: f32,
}

/// How far the opacity of two layers lies apart, 0 to 1. It does not depend on the sprites' order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OpacityError {
    /// At any pixel.
    pub largest: f32,
    /// Over all pixels.
    pub mean: f64,
}

/// Compares two pictures in linear light. Without pixels nothing differs.
///
/// # Errors
/// If they are of different sizes.
pub fn linear_error(a: &LinearPicture, b: &LinearPicture) -> Result<LinearError, SizesDiffer> {
    let map = linear_error_map(a, b)?;
    let width = (a.width as usize).max(1);
    let rows = a.pixels.par_chunks(width).zip(b.pixels.par_chunks(width));
    let row_sums: Vec<f64> = rows.map(|(a, b)| squares(a, b)).collect();
    let mean_square = row_sums.iter().sum::<f64>() / (3 * map.values.len()).max(1) as f64;
    Ok(LinearError { rmse: mean_square.sqrt(), largest: map.largest(), p999: map.percentile(0.999) })
}

/// Each pixel's largest difference of a channel.
///
/// # Errors
/// If the pictures are of different sizes.
pub fn linear_error_map(a: &LinearPicture, b: &LinearPicture) -> Result<PixelMap, SizesDiffer> {
    SizesDiffer::check([a.width, a.height], [b.width, b.height])?;
    let values = a.pixels.par_iter().zip(&b.pixels).map(|(a, b)| largest_difference(*a, *b)).collect();
    Ok(PixelMap { width: a.width, height: a.height, values })
}

/// Compares two layers' opacity. Without pixels nothing differs.
///
/// # Errors
/// If they are of different sizes.
pub fn opacity_error(a: &Layer, b: &Layer) -> Result<OpacityError, SizesDiffer> {
    SizesDiffer::check([a.width, a.height], [b.width, b.height])?;
    let values = a.pixels.par_iter().zip(&b.pixels).map(|(a, b)| apart(a.a, b.a)).collect();
    let map = PixelMap { width: a.width, height: a.height, values };
    Ok(OpacityError { largest: map.largest(), mean: map.mean() })
}

/// |a − b|, infinite where only one of them is a number.
#[inline(always)]
pub(super) fn apart(a: f32, b: f32) -> f32 {
    let difference = (a - b).abs();
    let same = a == b || (a.is_nan() && b.is_nan());
    let difference = if difference.is_nan() { f32::INFINITY } else { difference };
    if same { 0.0 } else { difference }
}

/// The largest channel's difference.
#[inline(always)]
pub(super) fn largest_difference(a: Rgb, b: Rgb) -> f32 {
    apart(a.r, b.r).max(apart(a.g, b.g)).max(apart(a.b, b.b))
}

fn squares(a: &[Rgb], b: &[Rgb]) -> f64 {
    // A sum for each channel: three chains of additions that don't wait for one another.
    let mut sums = [0.0; 3];
    for (a, b) in a.iter().zip(b) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.to_array().into_iter().zip(b.to_array())) {
            let difference = f64::from(apart(a, b));
            *sum += difference * difference;
        }
    }
    sums.iter().sum()
}
