//! The level plane at the base altitude that the box tool draws on.

use super::screen::Screen;
use crate::theme;
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::camera::NEAR_M;
use egui::{Painter, Pos2};
use glam::DVec3;

/// Nobody draws where a point of the window covers more, metres: towards the horizon a hand's width would be a country.
const COARSEST_M: f64 = 200.0;
/// Points between lines.
const STEP: f64 = 20.0;
/// Lines on each side of the patch's middle.
const LINES: i32 = 8;

/// Where the plane at `altitude_m` lies under the pointer; none where the view passes it by.
pub(super) fn under(at: Pos2, screen: &Screen, altitude_m: f64) -> Option<DVec3> {
    let ray = screen.ray(at).as_dvec3();
    let depth = (altitude_m - screen.view.eye.y) / ray.y;
    let is_near = depth > f64::from(NEAR_M) && depth * f64::from(screen.view.pixel()) < COARSEST_M;
    is_near.then(|| DVec3 { y: altitude_m, ..screen.view.eye + ray * depth })
}

/// Paints a round patch of grid about a point of the plane, along the axes of `space`, that fades to its rim.
pub(super) fn paint_patch(painter: &Painter, screen: &Screen, space: &ModelSpace, middle: DVec3, least_step_m: f64) {
    let step_m = round_step(screen.metres_per_point(middle) * STEP, least_step_m);
    let radius_m = step_m * f64::from(LINES);
    let local = space.turn.conjugate() * (middle - space.origin);
    let to_eye = |x: f64, z: f64| screen.relative(space.origin + space.turn * DVec3::new(x, local.y, z));
    let (first_x, first_z) = ((local.x / step_m).round(), (local.z / step_m).round());
    for line in -LINES..=LINES {
        for along_x in [true, false] {
            let place = (if along_x { first_z } else { first_x } + f64::from(line)) * step_m;
            let off = place - if along_x { local.z } else { local.x };
            let half = (radius_m * radius_m - off * off).max(0.0).sqrt();
            let ends = if along_x {
                [to_eye(local.x - half, place), to_eye(local.x + half, place)]
            } else {
                [to_eye(place, local.z - half), to_eye(place, local.z + half)]
            };
            let fade = (1.0 - (off / radius_m).powi(2)).max(0.0) as f32;
            let mut stroke = theme::GRID;
            stroke.color = stroke.color.gamma_multiply(fade);
            if let Some(ends) = screen.line(ends[0], ends[1]) {
                painter.line_segment(ends, theme::casing(stroke));
                painter.line_segment(ends, stroke);
            }
        }
    }
}

/// A step of 1, 2 or 5 times a power of ten near `wanted_m`; a multiple of `least_m` if that is given.
pub(super) fn round_step(wanted_m: f64, least_m: f64) -> f64 {
    let wanted_m = wanted_m.max(1e-3);
    if least_m > 0.0 {
        return least_m * (wanted_m / least_m).round().max(1.0);
    }
    let power = 10.0_f64.powf(wanted_m.log10().floor());
    let factor = [1.0, 2.0, 5.0, 10.0].into_iter().find(|factor| factor * power >= wanted_m);
    factor.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::scene::Camera;
    use egui::{Rect, pos2};

    #[test]
    fn steps_are_round() {
        for (wanted, least, step) in [(31.0, 0.0, 50.0), (100.0, 0.0, 100.0), (0.15, 0.0, 0.2), (31.0, 15.0, 30.0)] {
            assert!((round_step(wanted, least) - step).abs() < 1e-9, "{wanted}");
        }
    }

    #[test]
    fn rays_meet_the_plane_or_pass_it_by() {
        let rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(100.0, 100.0));
        let eye = DVec3::new(1e6, 500.0, -2e6);
        let screen = Screen::new(&Camera::free(eye), rect);
        let above = under(pos2(50.0, 20.0), &screen, 600.0).expect("seen from below");
        assert!(above.y == 600.0 && above.z < eye.z && (above.x - eye.x).abs() < 1e-6);
        assert!(under(pos2(50.0, 80.0), &screen, 400.0).is_some(), "seen from above");
        assert!(under(pos2(50.0, 80.0), &screen, 600.0).is_none(), "behind");
        assert!(under(pos2(50.0, 50.0), &screen, 600.0).is_none(), "level");
        assert!(under(pos2(50.0, 50.001), &screen, 400.0).is_none(), "at the horizon");
        assert!(under(pos2(50.0, 20.0), &screen, 500.0).is_none(), "the eye is in it");
        assert!(under(pos2(50.0, 20.0), &screen, f64::NAN).is_none());
    }
}
