//! The weights of ꟻLIP's filters for one viewing distance, in one dimension each.
//!
//! A filter over a square is a sum of products f(x)·f(y) or f(x)·g(y), and each f is even or odd, so that its weights
//! at 0, 1, 2, … pixels from the middle say all.

use std::f64::consts::PI;

/// Weights at 0, 1, 2, … pixels from the middle.
pub type Half = Vec<f32>;

/// Sums of Gaussians (a, b) whose Fourier transforms a·exp(−π²x²/b)·√(π/b) are the eye's contrast sensitivity for
/// luminance, red against green, and blue against yellow: the paper's table 1, after Johnson and Fairchild.
const SENSITIVITY: [&[(f64, f64)]; 3] = [&[(1.0, 0.0047)], &[(1.0, 0.0053)], &[(34.1, 0.04), (13.5, 0.025)]];
/// Width of the features that eyes are keen on, degrees: the paper's w.
const FEATURE_WIDTH_DEG: f64 = 0.082;

/// All filters for one number of pixels per degree.
pub struct Filters {
    /// For luminance, red against green, and blue against yellow: each an even filter along rows and down columns.
    pub sensitivity: [Vec<Half>; 3],
    /// A Gaussian; even.
    pub smooth: Half,
    /// Its first derivative, for edges; odd.
    pub slope: Half,
    /// Its second derivative, for points; even.
    pub bend: Half,
    /// The farthest pixel that any of them weighs.
    pub reach: usize,
}

impl Filters {
    pub fn new(pixels_per_degree: f64) -> Self {
        let widest = SENSITIVITY.iter().copied().flatten().map(|(_, b)| *b).fold(0.0, f64::max);
        let radius = reach_of((widest / 2.0).sqrt() / PI * pixels_per_degree);
        let sigma = 0.5 * FEATURE_WIDTH_DEG * pixels_per_degree;
        let feature_radius = reach_of(sigma);
        let gauss: Vec<f64> = (0..=feature_radius).map(|k| libm::exp(-square(k) / (2.0 * sigma * sigma))).collect();
        let derived = |f: &dyn Fn(f64) -> f64| -> Vec<f64> {
            gauss.iter().enumerate().map(|(k, weight)| f(k as f64) * weight).collect()
        };
        Self {
            sensitivity: SENSITIVITY.map(|gaussians| sensitivity(gaussians, pixels_per_degree, radius)),
            smooth: balanced(&gauss, 1.0),
            slope: balanced(&derived(&|x| x), 2.0),
            bend: balanced(&derived(&|x| x * x / (sigma * sigma) - 1.0), 1.0),
            reach: radius.max(feature_radius),
        }
    }
}

/// Three standard deviations hold all that matters: the paper's choice.
fn reach_of(standard_deviation: f64) -> usize {
    libm::ceil(3.0 * standard_deviation) as usize
}

fn square(k: usize) -> f64 {
    (k * k) as f64
}

/// One filter for each Gaussian; the sum of their squares over the plane is 1.
fn sensitivity(gaussians: &[(f64, f64)], pixels_per_degree: f64, radius: usize) -> Vec<Half> {
    let at = |b: f64, k: usize| libm::exp(-PI * PI * square(k) / (b * pixels_per_degree * pixels_per_degree));
    let height = |a: f64, b: f64| a * (PI / b).sqrt();
    let line = |b: f64| 1.0 + 2.0 * (1..=radius).map(|k| at(b, k)).sum::<f64>();
    let total: f64 = gaussians.iter().map(|&(a, b)| height(a, b) * line(b) * line(b)).sum();
    let half = |&(a, b): &(f64, f64)| {
        let scale = (height(a, b) / total).sqrt();
        // What f32 would round away is left out: the narrow filters need less than the widest's radius.
        (0..=radius).map(|k| at(b, k)).take_while(|weight| *weight > 1e-9).map(|w| (w * scale) as f32).collect()
    };
    gaussians.iter().map(half).collect()
}

/// Positive and negative weights scaled to sum to 1 and −1 over both halves; of an odd filter, whose halves have
/// opposite signs, one half to 1: `sides` is 2 where the given half is to count as both.
fn balanced(half: &[f64], sides: f64) -> Half {
    let sum = |sign: f64| {
        let both = half.iter().enumerate().map(|(k, w)| if k == 0 { *w } else { 2.0 * w });
        both.map(|w| (w * sign).max(0.0)).sum::<f64>() / sides
    };
    let (positive, negative) = (sum(1.0), sum(-1.0));
    half.iter().map(|w| (w / if *w < 0.0 { negative } else { positive.max(f64::MIN_POSITIVE) }) as f32).collect()
}
