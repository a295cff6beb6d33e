//! One slide: a picture of the truth, or a map in the colours of [`heat`].

use crate::chart::heat;
use crate::opening::Beside;
use crate::state::Lens;
use crate::viewport::picture::Shot;
use cloudwright_core::derived::Derived;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::{PIXELS_PER_DEGREE, PixelMap, flip, overdraw_map, wrong_order};
use cloudwright_core::method::{Renderer, Settings};
use cloudwright_core::scene::Scene;
use cloudwright_core::version::Version;
use cloudwright_core::watch::Watch;
use std::sync::Arc;

/// Of a map's pixels, the share that is not brighter than the brightest colour: single worst ones would darken all.
const BRIGHTEST: f64 = 0.999;

/// What is to be drawn.
pub(super) struct Wish {
    pub(super) lens: Lens,
    pub(super) scene: Arc<Scene>,
    pub(super) derived: Arc<Derived>,
    pub(super) beside: Beside,
    pub(super) shot: Shot,
    /// The same view as the truth draws it.
    pub(super) truth: Shot,
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
pub(super) fn draw(wish: &Wish) -> Option<Slide> {
    let Wish { lens, scene, derived, beside, number, coarseness, watch, .. } = wish;
    let smaller = |shot: &Shot| Shot { size: shot.size.map(|side| side.div_ceil(*coarseness).max(1)), ..shot.clone() };
    let picture_of = |shot: &Shot, settings: &Settings| {
        let shot = Shot { settings: *settings, ..smaller(shot) };
        settings.picture(&shot.frame(scene, derived, beside), watch).filter(|_| !watch.is_cancelled())
    };
    let truth = || picture_of(&wish.truth, &wish.truth.settings);
    let map_of = |map: fn(&cloudwright_core::frame::Frame<'_>) -> PixelMap| {
        (!watch.is_cancelled()).then(|| map(&smaller(&wish.shot).frame(scene, derived, beside)))
    };
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
            let mut settings = wish.shot.settings;
            if settings.renderer == Renderer::Gpu {
                settings.renderer = Settings::SHIPPED.renderer;
            }
            flip(&truth()?, &picture_of(&wish.shot, &settings)?, PIXELS_PER_DEGREE).ok()?
        }
    };
    let scale = Scale { brightest: map.percentile(BRIGHTEST), mean: map.mean() };
    let picture = heat::picture([map.width, map.height], &map.values, scale.brightest);
    Some(Slide { number: *number, coarseness: *coarseness, picture, scale: Some(scale) })
}
