//! Sprites as soft balls, and the optical depth of what a ray passes of them (MODEL §10).
//!
//! A sprite is an ellipsoid about the vertical, as wide and high as it is when seen from its own level. Its extinction
//! falls as 1 − r² from the middle to its rim, so the depth of any piece of a chord is a polynomial of where the piece
//! begins and ends.

use glam::Vec3;
use std::sync::LazyLock;

/// An optical depth through a ball's middle that counts as quite opaque.
const MOST_DEPTH: f32 = 8.0;
/// Depths in the table that tells which depth covers as much as a tile.
const STEPS: usize = 256;

/// A sprite as a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// Metres in the model's space, from the middle of its sprites.
    pub center: Vec3,
    /// One over half of what it measures across and upwards, 1/m.
    pub inverse_half: [f32; 2],
    /// Optical depth through the middle.
    pub depth: f32,
}

/// A direction that balls are met in.
#[derive(Debug, Clone, Copy)]
pub struct Ray {
    direction: Vec3,
}

impl Ball {
    /// One that covers as much of the square around it as a sprite does that is so opaque on average, 0 to 1. `half`: half of
    /// what it measures across and upwards, metres.
    pub fn new(center: Vec3, half: [f32; 2], opacity: f32) -> Self {
        Self { center, inverse_half: half.map(|half| 1.0 / half.max(1e-3)), depth: depth_that_covers(opacity) }
    }

    /// The longest half of its sides, metres.
    pub fn reach(&self) -> f32 {
        1.0 / self.inverse_half[0].min(self.inverse_half[1])
    }

    /// Half of what it measures along the axes, metres.
    pub fn half(&self) -> Vec3 {
        let [across, upwards] = self.inverse_half;
        Vec3::new(1.0 / across, 1.0 / upwards, 1.0 / across)
    }

    /// Half of what it measures across a direction: along the level, and along what looks up from that, metres.
    pub fn half_across(&self, direction: Vec3) -> [f32; 2] {
        let Vec3 { x: across, y: upwards, .. } = self.half();
        let level_squared = (1.0 - direction.y * direction.y).max(0.0);
        [across, (across * across * direction.y * direction.y + upwards * upwards * level_squared).sqrt()]
    }

    /// Extinction at a point, 1/m along `ray`.
    pub fn extinction(&self, point: Vec3, ray: Ray) -> f32 {
        let from_middle = self.in_own_space(point - self.center);
        let length = self.in_own_space(ray.direction).length();
        0.75 * self.depth * length * (1.0 - from_middle.length_squared()).max(0.0)
    }

    /// Optical depth of what of it lies along `ray` from `point` on.
    #[inline]
    pub fn depth_beyond(&self, point: Vec3, ray: Ray) -> f32 {
        let along = self.along(ray.direction);
        let from_middle = self.in_own_space(point - self.center);
        0.75 * self.depth * beyond(from_middle.dot(along), from_middle.length_squared())
    }

    /// A direction in its own space, unit.
    #[inline]
    pub(super) fn along(&self, direction: Vec3) -> Vec3 {
        let along = self.in_own_space(direction);
        along / along.length_squared().sqrt()
    }

    #[inline]
    fn in_own_space(&self, v: Vec3) -> Vec3 {
        let [across, upwards] = self.inverse_half;
        Vec3::new(v.x * across, v.y * upwards, v.z * across)
    }
}

impl Ray {
    /// Towards a unit vector.
    pub fn towards(direction: Vec3) -> Self {
        Self { direction }
    }
}

/// Of a ball of half size 1 whose extinction falls as 1 − r², what lies beyond a point along a ray, which `begins` so far
/// from where it is nearest to the middle, and at that distance, `squared`, from the middle.
#[inline]
pub(super) fn beyond(begins: f32, squared: f32) -> f32 {
    // Where the ray passes by, its chord is a point, beyond which lies nothing.
    let within = (1.0 - (squared - begins * begins)).max(0.0);
    let half_chord = within.sqrt();
    let from = begins.max(-half_chord).min(half_chord);
    let sum = |t: f32| t * (within - t * t * (1.0 / 3.0));
    sum(half_chord) - sum(from)
}

/// What a ball covers of the square around it, by its depth through the middle, in [`STEPS`] from 0 to [`MOST_DEPTH`].
static COVERS: LazyLock<[f32; STEPS + 1]> = LazyLock::new(|| {
    std::array::from_fn(|step| {
        let depth = step as f32 / STEPS as f32 * MOST_DEPTH;
        // Rings of equal area: at the square x of the distance a chord has the depth (1 − x)^1.5.
        let ring = |i: usize| {
            let inside = 1.0 - (i as f32 + 0.5) / 128.0;
            1.0 - libm::expf(-depth * inside * inside.sqrt())
        };
        (0..128).map(ring).sum::<f32>() / 128.0 * std::f32::consts::FRAC_PI_4
    })
});

/// The depth through the middle of a ball that covers that share of the square around it.
fn depth_that_covers(share: f32) -> f32 {
    let above = COVERS.partition_point(|covers| *covers < share);
    if above == 0 {
        return 0.0;
    }
    let Some(upper) = COVERS.get(above) else { return MOST_DEPTH };
    let lower = COVERS[above - 1];
    (above as f32 - 1.0 + (share - lower) / (upper - lower)) / STEPS as f32 * MOST_DEPTH
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ball_covers_what_its_tile_does() {
        for share in [0.0, 0.02, 0.2, 0.45, 0.6] {
            let depth = f64::from(depth_that_covers(share));
            let cells = 400;
            let cover = |i: usize| {
                let [x, y] = [i % cells, i / cells].map(|at| (at as f64 + 0.5) / cells as f64 * 2.0 - 1.0);
                1.0 - (-depth * (1.0 - x * x - y * y).max(0.0).powf(1.5)).exp()
            };
            let covers = (0..cells * cells).map(cover).sum::<f64>() / (cells * cells) as f64;
            assert!((covers - f64::from(share)).abs() < 2e-3, "{share}: {covers}");
        }
        assert_eq!(depth_that_covers(1.0), MOST_DEPTH);
    }

    /// The polynomial against the sum over short steps, from before, within and behind a flat ball.
    #[test]
    fn pieces_of_chords_are_as_deep_as_their_steps() {
        let ball = Ball { center: Vec3::new(3.0, -2.0, 1.0), inverse_half: [1.0 / 8.0, 1.0 / 3.0], depth: 2.5 };
        let direction = Vec3::new(0.5, 0.7, -0.3).normalize();
        let ray = Ray::towards(direction);
        for offset in [Vec3::ZERO, Vec3::new(2.0, 1.0, -1.0), Vec3::new(-4.0, 0.5, 2.0), Vec3::splat(9.0)] {
            for begins in [-30.0, -2.0, 0.0, 1.5, 30.0] {
                let from = ball.center + offset + direction * begins;
                let step = 0.004;
                let sum: f64 = (0..20_000)
                    .map(|i| f64::from(ball.extinction(from + direction * ((i as f32 + 0.5) * step), ray)))
                    .sum::<f64>()
                    * f64::from(step);
                let got = f64::from(ball.depth_beyond(from, ray));
                assert!((got - sum).abs() < 2e-3, "{offset} from {begins}: {got}, by steps {sum}");
            }
        }
        let through = ball.depth_beyond(ball.center - direction * 50.0, ray);
        assert!((through - 2.5).abs() < 1e-4, "through the middle: {through}");
    }
}
