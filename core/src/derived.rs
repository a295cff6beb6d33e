//! The caches between the phases: what was computed from the scene, and what a [`Change`] makes stale.
//!
//! Populated models are shared by their placements; a change recomputes only the models and clouds it touched.
//! [`Derived::work_done`] counts, so that tests can prove it.

use crate::document::Change;
use crate::scene::{Cloud, CloudModel, ModelId, Scene};
use crate::sprites::{PlacedCloud, PopulatedModel, place, populate};
use crate::version::Version;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Everything that the camera clock needs from the scene's clouds.
#[derive(Debug, Clone)]
pub struct Derived {
    clouds: Vec<PlacedCloud>,
    version: Version,
    populated: FxHashMap<(ModelId, u64), (Arc<CloudModel>, Arc<PopulatedModel>)>,
    work: WorkDone,
}

/// How often something was computed since the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct WorkDone {
    /// Models strewn and culled.
    pub models_populated: u64,
    /// Clouds placed.
    pub clouds_placed: u64,
}

impl Derived {
    /// Computes everything.
    pub fn new(scene: &Scene) -> Self {
        let mut derived = Self {
            clouds: Vec::new(),
            version: Version::fresh(),
            populated: FxHashMap::default(),
            work: WorkDone::default(),
        };
        derived.update(scene, &Change::everything());
        derived
    }

    /// The clouds, in the scene's order; a cloud whose model is missing has no sprites to show and is left out.
    pub fn clouds(&self) -> &[PlacedCloud] {
        &self.clouds
    }

    /// Tells this state of the clouds from every other.
    pub fn version(&self) -> Version {
        self.version
    }

    /// What has been computed so far.
    pub fn work_done(&self) -> WorkDone {
        self.work
    }

    /// Recomputes what `change` touched in `scene`, which is the scene after the change.
    pub fn update(&mut self, scene: &Scene, change: &Change) {
        if !change.touches_sprites() {
            return;
        }
        let models: FxHashMap<ModelId, &CloudModel> = scene.models.iter().map(|model| (model.id, model)).collect();
        self.populate_stale(scene, &models, change);
        let ground = scene.ground.as_ref().map(|ground| ground.altitude_m);
        let count_before = self.clouds.len();
        let mut before: FxHashMap<_, _> =
            std::mem::take(&mut self.clouds).into_iter().map(|cloud| (cloud.id, cloud)).collect();
        let placed: Vec<(bool, PlacedCloud)> = scene
            .clouds
            .iter()
            .map(|cloud| (cloud, before.remove(&cloud.id)))
            .collect::<Vec<_>>()
            .into_par_iter()
            .filter_map(|(cloud, old)| {
                let stale =
                    change.touches_cloud(cloud.id) || change.touches_model(cloud.model) || change.touches_ground();
                if let (false, Some(old)) = (stale, old) {
                    return Some((false, old));
                }
                let (model, sprites) = self.populated.get(&(cloud.model, seed_of(&models, cloud)?))?;
                Some((true, place(cloud, model, sprites, ground)))
            })
            .collect();
        let new = placed.iter().filter(|(new, _)| *new).count();
        self.work.clouds_placed += new as u64;
        if new > 0 || placed.len() != count_before {
            self.version = Version::fresh();
        }
        self.clouds = placed.into_iter().map(|(_, cloud)| cloud).collect();
    }

    /// Populates the models and seeds in use whose boxes, culling, category or seed are not what they were.
    fn populate_stale(&mut self, scene: &Scene, models: &FxHashMap<ModelId, &CloudModel>, change: &Change) {
        let mut before = std::mem::take(&mut self.populated);
        let mut wanted: Vec<(ModelId, u64)> =
            scene.clouds.iter().filter_map(|cloud| Some((cloud.model, seed_of(models, cloud)?))).collect();
        wanted.sort_unstable();
        wanted.dedup();
        // One copy of a touched model for all its seeds.
        let mut copies: FxHashMap<ModelId, Arc<CloudModel>> = FxHashMap::default();
        let mut copy =
            |model: &CloudModel| Arc::clone(copies.entry(model.id).or_insert_with(|| Arc::new(model.clone())));
        let mut fresh = Vec::new();
        for key in wanted {
            let Some(model) = models.get(&key.0) else { continue };
            match before.remove(&key) {
                Some(kept) if !change.touches_model(key.0) => {
                    self.populated.insert(key, kept);
                }
                Some((old, sprites)) if same_sprites(&old, model) => {
                    self.populated.insert(key, (copy(model), sprites));
                }
                _ => fresh.push((key, copy(model))),
            }
        }
        self.work.models_populated += fresh.len() as u64;
        let populated: Vec<_> = fresh
            .into_par_iter()
            .map(|(key, model)| {
                let sprites = Arc::new(populate(&model, key.1));
                (key, (model, sprites))
            })
            .collect();
        self.populated.extend(populated);
    }
}

fn seed_of(models: &FxHashMap<ModelId, &CloudModel>, cloud: &Cloud) -> Option<u64> {
    Some(cloud.seed.unwrap_or(models.get(&cloud.model)?.seed))
}

/// Whether two states of a model give the same sprites, whatever their colours and groups' light.
fn same_sprites(a: &CloudModel, b: &CloudModel) -> bool {
    a.boxes == b.boxes && a.cull_radius == b.cull_radius && a.category == b.category
}
