//! What a sorted list of whole sprites costs in colour, against each ray's own order.
//!
//! Sprites that face the eye cross one another, so a list that is right for one pixel is wrong for its neighbour.
//! Where two fragments that are next to each other on a ray, of opacity α and β and colours c and d, with transmittance
//! T before them, change places, the pixel changes by T·α·β·(c − d), and its opacity not at all.
//!
//! So weigh pairs thus: take a ray's fragments in the list's order, nearest first. Each in turn is sunk through all that
//! the list has behind it, which stand in the order of their own depths; what swapping it with the next one costs, in
//! the largest channel, is the pair's weight, and T all that is before the two at that moment: what the list has in
//! front, and what it has sunk through already. A pair is *wrong* where the fragment is really the farther one. Sinking
//! each just as far as it belongs turns the list's order into the true one swap by swap, so the weights of the wrong
//! pairs are what the list's order costs, exactly as colours don't cancel out; they bound the error of the pixel's
//! colour. The idea is the insertion sort's, with colours for counts.

use super::PixelMap;
use super::errors::largest_difference;
use crate::color::Rgb;
use crate::frame::Frame;
use crate::raster::bins::{assemble, map_tiles};
use crate::raster::{ScreenSprite, prepare};
use std::cmp::Ordering;

/// Less than this share of a pixel's light is not followed further. What that leaves out of a pixel's weights is at most
/// twice this times the largest difference of two colours.
const NEGLIGIBLE: f32 = 1e-5;

/// What a list's order costs.
#[derive(Debug, Clone, PartialEq)]
pub struct WrongOrder {
    /// The wrong pairs' weights as a share of all pairs' weights, 0 to 1; 0 where no sprites overlap.
    pub share: f64,
    /// Each pixel's wrong pairs' weights: linear light before exposure, no less than the wrong order changes it by.
    pub cost: PixelMap,
}

/// Weighs the frame's list against the order along the ray through each pixel's centre.
///
/// Fragments are those of the truth with one sample a pixel: filtered for a pixel, ordered by their own depth, equally
/// deep ones by their sprites' places in the scene.
pub fn wrong_order(frame: &Frame<'_>) -> WrongOrder {
    let (width, height) = (frame.view.width, frame.view.height);
    let sprites = prepare(frame);
    let tiles = map_tiles(&sprites, width, height, |rect, members| {
        let mut ray = Ray::default();
        let pixel = |i: u32| {
            let (x, y) = (rect.left + i % rect.width, rect.top + i / rect.width);
            ray.take(frame, &sprites, members, x as f32 + 0.5, y as f32 + 0.5);
            ray.weigh()
        };
        (0..rect.width * rect.height).map(pixel).collect()
    });
    let weights = assemble(&tiles, width, height, Weights::default());
    let map = |of: fn(&Weights) -> f32| PixelMap { width, height, values: weights.iter().map(of).collect() };
    let (cost, all) = (map(|weights| weights.wrong), map(|weights| weights.all).mean());
    // Where no two colours overlap there is nothing to lose.
    let share = if all > 0.0 { cost.mean() / all } else { 0.0 };
    WrongOrder { share, cost }
}

/// Sums over a pixel's pairs.
#[derive(Debug, Clone, Copy, Default)]
struct Weights {
    wrong: f32,
    all: f32,
}

struct Fragment {
    depth: f32,
    /// Its cloud and its number within it, which order fragments at one depth.
    place: [u32; 2],
    /// Not multiplied by `alpha`, which is above 0.
    color: Rgb,
    alpha: f32,
}

impl Fragment {
    /// Nearest first; of equally near ones the later in the scene is drawn over the earlier.
    fn compare(&self, other: &Self) -> Ordering {
        self.depth.total_cmp(&other.depth).then(other.place.cmp(&self.place))
    }
}

/// A ray's fragments: as listed, nearest first, and the numbers of those not yet sunk by their own depth.
#[derive(Default)]
struct Ray {
    listed: Vec<Fragment>,
    by_depth: Vec<usize>,
}

impl Ray {
    /// The fragments at a pixel coordinate of those sprites that are `members`, nearest first.
    fn take(&mut self, frame: &Frame<'_>, sprites: &[ScreenSprite], members: &[u32], x: f32, y: f32) {
        let fragment = |&member: &u32| {
            let sprite = &sprites[member as usize];
            let (fragment, depth) = sprite.fragment(frame.atlas, x, y, |depth| sprite.mip_at(depth, 1.0))?;
            let drawn = &frame.list.sprites[member as usize];
            let color = Rgb::new(fragment.r, fragment.g, fragment.b) * (1.0 / fragment.a);
            let place = [drawn.cloud, drawn.sprite];
            (fragment.a > 0.0).then_some(Fragment { depth, place, color, alpha: fragment.a })
        };
        self.listed.clear();
        self.listed.extend(members.iter().filter_map(fragment));
        self.by_depth.clear();
        self.by_depth.extend(0..self.listed.len());
        self.by_depth.sort_by(|&a, &b| self.listed[a].compare(&self.listed[b]));
    }

    fn weigh(&mut self) -> Weights {
        let mut weights = Weights::default();
        let mut before_it = 1.0;
        for (index, sinking) in self.listed.iter().enumerate() {
            if before_it < NEGLIGIBLE {
                break;
            }
            self.by_depth.retain(|&other| other != index);
            let mut before_both = before_it;
            for passed in self.by_depth.iter().map(|&other| &self.listed[other]) {
                if before_both < NEGLIGIBLE * before_it {
                    break;
                }
                let colors = largest_difference(sinking.color, passed.color);
                let weight = before_both * sinking.alpha * passed.alpha * colors;
                weights.all += weight;
                if passed.compare(sinking) == Ordering::Less {
                    weights.wrong += weight;
                }
                before_both *= 1.0 - passed.alpha;
            }
            before_it *= 1.0 - sinking.alpha;
        }
        weights
    }
}
