//! The fit of one model, by one of its clouds.

use super::alone::{Alone, By, Look};
use super::likeness::Pairs;
use super::squares::Squares;
use super::values::Values;
use super::{BELOW, Choice, FittedModel, Hour, Likeness};
use crate::color::Rgb;
use crate::image::Layer;
use crate::scene::{Cloud, CloudModel, Scene};
use crate::sprites::{Atlas, SoftLight};
use crate::traced::{Surroundings, Traced};
use crate::watch::Watch;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Pixels count where the sprites and the vapour are at least as opaque.
const SHOWS: f32 = 0.1;
/// Self-shadows that are tried.
const SHADOWS: u32 = 100;
/// Of the whole way, up to where the path tracer is done.
const TRACED: f32 = 0.6;
/// And the units are drawn.
const DRAWN: f32 = 0.95;

/// What `model` is with its light fitted, none if it can't be brought nearer; none at all if nothing of `cloud` shows, or
/// `watch` is cancelled. `reach` is told how far it is.
pub(super) fn fit(
    scene: &Scene,
    (cloud, model): (&Cloud, &CloudModel),
    atlas: &Atlas,
    (choice, hours): (&Choice, &[Hour]),
    reach: &(dyn Fn(f32) + Sync),
    watch: &Watch,
) -> Option<(FittedModel, Option<CloudModel>)> {
    let alone = Alone::new(scene, (cloud, model), atlas, watch)?;
    let suns = hours.iter().map(|hour| hour.sun).collect();
    let around = Surroundings { above: 1.0, below: BELOW, suns };
    let mut traced = alone.traced(&around, choice.samples, &|share| reach(TRACED * share), watch)?;
    let brightness =
        Pairs::brightness(&One { alone: &alone, model, choice, hours, traced: &traced }.pairs(model, watch)?);
    for plane in traced.iter_mut().flat_map(|view| view.suns.iter_mut().chain([&mut view.sky])) {
        plane.iter_mut().for_each(|light| *light *= brightness as f32);
    }
    let one = One { alone: &alone, model, choice, hours, traced: &traced };
    let before_values = Values::now(model, alone.placed(), &alone.heights);
    let before = one.likeness(model, watch)?;
    let values = one.best(before_values, &|share| reach(TRACED + (DRAWN - TRACED) * share), watch)?;
    let mut new = model.clone();
    values.write(&mut new, &alone.heights, choice.free);
    let after = one.likeness(&new, watch)?;
    let told = |after, values| FittedModel { id: model.id, name: model.name.clone(), before, after, values };
    Some(if after.error < before.error {
        (told(after, values), Some(new))
    } else {
        (told(before, before_values), None)
    })
}

/// A model before what is wanted of it.
struct One<'a> {
    alone: &'a Alone<'a>,
    model: &'a CloudModel,
    choice: &'a Choice,
    hours: &'a [Hour],
    traced: &'a [Traced],
}

impl One<'_> {
    /// The values that bring it nearest.
    fn best(&self, now: Values, reach: &(dyn Fn(f32) + Sync), watch: &Watch) -> Option<Values> {
        let done = AtomicUsize::new(0);
        let of_view = |view: usize| {
            if watch.is_cancelled() {
                return None;
            }
            let sums = (self.of_sky(view), self.of_suns(view));
            reach((done.fetch_add(1, Ordering::Relaxed) + 1) as f32 / self.alone.views() as f32);
            Some(sums)
        };
        let views: Vec<Option<_>> = (0..self.alone.views()).into_par_iter().map(of_view).collect();
        let (sky, suns) =
            views.into_iter().collect::<Option<Vec<_>>>()?.into_iter().reduce(|mut sum, (sky, suns)| {
                sum.0.join(&sky);
                sum.1.join(&suns);
                sum
            })?;
        let free = self.choice.free;
        let levels: Vec<f64> = if free.levels { now.levels.map(f64::from).into() } else { Vec::new() };
        let steps: Vec<f64> = if free.shares { steps_of(now.shares).into() } else { Vec::new() };
        let shadows: Vec<f64> = if free.self_shadow {
            (0..=SHADOWS).map(|step| f64::from(step) / f64::from(SHADOWS)).collect()
        } else {
            vec![self.model.self_shadow]
        };
        let solved = shadows.into_iter().map(|shadow| (shadow, sky.solve(shadow, &levels), suns.solve(shadow, &steps)));
        let (shadow, sky, suns) = solved.min_by(|a, b| (a.1.rest + a.2.rest).total_cmp(&(b.1.rest + b.2.rest)))?;
        let mut best = Values { self_shadow: shadow as f32, ..now };
        for (level, found) in best.levels.iter_mut().zip(&sky.unknowns) {
            *level = *found as f32;
        }
        if let Ok(steps) = <[f64; 6]>::try_from(suns.unknowns) {
            best.shares = shares_of(steps);
        }
        Some(best)
    }

    /// The sky's light in a view: a unit of each level, three at a time as red, green and blue.
    fn of_sky(&self, view: usize) -> Squares {
        let free = self.choice.free.levels;
        let mut sums = Squares::new(if free { 5 } else { 0 });
        let with_levels = |levels: [[f32; 3]; 5], self_shadow: f32| {
            let mut look = Look::of(self.model, self.alone, self_shadow);
            for (level, [r, g, b]) in look.levels.iter_mut().zip(levels) {
                level.color.rgb = Rgb::new(r, g, b);
            }
            self.alone.drawn(&look, By::Sky, view)
        };
        let pictures: Vec<Layer> = if free {
            let unit = |level: usize, channel: usize| f32::from(u8::from(level == channel));
            let threes = [0, 3]
                .map(|first| std::array::from_fn(|level| std::array::from_fn(|channel| unit(level, first + channel))));
            [0.0, 1.0].iter().flat_map(|&shadow| threes.map(|levels| with_levels(levels, shadow))).collect()
        } else {
            let now = Values::levels_of(self.model).map(|level| [level; 3]);
            [0.0, 1.0].map(|shadow| with_levels(now, shadow)).into()
        };
        // Over the hours one brightness serves all: what is wanted of it is their mean, each as bright as it is.
        let weight = self.hours.iter().map(|hour| hour.ambient * hour.ambient).sum::<f64>();
        let share =
            self.hours.iter().map(|hour| hour.ambient * hour.sky_light).sum::<f64>() / weight.max(f64::MIN_POSITIVE);
        let traced = &self.traced[view];
        for (at, wanted, opacity) in shown(traced, &traced.sky, &pictures[0]) {
            let of = |picture: &Layer| {
                let pixel = picture.pixels[at];
                [pixel.r, pixel.g, pixel.b].map(|channel| f64::from(channel / pixel.a))
            };
            let side = |pictures: &[Layer]| -> Vec<f64> {
                if free {
                    let [a, b] = [of(&pictures[0]), of(&pictures[1])];
                    vec![0.0, a[0], a[1], a[2], b[0], b[1]]
                } else {
                    vec![of(&pictures[0])[1]]
                }
            };
            let (clear, shadowed) = pictures.split_at(pictures.len() / 2);
            let pixel: Vec<f64> = side(clear).into_iter().chain(side(shadowed)).chain([share * wanted]).collect();
            sums.add(&pixel, weight * opacity);
        }
        sums
    }

    /// The suns' light in a view: a unit of each step of the shares, and the halo.
    fn of_suns(&self, view: usize) -> Squares {
        let free = self.choice.free.shares;
        let count = if free { 6 } else { 0 };
        let mut sums = Squares::new(count);
        for (hour, wanted) in self.hours.iter().zip(&self.traced[view].suns) {
            let draw = |look: &Look| self.alone.drawn(look, By::Sun(hour.sun), view);
            let side = |self_shadow: f32| -> Vec<Layer> {
                let look = Look::of(self.model, self.alone, self_shadow);
                if !free {
                    return vec![draw(&look)];
                }
                let with_steps = |steps: [f64; 6], halo: f32| {
                    let values = Values { levels: [0.0; 5], shares: shares_of(steps), self_shadow };
                    let groups = values.groups(self.alone.placed(), &self.alone.heights);
                    draw(&Look { groups, soft_light: SoftLight { halo, self_shadow }, ..look.clone() })
                };
                let unit = |step: usize| std::array::from_fn(|at| if at == step { 1.0 } else { 0.0 });
                let halo = with_steps([0.0; 6], self.model.halo as f32);
                [halo].into_iter().chain((0..6).map(|step| with_steps(unit(step), 0.0))).collect()
            };
            let pictures: Vec<Layer> = [0.0, 1.0].into_iter().flat_map(side).collect();
            let weight = hour.sun_light * hour.sun_light;
            for (at, wanted, opacity) in shown(&self.traced[view], wanted, &pictures[0]) {
                let of = |picture: &Layer| f64::from(picture.pixels[at].g / picture.pixels[at].a);
                let pixel: Vec<f64> = pictures.iter().map(of).chain([wanted]).collect();
                sums.add(&pixel, weight * opacity);
            }
        }
        sums
    }

    /// How near all light of `model`, this one or what it may become, comes to what is wanted.
    fn likeness(&self, model: &CloudModel, watch: &Watch) -> Option<Likeness> {
        Some(Likeness::of(&self.pairs(model, watch)?))
    }

    /// All light of `model` beside what is wanted, hour by hour.
    fn pairs(&self, model: &CloudModel, watch: &Watch) -> Option<Vec<Pairs>> {
        let values = Values::now(model, self.alone.placed(), &self.alone.heights);
        let mut look = Look::of(model, self.alone, model.self_shadow as f32);
        look.levels = values.grey(look.levels);
        let of_view = |view: usize| -> Option<Vec<Pairs>> {
            if watch.is_cancelled() {
                return None;
            }
            let traced = &self.traced[view];
            let sky = self.alone.drawn(&look, By::Sky, view);
            let of_hour = |(hour, wanted): (&Hour, &Vec<f32>)| {
                let mut pairs = Pairs::default();
                let sun = self.alone.drawn(&look, By::Sun(hour.sun), view);
                let by_sky = shown(traced, &traced.sky, &sky);
                for ((at, by_sky, opacity), (_, by_sun, _)) in by_sky.zip(shown(traced, wanted, &sun)) {
                    let light = |picture: &Layer| f64::from(picture.pixels[at].g / picture.pixels[at].a);
                    let of_sky = [hour.ambient * light(&sky), hour.sky_light * by_sky];
                    let of_sun = [light(&sun), by_sun].map(|light| hour.sun_light * light);
                    pairs.add([of_sky, of_sun], opacity);
                }
                pairs
            };
            Some(self.hours.iter().zip(&traced.suns).map(of_hour).collect())
        };
        let views: Vec<Option<_>> = (0..self.alone.views()).into_par_iter().map(of_view).collect();
        let join = |sum: Vec<Pairs>, view: Vec<Pairs>| sum.into_iter().zip(view).map(|(a, b)| a.joined(b)).collect();
        views.into_iter().collect::<Option<Vec<_>>>()?.into_iter().reduce(join)
    }
}

/// Of each pixel in which both show: its number, the radiance that is wanted there, and how opaque the sprites are.
fn shown<'a>(
    traced: &'a Traced,
    wanted: &'a [f32],
    picture: &'a Layer,
) -> impl Iterator<Item = (usize, f64, f64)> + use<'a> {
    let all = traced.alpha.iter().zip(wanted).zip(&picture.pixels).enumerate();
    all.filter(|(_, ((alpha, _), pixel))| **alpha >= SHOWS && pixel.a >= SHOWS)
        .map(|(at, ((alpha, wanted), pixel))| (at, f64::from(wanted / alpha), pixel.a.into()))
}

/// Cmin, and by how much Cmed is above it and Cmax above that, at the bottom and at the top.
fn steps_of(shares: [[f32; 3]; 2]) -> [f64; 6] {
    let [[a, b, c], [d, e, f]] = shares.map(|end| end.map(f64::from));
    [a, b - a, c - b, d, e - d, f - e]
}

fn shares_of([a, b, c, d, e, f]: [f64; 6]) -> [[f32; 3]; 2] {
    [[a, a + b, a + b + c], [d, d + e, d + e + f]].map(|end| end.map(|share| share as f32))
}
