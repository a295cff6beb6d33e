//! Few balls that stand for many.

use super::Ball;
use glam::Vec3;

/// Of a ball whose extinction falls as 1 − r²: the square of its half, over its variance along an axis.
const HALF_OVER_SPREAD: f32 = 7.0;

/// At most `most` balls, a power of two, with the cross-section and the spread of those that each stands for. They are
/// halved across their longest side, until few enough are left.
pub fn gathered(balls: &[Ball], most: usize) -> Vec<Ball> {
    let mut all: Vec<Ball> = balls.iter().filter(|ball| ball.depth > 0.0).copied().collect();
    let mut parts: Vec<&mut [Ball]> = if all.is_empty() { Vec::new() } else { vec![&mut all] };
    while parts.len() * 2 <= most && parts.iter().any(|part| part.len() > 1) {
        parts = parts.into_iter().flat_map(halved).collect();
    }
    parts.iter().map(|part| one_of(part)).collect()
}

fn halved(part: &mut [Ball]) -> impl Iterator<Item = &mut [Ball]> {
    let low = part.iter().map(|ball| ball.center).fold(Vec3::MAX, Vec3::min);
    let high = part.iter().map(|ball| ball.center).fold(Vec3::MIN, Vec3::max);
    let axis = (high - low).max_position();
    let middle = part.len() / 2;
    if part.len() > 1 {
        part.select_nth_unstable_by(middle, |a, b| {
            let key = |ball: &Ball| ball.center.to_array();
            // Ties by the rest, so that what is first does not depend on the order within.
            key(a)[axis].total_cmp(&key(b)[axis]).then_with(|| order(a, b))
        });
    }
    let (first, second) = part.split_at_mut(middle);
    [first, second].into_iter().filter(|half| !half.is_empty())
}

fn order(a: &Ball, b: &Ball) -> std::cmp::Ordering {
    let numbers = |ball: &Ball| [ball.center.x, ball.center.y, ball.center.z, ball.depth];
    numbers(a)
        .into_iter()
        .zip(numbers(b))
        .map(|(a, b)| a.total_cmp(&b))
        .fold(std::cmp::Ordering::Equal, |so, next| so.then(next))
}

/// The one ball that stands for some.
fn one_of(balls: &[Ball]) -> Ball {
    if let [only] = balls {
        return *only;
    }
    let sum = |of: &dyn Fn(&Ball) -> Vec3| balls.iter().map(|ball| of(ball) * cross_section(ball)).sum::<Vec3>();
    let all: f32 = balls.iter().map(cross_section).sum();
    let center = sum(&|ball| ball.center) / all;
    let spread = sum(&|ball| {
        let (off, half) = (ball.center - center, ball.half());
        off * off + half * half / HALF_OVER_SPREAD
    }) / all;
    let half = [0.5 * (spread.x + spread.z), spread.y].map(|spread| (HALF_OVER_SPREAD * spread).sqrt().max(1e-3));
    let of_depth_one = Ball { center, inverse_half: half.map(|half| 1.0 / half), depth: 1.0 };
    Ball { depth: all / cross_section(&of_depth_one), ..of_depth_one }
}

/// In proportion to all the light that it takes away while it is thin, whichever way that comes: depth times the mean area.
fn cross_section(ball: &Ball) -> f32 {
    let [across, upwards] = ball.inverse_half;
    ball.depth / libm::cbrtf(across * across * upwards * across * across * upwards)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::baked::optical_depth;
    use crate::random::{draw, unit};

    fn heap(count: u32) -> Vec<Ball> {
        let one = |i: u32| {
            let [x, y, z, size] = draw(9, 1, i, 0).map(|bits| unit(bits) as f32);
            let center = Vec3::new(x - 0.5, y * 0.7, z - 0.5) * 1000.0;
            Ball::new(center, [60.0 + 60.0 * size, 50.0 + 40.0 * size], 0.3)
        };
        (0..count).map(one).collect()
    }

    #[test]
    fn few_are_as_deep_as_many() {
        let many = heap(400);
        let few = gathered(&many, 32);
        assert_eq!(few.len(), 32);
        let taken = |balls: &[Ball]| balls.iter().map(cross_section).sum::<f32>();
        assert!((taken(&few) / taken(&many) - 1.0).abs() < 1e-4);
        // In the light that is left behind it, spot by spot: outlines and gaps shift by some of a ball's radius, a third of the
        // heap's; the sum of what is taken does not.
        let mut off = Vec::new();
        for towards in [Vec3::Y, Vec3::new(0.7, 0.7, 0.0), Vec3::new(0.0, 0.2, -1.0)].map(Vec3::normalize) {
            for step in 0..100 {
                let at = Vec3::new((step % 10) as f32 - 4.5, 0.0, (step / 10) as f32 - 4.5) * 100.0 - towards * 2000.0;
                let left = |balls: &[Ball]| (-0.1 * optical_depth(balls, at, towards)).exp();
                off.push((left(&few) - left(&many)).abs());
            }
        }
        off.sort_by(f32::total_cmp);
        assert!(off[off.len() / 2] < 0.1 && off[off.len() * 95 / 100] < 0.25, "{} {}", off[150], off[285]);
    }

    #[test]
    fn of_none_and_one() {
        assert!(gathered(&[], 32).is_empty());
        let one = heap(1);
        assert_eq!(gathered(&one, 32), one);
        assert_eq!(gathered(&heap(3), 32).len(), 3);
    }
}
