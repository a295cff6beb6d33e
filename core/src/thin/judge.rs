//! The scene as it was, seen from everywhere: which sprites it would miss least, and how far a trial is from it.

use super::Key;
use super::losses::losses;
use super::trial::{Trial, id_of};
use super::vantages::{Vantage, vantages};
use crate::draw;
use crate::frame::Frame;
use crate::image::Picture;
use crate::measure::{PIXELS_PER_DEGREE, flip};
use crate::sprites::Atlas;
use crate::watch::Watch;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// The scene as it was, from everywhere.
pub(super) struct Judge<'a> {
    atlas: &'a Atlas,
    pub(super) vantages: Vec<Vantage>,
    pictures: Vec<Option<Picture>>,
    tolerance: f64,
    watch: &'a Watch,
}

impl<'a> Judge<'a> {
    pub(super) fn new(trial: &Trial, atlas: &'a Atlas, tolerance: f64, watch: &'a Watch) -> Self {
        let vantages = vantages(trial.document.scene(), trial.derived.clouds());
        let mut judge = Self { atlas, vantages, pictures: Vec::new(), tolerance, watch };
        judge.pictures = judge.vantages.par_iter().map(|vantage| judge.picture(trial, vantage)).collect();
        judge
    }

    fn frame<'t>(&'t self, trial: &'t Trial, vantage: &Vantage) -> Frame<'t> {
        Frame::new(trial.document.scene(), &trial.derived, self.atlas, &vantage.sight)
    }

    /// There is one, since what ships draws on the CPU.
    fn picture(&self, trial: &Trial, vantage: &Vantage) -> Option<Picture> {
        draw::picture(&self.frame(trial, vantage), self.watch)
    }

    /// All sprites, those first that are missed least in the view that misses them most.
    pub(super) fn ranked(&self, trial: &Trial) -> Vec<Key> {
        let in_view = |vantage: &Vantage| {
            let frame = self.frame(trial, vantage);
            let mut of_key: FxHashMap<Key, f32> = FxHashMap::default();
            for (drawn, loss) in frame.list.sprites.iter().zip(losses(&frame)) {
                let cloud = &frame.clouds[drawn.cloud as usize];
                let sprite = &cloud.sprites[drawn.sprite as usize];
                *of_key.entry((trial.models[&cloud.id], id_of(sprite))).or_default() += loss;
            }
            of_key
        };
        let most = |mut a: FxHashMap<Key, f32>, b: FxHashMap<Key, f32>| {
            for (key, loss) in b {
                let most = a.entry(key).or_default();
                *most = most.max(loss);
            }
            a
        };
        let unseen = || {
            trial
                .derived
                .clouds()
                .iter()
                .flat_map(|cloud| cloud.sprites.iter().map(|sprite| ((trial.models[&cloud.id], id_of(sprite)), 0.0)))
                .collect()
        };
        let losses = most(unseen(), self.vantages.par_iter().map(in_view).reduce(FxHashMap::default, most));
        let outermost = trial.outermost();
        let mut ranked: Vec<_> = losses.into_iter().filter(|(key, _)| !outermost.contains(key)).collect();
        ranked.sort_by(|(a, loss), (b, other)| loss.total_cmp(other).then(a.cmp(b)));
        ranked.into_iter().map(|(key, _)| key).collect()
    }

    /// The largest error of any view and which that is; none as soon as one exceeds the tolerance.
    pub(super) fn worst(&self, trial: &Trial) -> Option<(f64, usize)> {
        let error = |(index, vantage): (usize, &Vantage)| {
            let (was, is) = (self.pictures[index].as_ref()?, self.picture(trial, vantage)?);
            let error = flip(was, &is, PIXELS_PER_DEGREE).ok()?.mean();
            (error <= self.tolerance && !self.watch.is_cancelled()).then_some((error, index))
        };
        let larger = |a: (f64, usize), b: (f64, usize)| if (b.0, a.1) > (a.0, b.1) { b } else { a };
        self.vantages.par_iter().enumerate().map(error).try_reduce(|| (0.0, 0), |a, b| Some(larger(a, b)))
    }
}
