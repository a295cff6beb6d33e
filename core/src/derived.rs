//! The caches between the phases: what was computed from the scene, and what a [`Change`] makes stale.
//!
//! A change says where to look; what it touched is compared with what was computed from, and only what differs is
//! computed again. That is written down first, in a [`Plan`], so that whoever asks can see how much there is to do.
//! Populated models are shared by their placements, and states of the caches share what is equal in them, so one is
//! copied for the price of a list. [`Derived::work_done`] counts, so that tests can prove it.

mod plan;

pub use plan::Plan;

use crate::change::Change;
use crate::scene::{Cloud, CloudId, CloudModel, ModelId, Scene};
use crate::sprites::{Bake, PlacedCloud, PopulatedModel, Shapes};
use crate::version::Version;
use crate::watch::Watch;
use crate::weather::{CloudNow, KeptShadows, Timeline, WeatherRules, clouds_now};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Everything that the camera clock needs from the scene's clouds.
#[derive(Debug, Clone)]
pub struct Derived {
    clouds: Vec<PlacedCloud>,
    /// What each of the clouds was placed from.
    sources: Vec<Source>,
    /// Where each cloud stands in the list.
    index: Arc<FxHashMap<CloudId, usize>>,
    version: Version,
    shapes: Shapes,
    timeline: Arc<Timeline>,
    populated: FxHashMap<Key, Populated>,
    work: WorkDone,
    /// Whether a frame bakes the light that it lacks.
    bakes_on_demand: bool,
    shadows: KeptShadows,
}

/// A model under a seed: what sprites are strewn from.
type Key = (ModelId, u64);

/// A model with its sprites under one seed.
#[derive(Debug, Clone)]
struct Populated {
    model: Arc<CloudModel>,
    sprites: Arc<PopulatedModel>,
    /// The light that is baked of it, if the model is lit so.
    bake: Option<Bake>,
}

/// All that a placed cloud comes from.
#[derive(Debug, Clone)]
struct Source {
    cloud: Arc<Cloud>,
    ground_altitude_m: Option<f64>,
    populated: Populated,
}

/// How often something was computed since the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct WorkDone {
    /// Models strewn and culled.
    pub models_populated: u64,
    /// Clouds placed.
    pub clouds_placed: u64,
    /// Clouds that kept their sprites and were given another place, light, colour levels, name or formation.
    pub clouds_dressed: u64,
}

impl Default for Derived {
    /// Of a scene without clouds.
    fn default() -> Self {
        Self {
            clouds: Vec::new(),
            sources: Vec::new(),
            index: Arc::default(),
            version: Version::fresh(),
            shapes: Shapes::of(&[]),
            timeline: Arc::default(),
            populated: FxHashMap::default(),
            work: WorkDone::default(),
            bakes_on_demand: false,
            shadows: KeptShadows::default(),
        }
    }
}

impl Derived {
    /// Computes everything.
    pub fn new(scene: &Scene) -> Self {
        let mut derived = Self::default();
        derived.update(scene, &Change::everything());
        derived
    }

    /// The clouds, in the scene's order. Those of hidden folders are left out, and so are those whose model is missing.
    pub fn clouds(&self) -> &[PlacedCloud] {
        &self.clouds
    }

    /// Where the cloud of that id stands in the list; none if it is not there.
    pub fn index_of(&self, id: CloudId) -> Option<usize> {
        self.index.get(&id).copied()
    }

    /// The cloud of that id.
    pub fn cloud(&self, id: CloudId) -> Option<&PlacedCloud> {
        self.clouds.get(self.index_of(id)?)
    }

    /// The sprites of a model under a seed, as strewn for its clouds; none if no cloud shows it so.
    pub fn populated(&self, model: ModelId, seed: u64) -> Option<&PopulatedModel> {
        self.populated.get(&(model, seed)).map(|populated| &*populated.sprites)
    }

    /// Tells this state of the clouds from every other.
    pub fn version(&self) -> Version {
        self.version
    }

    /// Of this state of the clouds, what a view's memory is about: the same through whatever leaves all sprites where
    /// they are.
    pub fn shapes(&self) -> &Shapes {
        &self.shapes
    }

    /// The clouds at `clock_s`, seconds of the scene's clock, in their order.
    pub fn clouds_at(&self, clock_s: f64, rules: WeatherRules) -> Vec<CloudNow<'_>> {
        clouds_now(&self.clouds, &self.timeline, clock_s, rules)
    }

    /// Whether any cloud forms or dissipates by terms of its own.
    pub fn forms(&self) -> bool {
        self.clouds.iter().any(|cloud| cloud.cloud.formation.is_some())
    }

    /// Whether anything but aircraft is not as it was when the clock was at another second.
    pub fn moves(&self) -> bool {
        self.forms() || self.timeline.moves()
    }

    /// What the clock makes of the scene.
    pub fn timeline(&self) -> &Arc<Timeline> {
        &self.timeline
    }

    /// Where frames keep the shadows of the clouds.
    pub(crate) fn shadows(&self) -> &KeptShadows {
        &self.shadows
    }

    /// What has been computed so far.
    pub fn work_done(&self) -> WorkDone {
        self.work
    }

    /// What there is to compute before this is `scene`'s, if no more than `change` has touched it since it was this.
    pub fn plan<'a>(&'a self, scene: &'a Scene, change: &Change) -> Plan<'a> {
        Plan::new(self, scene, change)
    }

    /// Whether light is still to be baked: until then clouds are lit by what is known of their sprites from before, or by
    /// their groups alone.
    pub fn is_unbaked(&self) -> bool {
        !self.bakes().all(Bake::is_done)
    }

    /// Bakes the light that is still to be baked, for this and all copies of it; false if `watch` is cancelled before.
    pub fn bake(&self, watch: &Watch) -> bool {
        self.bakes().all(|bake| bake.finish(watch))
    }

    /// The same before a frame, unless someone else sees to it.
    pub(crate) fn bake_on_demand(&self) {
        if self.bakes_on_demand {
            self.bake(&Watch::default());
        }
    }

    fn bakes(&self) -> impl Iterator<Item = &Bake> {
        self.populated.values().filter_map(|populated| populated.bake.as_ref())
    }

    /// The cloud of that index with none beside it, as if the scene had no other.
    #[must_use]
    pub(crate) fn alone(&self, cloud: usize) -> Self {
        let (clouds, sources) = (vec![self.clouds[cloud].clone()], vec![self.sources[cloud].clone()]);
        Self { clouds, sources, timeline: Arc::clone(&self.timeline), ..Self::default() }
    }

    /// Recomputes what `change` touched in `scene`, which is the scene after the change.
    pub fn update(&mut self, scene: &Scene, change: &Change) {
        if change.touches_derived()
            && let Some(updated) = self.plan(scene, change).carry_out(&Watch::default())
        {
            *self = updated;
        }
    }
}
