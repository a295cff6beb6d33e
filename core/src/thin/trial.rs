//! The scene with some sprites less, one step after the other; the last step can be taken back.

use super::Key;
use crate::arrange::sprites::{SpriteId, drop_from};
use crate::derived::Derived;
use crate::document::{Change, Edit, ListEdit};
use crate::scene::{CloudId, ModelId, Scene, Weather};
use crate::sprites::{PlacedCloud, Sprite};
use crate::watch::Watch;
use rustc_hash::{FxHashMap, FxHashSet};

/// Takes out all that the clock, or the air, does to clouds.
fn at_rest(scene: &mut Scene) {
    scene.tracks.clear();
    scene.weather = Weather::default();
    for cloud in scene.clouds.iter_mut() {
        (cloud.formation, cloud.formed) = (None, None);
        (cloud.opacity, cloud.growth) = (1.0, 1.0);
    }
}

/// The scene with some sprites less.
pub(super) struct Trial<'a> {
    pub(super) scene: Scene,
    pub(super) derived: Derived,
    pub(super) models: FxHashMap<CloudId, ModelId>,
    /// Before the last step.
    before: Option<(Scene, Derived)>,
    /// What clouds show at first, by model and seed; what else appears was hidden by what is gone.
    at_first: FxHashMap<(ModelId, u64), FxHashSet<SpriteId>>,
    /// What any cloud of a model showed at first.
    pub(super) wanted: FxHashSet<Key>,
    watch: &'a Watch,
}

impl<'a> Trial<'a> {
    /// With every cloud whole and at rest, whatever the clock says. None if `watch` was cancelled.
    pub(super) fn new(scene: &Scene, watch: &'a Watch) -> Option<Self> {
        let mut scene = scene.clone();
        at_rest(&mut scene);
        let nothing = Derived::default();
        let derived = nothing.plan(&scene, &Change::everything()).carry_out(&watch.part())?;
        // What is dropped later leaves the others' light as it was.
        derived.bake(&watch.part()).then_some(())?;
        let models: FxHashMap<_, _> = scene.clouds.iter().map(|cloud| (cloud.id, cloud.model)).collect();
        let seeds = scene.models_by_id();
        let seed_of =
            |cloud: &crate::scene::Cloud| Some((cloud.model, cloud.seed.or(Some(seeds.get(&cloud.model)?.seed))?));
        let mut at_first = FxHashMap::default();
        for key in scene.clouds.iter().filter_map(seed_of) {
            at_first.entry(key).or_insert_with(|| shown(&derived, key).collect::<FxHashSet<_>>());
        }
        let of_models = at_first.iter().flat_map(|((model, _), shown)| shown.iter().map(|&sprite| (*model, sprite)));
        let wanted = of_models.collect();
        Some(Self { scene, derived, models, before: None, at_first, wanted, watch })
    }

    /// Sprites that say where a cloud ends: without them, the light on all others would change.
    pub(super) fn outermost(&self) -> FxHashSet<Key> {
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

    pub(super) fn sprite_count(&self) -> u64 {
        self.derived.clouds().iter().map(|cloud| cloud.sprites.len() as u64).sum()
    }

    /// The sprites that are left, each once for all clouds of its model.
    pub(super) fn keys(&self) -> impl Iterator<Item = Key> {
        self.at_first.keys().flat_map(|&key| shown(&self.derived, key).map(move |sprite| (key.0, sprite)))
    }

    /// One step. Less may be dropped if the watch is cancelled.
    pub(super) fn drop_sprites(&mut self, keys: &[Key]) {
        self.before = Some((self.scene.clone(), self.derived.clone()));
        let mut keys = keys.to_vec();
        while !keys.is_empty() && !self.watch.is_cancelled() {
            self.apply(&keys);
            keys = self.come_up();
        }
    }

    fn apply(&mut self, keys: &[Key]) {
        let mut of_model: FxHashMap<ModelId, Vec<SpriteId>> = FxHashMap::default();
        for &(model, sprite) in keys {
            of_model.entry(model).or_default().push(sprite);
        }
        for at in 0..self.scene.models.len() {
            if let Some(sprites) = of_model.get(&self.scene.models[at].id) {
                drop_from(&mut self.scene.models[at], sprites);
            }
        }
        let change = Change::of_models(of_model.into_keys());
        if let Some(derived) = self.derived.plan(&self.scene, &change).place(&self.watch.part()) {
            self.derived = derived;
        }
    }

    /// Sprites that no cloud showed at first.
    fn come_up(&self) -> Vec<Key> {
        let mut new = FxHashSet::default();
        for (&key, at_first) in &self.at_first {
            let others = shown(&self.derived, key).filter(|sprite| !at_first.contains(sprite));
            new.extend(others.map(|sprite| (key.0, sprite)).filter(|key| !self.wanted.contains(key)));
        }
        new.into_iter().collect()
    }

    /// Undoes the last step.
    pub(super) fn take_back(&mut self) {
        if let Some(before) = self.before.take() {
            (self.scene, self.derived) = before;
        }
    }

    /// What leads from `scene` to this.
    pub(super) fn edits(&self, scene: &Scene) -> Vec<Edit> {
        let pairs = scene.models.iter().zip(&self.scene.models);
        let boxes = pairs.flat_map(|(old, new)| old.boxes.iter().zip(&new.boxes).map(|boxes| (old.id, boxes)));
        let changed = boxes.filter(|(_, (old, new))| old != new);
        changed.map(|(model, (_, new))| Edit::Box(model, ListEdit::Replace(new.clone()))).collect()
    }
}

/// What the clouds of a model under a seed show.
fn shown(derived: &Derived, (model, seed): (ModelId, u64)) -> impl Iterator<Item = SpriteId> {
    let populated = derived.populated(model, seed);
    populated.into_iter().flat_map(|populated| &populated.sprites).map(|sprite| (sprite.box_id, sprite.index))
}

/// Within its model.
pub(super) fn id_of(sprite: &Sprite) -> SpriteId {
    (sprite.box_id, sprite.index)
}
