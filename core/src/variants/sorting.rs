//! Lazy sorting, as two programs have it: cheap, and late.

use crate::camera::View;
use crate::draw_list::{Ranks, eye_offset};
use crate::sprites::PlacedCloud;
use glam::{DVec3, Vec3};

/// When they sort.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LazySorting {
    /// SkyWorks (Harris): anew after 36.9° of turn (a cosine of 0.8) or 10 m of travel.
    SkyWorks,
    /// SimGear: one pass of bubble sort a frame; each that finds nothing to do doubles the frames to the next one, up to
    /// 128.
    SimGear,
}

/// What they remember.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct LazyState {
    eye: DVec3,
    forward: Vec3,
    /// Frames to wait between two passes, and how many were.
    wait: u32,
    waited: u32,
}

impl LazyState {
    /// A whole sort was made for `view`.
    pub(crate) fn sorted_at(&mut self, view: &View) {
        (self.eye, self.forward) = (view.eye, view.forward);
    }

    /// A frame: sorts `ranks` if it is time.
    pub(crate) fn step(&mut self, how: LazySorting, ranks: &mut Ranks, clouds: &[PlacedCloud], view: &View) {
        match how {
            LazySorting::SkyWorks => {
                if self.forward.dot(view.forward) < 0.8 || self.eye.distance(view.eye) > 10.0 {
                    *ranks = Ranks::from_afar(clouds, view);
                    self.sorted_at(view);
                }
            }
            LazySorting::SimGear => {
                self.waited += 1;
                if self.waited > self.wait {
                    self.waited = 0;
                    let swapped = bubble(ranks, clouds, view);
                    self.wait = if swapped { 0 } else { (self.wait * 2).clamp(1, 128) };
                }
            }
        }
    }
}

/// One pass from far to near. Whether any two changed places.
fn bubble(ranks: &mut Ranks, clouds: &[PlacedCloud], view: &View) -> bool {
    let mut in_order: Vec<(u32, u32, f32)> = vec![(0, 0, 0.0); ranks.of_cloud.iter().map(Vec::len).sum()];
    for (index, (places, cloud)) in ranks.of_cloud.iter().zip(clouds).enumerate() {
        let offset = eye_offset(cloud, view);
        for (sprite, place) in places.iter().enumerate() {
            let distance = (offset + cloud.sprites[sprite].position).length_squared();
            in_order[*place as usize] = (index as u32, sprite as u32, distance);
        }
    }
    let mut swapped = false;
    for i in 1..in_order.len() {
        if in_order[i - 1].2 < in_order[i].2 {
            in_order.swap(i - 1, i);
            swapped = true;
        }
    }
    for ((cloud, sprite, _), place) in in_order.into_iter().zip(0..) {
        ranks.of_cloud[cloud as usize][sprite as usize] = place;
    }
    swapped
}
