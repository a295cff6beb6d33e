//! Three wheels that stay down, with a fairing over each.

use super::solid::{Paint, Solid, loft, ring, sample};
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
    let sections: [(f32, f32, f32, f32); 7] = [
        (-0.40, 0.0, 0.0, 0.02),
        (-0.36, 0.065, 0.085, 0.02),
        (-0.22, 0.105, 0.145, 0.03),
        (0.00, 0.12, 0.165, 0.04),
        (0.26, 0.09, 0.125, 0.04),
        (0.50, 0.04, 0.055, 0.03),
        (0.66, 0.0, 0.0, 0.03),
    ];
    let sections = sections
        .map(|(z, width, height, y)| ring(center + Vec3::new(0.0, y, z) * size, width * size, height * size, 8));
    let mut wheel = loft(&sections, true, |_, j| if j == 3 || j == 0 { Paint::Accent } else { Paint::White });
    wheel.add(tyre(center, size));
    wheel
}

fn tyre(center: Vec3, size: f32) -> Solid {
    const SPOKES: usize = 11;
    // From hub to hub over the tread: distance from the axle and along it.
    let profile: [(f32, f32); 6] =
        [(0.0, 0.06), (0.165, 0.065), (0.20, 0.035), (0.20, -0.035), (0.165, -0.065), (0.0, -0.06)];
    let sections = profile.map(|(radius, along)| {
        sample(SPOKES, |t| {
            let (sin, cos) = libm::sincosf(std::f32::consts::TAU * t);
            center + Vec3::new(along, radius * sin, radius * cos) * size
        })
    });
    loft(&sections, true, |_, _| Paint::Dark)
}
