//! The scene with some sprites less, one undoable step after the other.

use super::Key;
use crate::arrange::sprites::{SpriteId, dropped};
use crate::derived::Derived;
use crate::document::{Document, Edit, ListEdit};
use crate::scene::{CloudId, ModelId, Scene};
use crate::sprites::{PlacedCloud, Sprite};
use rustc_hash::{FxHashMap, FxHashSet};

/// The scene with some sprites less.
pub(super) struct Trial {
    pub(super) document: Document,
    pub(super) derived: Derived,
    pub(super) models: FxHashMap<CloudId, ModelId>,
    /// What each cloud showed at first; what else appears was hidden by what is gone.
    at_first: FxHashMap<CloudId, FxHashSet<SpriteId>>,
    /// What any cloud of a model showed at first.
    wanted: FxHashSet<Key>,
    pub(super) keys_at_first: usize,
}

impl Trial {
    /// With every cloud whole, whatever the clock says.
    pub(super) fn new(scene: &Scene) -> Self {
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

    /// One step of the document.
    pub(super) fn drop_sprites(&mut self, keys: &[Key]) {
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

    pub(super) fn take_back(&mut self) {
        if let Some(change) = self.document.undo() {
            self.derived.update(self.document.scene(), &change);
        }
    }

    /// What leads from `scene` to this.
    pub(super) fn edits(&self, scene: &Scene) -> Vec<Edit> {
        let thinned = self.document.scene();
        let pairs = scene.models.iter().zip(&thinned.models);
        let boxes = pairs.flat_map(|(old, new)| old.boxes.iter().zip(&new.boxes).map(|boxes| (old.id, boxes)));
        let changed = boxes.filter(|(_, (old, new))| old != new);
        changed.map(|(model, (_, new))| Edit::Box(model, ListEdit::Replace(new.clone()))).collect()
    }
}

/// Within its model.
pub(super) fn id_of(sprite: &Sprite) -> SpriteId {
    (sprite.box_id, sprite.index)
}
