//! A cloud's sprites as a grid of extinction, for volumes that leave: a path tracer lights those itself.
//!
//! A sprite stands for a soft ball as deep as it is wide (MODEL §6). Its tile says how much light it lets through at each
//! distance from its middle; what extinction does the same along level chords follows by peeling shells from the outside
//! in (`profile`). Balls are summed into voxels, each with all that it holds, however coarse the voxels are. Tiles let
//! through more here and less there than their mean, so one factor for the whole cloud has the opacity along chords come
//! nearest to the sprites' ([`chord`] says how near).

mod ball;
pub mod chord;
mod grid;
mod profile;

pub use grid::DensityGrid;

use crate::sprites::{Atlas, TILES};
use crate::watch::Watch;
use crate::weather::{CloudNow, Light};
use ball::Ball;
use chord::ChordError;
use glam::{DVec3, UVec3, Vec3};
use profile::Profiles;
use rayon::prelude::*;

/// The most voxels of a grid: 512³.
pub const MOST_VOXELS: u64 = 1 << 27;

/// The most voxels that a grid of several clouds has by itself: 256³.
const MOST_SHARED: f64 = (1 << 24) as f64;

/// How fine a grid is to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fineness {
    /// The side of a voxel, metres.
    VoxelM(f32),
    /// So many voxels along the longest side of the largest cloud; fewer if several clouds would take more than 256³.
    Longest(u32),
}

/// A grid, and how near the opacity along its chords comes to the sprites'.
#[derive(Debug, Clone, PartialEq)]
pub struct Density {
    /// The voxels.
    pub grid: DensityGrid,
    /// What all extinction was multiplied with, so that it does.
    pub factor: f32,
    /// What is left.
    pub error: ChordError,
}

/// Why there is no grid.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum DensityError {
    /// Clouds without sprites, or none of which shows.
    #[error("there is nothing of it")]
    Nothing,
    /// More than [`MOST_VOXELS`].
    #[error("it would take {0} voxels, more than {MOST_VOXELS}; make them larger")]
    TooFine(u64),
    /// Nobody wants it any more.
    #[error("stopped")]
    Cancelled,
}

/// Clouds that are to be one body of vapour, at one moment.
#[derive(Debug, Clone, Copy)]
pub struct Vapour<'a> {
    /// They, near one another.
    pub clouds: &'a [&'a CloudNow<'a>],
    /// The sheet of their tiles.
    pub atlas: &'a Atlas,
    /// What scales their opacity.
    pub light: &'a Light,
}

impl Vapour<'_> {
    /// The least and greatest corner of what it fills, metres in the world; none if nothing shows.
    pub fn bounds(&self) -> Option<[DVec3; 2]> {
        bounds(&ball::of_clouds(self)).map(|bounds| bounds.map(|corner| self.origin() + corner.as_dvec3()))
    }

    /// Its extinction. The same bytes on any number of threads.
    ///
    /// # Errors
    /// If nothing of it shows, the grid would be too large, or `watch` is cancelled.
    pub fn density(&self, fineness: Fineness, watch: &Watch) -> Result<Density, DensityError> {
        let balls = ball::of_clouds(self);
        let [low, high] = bounds(&balls).ok_or(DensityError::Nothing)?;
        let (size, voxel_m) = self.size(high - low, fineness)?;
        let mut grid = DensityGrid::clear(size, voxel_m, self.origin() + low.as_dvec3());
        grid.add(&balls, -low, &Profiles::new(self.atlas), |_| 1.0, watch);
        let chords = chord::through(self, watch);
        if watch.is_cancelled() {
            return Err(DensityError::Cancelled);
        }
        let (factor, error) = chord::fit(&grid, -low, &chords);
        grid.extinction.par_iter_mut().for_each(|value| *value *= factor);
        Ok(Density { grid, factor, error })
    }

    /// For each voxel of `grid`, which is its own, the mean of what `of_tile` says of the tiles that make it dense; 0 where
    /// nothing does.
    ///
    /// # Errors
    /// If `watch` is cancelled.
    pub fn mean_of_tiles(
        &self,
        grid: &DensityGrid,
        of_tile: [f32; TILES],
        watch: &Watch,
    ) -> Result<Vec<f32>, DensityError> {
        let (balls, profiles) = (ball::of_clouds(self), Profiles::new(self.atlas));
        let from_corner = (self.origin() - grid.corner).as_vec3();
        let summed = |weight: &(dyn Fn(u8) -> f32 + Sync)| {
            let mut sums = DensityGrid::clear(grid.size, grid.voxel_m, grid.corner);
            sums.add(&balls, from_corner, &profiles, weight, watch);
            sums.extinction
        };
        let (weighed, plain) = (summed(&|tile| of_tile[usize::from(tile) % TILES]), summed(&|_| 1.0));
        if watch.is_cancelled() {
            return Err(DensityError::Cancelled);
        }
        let mean = |(weighed, plain): (&f32, &f32)| if *plain > 0.0 { weighed / plain } else { 0.0 };
        Ok(weighed.iter().zip(&plain).map(mean).collect())
    }

    /// What positions count from.
    fn origin(&self) -> DVec3 {
        self.clouds.first().map_or(DVec3::ZERO, |cloud| cloud.origin())
    }

    /// Voxels along the axes, and a voxel's side, metres, of what measures `span`.
    fn size(&self, span: Vec3, fineness: Fineness) -> Result<(UVec3, f32), DensityError> {
        let span = span.as_dvec3();
        let voxel_m = match fineness {
            Fineness::VoxelM(side) => f64::from(side),
            Fineness::Longest(count) => {
                let alone = |cloud: &&CloudNow<'_>| {
                    let [low, high] = bounds(&ball::of_clouds(&Vapour { clouds: &[*cloud], ..*self }))?;
                    Some(f64::from((high - low).max_element()))
                };
                let longest = self.clouds.iter().filter_map(alone).fold(0.0, f64::max);
                let most = if self.clouds.len() > 1 { MOST_SHARED } else { MOST_VOXELS as f64 };
                // A little larger, so that rounding adds no voxel.
                (longest / f64::from(count.max(1))).max(libm::cbrt(span.element_product() / most)) * 1.000_001
            }
        };
        let counts = (span / voxel_m).ceil().max(DVec3::ONE);
        let voxels = counts.element_product();
        if !(voxel_m > 0.0 && voxels <= MOST_VOXELS as f64) {
            return Err(DensityError::TooFine(voxels.max(MOST_VOXELS as f64 + 1.0) as u64));
        }
        Ok((counts.as_uvec3(), voxel_m as f32))
    }
}

fn bounds(balls: &[Ball]) -> Option<[Vec3; 2]> {
    let low = balls.iter().map(|ball| ball.center - ball.reach()).reduce(Vec3::min)?;
    let high = balls.iter().map(|ball| ball.center + ball.reach()).reduce(Vec3::max)?;
    Some([low, high])
}
