//! What light a grid of extinction sends to an eye: a slow estimate by tracing paths, to judge the sprites' light by.
//!
//! All light is scattered and none absorbed, as droplets do it, and thrown forward by Henyey and Greenstein's phase function
//! of g = .85 (*Diffuse radiation in the galaxy*, 1941; MODEL §10). Paths begin at the eye. The first scattering of each is
//! within the cloud, and the path counts as much as the cloud is opaque there, so none is spent on what is clear. At each
//! scattering some of each sun's light comes straight (next-event estimation); a path that leaves ends in the sky. No path
//! depends on the lights, so one path serves the sky and all suns.
//!
//! A voxel is as dense throughout, which makes free flights exact (`walk.rs`). Random numbers belong to pixel, sample and
//! scattering, and each pixel's sums have one order: the same bytes on any number of threads. The judge is Mitsuba
//! (tests/judges/traced.py).

mod phase;
mod walk;

pub use phase::FORWARD;
pub use walk::Medium;

use crate::camera::View;
use crate::random::{draw, unit};
use crate::watch::Watch;
use glam::Vec3;
use rayon::prelude::*;
use std::f64::consts::PI;
use std::sync::atomic::{AtomicUsize, Ordering};

/// After so many scatterings a path has forgotten whence it came: it ends in the mean of the sky. A path through a cloud
/// meets as many as a chord is optically deep on average, whatever scatters how (Blanco and Fournier, *An invariance
/// property of diffusive random walks*, 2003): some tens.
const MOST_SCATTERINGS: u32 = 20_000;
/// Of the dice.
const SEED: u64 = 0x7_2AC3;

/// What light comes from without. A sun gives a white, matt card that faces it a radiance of 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Surroundings {
    /// Radiance of the sky above the horizon.
    pub above: f32,
    /// Radiance of what lies below it.
    pub below: f32,
    /// To each sun, unit. Each is alone in its own picture.
    pub suns: Vec<Vec3>,
}

/// What a picture is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Traced {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// How much of what is behind it the grid hides, 0 to 1; top row first.
    pub alpha: Vec<f32>,
    /// Radiance by the sky's light alone, times alpha.
    pub sky: Vec<f32>,
    /// Radiance by each sun's light alone, times alpha, in their order.
    pub suns: Vec<Vec<f32>>,
}

/// A pixel's light before it falls into planes.
struct Pixel {
    alpha: f64,
    sky: f64,
    suns: Vec<f64>,
}

/// What `view` sees of `medium`, with so many `samples` a pixel, strewn over it; pixels are clear where `watch` was cancelled
/// before.
pub fn trace(medium: &Medium, view: &View, around: &Surroundings, samples: u32, watch: &Watch) -> Traced {
    let (done, count) = (AtomicUsize::new(0), view.width as usize * view.height as usize);
    let pixel = |number: usize| {
        let pixel = pixel(medium, view, around, number as u32, samples.max(1), watch);
        watch.reach((done.fetch_add(1, Ordering::Relaxed) + 1) as f32 / count as f32);
        pixel
    };
    let pixels: Vec<Pixel> = (0..count).into_par_iter().map(pixel).collect();
    let plane = |of: &dyn Fn(&Pixel) -> f64| pixels.iter().map(|pixel| of(pixel) as f32).collect();
    Traced {
        width: view.width,
        height: view.height,
        alpha: plane(&|pixel| pixel.alpha),
        sky: plane(&|pixel| pixel.sky),
        suns: (0..around.suns.len()).map(|sun| plane(&|pixel| pixel.suns[sun])).collect(),
    }
}

fn pixel(medium: &Medium, view: &View, around: &Surroundings, number: u32, samples: u32, watch: &Watch) -> Pixel {
    let mut sum = Pixel { alpha: 0.0, sky: 0.0, suns: vec![0.0; around.suns.len()] };
    let eye = medium.place_of(view.eye);
    let [column, row] = [number % view.width, number / view.width];
    for sample in 0..samples {
        if watch.is_cancelled() {
            break;
        }
        let [across, down, flight, _] = draw(SEED, number.into(), sample, 0).map(unit);
        let ray = view.ray(column as f32 + across as f32, row as f32 + down as f32);
        let dice = |scattering| draw(SEED, number.into(), sample, scattering);
        path(medium, (eye, ray.normalize()), around, flight, dice, &mut sum);
    }
    let mean = 1.0 / f64::from(samples);
    sum.alpha *= mean;
    sum.sky *= mean;
    sum.suns.iter_mut().for_each(|sun| *sun *= mean);
    sum
}

/// Adds what one path from `eye` along a unit `ray` brings to `sum`. `flight`, 0 to 1, says how far it gets first, `dice`
/// what becomes of it at each scattering.
fn path(
    medium: &Medium,
    (eye, ray): (Vec3, Vec3),
    around: &Surroundings,
    flight: f64,
    dice: impl Fn(u32) -> [u32; 4],
    sum: &mut Pixel,
) {
    let through = libm::exp(-medium.depth(eye, ray));
    let alpha = 1.0 - through;
    // Of the light that is scattered at all, evenly what share was before.
    let first = depth_for(1.0 - flight * alpha);
    let Some(mut place) = medium.fly(eye, ray, first) else { return };
    sum.alpha += alpha;
    let mut direction = ray;
    for scattering in 1..=MOST_SCATTERINGS {
        for (sun, light) in around.suns.iter().zip(&mut sum.suns) {
            let straight = libm::exp(-medium.depth(place, *sun));
            *light += alpha * PI * phase::share(direction.dot(*sun)) * straight;
        }
        let [turn, around_ray, flight, _] = dice(scattering).map(unit);
        direction = phase::scattered(direction, turn, around_ray);
        match medium.fly(place, direction, depth_for(flight)) {
            Some(next) => place = next,
            None => {
                sum.sky += alpha * f64::from(if direction.y > 0.0 { around.above } else { around.below });
                return;
            }
        }
    }
    sum.sky += alpha * 0.5 * f64::from(around.above + around.below);
}

/// The optical depth that light gets through by that share.
fn depth_for(share: f64) -> f64 {
    -libm::log(share)
}
