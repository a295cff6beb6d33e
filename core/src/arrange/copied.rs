//! Which copies a duplication made, and their tracks: each property of a copy moves as the original's does.

use super::{Plan, at_end, keys};
use crate::document::Edit;
use crate::property::Owner;
use crate::scene::{CloudBox, CloudModel, HasId, KeyValue, List, ModelId, Scene, ShadingGroup, Thing, Track, TrackId};
use glam::DVec3;
use std::collections::BTreeMap;

/// Groups and boxes of a model.
type Parts<G, B> = (ModelId, G, B);

/// Originals and their copies.
#[derive(Debug, Default)]
pub(super) struct Copied {
    of: BTreeMap<Owner, Vec<Owner>>,
}

impl Copied {
    /// `new` is a copy of `old`.
    pub(super) fn thing(&mut self, old: Thing, new: Thing) {
        self.owner(Owner::Thing(old), Owner::Thing(new));
    }

    /// `new` is a copy of `old` with all its parts, in the same order.
    pub(super) fn model(&mut self, old: &CloudModel, new: &CloudModel) {
        self.thing(Thing::Model(old.id), Thing::Model(new.id));
        self.levels(old.id, new);
        self.parts((old.id, &old.groups, &old.boxes), (new.id, &new.groups, &new.boxes));
    }

    /// `new` has the colour levels of `old`.
    pub(super) fn levels(&mut self, old: ModelId, new: &CloudModel) {
        for level in 0..new.color_levels.len() {
            self.owner(Owner::Level(old, level), Owner::Level(new.id, level));
        }
    }

    /// Groups and boxes of one model have copies in another, in the same order.
    pub(super) fn parts<'a>(
        &mut self,
        (old, groups, boxes): Parts<impl IntoIterator<Item = &'a ShadingGroup>, impl IntoIterator<Item = &'a CloudBox>>,
        (new, new_groups, new_boxes): Parts<&List<ShadingGroup>, &List<CloudBox>>,
    ) {
        for (a, b) in groups.into_iter().zip(new_groups) {
            self.thing(Thing::Group(old, a.id()), Thing::Group(new, b.id()));
        }
        for (a, b) in boxes.into_iter().zip(new_boxes) {
            self.thing(Thing::Box(old, a.id()), Thing::Box(new, b.id()));
        }
    }

    fn owner(&mut self, old: Owner, new: Owner) {
        self.of.entry(old).or_default().push(new);
    }

    /// Copies of the originals' tracks. Clouds are `offset` metres away, and so is what their tracks say.
    pub(super) fn insert_tracks(&self, plan: &mut Plan<'_>, offset: DVec3) {
        self.insert_tracks_of(plan.scene, plan, offset);
    }

    /// The same of originals in the scene `from`.
    pub(super) fn insert_tracks_of(&self, from: &Scene, plan: &mut Plan<'_>, offset: DVec3) {
        let copies = |owner: Owner| self.of.get(&owner).cloned().unwrap_or_default();
        for (target, track) in keys::of_copies(from, copies) {
            let mut new = Track { id: TrackId::new(&mut plan.next_id), property: target.to_string(), ..track.clone() };
            if matches!(target.owner, Owner::Thing(Thing::Cloud(_))) && target.property.path == "position" {
                for key in &mut new.keys {
                    if let KeyValue::Three(place) = &mut key.value {
                        *place = (DVec3::from_array(*place) + offset).to_array();
                    }
                }
            }
            plan.edits.push(Edit::Track(at_end(new)));
        }
    }
}
