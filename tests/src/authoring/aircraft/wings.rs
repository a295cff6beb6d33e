//! All that is an aerofoil: wings, tailplane, fin and struts.

use super::solid::{Paint, Solid, loft};
use glam::Vec3;

/// One section of a wing: its leading edge, its chord and how thick it is.
#[derive(Clone, Copy)]
pub struct Rib {
    /// Leading edge.
    pub nose: Vec3,
    /// From the leading edge to the trailing edge, along and length.
    pub chord: Vec3,
    /// Across chord and span, unit: towards the upper side.
    pub up: Vec3,
    /// Greatest thickness over the chord.
    pub thickness: f32,
    /// Greatest camber over the chord.
    pub camber: f32,
}

/// Of the chord, from the leading edge: more where it bends. The hinges are at one of them.
const ALONG: [f32; 6] = [0.0, 0.025, 0.11, 0.32, HINGE, 1.0];
const HINGE: f32 = 0.74;

impl Rib {
    /// From the trailing edge over the upper side to the leading edge, and back below: NACA's four-digit sections
    /// (Jacobs, Ward and Pinkerton 1933), with a closed trailing edge.
    pub fn points(&self) -> Vec<Vec3> {
        let size = self.chord.length();
        let point = |x: f32, side: f32| {
            let curve = 0.2969 * x.sqrt() - 0.1260 * x - 0.3516 * x * x + 0.2843 * x.powi(3) - 0.1036 * x.powi(4);
            let half = 5.0 * self.thickness * curve;
            let middle = self.camber * 4.0 * x * (1.0 - x);
            self.nose + self.chord * x + self.up * (size * (middle + side * half))
        };
        let above = ALONG.iter().rev().map(|x| point(*x, 1.0));
        above.chain(ALONG[1..].iter().map(|x| point(*x, -1.0))).collect()
    }
}

/// Which of the spaces between the points along a chord face j covers, on either side.
fn along(j: usize) -> usize {
    let spaces = ALONG.len() - 1;
    if j < spaces { spaces - 1 - j } else { j - spaces }
}

/// Behind the hinge.
fn is_flap(j: usize) -> bool {
    along(j) == ALONG.len() - 2
}

/// A skin over ribs; `paint` knows the bay and the face around the section.
pub fn skin(ribs: &[Rib], paint: impl Fn(usize, usize) -> Paint) -> Solid {
    loft(&ribs.iter().map(Rib::points).collect::<Vec<_>>(), false, paint)
}

/// Wings, tail and struts.
pub fn all() -> Solid {
    let mut all = wing();
    all.add(tailplane());
    all.add(strut());
    let mut all = all.with_mirror_image();
    all.add(fin());
    all
}

/// Up with the span: tan 1.7°.
const DIHEDRAL: f32 = 0.03;
/// Where flaps end and ailerons begin, and where the tip is painted.
const TIP_FROM: f32 = 4.78;

fn wing() -> Solid {
    // Span, leading edge and chord; the outer panel tapers, the end is rounded.
    let stations: [(f32, f32, f32, f32); 8] = [
        (0.0, -0.50, 1.63, 0.125),
        (0.62, -0.50, 1.63, 0.125),
        (2.62, -0.50, 1.63, 0.125),
        (TIP_FROM, -0.33, 1.24, 0.115),
        (5.20, -0.295, 1.15, 0.11),
        (5.38, -0.26, 1.06, 0.095),
        (5.47, -0.18, 0.90, 0.06),
        (5.50, -0.05, 0.66, 0.02),
    ];
    let ribs = stations.map(|(x, z, chord, thickness)| {
        // The tip is turned down by 3°, so that it stalls last.
        let twist = 0.052 * (0.3 - (x / 5.5).min(1.0));
        let (sin, cos) = libm::sincosf(twist);
        Rib {
            nose: Vec3::new(x, 0.80 + DIHEDRAL * x, z),
            chord: Vec3::new(0.0, -sin, cos) * chord,
            up: Vec3::new(0.0, cos, sin),
            thickness,
            camber: 0.02,
        }
    });
    skin(&ribs, |bay, j| match bay {
        1 | 2 if is_flap(j) => Paint::Grey,
        5 | 6 if along(j) <= 1 => Paint::Green,
        3.. => Paint::Accent,
        _ => Paint::White,
    })
}

fn tailplane() -> Solid {
    let stations: [(f32, f32, f32, f32); 5] = [
        (0.0, 4.28, 1.02, 0.09),
        (0.16, 4.28, 1.02, 0.09),
        (1.52, 4.52, 0.72, 0.09),
        (1.66, 4.58, 0.62, 0.07),
        (1.72, 4.70, 0.42, 0.03),
    ];
    let ribs = stations.map(|(x, z, chord, thickness)| Rib {
        nose: Vec3::new(x, 0.15, z),
        chord: Vec3::Z * chord,
        up: Vec3::Y,
        thickness,
        camber: 0.0,
    });
    skin(&ribs, |bay, j| match bay {
        1 if is_flap(j) => Paint::Grey,
        2.. => Paint::Accent,
        _ => Paint::White,
    })
}

fn fin() -> Solid {
    // Height, leading edge and chord; a low fillet leads up to it.
    let stations: [(f32, f32, f32, f32); 6] = [
        (0.10, 2.95, 2.35, 0.035),
        (0.36, 3.62, 1.72, 0.05),
        (0.56, 4.02, 1.36, 0.07),
        (1.46, 4.70, 0.86, 0.085),
        (1.58, 4.84, 0.72, 0.06),
        (1.62, 5.00, 0.50, 0.02),
    ];
    let ribs = stations.map(|(y, z, chord, thickness)| Rib {
        nose: Vec3::new(0.0, y, z),
        chord: Vec3::Z * chord,
        up: Vec3::X,
        thickness,
        camber: 0.0,
    });
    skin(&ribs, |bay, j| match bay {
        0 => Paint::White,
        1.. if is_flap(j) => Paint::White,
        _ => Paint::Accent,
    })
}

/// From the cabin's floor to the middle of the wing.
fn strut() -> Solid {
    let (foot, head) = (Vec3::new(0.48, -0.40, -0.12), Vec3::new(2.60, 0.83, -0.06));
    let along = (head - foot).normalize();
    let up = Vec3::Z.cross(along).normalize();
    let ribs = [foot, head].map(|nose| Rib { nose, chord: Vec3::Z * 0.17, up, thickness: 0.3, camber: 0.0 });
    skin(&ribs, |_, _| Paint::White)
}
