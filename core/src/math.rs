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
    // So large a number has no bits left below 1: a sum with it is rounded, and its lowest bits are the whole number.
    const ROUNDER: f32 = 1.5 * 8_388_608.0;
    let rounded = x * std::f32::consts::LOG2_E + ROUNDER;
    let whole = rounded - ROUNDER;
    // ln 2 in two parts, so that the difference is exact (Cody and Waite 1980); what is left lies within ½ ln 2.
    let r = (x - whole * 0.693_359_4) + whole * 2.121_944_4e-4;
    let fraction =
        1.0 + r * (1.0 + r * (0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 + r * (1.0 / 720.0))))));
    let scale = f32::from_bits((rounded.to_bits() << 23).wrapping_add(1.0_f32.to_bits()));
    if x < -87.3 { 0.0 } else { fraction * scale }
}

/// ln x within 3·10⁻⁷ + 1.5·10⁻⁷ |ln x| of its value for a number from the least normal one, 10⁻³⁸, on; smaller ones are
/// taken for that. Plain arithmetic as in [`exp`].
#[inline(always)]
pub fn ln(x: f32) -> f32 {
    // x = m · 2^e with m from √½ to √2.
    let bits = x.max(f32::MIN_POSITIVE).to_bits() as i32;
    let exponent = (bits - std::f32::consts::FRAC_1_SQRT_2.to_bits() as i32) >> 23;
    let m = f32::from_bits((bits - (exponent << 23)) as u32);
    // ln m = 2 artanh s, and |s| ≤ 0.172: s¹¹/11 is 10⁻¹⁰.
    let s = (m - 1.0) / (m + 1.0);
    let q = s * s;
    let tail = q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * (1.0 / 9.0))));
    exponent as f32 * std::f32::consts::LN_2 + 2.0 * (s + s * tail)
}

/// x to a power that is not negative, within 1.8·10⁻⁶ of its value for x from 10⁻³ to 10³ and powers up to 1; 0 where x is 0
/// or less. Plain arithmetic as in [`exp`].
#[inline(always)]
pub fn pow(x: f32, power: f32) -> f32 {
    let positive = exp(power * ln(x));
    if x > 0.0 { positive } else { 0.0 }
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

    #[test]
    fn ln_and_pow_are_near_what_they_are_named_for() {
        for i in -6000..6000_i32 {
            let x = exp(i as f32 * 0.0123);
            let exact = f64::from(x).ln();
            // The roundings of s and of the tail by some ulps each; of the exponent's part, whose ln 2 is off by 0.3·10⁻⁷,
            // and of the sum by half an ulp each, 0.6·10⁻⁷.
            assert!((f64::from(ln(x)) - exact).abs() < 3e-7 + 1.5e-7 * exact.abs(), "ln {x}: {} for {exact}", ln(x));
            if exact.abs() < 6.9 {
                for power in [0.0, 1.0 / 3.0, 0.7, 1.0] {
                    let exact = f64::from(x).powf(power.into());
                    // The error of ln, at most 1.4·10⁻⁶ here, weighs by the power at most; exp adds 4·10⁻⁷.
                    assert!((f64::from(pow(x, power)) / exact - 1.0).abs() < 1.8e-6, "{x} to the {power}");
                }
            }
        }
        assert_eq!(ln(1.0), 0.0);
        assert_eq!([pow(0.0, 0.7), pow(-1.0, 0.5), pow(1.0, 0.3)], [0.0, 0.0, 1.0]);
        assert!(ln(0.0).is_finite());
    }
}
