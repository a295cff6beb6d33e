//! Inside a cloud: a sprite near the eye stops turning, and fades for it (W, bounded as MODEL §4 has it).
//!
//! Within half the sprite's radius of the eye a sprite that went on facing it would visibly spin; beyond, one that
//! stopped would part before the camera like the Red Sea. W locks it and multiplies its alpha by the dot product of the
//! locked and the present direction to the eye, which jumps where the eye passes the sprite's centre closely. What is
//! done here goes from the one to the other over a shell around the eye, which begins where the eye enters the ball that the
//! sprite stands for, and fades by how far the eye is before the locked quad's plane; nothing moves faster than some
//! 3 / lock distance for each metre flown, whatever the path.

use crate::camera::{NEAR_M, View};
use crate::math::{smoothstep, unit_or};
use glam::Vec3;

/// Of the sprite's radius: within this distance of the eye it is locked (W).
pub const LOCK_SHARE: f32 = 0.5;
/// Of the lock distance: from here on, the sprite's radius, it faces the eye altogether and is all there.
pub const SHELL: f32 = 2.0;

/// Which way a sprite faces, and how much of it shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Locked {
    /// Unit, from the sprite's centre.
    pub towards: Vec3,
    /// 0 to 1; a factor of its alpha.
    pub fade: f32,
}

/// The distance within which a sprite of `radius` metres is locked, metres.
pub fn lock_distance(radius: f32) -> f32 {
    (LOCK_SHARE * radius).max(f32::MIN_POSITIVE)
}

/// How near to the eye a sprite of `radius` metres no longer simply faces it, metres.
pub fn lock_reach(radius: f32) -> f32 {
    SHELL * lock_distance(radius)
}

/// The rule: `to_eye` leads from the sprite's centre to the eye, `remembered` (unit) did so when the eye was last
/// beyond the shell. Continuous in `to_eye`; an eye at the centre faces nothing and sees nothing.
pub fn lock(to_eye: Vec3, remembered: Vec3, lock_m: f32) -> Locked {
    let present = unit_or(to_eye, remembered);
    let share = smoothstep(lock_m, SHELL * lock_m, to_eye.length());
    let between = remembered * (1.0 - share) + present * share;
    let before_plane = (remembered.dot(to_eye) / (SHELL * lock_m)).clamp(0.0, 1.0);
    let fade = between.length() * (before_plane + (1.0 - before_plane) * share);
    Locked { towards: unit_or(between, remembered), fade: fade.min(1.0) }
}

/// How much of a quad shows that lies `before` metres before the eye, along its own normal: all but nothing where the
/// near plane could cut it. `near_reach` is [`near_reach`]'s.
pub fn near_fade(before: f32, near_reach: f32) -> f32 {
    smoothstep(near_reach, 2.0 * near_reach, before)
}

/// How far from the eye the near plane's corners lie, metres: a plane farther than this from the eye doesn't meet it.
pub fn near_reach(view: &View) -> f32 {
    let corner = view.ray(0.0, 0.0).length();
    NEAR_M * corner
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_what_it_says_at_its_ends() {
        let n = Vec3::X;
        for (to_eye, towards, fade) in [
            (Vec3::X * 20.0, Vec3::X, 1.0),
            (Vec3::NEG_Z * 20.0, Vec3::NEG_Z, 1.0),
            (Vec3::X * 10.0, Vec3::X, 0.5),
            (Vec3::X * 5.0, Vec3::X, 0.25),
            (Vec3::new(5.0, 8.0, 0.0), Vec3::X, 0.25),
            (Vec3::ZERO, Vec3::X, 0.0),
            (Vec3::NEG_X * 9.0, Vec3::X, 0.0),
        ] {
            let got = lock(to_eye, n, 10.0);
            assert!(got.towards.distance(towards) < 1e-6 && (got.fade - fade).abs() < 1e-6, "{to_eye}: {got:?}");
        }
    }

    /// The fade's slope, metre for metre, is within what its formula allows.
    ///
    /// With r the lock distance, t the place in the shell (0 to 1, r wide), s = 3t² − 2t³, A = |m|·q, q = p + (1 − p)s:
    /// within r only p moves, by 1/2r. In the shell |s'| = 6 t(1 − t)/r, e turns by at most 1/(1 + t)r, p moves by 1/2r. As
    /// |d|m|| ≤ |s'||e − n| + s/(1 + t)r, and |dq| ≤ (1 − p)|s'| + (1 − s)/2r:
    /// |dA| ≤ (|s'||e − n| + s/(1 + t)r)·q + |m|·(|s'| + (1 − s)/2r). Where |e − n| = 2, p = 0, q = s and |m| = |1 − 2s|; the
    /// sum is largest at t = 0.73: 3.13/r. Elsewhere |e − n| is smaller: at a right angle it comes to 2.8/r.
    #[test]
    fn the_slope_is_bounded() {
        const STEP: f32 = 1e-3;
        let mut steepest: f32 = 0.0;
        let lock_m = 2.0_f32;
        for i in 0..60 {
            // Directions from along n to against it.
            let angle = i as f32 / 59.0 * std::f32::consts::PI;
            let (along, across) = (Vec3::new(angle.cos(), angle.sin(), 0.0), Vec3::new(-angle.sin(), angle.cos(), 0.0));
            for j in 0..400 {
                let at = along * (j as f32 / 399.0 * 1.2 * SHELL * lock_m);
                for step in [along, across, (along + across).normalize(), Vec3::Z] {
                    let [a, b] = [at, at + step * STEP].map(|to_eye| lock(to_eye, Vec3::X, lock_m).fade);
                    steepest = steepest.max((b - a).abs() / STEP * lock_m);
                }
            }
        }
        assert!((2.0..=3.2).contains(&steepest), "{steepest} / lock distance");
    }
}
