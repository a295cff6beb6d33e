//! Spinner and propeller, standing still: what is opaque can't blur.

use super::solid::{Paint, Solid, loft, ring};
use super::wings::{Rib, skin};
use glam::{Quat, Vec3};

/// Where the blades are along the axis.
const BLADES_Z: f32 = -2.16;

/// Two blades and the spinner between them.
pub fn all() -> Solid {
    // Along the axis, and distance from it.
    let spinner: [(f32, f32); 5] = [(-2.46, 0.0), (-2.42, 0.06), (-2.30, 0.125), (-2.18, 0.17), (-2.04, 0.185)];
    let sections = spinner.map(|(z, radius)| ring(Vec3::Z * z, Vec3::X * radius, Vec3::Y * radius, 12));
    let mut all = loft(&sections, true, |_, _| Paint::Accent);
    for turn_deg in [28.0_f32, 208.0] {
        all.add(blade(Quat::from_rotation_z(turn_deg.to_radians())));
    }
    all
}

/// A blade upwards, turned about the axis.
fn blade(turn: Quat) -> Solid {
    // Distance from the axis, chord and pitch.
    let stations: [(f32, f32, f32); 4] =
        [(0.12, 0.12, 0.95), (0.40, 0.16, 0.62), (0.84, 0.12, 0.36), (0.95, 0.05, 0.33)];
    let ribs = stations.map(|(radius, chord, pitch)| {
        let (sin, cos) = libm::sincosf(pitch);
        let along = Vec3::new(-cos, 0.0, sin);
        Rib {
            nose: turn * (Vec3::new(0.0, radius, BLADES_Z) - along * (0.4 * chord)),
            chord: turn * along * chord,
            up: turn * Vec3::new(-sin, 0.0, -cos),
            thickness: 0.13,
            camber: 0.03,
        }
    });
    skin(&ribs, |bay, _| if bay == 2 { Paint::Accent } else { Paint::Dark })
}
