//! Straight ways through the voxels of a grid, each as dense throughout.
//!
//! So the optical depth of a way is a sum, and how far light gets is exact. Tracking with null collisions (Woodcock) would
//! take more steps: a voxel of a cloud is about as long as a free flight in its core, and the rest is clear.

use crate::density::DensityGrid;
use glam::{DVec3, UVec3, Vec3};
use std::cmp::Ordering;

/// A grid to go through. Places count in voxels from its corner.
#[derive(Debug, Clone)]
pub struct Medium {
    size: UVec3,
    voxel_m: f32,
    corner: DVec3,
    /// Optical depth of a voxel's side.
    depth: Vec<f32>,
}

/// A way from voxel to voxel: the index of each with the length within it, voxels, and where it begins.
struct Walk<'a> {
    medium: &'a Medium,
    voxel: [i32; 3],
    /// How far along the way the next side across each axis is.
    next: [f32; 3],
    /// From one side to the next.
    between: [f32; 3],
    step: [i32; 3],
    at: f32,
}

impl Medium {
    /// Filled as `grid` is; what is not a number, or below 0, is clear.
    pub fn new(grid: &DensityGrid) -> Self {
        let depth = grid.extinction.iter().map(|extinction| (extinction * grid.voxel_m).max(0.0));
        Self {
            size: grid.size,
            voxel_m: grid.voxel_m,
            corner: grid.corner,
            depth: depth.map(|depth| if depth.is_finite() { depth } else { 0.0 }).collect(),
        }
    }

    /// A place in the world, metres.
    pub(super) fn place_of(&self, world: DVec3) -> Vec3 {
        ((world - self.corner) / f64::from(self.voxel_m)).as_vec3()
    }

    /// Optical depth of all that lies from a place on along a unit direction.
    pub(super) fn depth(&self, from: Vec3, direction: Vec3) -> f64 {
        const DARK: f64 = 40.0;
        let mut sum = 0.0;
        for (depth, length, _) in Walk::new(self, from, direction).into_iter().flatten() {
            sum += f64::from(depth * length);
            // e⁻⁴⁰ is nothing.
            if sum > DARK {
                break;
            }
        }
        sum
    }

    /// How far light gets from a place along a unit direction until it has met that optical depth; none if it leaves.
    pub(super) fn fly(&self, from: Vec3, direction: Vec3, depth: f64) -> Option<Vec3> {
        let mut left = depth;
        for (depth, length, at) in Walk::new(self, from, direction)? {
            let here = f64::from(depth * length);
            if here > left {
                return Some(from + direction * (at + (left / f64::from(depth)) as f32));
            }
            left -= here;
        }
        None
    }
}

impl<'a> Walk<'a> {
    /// None if the way misses the grid.
    fn new(medium: &'a Medium, from: Vec3, direction: Vec3) -> Option<Self> {
        let size = medium.size.as_vec3();
        let (mut enters, mut leaves) = (0.0_f32, f32::INFINITY);
        for axis in 0..3 {
            let (place, along) = (from[axis], direction[axis]);
            if along == 0.0 {
                if !(0.0..size[axis]).contains(&place) {
                    return None;
                }
                continue;
            }
            let [a, b] = [-place / along, (size[axis] - place) / along];
            enters = enters.max(a.min(b));
            leaves = leaves.min(a.max(b));
        }
        if enters.partial_cmp(&leaves) != Some(Ordering::Less) {
            return None;
        }
        let place = from + direction * enters;
        let (mut voxel, mut next, mut between, mut step) = ([0; 3], [f32::INFINITY; 3], [f32::INFINITY; 3], [0; 3]);
        for axis in 0..3 {
            let along = direction[axis];
            voxel[axis] = (place[axis].max(0.0) as i32).min(medium.size[axis] as i32 - 1);
            if along != 0.0 {
                step[axis] = if along > 0.0 { 1 } else { -1 };
                let side = voxel[axis] + i32::from(along > 0.0);
                next[axis] = ((side as f32 - from[axis]) / along).max(enters);
                between[axis] = 1.0 / along.abs();
            }
        }
        Some(Self { medium, voxel, next, between, step, at: enters })
    }
}

impl Iterator for Walk<'_> {
    /// Optical depth of the voxel's side, length within it, and how far along the way it begins.
    type Item = (f32, f32, f32);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let size = self.medium.size;
        let [x, y, z] = self.voxel;
        if x < 0 || y < 0 || z < 0 || x >= size.x as i32 || y >= size.y as i32 || z >= size.z as i32 {
            return None;
        }
        let depth = self.medium.depth[((z as usize) * size.y as usize + y as usize) * size.x as usize + x as usize];
        let [a, b, c] = self.next;
        let axis = if a <= b && a <= c { 0 } else { 1 + usize::from(c < b) };
        let end = self.next[axis];
        let item = (depth, (end - self.at).max(0.0), self.at);
        self.at = end;
        self.voxel[axis] += self.step[axis];
        self.next[axis] += self.between[axis];
        Some(item)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{draw, unit};

    fn some_grid() -> DensityGrid {
        let mut grid = DensityGrid::clear(UVec3::new(5, 4, 3), 20.0, DVec3::new(100.0, -30.0, 7.0));
        for (index, value) in (0..).zip(&mut grid.extinction) {
            *value = unit(draw(3, 0, index, 0)[0]) as f32 * 0.1;
        }
        grid
    }

    /// Ways in all directions, from within and without: the depth is that of many small steps.
    #[test]
    fn a_depth_is_the_sum_of_small_steps() {
        let grid = some_grid();
        let medium = Medium::new(&grid);
        for number in 0..300 {
            let [x, y, z, u] = draw(4, 0, number, 0).map(|bits| unit(bits) as f32);
            let [a, b, c, _] = draw(4, 0, number, 1).map(|bits| unit(bits) as f32 - 0.5);
            let from = Vec3::new(x * 9.0 - 2.0, y * 8.0 - 2.0, z * 7.0 - 2.0);
            let direction = if u < 0.2 {
                [Vec3::X, Vec3::NEG_Y, Vec3::Z][number as usize % 3]
            } else {
                Vec3::new(a, b, c).normalize()
            };
            const STEP: f32 = 0.002;
            let at = |place: Vec3| {
                let inside = place.cmpge(Vec3::ZERO).all() && place.cmplt(grid.size.as_vec3()).all();
                let voxel = place.as_uvec3();
                if inside { grid.extinction[((voxel.z * 4 + voxel.y) * 5 + voxel.x) as usize] * 20.0 } else { 0.0 }
            };
            let steps = (0..10_000).map(|i| f64::from(at(from + direction * ((i as f32 + 0.5) * STEP)) * STEP));
            let (got, want) = (medium.depth(from, direction), steps.sum::<f64>());
            // A step may lie across each of some ten sides, of voxels of a depth of 2 at most.
            assert!((got - want).abs() < 0.02, "from {from} along {direction}: {got}, not {want}");
            if want > 0.1 {
                let place = medium.fly(from, direction, 0.5 * got).expect("half of it is within");
                let rest = medium.depth(place, direction);
                assert!((rest - 0.5 * got).abs() < 1e-3, "half of {got} leaves {rest}");
            }
            assert_eq!(medium.fly(from, direction, got + 1e-4), None);
        }
    }

    #[test]
    fn what_is_no_extinction_is_clear() {
        let mut grid = DensityGrid::clear(UVec3::new(3, 1, 1), 10.0, DVec3::ZERO);
        grid.extinction = vec![f32::NAN, -1.0, f32::INFINITY];
        assert_eq!(Medium::new(&grid).depth(Vec3::new(-1.0, 0.5, 0.5), Vec3::X), 0.0);
    }
}
