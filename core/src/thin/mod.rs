//! Model no more than a scene needs: sprites that nobody would miss are dropped.
//!
//! A scene is looked at from its cameras, along its paths and from around each cloud, that one alone (`vantages.rs`), by the light of its
//! hour and with every cloud whole. Sprites are sorted by the most that they add to any of these pictures (`losses.rs`),
//! and as many of the least are dropped as leave each picture's mean FLIP against the scene as it was within the
//! tolerance. Then what is left is weighed again, for what stood behind the dropped ones shows now. Where even a few can't
//! be spared although they show little (they moved the light of others, say), they stay, and the next ones are tried.
//!
//! Dropped sprites are edits of their boxes, as if by hand; a candidate that the cull had left out in favour of one
//! that is gone is dropped too. Clouds of one model share their boxes, and so what is dropped.

mod losses;
mod vantages;

use crate::arrange::sprites::{SpriteId, dropped};
use crate::derived::Derived;
use crate::document::{Document, Edit, ListEdit};
use crate::frame::{Frame, Sight};
use crate::image::Picture;
use crate::measure::{PIXELS_PER_DEGREE, flip};
use crate::model_in_view::Meshes;
use crate::raster::fast;
use crate::scene::{CloudId, ModelId, Scene};
use crate::sprites::{Atlas, PlacedCloud, Sprite};
use crate::view_history::ViewHistory;
use crate::watch::Watch;
use losses::losses;
use rayon::prelude::*;
use rustc_hash::{FxHashMap, FxHashSet};
use vantages::{Vantage, vantages};

/// Width and height of the pictures that are compared.
const SIZE: [u32; 2] = [240, 135];
/// Of the sprites, the smallest share that is worth another try.
const FINEST: usize = 128;
/// So many such shares may turn out to be missed before it ends.
const MISSED: usize = 16;

/// What a scene can do without.
#[derive(Debug, Clone, PartialEq)]
pub struct Thinned {
    /// Drop the sprites; one transaction.
    pub edits: Vec<Edit>,
    /// Sprites drawn, over all clouds, before.
    pub before: u64,
    /// And after.
    pub after: u64,
    /// The largest mean FLIP of any view.
    pub error: f64,
    /// Which view that is.
    pub worst_view: String,
    /// How many views there are.
    pub views: usize,
}

/// Why a scene is not thinned.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ThinError {
    /// Not above 0 and at most 1.
    #[error("a tolerance is a mean FLIP above 0 and at most 1, not {0}")]
    Tolerance(f64),
    /// Nothing to drop.
    #[error("the scene has no sprites")]
    NoSprites,
    /// The first step is too much already.
    #[error("without even the {sprites} sprites that show least, a view is further off than {tolerance}")]
    CannotHold {
        /// How many were tried.
        sprites: usize,
        /// As asked for.
        tolerance: f64,
    },
    /// The watch was cancelled.
    #[error("cancelled")]
    Cancelled,
}

/// A sprite of a model, in whichever clouds show it.
type Key = (ModelId, SpriteId);

/// Finds what `scene`, drawn with `atlas`, can do without: no view's mean FLIP exceeds `tolerance`.
///
/// # Errors
/// If the tolerance is none, there are no sprites, nothing can be dropped within it, or `watch` was cancelled.
pub fn thin(scene: &Scene, atlas: &Atlas, tolerance: f64, watch: &Watch) -> Result<Thinned, ThinError> {
    if !(tolerance > 0.0 && tolerance <= 1.0) {
        return Err(ThinError::Tolerance(tolerance));
    }
    let mut trial = Trial::new(scene);
    let before = trial.sprite_count();
    if before == 0 {
        return Err(ThinError::NoSprites);
    }
    let judge = Judge::new(&trial, atlas, tolerance, watch);
    let finest = (trial.keys_at_first / FINEST).max(1);
    let (mut held, mut step, mut missed) = (None, usize::MAX, FxHashSet::default());
    let mut ranked = Vec::new();
    while missed.len() < MISSED * finest && !watch.is_cancelled() {
        if ranked.len() < step {
            ranked = judge.ranked(&trial);
            ranked.retain(|key| !missed.contains(key));
            step = step.min(ranked.len() / 2);
        }
        if step < finest {
            break;
        }
        watch.reach(progress(step, missed.len(), trial.keys_at_first));
        trial.drop_sprites(&ranked[..step]);
        match judge.worst(&trial) {
            Some(worst) => (held, ranked) = (Some(worst), Vec::new()),
            None => {
                trial.take_back();
                if step == finest {
                    // Some of them matter more than was guessed. Others may not.
                    missed.extend(ranked.drain(..step));
                }
                step = (step / 2).max(finest);
            }
        }
    }
    match held {
        _ if watch.is_cancelled() => Err(ThinError::Cancelled),
        None => Err(ThinError::CannotHold { sprites: finest, tolerance }),
        Some((error, view)) => Ok(Thinned {
            edits: trial.edits(scene),
            before,
            after: trial.sprite_count(),
            error,
            worst_view: judge.vantages[view].name.clone(),
            views: judge.vantages.len(),
        }),
    }
}

fn id_of(sprite: &Sprite) -> SpriteId {
    (sprite.box_id, sprite.index)
}

/// Steps halve from half of all sprites to the finest: so many times of how many; that is half of the way. The other
/// half are the sprites that turn out to be missed.
fn progress(step: usize, missed: usize, all: usize) -> f32 {
    let halvings = |times: usize| (times.max(1) as f32).log2();
    let halved = 1.0 - halvings(step * FINEST / all.max(1)) / halvings(FINEST);
    0.5 * halved.clamp(0.0, 1.0) + 0.5 * (missed * FINEST) as f32 / (all.max(1) * MISSED) as f32
}

/// The scene with some sprites less.
struct Trial {
    document: Document,
    derived: Derived,
    models: FxHashMap<CloudId, ModelId>,
    /// What each cloud showed at first; what else appears was hidden by what is gone.
    at_first: FxHashMap<CloudId, FxHashSet<SpriteId>>,
    /// What any cloud of a model showed at first.
    wanted: FxHashSet<Key>,
    keys_at_first: usize,
}

impl Trial {
    /// With every cloud whole, whatever the clock says.
    fn new(scene: &Scene) -> Self {
        let mut scene = scene.clone();
        scene.clouds.iter_mut().for_each(|cloud| cloud.formation = None);
        let derived = Derived::new(&scene);
        let models: FxHashMap<_, _> = scene.clouds.iter().map(|cloud| (cloud.id, cloud.model)).collect();
        let shown = |cloud: &PlacedCloud| cloud.sprites.iter().map(id_of).collect();
        let at_first: FxHashMap<CloudId, FxHashSet<SpriteId>> =
            derived.clouds().iter().map(|cloud| (cloud.id, shown(cloud))).collect();
        let of_models = at_first.iter().flat_map(|(cloud, shown)| shown.iter().map(|&sprite| (models[cloud], sprite)));
        let wanted: FxHashSet<Key> = of_models.collect();
        let keys_at_first = wanted.len();
        Self { document: Document::new(scene), derived, models, at_first, wanted, keys_at_first }
    }

    /// Sprites that say where a cloud ends: without them, the light on all others would change.
    fn outermost(&self) -> FxHashSet<Key> {
        let outwards: [fn(&Sprite) -> f32; 8] = [
            |sprite| sprite.position.x,
            |sprite| -sprite.position.x,
            |sprite| sprite.position.y,
            |sprite| -sprite.position.y,
            |sprite| sprite.position.z,
            |sprite| -sprite.position.z,
            |sprite| sprite.position.y + sprite.radius(),
            |sprite| -sprite.position.y + sprite.radius(),
        ];
        let of_cloud = |cloud: &PlacedCloud| -> Vec<Key> {
            let model = self.models[&cloud.id];
            let farthest = |out: &fn(&Sprite) -> f32| cloud.sprites.iter().max_by(|a, b| out(a).total_cmp(&out(b)));
            outwards.iter().filter_map(farthest).map(|sprite| (model, id_of(sprite))).collect()
        };
        self.derived.clouds().iter().flat_map(of_cloud).collect()
    }

    fn sprite_count(&self) -> u64 {
        self.derived.clouds().iter().map(|cloud| cloud.sprites.len() as u64).sum()
    }

    /// One step of the document.
    fn drop_sprites(&mut self, keys: &[Key]) {
        self.document.begin("Thin");
        let mut keys = keys.to_vec();
        while !keys.is_empty() {
            self.apply(&keys);
            keys = self.come_up();
        }
        // Edits of boxes that are there don't fail.
        let _ = self.document.commit();
    }

    fn apply(&mut self, keys: &[Key]) {
        let mut of_model: FxHashMap<ModelId, Vec<SpriteId>> = FxHashMap::default();
        for &(model, sprite) in keys {
            of_model.entry(model).or_default().push(sprite);
        }
        let scene = self.document.scene();
        let edits: Vec<_> =
            of_model.iter().flat_map(|(model, sprites)| dropped(scene, *model, sprites).edits).collect();
        for edit in edits {
            if let Ok(change) = self.document.apply(edit) {
                self.derived.update(self.document.scene(), &change);
            }
        }
    }

    /// Sprites that no cloud showed at first.
    fn come_up(&self) -> Vec<Key> {
        let mut new = FxHashSet::default();
        for cloud in self.derived.clouds() {
            let (model, at_first) = (self.models[&cloud.id], &self.at_first[&cloud.id]);
            let others = cloud.sprites.iter().map(id_of).filter(|sprite| !at_first.contains(sprite));
            new.extend(others.map(|sprite| (model, sprite)).filter(|key| !self.wanted.contains(key)));
        }
        new.into_iter().collect()
    }

    fn take_back(&mut self) {
        if let Some(change) = self.document.undo() {
            self.derived.update(self.document.scene(), &change);
        }
    }

    /// What leads from `scene` to this.
    fn edits(&self, scene: &Scene) -> Vec<Edit> {
        let thinned = self.document.scene();
        let pairs = scene.models.iter().zip(&thinned.models);
        let boxes = pairs.flat_map(|(old, new)| old.boxes.iter().zip(&new.boxes).map(|boxes| (old.id, boxes)));
        let changed = boxes.filter(|(_, (old, new))| old != new);
        changed.map(|(model, (_, new))| Edit::Box(model, ListEdit::Replace(new.clone()))).collect()
    }
}

/// The scene as it was, from everywhere.
struct Judge<'a> {
    atlas: &'a Atlas,
    vantages: Vec<Vantage>,
    pictures: Vec<Picture>,
    tolerance: f64,
    watch: &'a Watch,
}

impl<'a> Judge<'a> {
    fn new(trial: &Trial, atlas: &'a Atlas, tolerance: f64, watch: &'a Watch) -> Self {
        let vantages = vantages(trial.document.scene(), trial.derived.clouds());
        let mut judge = Self { atlas, vantages, pictures: Vec::new(), tolerance, watch };
        judge.pictures = judge.vantages.par_iter().map(|vantage| judge.picture(trial, vantage)).collect();
        judge
    }

    fn frame<'t>(&'t self, trial: &'t Trial, Vantage { camera, hidden, .. }: &Vantage) -> Frame<'t> {
        let scene = trial.document.scene();
        let (meshes, history) = (&Meshes::default(), &ViewHistory::default());
        let time_h = scene.time_of_day_h;
        let sight = Sight { camera, time_h, clock_s: 0.0, size: SIZE, hidden, meshes, history };
        Frame::of(scene, &trial.derived, self.atlas, &sight)
    }

    fn picture(&self, trial: &Trial, vantage: &Vantage) -> Picture {
        fast::picture(&self.frame(trial, vantage))
    }

    /// All sprites, those first that are missed least in the view that misses them most.
    fn ranked(&self, trial: &Trial) -> Vec<Key> {
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
    fn worst(&self, trial: &Trial) -> Option<(f64, usize)> {
        let error = |(index, vantage): (usize, &Vantage)| {
            let picture = self.picture(trial, vantage);
            let error = flip(&self.pictures[index], &picture, PIXELS_PER_DEGREE).ok()?.mean();
            (error <= self.tolerance && !self.watch.is_cancelled()).then_some((error, index))
        };
        let larger = |a: (f64, usize), b: (f64, usize)| if (b.0, a.1) > (a.0, b.1) { b } else { a };
        self.vantages.par_iter().enumerate().map(error).try_reduce(|| (0.0, 0), |a, b| Some(larger(a, b)))
    }
}
