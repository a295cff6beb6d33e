//! A map of errors as a picture: from black over purple and orange to pale yellow.
//!
//! The colours are matplotlib's “magma” (Stéfan van der Walt and Nathaniel Smith 2015, public domain), in which equal
//! steps look equal; FLIP's own tool shows its maps in it. Here are every fifteenth of its 256 entries; what lies
//! between is mixed, which differs from the full table by 3 of 255 at most.

use cloudwright_core::image::Picture;

/// sRGB, from no error to the largest.
pub const COLORS: [[u8; 3]; 18] = [
    [0, 0, 4],
    [9, 7, 32],
    [26, 16, 66],
    [49, 17, 101],
    [74, 16, 121],
    [98, 25, 128],
    [121, 34, 130],
    [145, 43, 129],
    [170, 51, 125],
    [194, 59, 117],
    [217, 70, 107],
    [236, 88, 96],
    [247, 114, 92],
    [252, 142, 100],
    [254, 170, 116],
    [254, 198, 138],
    [253, 226, 163],
    [252, 253, 191],
];

/// `share` of the largest error as a colour; what lies outside 0 to 1 is clamped, and NaN shows as the worst.
pub fn color(share: f32) -> [u8; 3] {
    let last = COLORS.len() - 1;
    let share = if share.is_nan() { 1.0 } else { share.clamp(0.0, 1.0) };
    let at = share * last as f32;
    let below = (at as usize).min(last - 1);
    let (from, to, t) = (COLORS[below], COLORS[below + 1], at - below as f32);
    std::array::from_fn(|i| (f32::from(from[i]) * (1.0 - t) + f32::from(to[i]) * t).round() as u8)
}

/// A picture of `errors`, one a pixel, top row first; `brightest` is the error shown as the last colour. Pixels
/// beyond the end of `errors` show none.
pub fn picture([width, height]: [u32; 2], errors: &[f32], brightest: f32) -> Picture {
    let opaque = |[r, g, b]: [u8; 3]| [r, g, b, 255];
    // A map without errors is black whatever its scale.
    let scale = if brightest > 0.0 { 1.0 / brightest } else { 0.0 };
    let mut pixels: Vec<_> = errors.iter().map(|error| opaque(color(error * scale))).collect();
    pixels.resize(width as usize * height as usize, opaque(COLORS[0]));
    Picture { width, height, pixels }
}
