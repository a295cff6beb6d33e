//! One slide: a picture of the truth, or a map in the colours of [`heat`].

use crate::chart::heat;
use crate::opening::Beside;
use crate::state::Lens;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::{PIXELS_PER_DEGREE, PixelMap, flip, overdraw_map, wrong_order};
use cloudwright_core::rules::{Rasterizer, Rules};
use cloudwright_core::scene::Scene;
use cloudwright_core::sight::Sight;
use cloudwright_core::version::Version;
use cloudwright_core::watch::Watch;
use std::sync::Arc;

/// Of a map's pixels, the share that is not brighter than the brightest colour: single worst ones would darken all.
const BRIGHTEST: f64 = 0.999;

/// What is to be drawn.
pub(super) struct Request {
    pub(super) lens: Lens,
    pub(super) scene: Arc<Scene>,
    pub(super) derived: Arc<Derived>,
    pub(super) beside: Beside,
    pub(super) sight: Sight,
    /// The same view as the truth draws it.
    pub(super) truth: Sight,
    pub(super) number: Version,
    /// Of the slide's pixels, the side in the viewport's pixels.
    pub(super) coarseness: u32,
    pub(super) watch: Arc<Watch>,
}

/// What was.
pub(super) struct Slide {
    pub(super) number: Version,
    pub(super) coarseness: u32,
    pub(super) picture: Picture,
    /// Of a map.
    pub(super) scale: Option<Scale>,
}

/// What a map's colours stand for.
pub(super) struct Scale {
    /// The brightest one.
    pub(super) brightest: f32,
    /// Over all pixels.
    pub(super) mean: f64,
}

/// From the first to be drawn to the last: each slide takes four times as long as the one before, or more.
pub(super) fn coarsenesses(lens: Lens) -> &'static [u32] {
    match lens {
        Lens::Picture => &[],
        Lens::Overdraw => &[1],
        // A figure for four pixels tells as much, and takes a second and not five.
        Lens::WrongOrder => &[4, 2],
        Lens::Wipe | Lens::Error => &[4, 2, 1],
    }
}

/// None if it is not wanted any more.
pub(super) fn draw(request: &Request) -> Option<Slide> {
    let Request { lens, scene, derived, beside, number, coarseness, watch, .. } = request;
    let frame_of = |sight: &Sight| {
        let size = sight.size.map(|side| side.div_ceil(*coarseness).max(1));
        Frame::new(scene, derived, beside.sheet(), &Sight { size, ..sight.clone() })
    };
    let picture_of = |sight: &Sight| draw::picture(&frame_of(sight), watch).filter(|_| !watch.is_cancelled());
    let truth = || picture_of(&request.truth);
    let map_of = |map: fn(&Frame<'_>) -> PixelMap| (!watch.is_cancelled()).then(|| map(&frame_of(&request.sight)));
    let map = match lens {
        Lens::Picture => return None,
        Lens::Wipe => {
            let picture = truth()?;
            return Some(Slide { number: *number, coarseness: *coarseness, picture, scale: None });
        }
        Lens::Overdraw => map_of(overdraw_map)?,
        Lens::WrongOrder => map_of(|frame| wrong_order(frame).cost)?,
        Lens::Error => {
            // A device draws what the CPU does, but not on this thread.
            let mut sight = request.sight.clone();
            if sight.rules.rasterizer == Rasterizer::Gpu {
                sight.rules.rasterizer = Rules::SHIPPED.rasterizer;
            }
            flip(&truth()?, &picture_of(&sight)?, PIXELS_PER_DEGREE).ok()?
        }
    };
    let scale = Scale { brightest: map.percentile(BRIGHTEST), mean: map.mean() };
    let picture = heat::picture([map.width, map.height], &map.values, scale.brightest);
    Some(Slide { number: *number, coarseness: *coarseness, picture, scale: Some(scale) })
}
