//! The up of a sprite that faces somewhere: what a still has, and what one carries along a path.
//!
//! No rule of direction alone is continuous on the whole sphere. A still takes the world's up, and towards the poles
//! the camera's. Along a path a sprite that comes near a pole carries its up by parallel transport (it turns only as far
//! as the facing does) and relaxes to the world's away from the poles. It relaxes by the angle that the facing turns, not
//! by time: at any speed the same, and nothing moves before an eye that hovers.

use crate::math::{across, smoothstep, unit_or};
use glam::Vec3;

/// Between these sines of the elevation the upright turns from the world's up to the camera's.
pub const POLE: [f32; 2] = [0.90, 0.99];
/// Of relaxing, for each angle that the facing turns.
pub const RELAXING: f32 = 3.0;

/// The world's up, across `towards`; `otherwise` at the poles themselves.
pub(super) fn world(towards: Vec3, otherwise: Vec3) -> Vec3 {
    unit_or(across(Vec3::Y, towards), otherwise)
}

/// How far it is to the pole: 1 from 26° on, 0 within 8°.
fn away_from_poles(towards: Vec3) -> f32 {
    1.0 - smoothstep(POLE[0], POLE[1], towards.y.abs())
}

/// The up of a sprite in a still: across `towards`, unit.
pub fn still(towards: Vec3, camera_up: Vec3) -> Vec3 {
    let fallback = across(if towards.x.abs() < 0.8 { Vec3::X } else { Vec3::Z }, towards).normalize();
    let away = away_from_poles(towards);
    let world = world(towards, Vec3::ZERO);
    let camera = unit_or(across(camera_up, towards), world);
    unit_or(world * away + camera * (1.0 - away), fallback)
}

/// `up`, across `before`, carried to `towards` (both unit) and relaxed on the way.
pub fn carry(up: Vec3, before: Vec3, towards: Vec3) -> Vec3 {
    let carried = transport(up, before, towards);
    let world = world(towards, carried);
    // The angle about `towards` that is left to the world's up, counter-clockwise as seen.
    let left = libm::atan2f(carried.cross(world).dot(towards), carried.dot(world));
    let turned = libm::atan2f(before.cross(towards).length(), before.dot(towards));
    let relaxes = RELAXING * turned * away_from_poles(towards);
    if left.abs() <= relaxes {
        return world;
    }
    let (sin, cos) = libm::sincosf(relaxes.copysign(left));
    unit_or(carried * cos + towards.cross(carried) * sin, world)
}

/// The least turn that takes `before` to `towards`, done to `up`. Turned right round, `up` stays.
fn transport(up: Vec3, before: Vec3, towards: Vec3) -> Vec3 {
    let half_way = before + towards;
    let scale = 1.0 + before.dot(towards);
    let moved = if scale > 1e-6 { up - half_way * (up.dot(towards) / scale) } else { up };
    unit_or(across(moved, towards), up)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn direction(elevation_deg: f32, heading_deg: f32) -> Vec3 {
        let (elevation, heading) = (elevation_deg.to_radians(), heading_deg.to_radians());
        Vec3::new(elevation.cos() * heading.sin(), elevation.sin(), -elevation.cos() * heading.cos())
    }

    /// Overhead at any miss distance the up turns no more than the facing does, times 1 + RELAXING; and it has come
    /// back to the world's well before the horizon.
    #[test]
    fn passing_overhead_never_spins() {
        for miss_m in [1e-6_f32, 0.1, 10.0, 60.0] {
            let towards = |along_m: f32| Vec3::new(miss_m, -100.0, along_m).normalize();
            let mut before = towards(-900.0);
            let mut up = still(before, Vec3::Y);
            for i in -8_990..=9_000 {
                let next = towards(i as f32 * 0.1);
                let carried = carry(up, before, next);
                // Chords of small angles; f32 unit vectors are good to some 10⁻⁶.
                let bound = before.distance(next) * (1.0 + RELAXING) + 1e-5;
                assert!(carried.distance(up) <= bound, "{miss_m} m at {i}");
                assert!(carried.dot(next).abs() < 1e-5 && (carried.length() - 1.0).abs() < 1e-5);
                (before, up) = (next, carried);
            }
            assert_eq!(up, world(before, Vec3::ZERO), "{miss_m} m: back at the world's");
        }
    }

    #[test]
    fn an_eye_that_hovers_turns_nothing() {
        let towards = direction(80.0, 20.0);
        let up = unit_or(across(Vec3::new(0.3, 0.2, 0.9), towards), Vec3::X);
        assert!(carry(up, towards, towards).distance(up) < 1e-6);
    }

    #[test]
    fn turned_right_round_it_stays() {
        assert_eq!(transport(Vec3::Y, Vec3::X, Vec3::NEG_X), Vec3::Y);
    }
}
