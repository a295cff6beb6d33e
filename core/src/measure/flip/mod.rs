//! ꟻLIP: how large the difference of two pictures looks to someone who flips between them.
//!
//! Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: *FLIP: A Difference Evaluator for Alternating
//! Images*, Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2) (HPG 2020), for displays of 8
//! bits. What an eye cannot resolve is filtered away, colours are compared in a space of even steps, and differences of
//! edges and points, which eyes are keen on, raise the error: 0 is equal, 1 is black for white.
//!
//! All filters are sums of products of a filter along rows and one along columns, so a pixel takes some 300 products
//! instead of 2,500. Bands of rows are filtered along the rows, then down the columns; [`filters`] has the weights,
//! [`convolve`] the sums, [`color`] the colours. The published tool is the judge (tests/flip_reference.py), plain sums
//! over squares are the oracle (tests/tests/core/measure/flip.rs).

mod color;
mod convolve;
mod filters;

use super::{PixelMap, SizesDiffer};
use crate::image::Picture;
use crate::math::pow;
use color::Colors;
use convolve::{Band, Seen};
use filters::Filters;
use rayon::prelude::*;

/// A degree of the eye's field in pixels: a display 0.7 m wide with 3,840 pixels, seen from 0.7 m. All figures that
/// are compared use it.
pub const PIXELS_PER_DEGREE: f64 = 67.020_643;

/// Rows that are filtered together. Those around a band are filtered for both neighbours: a fifth more at this height.
const BAND: usize = 64;
/// Columns that are filtered together.
const PIECE: usize = 128;

/// Each pixel's error, 0 to 1. `pixels_per_degree` is taken into 1 to 1,000, NaN for [`PIXELS_PER_DEGREE`]. Beyond the
/// edges the pictures go on as at them.
///
/// # Errors
/// If the pictures are of different sizes.
pub fn flip(reference: &Picture, test: &Picture, pixels_per_degree: f64) -> Result<PixelMap, SizesDiffer> {
    let (width, height) = (reference.width, reference.height);
    SizesDiffer::check([width, height], [test.width, test.height])?;
    let pixels_per_degree = if pixels_per_degree.is_nan() { PIXELS_PER_DEGREE } else { pixels_per_degree };
    let (filters, colors) = (Filters::new(pixels_per_degree.clamp(1.0, 1000.0)), Colors::new());
    let mut values = vec![0.0; width as usize * height as usize];
    let pair = Pair { filters, colors, pictures: [reference, test], width: width as usize, height: height as usize };
    values.par_chunks_mut((pair.width * BAND).max(1)).enumerate().for_each(|(index, out)| pair.compare(index, out));
    Ok(PixelMap { width, height, values })
}

/// What is compared, by what.
struct Pair<'a> {
    filters: Filters,
    colors: Colors,
    /// Reference and test.
    pictures: [&'a Picture; 2],
    width: usize,
    height: usize,
}

impl Pair<'_> {
    /// Puts the errors of the rows of a band into `out`. Wider instructions do the same sums in the same order.
    fn compare(&self, band: usize, out: &mut [f32]) {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has AVX2; the function needs nothing else.
            #[allow(unsafe_code)]
            return unsafe { self.compare_avx2(band, out) };
        }
        self.compare_plainly(band, out);
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn compare_avx2(&self, band: usize, out: &mut [f32]) {
        self.compare_plainly(band, out);
    }

    #[inline(always)]
    fn compare_plainly(&self, band: usize, out: &mut [f32]) {
        let Self { filters, colors, pictures, width, height } = self;
        let rows = band * BAND..((band + 1) * BAND).min(*height);
        let bands = [
            Band::new(filters, colors, pictures[0], rows.clone()),
            Band::new(filters, colors, pictures[1], rows.clone()),
        ];
        for start in (0..*width).step_by(PIECE) {
            let columns = start..(start + PIECE).min(*width);
            let (reference, test) = (bands[0].see(&rows, &columns), bands[1].see(&rows, &columns));
            let errors = errors(colors, reference, test);
            for (line, piece) in out.chunks_mut(*width).zip(errors.chunks(columns.len())) {
                line[columns.clone()].copy_from_slice(piece);
            }
        }
    }
}

/// The colours' errors raised by the features': c^(1 − f).
#[inline(always)]
fn errors(colors: &Colors, mut reference: Seen, mut test: Seen) -> Vec<f32> {
    colors.even(&mut reference.opponent);
    colors.even(&mut test.opponent);
    let mut errors = vec![0.0; reference.edge.len()];
    colors.put_errors(&mut errors, &reference.opponent, &test.opponent);
    let edges = reference.edge.iter().zip(&test.edge);
    let points = reference.point.iter().zip(&test.point);
    for ((error, (edge0, edge1)), (point0, point1)) in errors.iter_mut().zip(edges).zip(points) {
        let feature = (edge0 - edge1).abs().max((point0 - point1).abs()) * std::f32::consts::FRAC_1_SQRT_2;
        *error = pow(*error, 1.0 - feature.sqrt());
    }
    errors
}
