//! Three wheels that stay down, with a fairing over each.

use super::solid::{Paint, Solid, loft, ring};
use super::wings::{Rib, skin};
use glam::Vec3;

/// Main wheels on sprung legs, and the nose wheel on its own.
pub fn all() -> Solid {
    let mut main = leg(Vec3::new(0.40, -0.46, 0.30), Vec3::new(1.14, -1.12, 0.42), 0.15);
    main.add(wheel(Vec3::new(1.20, -1.16, 0.50), 1.0));
    let mut all = main.with_mirror_image();
    all.add(leg(Vec3::new(0.0, -0.40, -1.38), Vec3::new(0.0, -1.10, -1.44), 0.10));
    all.add(wheel(Vec3::new(0.0, -1.16, -1.40), 0.88));
    all
}

fn leg(top: Vec3, foot: Vec3, chord: f32) -> Solid {
    let up = Vec3::Z.cross(foot - top).normalize();
    let ribs = [top, foot].map(|nose| Rib { nose, chord: Vec3::Z * chord, up, thickness: 0.32, camber: 0.0 });
    skin(&ribs, |_, _| Paint::White)
}

/// A tyre that looks out below its fairing, a drop that is blunt in front.
fn wheel(center: Vec3, size: f32) -> Solid {
    // Along the fairing: place, half width, half height, centre's height.
    let fairing: [(f32, f32, f32, f32); 6] = [
        (-0.40, 0.0, 0.0, 0.02),
        (-0.35, 0.07, 0.09, 0.02),
        (-0.18, 0.11, 0.15, 0.03),
        (0.08, 0.12, 0.165, 0.04),
        (0.38, 0.065, 0.09, 0.035),
        (0.66, 0.0, 0.0, 0.03),
    ];
    let fairing = fairing.map(|(z, half_width, half_height, y)| {
        ring(center + Vec3::new(0.0, y, z) * size, Vec3::X * half_width * size, Vec3::Y * half_height * size, 8)
    });
    // From hub to hub over the tread: along the axle, and distance from it.
    let tyre: [(f32, f32); 4] = [(0.06, 0.0), (0.055, 0.2), (-0.055, 0.2), (-0.06, 0.0)];
    let tyre =
        tyre.map(|(x, radius)| ring(center + Vec3::X * x * size, Vec3::Z * radius * size, Vec3::Y * radius * size, 10));
    let mut wheel = loft(&fairing, true, |_, _| Paint::White);
    wheel.add(loft(&tyre, true, |_, _| Paint::Dark));
    wheel
}
