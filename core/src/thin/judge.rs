//! The scene as it was, seen from everywhere: which sprites it would miss least, and how far a trial is from it.

use super::Key;
use super::losses::losses;
use super::trial::{Trial, id_of};
use super::vantages::{Vantage, Vantages};
use crate::draw;
use crate::frame::Frame;
use crate::image::Picture;
use crate::measure::{PIXELS_PER_DEGREE, flip};
use crate::scene::ModelId;
use crate::sprites::Atlas;
use crate::watch::Watch;
use rayon::prelude::*;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Views of more sprites are drawn one after the other, each by all threads, as each takes memory for all its sprites.
const MANY_SPRITES: usize = 1 << 16;
/// Of the whole way, the first pictures.
const FIRST_PICTURES: f32 = 0.05;

/// The scene as it was, from everywhere.
pub(super) struct Judge<'a> {
    atlas: &'a Atlas,
    pub(super) vantages: Vec<Vantage>,
    /// Whose sprites may be dropped.
    models: FxHashSet<ModelId>,
    pictures: Vec<Option<Picture>>,
    tolerance: f64,
    /// The view that was too far off last; likely it is so again.
    strictest: AtomicUsize,
    watch: &'a Watch,
}

impl<'a> Judge<'a> {
    /// Some pictures are missing if `watch` is cancelled.
    pub(super) fn new(trial: &Trial<'_>, atlas: &'a Atlas, tolerance: f64, watch: &'a Watch) -> Self {
        let Vantages { list: vantages, models } = Vantages::new(&trial.scene, trial.derived.clouds(), &trial.models);
        let strictest = AtomicUsize::new(0);
        let mut judge = Self { atlas, vantages, models, pictures: Vec::new(), tolerance, strictest, watch };
        let done = AtomicUsize::new(0);
        judge.pictures = judge.each_view(|_, vantage| {
            let picture = judge.picture(trial, vantage);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            watch.reach(FIRST_PICTURES * done as f32 / judge.vantages.len() as f32);
            picture
        });
        judge
    }

    /// How many sprites may be dropped, each counted once for all clouds of its model.
    pub(super) fn key_count(&self, trial: &Trial<'_>) -> usize {
        trial.wanted.iter().filter(|(model, _)| self.models.contains(model)).count()
    }

    /// How many models with sprites keep them all, because no view is around a cloud of theirs.
    pub(super) fn kept_models(&self, trial: &Trial<'_>) -> usize {
        let models: FxHashSet<ModelId> = trial.wanted.iter().map(|(model, _)| *model).collect();
        models.difference(&self.models).count()
    }

    /// What `f` makes of each view and its place in the list.
    fn each_view<R: Send>(&self, f: impl Fn(usize, &Vantage) -> R + Sync) -> Vec<R> {
        let is_large = |vantage: &Vantage| vantage.sprites > MANY_SPRITES;
        let few = self.vantages.par_iter().enumerate();
        let few: Vec<_> = few.map(|(index, vantage)| (!is_large(vantage)).then(|| f(index, vantage))).collect();
        let all = few.into_iter().zip(&self.vantages).enumerate();
        all.map(|(index, (made, vantage))| made.unwrap_or_else(|| f(index, vantage))).collect()
    }

    /// What `f` makes of what is seen there.
    fn seen<R>(&self, trial: &Trial<'_>, vantage: &Vantage, f: impl FnOnce(&Frame<'_>) -> R) -> R {
        let alone = vantage.alone.map(|cloud| trial.derived.alone(cloud));
        let derived = alone.as_ref().unwrap_or(&trial.derived);
        f(&Frame::new(&trial.scene, derived, self.atlas, &vantage.sight))
    }

    /// None once the watch is cancelled, and only then, since what ships draws on the CPU.
    fn picture(&self, trial: &Trial<'_>, vantage: &Vantage) -> Option<Picture> {
        if self.watch.is_cancelled() {
            return None;
        }
        self.seen(trial, vantage, |frame| draw::picture(frame, self.watch))
    }

    /// The sprites that may be dropped, those first that are missed least in the view that misses them most. Any order if
    /// the watch is cancelled.
    pub(super) fn ranked(&self, trial: &Trial<'_>) -> Vec<Key> {
        let outermost = trial.outermost();
        let may_go = |key: &Key| self.models.contains(&key.0) && !outermost.contains(key);
        let losses: FxHashMap<Key, f32> = trial.keys().filter(may_go).map(|key| (key, 0.0)).collect();
        let losses = Mutex::new(losses);
        self.each_view(|_, vantage| {
            if self.watch.is_cancelled() {
                return;
            }
            let in_view = self.seen(trial, vantage, |frame| losses_by_key(trial, frame));
            // Not poisoned: nothing in it panics. The larger of two doesn't depend on which comes first.
            let Ok(mut losses) = losses.lock() else { return };
            for (key, loss) in in_view {
                if let Some(most) = losses.get_mut(&key) {
                    *most = most.max(loss);
                }
            }
        });
        let mut ranked: Vec<_> = losses.into_inner().unwrap_or_default().into_iter().collect();
        ranked.sort_by(|(a, loss), (b, other)| loss.total_cmp(other).then(a.cmp(b)));
        ranked.into_iter().map(|(key, _)| key).collect()
    }

    /// The largest error of any view and which that is; none as soon as one exceeds the tolerance.
    pub(super) fn worst(&self, trial: &Trial<'_>) -> Option<(f64, usize)> {
        let error = |index: usize| {
            let before = self.pictures[index].as_ref()?;
            let error = flip(before, &self.picture(trial, &self.vantages[index])?, PIXELS_PER_DEGREE).ok()?.mean();
            (error <= self.tolerance).then_some(error)
        };
        let strictest = self.strictest.load(Ordering::Relaxed);
        error(strictest)?;
        let is_off = AtomicBool::new(false);
        let errors = self.each_view(|index, _| {
            let error = if is_off.load(Ordering::Relaxed) { None } else { error(index) };
            if error.is_none() && !is_off.swap(true, Ordering::Relaxed) {
                self.strictest.store(index, Ordering::Relaxed);
            }
            error
        });
        let errors: Vec<f64> = errors.into_iter().collect::<Option<_>>()?;
        let larger = |a: (f64, usize), b: (f64, usize)| if b.0 > a.0 { b } else { a };
        Some(errors.into_iter().zip(0..).fold((0.0, 0), larger))
    }
}

fn losses_by_key(trial: &Trial<'_>, frame: &Frame<'_>) -> FxHashMap<Key, f32> {
    let mut of_key: FxHashMap<Key, f32> = FxHashMap::default();
    for (drawn, loss) in frame.list.sprites.iter().zip(losses(frame)) {
        let cloud = &frame.clouds[drawn.cloud as usize];
        let sprite = &cloud.sprites.all()[drawn.sprite as usize];
        *of_key.entry((trial.models[&cloud.id], id_of(sprite))).or_default() += loss;
    }
    of_key
}
