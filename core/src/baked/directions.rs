//! The directions for which light is baked: the corners of an octahedron whose faces are parted into smaller triangles,
//! as far as they lie above the horizon.
//!
//! Between three of them light is mixed by where the direction meets their triangle, so it has no step anywhere. A light
//! below the horizon counts as on it: what it lights, the day's tables say, and they leave next to nothing.

use crate::math::unit_or;
use glam::Vec3;

/// Directions from the horizon to straight up, by how finely the octahedron's edges are parted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Directions {
    parts: u32,
}

/// Three neighbours around a direction, and the share of each; the shares sum to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Around {
    /// Numbers of directions; the same one several times where fewer are enough.
    pub at: [u32; 3],
    /// 0 to 1.
    pub share: [f32; 3],
}

impl Directions {
    /// With edges of so many parts, at least 1: 5, 13, 25, 41 directions, as those that a whole sphere has 6, 18, 38, 66 of.
    pub const fn parted(parts: u32) -> Self {
        Self { parts: if parts == 0 { 1 } else { parts } }
    }

    /// Of how many parts an edge is.
    pub const fn parts(self) -> u32 {
        self.parts
    }

    /// How many there are: 2 n (n + 1) + 1.
    pub const fn count(self) -> usize {
        (2 * self.parts * (self.parts + 1) + 1) as usize
    }

    /// They, unit, in rows of x from −1, each by z. Their number is their place here.
    pub fn all(self) -> Vec<Vec3> {
        let n = self.parts as i32;
        let row = move |x: i32| {
            let width = n - x.abs();
            (-width..=width).map(move |z| Vec3::new(x as f32, (width - z.abs()) as f32, z as f32).normalize())
        };
        (-n..=n).flat_map(row).collect()
    }

    /// Which lie around `direction`, a unit vector; around straight down, where no horizon is nearest, straight up.
    pub fn around(self, direction: Vec3) -> Around {
        let above = unit_or(Vec3 { y: direction.y.max(0.0), ..direction }, Vec3::Y);
        let n = self.parts as f32;
        let flat = above * (n / (above.x.abs() + above.y + above.z.abs()));
        let (x, z) = (flat.x.abs().min(n), flat.z.abs().min(n));
        let (column, row) = (x.floor().min(n - 1.0), z.floor().min(n - 1.0));
        let (right, down) = (x - column, z - row);
        let number = |dx: f32, dz: f32| self.number(sign(column + dx, flat.x), sign(row + dz, flat.z));
        if right + down <= 1.0 {
            let at = [number(0.0, 0.0), number(1.0, 0.0), number(0.0, 1.0)];
            Around { at, share: [1.0 - right - down, right, down] }
        } else {
            let at = [number(1.0, 1.0), number(0.0, 1.0), number(1.0, 0.0)];
            Around { at, share: [right + down - 1.0, 1.0 - right, 1.0 - down] }
        }
    }

    /// The number of the direction that lies at whole parts `x` and `z`; beyond the edge, of the nearest: rounding alone
    /// leads there, with a share of next to nothing.
    fn number(self, x: i32, z: i32) -> u32 {
        let n = self.parts as i32;
        let x = x.clamp(-n, n);
        let width = n - x.abs();
        // Rows grow from 1 to 2 n + 1 and shrink again.
        let rows = x + n;
        let before = if x <= 0 { rows * rows } else { 2 * n * n + 2 * n + 1 - (n - x + 1) * (n - x + 1) };
        (before + z.clamp(-width, width) + width) as u32
    }
}

fn sign(whole: f32, of: f32) -> i32 {
    (if of < 0.0 { -whole } else { whole }) as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{draw, unit};

    #[test]
    fn each_direction_is_around_itself() {
        for parts in 1..=6 {
            let directions = Directions::parted(parts);
            let all = directions.all();
            assert_eq!(all.len(), directions.count());
            for (number, direction) in all.iter().enumerate() {
                let around = directions.around(*direction);
                let own = |(at, share): (&u32, &f32)| if *at as usize == number { *share } else { 0.0 };
                let share: f32 = around.at.iter().zip(&around.share).map(own).sum();
                assert!(share > 1.0 - 1e-5, "{parts} parts, {direction}: {around:?}");
            }
        }
    }

    /// Shares sum to 1, and what they mix of the directions themselves points where it should: within the reach of a
    /// triangle's chord.
    #[test]
    fn a_direction_lies_amid_those_around_it() {
        for i in 0..5000 {
            let [up, turn, parts, ..] = draw(7, 0, i, 0).map(unit);
            let directions = Directions::parted(1 + (parts * 6.0) as u32);
            let (y, turn) = (up as f32, (turn * std::f64::consts::TAU) as f32);
            let level = (1.0 - y * y).sqrt();
            let direction = Vec3::new(level * turn.cos(), y, level * turn.sin());
            let (all, around) = (directions.all(), directions.around(direction));
            assert!((around.share.iter().sum::<f32>() - 1.0).abs() < 1e-5, "{around:?}");
            assert!(around.share.iter().all(|share| (-1e-5..=1.0 + 1e-5).contains(share)), "{around:?}");
            let l1 = |v: Vec3| v / v.abs().element_sum();
            let mixed: Vec3 = around.at.iter().zip(around.share).map(|(at, share)| l1(all[*at as usize]) * share).sum();
            assert!(mixed.distance(l1(direction)) < 1e-5, "{direction}: {around:?}");
        }
    }

    #[test]
    fn below_the_horizon_is_on_it() {
        let directions = Directions::parted(2);
        let low = Vec3::new(0.6, -0.5, 0.2).normalize();
        assert_eq!(directions.around(low), directions.around(Vec3 { y: 0.0, ..low }.normalize()));
        assert_eq!(directions.around(Vec3::NEG_Y), directions.around(Vec3::Y));
        assert!(directions.around(Vec3::NAN).share.iter().all(|share| share.is_finite()));
    }
}
