//! What is to be computed for a scene, told before it is done: which models to strew, which clouds to place, which
//! only take another place, light or name.

use super::{Derived, Key, Populated, Source};
use crate::change::Change;
use crate::scene::{Cloud, CloudBox, CloudModel, GroupId, GroupLight, ModelId, Scene};
use crate::sprites::{
    Bake, PLACING, PlacedCloud, PopulatedModel, STREWING, SoftLight, dress, place_watched, populate_watched,
    stand_alike,
};
use crate::version::Version;
use crate::watch::Watch;
use crate::weather::Timeline;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The way from one state of the caches to the next.
#[derive(Debug)]
pub struct Plan<'a> {
    before: &'a Derived,
    scene: &'a Scene,
    /// Whether what moves with the clock is to be made anew.
    retimes: bool,
    ground_altitude_m: Option<f64>,
    /// Models whose sprites stay.
    kept: FxHashMap<Key, Populated>,
    /// Models to strew, in order of their keys.
    fresh: Vec<(Key, Arc<CloudModel>)>,
    clouds: Vec<Step<'a>>,
    work: u64,
}

/// What becomes of a cloud.
#[derive(Debug)]
enum Step<'a> {
    /// The one of that position before, as it was.
    Keep(usize),
    /// The one of that position before with the same sprites, but another place, light, colours or name.
    Dress(usize, &'a Arc<Cloud>, Populated),
    Place(&'a Arc<Cloud>, Key),
}

impl<'a> Plan<'a> {
    /// Up to so many sprites to strew, what there is to do is little: some 15 ms on one core.
    pub const LITTLE: u64 = 10_000;

    pub(super) fn new(before: &'a Derived, scene: &'a Scene, change: &Change) -> Self {
        let models: FxHashMap<ModelId, &Arc<CloudModel>> =
            scene.models.as_slice().iter().map(|model| (model.id, model)).collect();
        let key_of = |cloud: &Cloud| -> Option<Key> {
            let model = models.get(&cloud.model)?;
            Some((model.id, cloud.seed.unwrap_or(model.seed)))
        };
        let ground_altitude_m = scene.ground.as_ref().map(|ground| ground.altitude_m);
        let mut plan = Self {
            before,
            scene,
            // Tracks of looks know their models.
            retimes: change.touches_weather() || (before.timeline.moves_looks() && change.touches_models()),
            ground_altitude_m,
            kept: FxHashMap::default(),
            fresh: Vec::new(),
            clouds: Vec::new(),
            work: 0,
        };
        // What is strewn already stays so for clouds that are hidden, to be shown again soon; nothing is strewn for them.
        let is_strewn = |key: &Key| before.populated.contains_key(key) && !change.touches_model(key.0);
        let key_wanted = |cloud: &Cloud| key_of(cloud).filter(|key| scene.is_seen(cloud) || is_strewn(key));
        let mut wanted: Vec<Key> = scene.clouds.iter().filter_map(key_wanted).collect();
        wanted.sort_unstable();
        wanted.dedup();
        plan.sort_out_models(&wanted, &models, change);
        for cloud in scene.clouds.as_slice().iter().filter(|cloud| scene.is_seen(cloud)) {
            let (old, key) = (before.index_of(cloud.id), key_of(cloud));
            let touched =
                change.touches_cloud(cloud.id) || change.touches_model(cloud.model) || change.touches_ground();
            match (old, key) {
                (Some(old), _) if !touched => plan.clouds.push(Step::Keep(old)),
                (old, Some(key)) => plan.sort_out_cloud(cloud, key, old),
                (_, None) => {}
            }
        }
        plan
    }

    /// Which models and seeds in use keep their sprites, and which are not what they were.
    fn sort_out_models(&mut self, wanted: &[Key], models: &FxHashMap<ModelId, &Arc<CloudModel>>, change: &Change) {
        for key in wanted {
            let Some(model) = models.get(&key.0) else { continue };
            match self.before.populated.get(key) {
                Some(kept) if !change.touches_model(key.0) => {
                    self.kept.insert(*key, kept.clone());
                }
                Some(old) if same_sprites(&old.model, model) => {
                    let kept = Populated::new(Arc::clone(model), Arc::clone(&old.sprites), Some(old));
                    self.kept.insert(*key, kept);
                }
                _ => {
                    self.work += STREWING * sprites_tried(model);
                    self.fresh.push((*key, Arc::clone(model)));
                }
            }
        }
    }

    fn sort_out_cloud(&mut self, cloud: &'a Arc<Cloud>, key: Key, old: Option<usize>) {
        let populated = self.kept.get(&key);
        if let (Some(old), Some(populated)) = (old, populated)
            && self.keeps_sprites(old, cloud, populated)
        {
            let (placed, source) = (&self.before.clouds[old], &self.before.sources[old]);
            let as_it_was = source.cloud == *cloud
                && placed.color_levels == populated.model.color_levels
                && same_light(&source.populated.model, &populated.model)
                && placed.soft_light == SoftLight::of(&populated.model);
            let step = if as_it_was { Step::Keep(old) } else { Step::Dress(old, cloud, populated.clone()) };
            return self.clouds.push(step);
        }
        let fresh = self.fresh.binary_search_by_key(&key, |(each, _)| *each);
        let of_fresh = || fresh.map_or(0, |at| sprites_tried(&self.fresh[at].1));
        self.work += PLACING * populated.map_or_else(of_fresh, |populated| populated.sprites.sprites.len() as u64);
        self.clouds.push(Step::Place(cloud, key));
    }

    /// Whether the cloud that was at `old` has the sprites, in the groups, that `cloud` is to have.
    fn keeps_sprites(&self, old: usize, cloud: &Cloud, populated: &Populated) -> bool {
        let (placed, source) = (&self.before.clouds[old], &self.before.sources[old]);
        let Source { cloud: stood, ground_altitude_m, populated: had } = source;
        Arc::ptr_eq(&had.sprites, &populated.sprites)
            && same_groups(&had.model, &populated.model)
            && (stood.heading_deg, stood.scale) == (cloud.heading_deg, cloud.scale)
            && stand_alike(placed, (stood, *ground_altitude_m), (cloud, self.ground_altitude_m))
    }

    /// How much there is to do, as that many sprites to strew.
    pub fn sprites(&self) -> u64 {
        self.work / STREWING
    }

    /// Whether it is done sooner than handed to another thread and waited for.
    pub fn is_little(&self) -> bool {
        self.sprites() <= Self::LITTLE
    }

    /// Computes it; its light is baked by the first frame that shows it. None if `watch` was cancelled meanwhile.
    pub fn carry_out(self, watch: &Watch) -> Option<Derived> {
        Some(Derived { bakes_on_demand: true, ..self.place(watch)? })
    }

    /// The same for those who see to the light themselves ([`Derived::bake`]) and show clouds before.
    pub fn place(self, watch: &Watch) -> Option<Derived> {
        watch.expect(self.work);
        // The pool may be busy with a picture, and a frame of the window must not wait for that.
        let in_parallel = !self.is_little();
        let Self { before, scene, retimes, ground_altitude_m, mut kept, fresh, clouds, .. } = self;
        let mut work = before.work;
        work.models_populated += fresh.len() as u64;
        let fresh = map_all(fresh, in_parallel, |((id, seed), model)| {
            let sprites = Arc::new(populate_watched(&model, seed, watch));
            ((id, seed), Populated::new(model, sprites, before.populated.get(&(id, seed))))
        });
        kept.extend(fresh);
        let count = |wanted: fn(&Step<'_>) -> bool| clouds.iter().filter(|step| wanted(step)).count() as u64;
        let (placed, dressed) =
            (count(|step| matches!(step, Step::Place(..))), count(|step| matches!(step, Step::Dress(..))));
        work.clouds_placed += placed;
        work.clouds_dressed += dressed;
        let same_order = clouds.len() == before.clouds.len()
            && clouds.iter().enumerate().all(|(at, step)| matches!(step, Step::Keep(old) if *old == at));
        let clouds = map_all(clouds, in_parallel, |step| match step {
            Step::Keep(old) => Some((before.clouds[old].clone(), before.sources[old].clone())),
            Step::Dress(old, cloud, populated) => {
                let had = &before.sources[old];
                let keeps = [had.cloud.position == cloud.position, same_light(&had.populated.model, &populated.model)];
                let model = (&*populated.model, &*populated.sprites);
                let dressed =
                    PlacedCloud { bake: populated.bake.clone(), ..dress(&before.clouds[old], cloud, model, keeps) };
                Some((dressed, Source { cloud: Arc::clone(cloud), ground_altitude_m, populated }))
            }
            Step::Place(cloud, key) => {
                let populated = kept.get(&key)?.clone();
                let model = (&*populated.model, &*populated.sprites);
                let placed = PlacedCloud {
                    bake: populated.bake.clone(),
                    ..place_watched(cloud, model.0, model.1, ground_altitude_m, watch)
                };
                Some((placed, Source { cloud: Arc::clone(cloud), ground_altitude_m, populated }))
            }
        });
        if watch.is_cancelled() {
            return None;
        }
        let version = if same_order { before.version } else { Version::fresh() };
        let (clouds, sources): (Vec<PlacedCloud>, _) = clouds.into_iter().flatten().unzip();
        let shapes = if same_order { before.shapes.clone() } else { before.shapes.or_of(&clouds) };
        let same_ids = clouds.iter().map(|cloud| cloud.id).eq(before.clouds.iter().map(|cloud| cloud.id));
        let index_of = |(index, cloud): (usize, &PlacedCloud)| (cloud.id, index);
        let index = if same_ids {
            Arc::clone(&before.index)
        } else {
            Arc::new(clouds.iter().enumerate().map(index_of).collect())
        };
        let timeline = if retimes { Arc::new(Timeline::new(scene)) } else { Arc::clone(&before.timeline) };
        let bakes_on_demand = false;
        let shadows = before.shadows.clone();
        let populated = kept;
        Some(Derived { index, shapes, timeline, clouds, sources, version, populated, work, bakes_on_demand, shadows })
    }
}

impl Populated {
    /// With the light that was baked of it `before`, if its sprites and their opacities are still the same.
    fn new(model: Arc<CloudModel>, sprites: Arc<PopulatedModel>, before: Option<&Self>) -> Self {
        let before = before.and_then(|before| before.bake.as_ref());
        let levels = &model.color_levels;
        let bake =
            (!SoftLight::of(&model).is_none()).then(|| match before.filter(|bake| bake.is_of(&sprites, levels)) {
                Some(bake) => bake.clone(),
                None => Bake::new(Arc::clone(&sprites), *levels, before),
            });
        Self { model, sprites, bake }
    }
}

fn map_all<T: Send, R: Send>(items: Vec<T>, in_parallel: bool, f: impl Fn(T) -> R + Send + Sync) -> Vec<R> {
    if in_parallel { items.into_par_iter().map(f).collect() } else { items.into_iter().map(f).collect() }
}

fn sprites_tried(model: &CloudModel) -> u64 {
    model.boxes.iter().map(|each| u64::from(each.sprite_count)).sum()
}

/// Whether two states of a model strew the same sprites, whatever their colours, light and names.
fn same_sprites(a: &CloudModel, b: &CloudModel) -> bool {
    (a.boxes == b.boxes || same_boxes(a, b)) && a.cull_radius == b.cull_radius && a.category == b.category
}

fn same_boxes(a: &CloudModel, b: &CloudModel) -> bool {
    a.boxes.len() == b.boxes.len() && a.boxes.iter().zip(&b.boxes).all(|(a, b)| same_box(a, b))
}

fn same_box(a: &CloudBox, b: &CloudBox) -> bool {
    // By its fields, so that a new one can't be forgotten.
    let CloudBox {
        id,
        name: _,
        center,
        size,
        orientation,
        sprite_count,
        width,
        height,
        rotation_deg,
        category,
        group,
        light: _,
        lumps,
        key,
        seed,
        sprite_edits,
    } = a;
    *id == b.id
        && *center == b.center
        && *size == b.size
        && *orientation == b.orientation
        && *sprite_count == b.sprite_count
        && *width == b.width
        && *height == b.height
        && *rotation_deg == b.rotation_deg
        && *category == b.category
        && *group == b.group
        && *lumps == b.lumps
        && *key == b.key
        && *seed == b.seed
        && *sprite_edits == b.sprite_edits
}

/// Whether two states of a model with the same sprites have them in the same groups: what is said to be in a group that
/// the model lacks is in its box's own.
fn same_groups(a: &CloudModel, b: &CloudModel) -> bool {
    let ids = |model: &CloudModel| model.groups.iter().map(|group| group.id).collect::<BTreeSet<GroupId>>();
    a.groups == b.groups || ids(a) == ids(b)
}

/// Whether two states of a model with the same sprites in the same groups light those alike.
fn same_light(a: &CloudModel, b: &CloudModel) -> bool {
    let groups = |model: &CloudModel| -> BTreeMap<GroupId, GroupLight> {
        model.groups.iter().map(|group| (group.id, group.light)).collect()
    };
    let boxes_alike =
        a.boxes == b.boxes || a.boxes.iter().map(|each| each.light).eq(b.boxes.iter().map(|each| each.light));
    boxes_alike && (a.groups == b.groups || groups(a) == groups(b))
}
