//! ꟻLIP's colours: opponent channels, in which eyes filter, and a space of even steps, in which they compare.
//!
//! The paper filters YCxCz, whose factors and offset drop out of a sum of weights; what is left is Y, X − Y and Y − Z,
//! with X, Y, Z 1 each for white. Colours are compared in CIELAB, its hues weighted by lightness (Hunt's effect), by
//! the distance HyAB (Abasi, Amani Tehran, Fairchild 2020), which takes hues apart from lightness.

use crate::color::linear_from_srgb;
use crate::math::pow;
use glam::{DMat3, DVec3};

/// X, Y and Z of linear sRGB under D65, each row's denominator left out: they sum to 1, so that white is (1, 1, 1).
const XYZ_FROM_RGB: [[f64; 3]; 3] = [
    [10_135_552.0, 8_788_810.0, 4_435_075.0],
    [2_613_072.0, 8_788_810.0, 887_015.0],
    [1_425_312.0, 8_788_810.0, 70_074_185.0],
];
/// The power that differences of colour are raised to: the paper's q_c.
const COLOR_POWER: f32 = 0.7;
/// Differences up to this share of the largest (p_c) …
const COMMON_SHARE: f32 = 0.4;
/// … take this much of the errors' range (p_t).
const COMMON_ERRORS: f32 = 0.95;

/// What colours are computed with.
pub struct Colors {
    /// Linear light of a byte of sRGB.
    linear: [f32; 256],
    xyz_from_rgb: [[f32; 3]; 3],
    rgb_from_xyz: [[f32; 3]; 3],
    /// The difference of green and blue, the largest that a display shows.
    largest: f32,
}

impl Colors {
    pub fn new() -> Self {
        let rows = XYZ_FROM_RGB.map(DVec3::from_array).map(|row| row / row.element_sum());
        // DMat3 takes columns.
        let xyz_from_rgb = DMat3::from_cols_array_2d(&rows.map(|row| row.to_array())).transpose();
        let rows = |matrix: DMat3| [matrix.row(0), matrix.row(1), matrix.row(2)].map(|row| row.as_vec3().to_array());
        let mut colors = Self {
            linear: std::array::from_fn(|byte| linear_from_srgb(byte as f32 / 255.0)),
            xyz_from_rgb: rows(xyz_from_rgb),
            rgb_from_xyz: rows(xyz_from_rgb.inverse()),
            largest: 1.0,
        };
        let [green, blue] = [[0, 255, 0, 255], [0, 0, 255, 255]].map(|pixel| colors.opponent(pixel));
        colors.largest = pow(distance(colors.even_steps(green), colors.even_steps(blue)), COLOR_POWER);
        colors
    }

    /// Y, X − Y and Y − Z of a pixel.
    #[inline(always)]
    pub fn opponent(&self, [r, g, b, _]: [u8; 4]) -> [f32; 3] {
        let linear = |byte: u8| self.linear[usize::from(byte)];
        let [x, y, z] = product(&self.xyz_from_rgb, [linear(r), linear(g), linear(b)]);
        [y, x - y, y - z]
    }

    /// Turns opponent colours into lightness and two hues, in even steps.
    #[inline(always)]
    pub fn even(&self, [y, x_y, y_z]: &mut [Vec<f32>; 3]) {
        for ((y, x_y), y_z) in y.iter_mut().zip(x_y).zip(y_z) {
            [*y, *x_y, *y_z] = self.even_steps([*y, *x_y, *y_z]);
        }
    }

    /// The errors of colours in even steps, 0 to 1.
    #[inline(always)]
    pub fn put_errors(&self, errors: &mut [f32], [l0, r0, y0]: &[Vec<f32>; 3], [l1, r1, y1]: &[Vec<f32>; 3]) {
        let (lightness, hues) = (l0.iter().zip(l1), r0.iter().zip(r1).zip(y0.iter().zip(y1)));
        for ((error, (l0, l1)), ((r0, r1), (y0, y1))) in errors.iter_mut().zip(lightness).zip(hues) {
            *error = self.redistributed(distance([*l0, *r0, *y0], [*l1, *r1, *y1]));
        }
    }

    /// Lightness and two hues of an opponent colour, of which a display shows what it can.
    #[inline(always)]
    fn even_steps(&self, [y, x_y, y_z]: [f32; 3]) -> [f32; 3] {
        let [r, g, b] = product(&self.rgb_from_xyz, [y + x_y, y, y - y_z]);
        let shown = [r.clamp(0.0, 1.0), g.clamp(0.0, 1.0), b.clamp(0.0, 1.0)];
        let [x, y, z] = product(&self.xyz_from_rgb, shown);
        let [x, y, z] = [evened(x), evened(y), evened(z)];
        let lightness = 116.0 * y - 16.0;
        let hunt = 0.01 * lightness;
        [lightness, hunt * 500.0 * (x - y), hunt * 200.0 * (y - z)]
    }

    /// Common differences spread over most of the range, the rest pressed into what is left.
    #[inline(always)]
    fn redistributed(&self, distance: f32) -> f32 {
        let difference = pow(distance, COLOR_POWER);
        let common = COMMON_SHARE * self.largest;
        let rare = COMMON_ERRORS + (1.0 - COMMON_ERRORS) * (difference - common) / (self.largest - common);
        if difference < common { COMMON_ERRORS * difference / common } else { rare }
    }
}

/// CIELAB's curve: a cube root, straight near black.
#[inline(always)]
fn evened(t: f32) -> f32 {
    const EDGE: f32 = 6.0 / 29.0;
    let straight = t * (1.0 / (3.0 * EDGE * EDGE)) + 4.0 / 29.0;
    if t > EDGE * EDGE * EDGE { pow(t, 1.0 / 3.0) } else { straight }
}

/// HyAB: steps of lightness plus the distance of hues.
#[inline(always)]
fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    let [lightness, red_green, blue_yellow] = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    lightness.abs() + (red_green * red_green + blue_yellow * blue_yellow).sqrt()
}

#[inline(always)]
fn product(rows: &[[f32; 3]; 3], [x, y, z]: [f32; 3]) -> [f32; 3] {
    let row = |i: usize| rows[i][0] * x + rows[i][1] * y + rows[i][2] * z;
    [row(0), row(1), row(2)]
}
