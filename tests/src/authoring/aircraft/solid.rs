//! Painted triangles, and the one way to make them: a skin over cross sections.

use cloudwright_core::math::unit_or;
use glam::Vec3;

/// What a surface is painted with: a material of the model's file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Paint {
    /// Most of it.
    White,
    /// Flaps, ailerons, elevators.
    Grey,
    /// Stripes, tips and tail.
    Accent,
    /// Windows.
    Glass,
    /// Tyres, intakes, propeller.
    Dark,
    /// The left wing's light.
    Red,
    /// The right wing's light.
    Green,
}

impl Paint {
    /// Each, in the order of the file's materials.
    pub const ALL: [Self; 7] = [Self::White, Self::Grey, Self::Accent, Self::Glass, Self::Dark, Self::Red, Self::Green];

    /// The material's name, its colour (linear), and how rough it is in viewers that ask, 0 to 1.
    pub const fn material(self) -> (&'static str, [f32; 3], f32) {
        match self {
            Self::White => ("white", [0.86, 0.86, 0.84], 0.35),
            Self::Grey => ("grey", [0.62, 0.63, 0.64], 0.4),
            Self::Accent => ("accent", [0.60, 0.035, 0.02], 0.35),
            Self::Glass => ("glass", [0.025, 0.045, 0.065], 0.05),
            Self::Dark => ("dark", [0.03, 0.03, 0.032], 0.7),
            Self::Red => ("red light", [0.9, 0.01, 0.01], 0.3),
            Self::Green => ("green light", [0.01, 0.75, 0.12], 0.3),
        }
    }
}

/// A corner of a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// Metres.
    pub position: Vec3,
    /// Unit, outwards.
    pub normal: Vec3,
}

/// Triangles with their paint, counter-clockwise from outside.
#[derive(Debug, Clone, Default)]
pub struct Solid {
    /// Paint and corners.
    pub triangles: Vec<(Paint, [Vertex; 3])>,
}

impl Solid {
    /// Both.
    pub fn add(&mut self, other: Self) {
        self.triangles.extend(other.triangles);
    }

    /// With its mirror image on the other side of the aircraft; what is red there is green here.
    pub fn with_mirror_image(mut self) -> Self {
        let mirror = |v: Vertex| {
            let flip = |p: Vec3| Vec3::new(-p.x, p.y, p.z);
            Vertex { position: flip(v.position), normal: flip(v.normal) }
        };
        let image: Vec<_> = self
            .triangles
            .iter()
            .map(|(paint, [a, b, c])| {
                let paint = if *paint == Paint::Green { Paint::Red } else { *paint };
                (paint, [mirror(*a), mirror(*c), mirror(*b)])
            })
            .collect();
        self.triangles.extend(image);
        self
    }
}

/// A skin over `sections`, each of as many points, smooth all over; closed around if `closed`. `paint` is asked for the
/// face between points j and j + 1 of sections i and i + 1.
pub fn loft(sections: &[Vec<Vec3>], closed: bool, paint: impl Fn(usize, usize) -> Paint) -> Solid {
    let columns = sections.first().map_or(0, Vec::len);
    let (last_row, last_column) = (sections.len() - 1, columns - 1);
    let step = |j: usize, by: usize, back: bool| match (closed, back) {
        (true, false) => (j + by) % columns,
        (true, true) => (j + columns - by) % columns,
        (false, false) => (j + by).min(last_column),
        (false, true) => j.saturating_sub(by),
    };
    let normal = |i: usize, j: usize| {
        let along = |j: usize| sections[(i + 1).min(last_row)][j] - sections[i.saturating_sub(1)][j];
        let around = |i: usize| sections[i][step(j, 1, false)] - sections[i][step(j, 1, true)];
        // Where a section shrinks to a point, its neighbour tells which way is around.
        let ring = if i == 0 { 1 } else { i - 1 };
        let around = if around(i).length() > 1e-4 { around(i) } else { around(ring) };
        unit_or(along(j).cross(around), Vec3::ZERO)
    };
    let middle = |row: &Vec<Vec3>| row.iter().sum::<Vec3>() / columns as f32;
    // Which way is out: by most of the points, since a section's middle may lie outside a bent one.
    let out: f32 = (0..sections.len())
        .flat_map(|i| (0..columns).map(move |j| (i, j)))
        .map(|(i, j)| normal(i, j).dot(sections[i][j] - middle(&sections[i])))
        .sum();
    let sign = out.signum();
    let mut solid = Solid::default();
    for i in 0..last_row {
        for j in 0..if closed { columns } else { last_column } {
            let vertex = |i: usize, j: usize| Vertex { position: sections[i][j], normal: sign * normal(i, j) };
            let next = step(j, 1, false);
            let quad = [vertex(i, j), vertex(i, next), vertex(i + 1, next), vertex(i + 1, j)];
            for corners in [[0, 1, 2], [0, 2, 3]] {
                let [a, b, c] = corners.map(|k| quad[k]);
                let area = (b.position - a.position).cross(c.position - a.position);
                if area.length() > 1e-7 {
                    let outwards = area.dot(a.normal + b.normal + c.normal) > 0.0;
                    solid.triangles.push((paint(i, j), if outwards { [a, b, c] } else { [a, c, b] }));
                }
            }
        }
    }
    solid
}

/// `count` points around an ellipse, given by its half axes.
pub fn ring(center: Vec3, right: Vec3, up: Vec3, count: usize) -> Vec<Vec3> {
    (0..count)
        .map(|i| {
            let (sin, cos) = libm::sincosf(std::f32::consts::TAU * i as f32 / count as f32);
            center + right * cos + up * sin
        })
        .collect()
}
