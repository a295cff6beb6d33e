//! Lazy sorting, as two programs have it: cheap, and late.

use crate::camera::View;
use crate::draw_list::{LastSort, LazySorting, Ranks};
use crate::weather::CloudNow;

/// As SkyWorks does (Harris): anew after 36.9° of turn (a cosine of 0.8) or 10 m of travel.
pub const SKYWORKS: LazySorting = LazySorting { name: "after 10 m or 36.9°", step: skyworks };

/// As SimGear does: one pass of bubble sort a frame; each that finds nothing to do doubles the frames to the next one, up
/// to 128.
pub const SIMGEAR: LazySorting = LazySorting { name: "one bubble pass a frame", step: simgear };

fn skyworks(last: &mut LastSort, ranks: &mut Ranks, clouds: &[CloudNow<'_>], view: &View) {
    if last.forward.dot(view.forward) < 0.8 || last.eye.distance(view.eye) > 10.0 {
        *ranks = Ranks::from_afar(clouds, view);
        *last = LastSort::at(view);
    }
}

fn simgear(last: &mut LastSort, ranks: &mut Ranks, clouds: &[CloudNow<'_>], view: &View) {
    last.waited += 1;
    if last.waited > last.wait {
        last.waited = 0;
        let swapped = bubble(ranks, clouds, view);
        last.wait = if swapped { 0 } else { (last.wait * 2).clamp(1, 128) };
    }
}

/// One pass from far to near. Whether any two changed places.
fn bubble(ranks: &mut Ranks, clouds: &[CloudNow<'_>], view: &View) -> bool {
    let mut in_order: Vec<(u32, u32, f32)> = vec![(0, 0, 0.0); ranks.of_cloud.iter().map(Vec::len).sum()];
    for (index, (places, cloud)) in ranks.of_cloud.iter().zip(clouds).enumerate() {
        let offset = cloud.from_eye(view.eye);
        for (sprite, place) in places.iter().enumerate() {
            let distance = (offset + cloud.sprite_now(sprite).position).length_squared();
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
