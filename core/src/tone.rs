//! From linear light to a display: exposure, the tone curve “shoulder”, sRGB, dither.
//!
//! The twin in WGSL is render/src/pass/tone_map/tone_map.wgsl.

use crate::color::{Rgb, srgb_from_linear};
use std::sync::LazyLock;

/// Up to here the tone curve is the identity; above, light is pressed into what is left below white.
pub const SHOULDER: f32 = 0.7;

/// The tone curve: x below [`SHOULDER`], then an exponential that leaves with slope 1 and nears 1.
pub fn tone_curve(x: f32) -> f32 {
    if x <= SHOULDER {
        return x.max(0.0);
    }
    let room = 1.0 - SHOULDER;
    SHOULDER + room * (1.0 - libm::expf((SHOULDER - x) / room))
}

/// Ordered dither in (−½, ½) for pixel (x, y): Bayer's 8 × 8 matrix (1973), so that slow gradients don't band.
pub fn dither(x: u32, y: u32) -> f32 {
    let spread = |v: u32| ((v & 1) << 4) | ((v & 2) << 1) | ((v & 4) >> 2);
    let rank = (spread(x ^ y) << 1) | spread(y);
    (rank as f32 + 0.5) / 64.0 - 0.5
}

/// One pixel of a picture: `exposed` is linear light times the exposure. NaN shows as black.
///
/// Tone curve and sRGB come from a table, within 0.07 of a step of 8 bits.
pub fn encode(exposed: Rgb, x: u32, y: u32) -> [u8; 4] {
    let mut pixel = [[0; 4]];
    encode_row(&exposed.to_array().map(|channel| [channel]), x, y, &mut pixel);
    pixel[0]
}

/// Red, green and blue of a row of pixels, apart.
pub type Planes<const N: usize> = [[f32; N]; 3];

/// As [`encode`] for up to N pixels of a row that begins at (`left`, `y`): as many as `out` holds.
pub fn encode_row<const N: usize>(exposed: &Planes<N>, left: u32, y: u32, out: &mut [[u8; 4]]) {
    let offset: [f32; 8] = std::array::from_fn(|x| 0.5 + dither(left + x as u32, y));
    let table = BYTE_VALUES.as_slice();
    let indices = exposed.map(|channel| channel.map(table_index));
    for (x, pixel) in out.iter_mut().enumerate().take(N) {
        // A float to integer cast saturates.
        let byte = |c: usize| (table.get(indices[c][x] as usize).copied().unwrap_or(255.0) + offset[x % 8]) as u8;
        *pixel = [byte(0), byte(1), byte(2), 255];
    }
}

/// Which entry of the table holds tone curve and sRGB for linear light.
#[inline(always)]
#[allow(clippy::manual_clamp)] // unlike clamp, max takes NaN to the lower end
fn table_index(linear: f32) -> u32 {
    (linear.max(TABLE_FROM).min(TABLE_TO).to_bits() - TABLE_FROM.to_bits()) >> TABLE_SHIFT
}

/// The table's range of linear light: below, all is within 0.02 of black; above, the curve is white.
const TABLE_FROM: f32 = 1.0 / 262_144.0;
const TABLE_TO: f32 = 16.0;
/// Keeps 10 of the 23 bits behind a float's exponent: 1,024 entries for each doubling.
const TABLE_SHIFT: u32 = 13;

static BYTE_VALUES: LazyLock<Vec<f32>> = LazyLock::new(|| {
    let steps = (TABLE_TO.to_bits() - TABLE_FROM.to_bits()) >> TABLE_SHIFT;
    let middle = |step: u32| f32::from_bits(TABLE_FROM.to_bits() + (step << TABLE_SHIFT) + (1 << (TABLE_SHIFT - 1)));
    (0..=steps).map(|step| exact_byte_value(middle(step))).collect()
});

/// What the table is made from.
fn exact_byte_value(linear: f32) -> f32 {
    srgb_from_linear(tone_curve(linear)) * 255.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dither_has_each_rank_once() {
        let mut ranks: Vec<i32> = (0..64).map(|i| ((dither(i % 8, i / 8) + 0.5) * 64.0 - 0.5).round() as i32).collect();
        ranks.sort_unstable();
        assert_eq!(ranks, (0..64).collect::<Vec<_>>());
    }

    #[test]
    fn the_curve_rises_without_a_kink_to_white() {
        for i in 0..400 {
            let x = i as f32 * 0.01;
            let slope = (tone_curve(x + 0.001) - tone_curve(x)) / 0.001;
            assert!((0.0..=1.001).contains(&slope), "at {x}: {slope}");
            // The slope falls from 1 by at most 1/0.3 of itself for each unit: no kink.
            let next = (tone_curve(x + 0.011) - tone_curve(x + 0.01)) / 0.001;
            assert!((slope - next).abs() < 0.04, "at {x}: {slope}, then {next}");
        }
        assert_eq!(tone_curve(0.5), 0.5);
        assert!(tone_curve(3.0) > 0.99 && tone_curve(1e9) <= 1.0);
        assert_eq!(encode(Rgb::new(f32::NAN, 1e30, -3.0), 0, 0)[..3], [0, 255, 0]);
    }

    #[test]
    fn the_table_holds_the_curve() {
        for i in 0..200_000_u32 {
            let linear = i as f32 * 1e-4 * (i % 7) as f32;
            let error = (BYTE_VALUES[table_index(linear) as usize] - exact_byte_value(linear)).abs();
            // Half a step of 1/1024 in x changes sRGB by at most x/2048 · d(sRGB)/dx ≤ 255 · 0.5/2048 = 0.062.
            assert!(error <= 0.07, "at {linear}: off by {error}");
        }
    }
}
