//! An order as the place of every sprite, those out of view included.

use super::DrawList;
use crate::camera::View;
use crate::weather::CloudNow;

/// The place of every sprite from far to near, cloud by cloud.
#[derive(Debug, Clone, PartialEq)]
pub struct Ranks {
    pub(crate) of_cloud: Vec<Vec<u32>>,
}

impl Ranks {
    /// All sprites by their distance from the eye.
    pub fn from_afar(clouds: &[CloudNow<'_>], view: &View) -> Self {
        let list = DrawList::of_all(clouds, view);
        let mut of_cloud: Vec<Vec<u32>> = clouds.iter().map(|cloud| vec![0; cloud.placed.sprites.len()]).collect();
        for (drawn, place) in list.sprites.iter().zip(0..) {
            of_cloud[drawn.cloud as usize][drawn.sprite as usize] = place;
        }
        Self { of_cloud }
    }

    /// The place of a sprite; last for one that was not there.
    pub(super) fn of(&self, cloud: u32, sprite: u32) -> u32 {
        self.of_cloud.get(cloud as usize).and_then(|places| places.get(sprite as usize)).copied().unwrap_or(u32::MAX)
    }
}
