//! The stars: a field that no seed changes, at rest on the celestial sphere.
//!
//! The sphere falls into cells, 64 × 64 on each face of a cube, warped so that they are nearly of one size (the “quadratic”
//! projection of Google's S2: no trigonometry, so that all machines agree); a third of them hold a star. Their light falls
//! off as counts of real stars do: three times as many for each magnitude fainter, down to 6.5.
//!
//! What a picture shows of a star is its light, spread over a spot 1.2 pixels wide whose weights on pixels add up to the same
//! wherever it lies between them, so that it neither flickers nor changes as the view turns; in finer pictures the spot is
//! smaller and brighter, as its energy stays.
//! The twin in WGSL is render/src/pass/sky/night.wgsl.

use super::ground::hash;
use crate::color::Rgb;
use glam::Vec3;
use std::sync::LazyLock;

/// Along a side of a face of the cube.
const CELLS: u32 = 64;
/// Share of the cells that hold one: 9,000 stars.
const CHANCE: f32 = 0.37;
/// The spot's radius, pixels: a standard deviation of 0.6 along either axis.
const SPOT_PX: f32 = 2.08;
/// The widest spot, radians: half the narrowest cell. Stars fade from pictures too coarse for it.
const WIDEST: f32 = 0.0072;

/// One of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Star {
    /// Unit, in the stars' own axes.
    pub(super) direction: Vec3,
    /// 1 is the faintest's.
    pub(super) light: Rgb,
}

/// All of them.
pub(super) static STARS: LazyLock<Vec<Star>> = LazyLock::new(|| {
    let cells = (0..6).flat_map(|face| (0..CELLS).flat_map(move |i| (0..CELLS).map(move |j| [face, i, j])));
    cells.filter_map(star).collect()
});

/// That of a cell, if it holds one.
fn star([face, i, j]: [u32; 3]) -> Option<Star> {
    let random = |what: u32| hash(face * CELLS + i, j, 16 + what);
    if random(0) >= CHANCE {
        return None;
    }
    let (u, v) = (unwarped(i, random(1)), unwarped(j, random(2)));
    let side = if face % 2 == 0 { 1.0 } else { -1.0 };
    let direction = match face / 2 {
        0 => Vec3::new(side, u, v),
        1 => Vec3::new(v, side, u),
        _ => Vec3::new(u, v, side),
    };
    // The inverse of a power law's integral: N(> light) ∝ light^−4/3.
    let rank = random(3).max(1e-4).sqrt();
    let tint = Rgb::new(1.0, 0.80, 0.58).mix(Rgb::new(0.78, 0.90, 1.15), random(4));
    Some(Star { direction: direction.normalize(), light: tint * (1.0 / (rank * rank.sqrt())) })
}

/// A place on a face, −1 to 1, from that in a cell. In a face's outermost cells stars keep to the inner half, so that no
/// spot lies across its edge.
fn unwarped(cell: u32, within: f32) -> f32 {
    let within = match cell {
        0 => 0.5 + 0.5 * within,
        _ if cell == CELLS - 1 => 0.5 * within,
        _ => within,
    };
    let warped = (cell as f32 + within) / (0.5 * CELLS as f32) - 1.0;
    warped * (2.0 + warped.abs()) / 3.0
}

/// Where on a face, in cells.
fn in_cells(u: f32) -> f32 {
    let warped = (1.0 + 3.0 * u.abs()).sqrt() - 1.0;
    (warped.copysign(u) + 1.0) * (0.5 * CELLS as f32)
}

/// How a picture whose pixels are so wide, radians, shows a star.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    /// Of its rim, radians.
    pub(super) radius: f32,
    /// Radiance in its middle of a light of 1.
    peak: f32,
}

impl Spot {
    pub(super) fn new(pixel: f32) -> Self {
        let wanted = (SPOT_PX * pixel).max(1e-7);
        let radius = wanted.min(WIDEST);
        let fade = (radius / wanted) * (radius / wanted);
        // (1 − r²)⁴ over the disc integrates to π/5.
        Self { radius, peak: 5.0 / (std::f32::consts::PI * radius * radius) * fade * fade }
    }

    /// Radiance of a star in a unit `direction` of its own axes.
    pub(super) fn radiance(&self, star: &Star, direction: Vec3) -> Rgb {
        let apart = (direction - star.direction) / self.radius;
        let left = (1.0 - apart.length_squared()).max(0.0);
        star.light * (self.peak * (left * left) * (left * left))
    }
}

/// Radiance of all stars in a unit `direction` of their own axes: that of the four cells next to it.
pub(super) fn radiance(direction: Vec3, spot: &Spot) -> Rgb {
    let size = direction.abs();
    let (axis, major, u, v) = if size.x >= size.y && size.x >= size.z {
        (0, direction.x, direction.y, direction.z)
    } else if size.y >= size.z {
        (1, direction.y, direction.z, direction.x)
    } else {
        (2, direction.z, direction.x, direction.y)
    };
    let face = 2 * axis + u32::from(major < 0.0);
    let first = |u: f32| (in_cells(u / major.abs()) - 0.5).floor() as i32;
    let (i, j) = (first(u), first(v));
    let cells = [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]];
    let inside = |[i, j]: &[i32; 2]| (0..CELLS as i32).contains(i) && (0..CELLS as i32).contains(j);
    let found = cells.into_iter().filter(inside).filter_map(|[i, j]| star([face, i as u32, j as u32]));
    found.fold(Rgb::BLACK, |sum, star| sum + spot.radiance(&star, direction))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{draw, unit};

    fn any_direction(i: u32) -> Vec3 {
        let [x, y, z, _] = draw(1, 2, i, 0).map(|bits| unit(bits) as f32 * 2.0 - 1.0);
        Vec3::new(x, y, z).normalize()
    }

    #[test]
    fn four_cells_hold_all_that_is_seen() {
        let [mut lit, stars] = [0, STARS.len()];
        assert!((8_500..9_500).contains(&stars), "{stars}");
        for i in 0..4_000 {
            // On stars' rims, where most is to be missed, and on the cube's edges.
            let star = &STARS[(i as usize * 7) % stars];
            let spot = Spot::new([0.0008, 0.0034, 0.1][i as usize % 3]);
            let direction = (star.direction + any_direction(i) * spot.radius * 0.7).normalize();
            let all = STARS.iter().fold(Rgb::BLACK, |sum, star| sum + spot.radiance(star, direction));
            let near = radiance(direction, &spot);
            let off = (all.g - near.g).abs().max((all.b - near.b).abs());
            assert!(off <= 1e-4 * all.g, "{direction}: {near:?} for {all:?}");
            lit += usize::from(near.g > 0.0);
        }
        assert!(lit > 3_900, "{lit}");
    }

    #[test]
    fn many_are_faint_and_few_bright() {
        let brighter = |magnitudes: f32| {
            let light = 10.0_f32.powf(0.4 * magnitudes);
            STARS.iter().filter(|star| star.light.g > light * 0.9).count() as f32
        };
        for magnitudes in [1.0, 2.0, 3.0] {
            let more = brighter(magnitudes) / brighter(magnitudes + 1.0);
            assert!((2.6..4.4).contains(&more), "{more} for each magnitude at {magnitudes}");
        }
    }

    /// The sum over pixels, wherever among them the star lies and however wide they are.
    #[test]
    fn a_star_keeps_its_light() {
        let star = Star { direction: Vec3::Z, light: Rgb::grey(1.0) };
        for pixel in [0.0003, 0.0009, 0.003] {
            for at in 0..25_u32 {
                let (x, y) = ((at % 5) as f32 * 0.2, (at / 5) as f32 * 0.2);
                let pixels = (-4..=4).flat_map(|i| (-4..=4).map(move |j| [i as f32, j as f32]));
                let sum: f32 = pixels
                    .map(|[i, j]| {
                        let ray = Vec3::new((i + x) * pixel, (j + y) * pixel, 1.0).normalize();
                        Spot::new(pixel).radiance(&star, ray).g * pixel * pixel
                    })
                    .sum();
                assert!((sum - 1.0).abs() < 0.01, "{sum} at {x} {y} in pixels of {pixel}");
            }
        }
    }
}
