//! From linear light to a display: exposure, the tone curve “shoulder”, sRGB, dither.
//!
//! The twin in WGSL is render/src/pass/tone_map/tone_map.wgsl.

use crate::color::{Rgb, srgb_from_linear};

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
pub fn encode(exposed: Rgb, x: u32, y: u32) -> [u8; 4] {
    let dither = dither(x, y);
    // A float to integer cast saturates and takes NaN to 0.
    let [r, g, b] = exposed.to_array().map(|c| (srgb_from_linear(tone_curve(c)) * 255.0 + 0.5 + dither) as u8);
    [r, g, b, 255]
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
        }
        assert!(tone_curve(1e9) <= 1.0);
        assert_eq!(encode(Rgb::new(f32::NAN, 1e30, -3.0), 0, 0)[..3], [0, 255, 0]);
    }
}
