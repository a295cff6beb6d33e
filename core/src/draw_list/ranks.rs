//! An order as the place of every sprite, those out of view included.

use super::DrawList;
use crate::camera::View;
use crate::sprites::Known;
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

    /// The same order of those clouds that are known, without gaps where others were; none if there are new ones.
    pub(super) fn of_known(&self, known: &Known, cloud_count: usize) -> Option<Self> {
        let places = |index: u32| known.index(index).and_then(|before| self.of_cloud.get(before as usize)).cloned();
        let mut of_cloud = (0..cloud_count as u32).map(places).collect::<Option<Vec<_>>>()?;
        let mut in_order: Vec<&mut u32> = of_cloud.iter_mut().flatten().collect();
        in_order.sort_unstable_by_key(|place| **place);
        in_order.into_iter().zip(0..).for_each(|(place, next)| *place = next);
        Some(Self { of_cloud })
    }

    /// The place of a sprite; last for one that was not there.
    pub(super) fn of(&self, cloud: u32, sprite: u32) -> u32 {
        self.of_cloud.get(cloud as usize).and_then(|places| places.get(sprite as usize)).copied().unwrap_or(u32::MAX)
    }
}
