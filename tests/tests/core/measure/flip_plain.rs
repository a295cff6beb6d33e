//! ꟻLIP as the paper writes it: filters over squares, summed pixel by pixel in f64. Slow and easy to trust.

use cloudwright_core::image::Picture;
use std::f64::consts::PI;

/// A channel of a picture, or a filter: value at (column, row).
struct Square {
    width: i64,
    height: i64,
    values: Vec<f64>,
}

impl Square {
    fn new(width: i64, height: i64, value: impl Fn(i64, i64) -> f64) -> Self {
        let values = (0..width * height).map(|i| value(i % width, i / width)).collect();
        Self { width, height, values }
    }

    /// A filter of the given radius: weights by the distance from its middle.
    fn filter(radius: i64, weight: impl Fn(f64, f64) -> f64) -> Self {
        Self::new(2 * radius + 1, 2 * radius + 1, |x, y| weight((x - radius) as f64, (y - radius) as f64))
    }

    /// Beyond the edges as at them.
    fn at(&self, x: i64, y: i64) -> f64 {
        self.values[(y.clamp(0, self.height - 1) * self.width + x.clamp(0, self.width - 1)) as usize]
    }

    fn filtered(&self, filter: &Self) -> Self {
        let radius = filter.width / 2;
        Self::new(self.width, self.height, |x, y| {
            let offsets = (-radius..=radius).flat_map(|dy| (-radius..=radius).map(move |dx| (dx, dy)));
            offsets.map(|(dx, dy)| filter.at(radius + dx, radius + dy) * self.at(x + dx, y + dy)).sum()
        })
    }

    /// Positive weights scaled to sum to 1, negative ones to −1.
    fn balanced(mut self) -> Self {
        let sum = |sign: f64| self.values.iter().map(|w| (w * sign).max(0.0)).sum::<f64>();
        let (positive, negative) = (sum(1.0), sum(-1.0));
        self.values.iter_mut().for_each(|w| *w /= if *w < 0.0 { negative } else { positive });
        self
    }
}

/// Each pixel's error.
pub fn flip(reference: &Picture, test: &Picture, pixels_per_degree: f64) -> Vec<f64> {
    let pictures = [reference, test].map(opponent);
    let filters = sensitivity(pixels_per_degree);
    let colors = pictures.each_ref().map(|channels| {
        let filtered: [Square; 3] = std::array::from_fn(|c| channels[c].filtered(&filters[c]));
        let at = |i: usize| clamped([0, 1, 2].map(|c| filtered[c].values[i]));
        (0..filtered[0].values.len()).map(|i| hunt(lab(at(i)))).collect::<Vec<_>>()
    });
    let features = pictures.each_ref().map(|channels| features(&channels[0], pixels_per_degree));

    let largest = hyab(hunt(lab(xyz([0.0, 1.0, 0.0]))), hunt(lab(xyz([0.0, 0.0, 1.0])))).powf(0.7);
    let error = |i: usize| {
        let difference = hyab(colors[0][i], colors[1][i]).powf(0.7);
        let common = 0.4 * largest;
        let color = if difference < common {
            0.95 * difference / common
        } else {
            0.95 + 0.05 * (difference - common) / (largest - common)
        };
        let [edge, point] = [0, 1].map(|kind| (features[0][kind][i] - features[1][kind][i]).abs());
        let feature = (edge.max(point) / 2.0_f64.sqrt()).sqrt();
        color.powf(1.0 - feature)
    };
    (0..reference.pixels.len()).map(error).collect()
}

/// YCxCz.
fn opponent(picture: &Picture) -> [Square; 3] {
    let linear = |byte: u8| {
        let s = f64::from(byte) / 255.0;
        if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }
    };
    let (width, height) = (i64::from(picture.width), i64::from(picture.height));
    [0, 1, 2].map(|c| {
        Square::new(width, height, |x, y| {
            let [r, g, b, _] = picture.pixels[(y * width + x) as usize];
            let [x, y, z] = xyz([r, g, b].map(linear));
            [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)][c]
        })
    })
}

const WHITE: [f64; 3] = [0.950_428_545, 1.0, 1.088_900_371];
const XYZ_FROM_RGB: [[f64; 3]; 3] = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];

/// As shares of white's.
fn xyz(rgb: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|row| (0..3).map(|c| XYZ_FROM_RGB[row][c] * rgb[c]).sum::<f64>() / WHITE[row])
}

/// What a display can show of a colour in YCxCz; as shares of white's X, Y, Z.
fn clamped([y, cx, cz]: [f64; 3]) -> [f64; 3] {
    let y = (y + 16.0) / 116.0;
    let [x, y, z] = [y + cx / 500.0, y, y - cz / 200.0];
    let columns: [glam::DVec3; 3] = [0, 1, 2].map(|c| [0, 1, 2].map(|row| XYZ_FROM_RGB[row][c] / WHITE[row]).into());
    let rgb = glam::DMat3::from_cols(columns[0], columns[1], columns[2]).inverse() * glam::DVec3::new(x, y, z);
    xyz(rgb.clamp(glam::DVec3::ZERO, glam::DVec3::ONE).to_array())
}

fn lab(xyz: [f64; 3]) -> [f64; 3] {
    let edge: f64 = 6.0 / 29.0;
    let [x, y, z] = xyz.map(|t| if t > edge.powi(3) { t.cbrt() } else { t / (3.0 * edge * edge) + 4.0 / 29.0 });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn hunt([l, a, b]: [f64; 3]) -> [f64; 3] {
    [l, 0.01 * l * a, 0.01 * l * b]
}

fn hyab(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).abs() + (a[1] - b[1]).hypot(a[2] - b[2])
}

fn sensitivity(pixels_per_degree: f64) -> [Square; 3] {
    let gaussian = |a: f64, b: f64, z: f64| a * (PI / b).sqrt() * (-PI * PI * z / b).exp();
    let radius = (3.0 * (0.04 / (2.0 * PI * PI)).sqrt() * pixels_per_degree).ceil() as i64;
    let filter = |weight: &dyn Fn(f64) -> f64| {
        Square::filter(radius, |x, y| weight((x * x + y * y) / (pixels_per_degree * pixels_per_degree))).balanced()
    };
    [
        filter(&|z| gaussian(1.0, 0.0047, z)),
        filter(&|z| gaussian(1.0, 0.0053, z)),
        filter(&|z| gaussian(34.1, 0.04, z) + gaussian(13.5, 0.025, z)),
    ]
}

/// Strength of edges and points in luminance, YCxCz's Y.
fn features(luminance: &Square, pixels_per_degree: f64) -> [Vec<f64>; 2] {
    let luminance = Square::new(luminance.width, luminance.height, |x, y| (luminance.at(x, y) + 16.0) / 116.0);
    let sigma = 0.5 * 0.082 * pixels_per_degree;
    let radius = (3.0 * sigma).ceil() as i64;
    let gauss = |x: f64, y: f64| (-(x * x + y * y) / (2.0 * sigma * sigma)).exp();
    let slope = |x: f64, y: f64| -x * gauss(x, y);
    let bend = |x: f64, y: f64| (x * x / (sigma * sigma) - 1.0) * gauss(x, y);
    let strength = |weight: &dyn Fn(f64, f64) -> f64| {
        let across = luminance.filtered(&Square::filter(radius, weight).balanced());
        let down = luminance.filtered(&Square::filter(radius, |x, y| weight(y, x)).balanced());
        across.values.iter().zip(&down.values).map(|(a, b)| a.hypot(*b)).collect::<Vec<_>>()
    };
    [strength(&slope), strength(&bend)]
}
