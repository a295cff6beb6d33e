//! The few formulas that several phases share.

use glam::Vec3;

/// 0 below `from`, 1 above `to`, 3t² − 2t³ between; a step when the two are equal.
#[inline(always)]
pub fn smoothstep(from: f32, to: f32, x: f32) -> f32 {
    if to <= from {
        return if x < from { 0.0 } else { 1.0 };
    }
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// `v` scaled to length 1, or `fallback` where `v` is too short to have a direction.
///
/// Bounded for tiny and huge vectors alike: the largest component is divided out first.
pub fn unit_or(v: Vec3, fallback: Vec3) -> Vec3 {
    let largest = v.abs().max_element();
    if !(largest.is_finite() && largest > f32::MIN_POSITIVE) {
        return fallback;
    }
    let scaled = v / largest;
    scaled / scaled.length()
}

/// The part of `v` across the unit vector `axis`.
pub fn across(v: Vec3, axis: Vec3) -> Vec3 {
    v - axis * v.dot(axis)
}

/// e^x within 4·10⁻⁷ of its value, 0 below −87.3 and about 10³⁸ above 87.3: plain arithmetic without branches, so that
/// a loop over pixels runs eight at once, and the same everywhere.
#[inline(always)]
pub fn exp(x: f32) -> f32 {
    let x = x.clamp(-87.4, 87.4);
    let whole = (x * std::f32::consts::LOG2_E + 0.5).floor();
    // ln 2 in two parts, so that the difference is exact (Cody and Waite 1980); what is left lies within ½ ln 2.
    let r = (x - whole * 0.693_359_4) + whole * 2.121_944_4e-4;
    let fraction =
        1.0 + r * (1.0 + r * (0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 + r * (1.0 / 720.0))))));
    let scale = f32::from_bits(((whole as i32 + 127) as u32) << 23);
    if x < -87.3 { 0.0 } else { fraction * scale }
}

/// Hours as a clock shows them, `HH:MM`, to the nearest minute; cyclic.
pub fn clock(hours: f64) -> String {
    let minutes = libm::round(hours.rem_euclid(24.0) * 60.0) as u32 % 1440;
    format!("{:02}:{:02}", minutes / 60, minutes % 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exp_is_near_the_exponential() {
        for i in -8700..8700_i32 {
            let x = i as f32 * 0.01;
            let exact = f64::from(x).exp();
            // r⁷/7! at r = ½ ln 2 is 1.2·10⁻⁷; the roundings of r and of the sum are some ulps of 6·10⁻⁸.
            assert!((f64::from(exp(x)) / exact - 1.0).abs() < 4e-7, "{x}: {} for {exact}", exp(x));
        }
        assert_eq!(exp(-1e30), 0.0);
        assert!(exp(f32::INFINITY).is_finite());
    }
}
