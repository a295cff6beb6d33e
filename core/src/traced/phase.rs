//! How droplets turn light: Henyey and Greenstein's phase function (*Diffuse radiation in the galaxy*, 1941).

use glam::Vec3;
use std::f64::consts::{PI, TAU};

/// The mean cosine of the angle by which light is turned, of cloud droplets in visible light (MODEL §10).
pub const FORWARD: f64 = 0.85;

/// Of scattered light, how much goes on so that it is turned by an angle of that cosine, a steradian⁻¹.
pub(super) fn share(cos: f32) -> f64 {
    const G: f64 = FORWARD;
    let spread = 1.0 + G * G - 2.0 * G * f64::from(cos.clamp(-1.0, 1.0));
    (1.0 - G * G) / (4.0 * PI * spread * spread.sqrt())
}

/// Where light that came along a unit `direction` goes on, by two dice from 0 to 1.
pub(super) fn scattered(direction: Vec3, turn: f64, around: f64) -> Vec3 {
    const G: f64 = FORWARD;
    let part = (1.0 - G * G) / (1.0 - G + 2.0 * G * turn);
    let cos = ((1.0 + G * G - part * part) / (2.0 * G)).clamp(-1.0, 1.0);
    let sin = (1.0 - cos * cos).sqrt();
    let (right, up) = direction.any_orthonormal_pair();
    let [x, y] = [libm::cos(around * TAU) * sin, libm::sin(around * TAU) * sin];
    (direction * cos as f32 + right * x as f32 + up * y as f32).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{draw, unit};

    /// A histogram of what is drawn against the function: 40 bins of 40,000 draws, each within five standard deviations.
    #[test]
    fn what_is_drawn_is_what_the_function_says() {
        const BINS: usize = 40;
        const DRAWS: u32 = 40_000;
        let from = Vec3::new(0.3, -0.5, 0.8).normalize();
        let mut counts = [0_u32; BINS];
        for number in 0..DRAWS {
            let [turn, around, ..] = draw(1, 2, number, 0).map(unit);
            let cos = from.dot(scattered(from, turn, around)).clamp(-1.0, 1.0);
            counts[((0.5 + 0.5 * cos) * BINS as f32).min(BINS as f32 - 1.0) as usize] += 1;
        }
        let steps = 1000;
        for (bin, count) in counts.iter().enumerate() {
            let cos = |i: usize| -1.0 + 2.0 * (bin as f64 + (i as f64 + 0.5) / f64::from(steps)) / BINS as f64;
            let mean: f64 = (0..steps as usize).map(|i| share(cos(i) as f32)).sum::<f64>() / f64::from(steps);
            let expected = mean * TAU * 2.0 / BINS as f64 * f64::from(DRAWS);
            let off = (f64::from(*count) - expected).abs();
            assert!(off < 5.0 * expected.sqrt() + 1.0, "bin {bin}: {count}, not {expected}");
        }
    }
}
