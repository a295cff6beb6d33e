//! The few formulas that several phases share.

use glam::Vec3;

/// 0 below `from`, 1 above `to`, 3t² − 2t³ between; a step when the two are equal.
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

/// Hours as a clock shows them, `HH:MM`, to the nearest minute; cyclic.
pub fn clock(hours: f64) -> String {
    let minutes = libm::round(hours.rem_euclid(24.0) * 60.0) as u32 % 1440;
    format!("{:02}:{:02}", minutes / 60, minutes % 60)
}
