//! The body: cowling, cabin and tail cone over rounded sections, with the windows painted in.

use super::solid::{Paint, Solid, loft};
use glam::Vec3;

/// A cross section: superellipses above and below the height where it is widest.
#[derive(Clone, Copy)]
struct Section {
    z: f32,
    half_width: f32,
    bottom: f32,
    widest: f32,
    top: f32,
    /// 2 is an ellipse, more is boxier.
    roundness: f32,
}

const fn section(z: f32, half_width: f32, bottom: f32, widest: f32, top: f32, roundness: f32) -> Section {
    Section { z, half_width, bottom, widest, top, roundness }
}

/// Up the side, of the way from the widest height to the top: the coach line, the sill, the head of the windows, and
/// two more that round the roof.
const UP: [f32; 6] = [0.0, 0.16, 0.34, 0.84, 0.96, 1.0];
/// Down the side, of the way to the bottom.
const DOWN: [f32; 4] = [0.4, 0.75, 0.94, 1.0];
/// Which of the faces up a side, counted from the widest, are glass where there is a window.
const SILL: usize = 2;
const HEAD: usize = 3;

/// From the propeller to the windscreen's foot.
const COWLING: [Section; 4] = [
    section(-2.02, 0.36, -0.29, -0.03, 0.20, 2.2),
    section(-1.92, 0.43, -0.36, -0.03, 0.26, 2.4),
    section(-1.50, 0.49, -0.43, -0.03, 0.31, 2.6),
    section(-1.02, 0.54, -0.50, -0.03, 0.36, 2.7),
];
/// The windscreen.
const SCREEN: [Section; 3] = [
    section(-1.02, 0.54, -0.50, -0.03, 0.36, 2.7),
    section(-0.74, 0.555, -0.53, -0.02, 0.60, 2.8),
    section(-0.46, 0.56, -0.55, 0.0, 0.79, 3.0),
];
/// The cabin below the wing: windscreen pillar, door, door pillar, rear window, last pillar.
const CABIN: [Section; 6] = [
    section(-0.46, 0.56, -0.55, 0.0, 0.79, 3.0),
    section(-0.36, 0.56, -0.555, 0.0, 0.81, 3.0),
    section(0.36, 0.55, -0.55, 0.0, 0.81, 3.0),
    section(0.46, 0.545, -0.545, 0.0, 0.81, 3.0),
    section(1.06, 0.49, -0.50, 0.0, 0.80, 2.9),
    section(1.16, 0.475, -0.49, 0.0, 0.78, 2.8),
];
/// The rear screen.
const REAR: [Section; 3] = [
    section(1.16, 0.475, -0.49, 0.0, 0.78, 2.8),
    section(1.55, 0.42, -0.43, 0.0, 0.61, 2.6),
    section(1.98, 0.355, -0.355, 0.01, 0.43, 2.4),
];
/// The tail cone.
const TAIL: [Section; 5] = [
    section(1.98, 0.355, -0.355, 0.01, 0.43, 2.4),
    section(2.9, 0.25, -0.21, 0.04, 0.33, 2.2),
    section(4.1, 0.15, -0.06, 0.08, 0.24, 2.0),
    section(5.2, 0.055, 0.06, 0.11, 0.17, 2.0),
    section(5.36, 0.0, 0.115, 0.115, 0.115, 2.0),
];

impl Section {
    /// Around from the right side over the top, down the left side and back below.
    fn points(&self) -> Vec<Vec3> {
        let across = |t: f32| {
            let rest = 1.0 - libm::powf(t, self.roundness);
            self.half_width * libm::powf(rest.max(0.0), 1.0 / self.roundness)
        };
        let above = |t: f32, side: f32| Vec3::new(side * across(t), self.widest + t * (self.top - self.widest), self.z);
        let below =
            |t: f32, side: f32| Vec3::new(side * across(t), self.widest + t * (self.bottom - self.widest), self.z);
        let mut points: Vec<Vec3> = UP.iter().map(|t| above(*t, 1.0)).collect();
        points.extend(UP[..UP.len() - 1].iter().rev().map(|t| above(*t, -1.0)));
        points.extend(DOWN.iter().map(|t| below(*t, -1.0)));
        points.extend(DOWN[..DOWN.len() - 1].iter().rev().map(|t| below(*t, 1.0)));
        points
    }
}

/// Which face up the side face j is, counted from the widest height on either side; none below it.
fn up_the_side(j: usize) -> Option<usize> {
    let ups = UP.len() - 1;
    (j < 2 * ups).then(|| j.min(2 * ups - 1 - j))
}

/// The whole body.
pub fn body() -> Solid {
    let skin = |sections: &[Section], paint: &dyn Fn(usize, Option<usize>) -> Paint| {
        let sections: Vec<_> = sections.iter().map(Section::points).collect();
        loft(&sections, true, |i, j| match up_the_side(j) {
            // The coach line runs from nose to tail.
            Some(0) => Paint::Accent,
            up => paint(i, up),
        })
    };
    let glass_above =
        |from: usize| move |_: usize, up: Option<usize>| if up >= Some(from) { Paint::Glass } else { Paint::White };
    let mut body = skin(&COWLING, &|_, _| Paint::White);
    body.add(skin(&SCREEN, &glass_above(SILL)));
    body.add(skin(&CABIN, &|i, up| {
        let in_window = up.is_some_and(|up| (SILL..HEAD).contains(&up));
        if in_window && i % 2 == 1 { Paint::Glass } else { Paint::White }
    }));
    body.add(skin(&REAR, &glass_above(SILL)));
    body.add(skin(&TAIL, &|_, _| Paint::White));
    body.add(face());
    body
}

/// The cowling's front, with an intake on either side of the spinner.
fn face() -> Solid {
    let rim = COWLING[0].points();
    let hub = Vec3::new(0.0, 0.0, COWLING[0].z - 0.035);
    let inwards = |size: f32| rim.iter().map(|p| hub.lerp(p.with_z(hub.z), size)).collect::<Vec<_>>();
    let (lip, inner, middle) = (inwards(0.93), inwards(0.45), inwards(0.0));
    let mut face = loft(&[lip.clone(), inner.clone()], true, |_, j| match up_the_side(j) {
        Some(0..=2) => Paint::Dark,
        _ => Paint::White,
    });
    face.add(loft(&[rim, lip], true, |_, _| Paint::White));
    face.add(loft(&[inner, middle], true, |_, _| Paint::White));
    face
}
