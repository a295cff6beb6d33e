//! Copies beside the originals: clouds of the same model or of one of their own, boxes, cameras, paths, aircraft.
//!
//! A copy looks like its original ([`super`] says how). A copied box therefore repeats its original's sprites;
//! another `key` rolls it anew. Copies at the very place of their originals lose their sprites to the cull. Tracks are
//! copied with what they move.

use super::copied::Copied;
use super::copy::{copy_model, copy_parts};
use super::{Arrangement, Names, Plan, Thing, at_end, chosen};
use crate::document::{Edit, ListEdit};
use crate::scene::{BoxId, Cloud, CloudId, ForKind, InScene, Listed, ModelId, Scene, for_each_kind};
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// What a copied cloud is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Copy {
    /// The original's model: a change to it shows in both.
    Linked,
    /// A copy of the original's model. Copies of clouds that share a model share its copy.
    Own,
}

/// Copies of clouds, `offset` metres in the world away.
pub fn clouds(scene: &Scene, ids: &[CloudId], offset: DVec3, copy: Copy) -> Arrangement {
    let mut plan = Plan::new(scene);
    let mut names = Names::new(scene.clouds.iter().map(|cloud| cloud.name.as_str()));
    let mut model_names = model_names(scene);
    let mut own: BTreeMap<ModelId, ModelId> = BTreeMap::new();
    let mut copies = Copied::default();
    for old in chosen(&scene.clouds, ids) {
        let model = match (copy, scene.model(old.model)) {
            (Copy::Own, Some(model)) => *own.entry(old.model).or_insert_with(|| {
                let new = copy_model(model, model_names.free(&model.name), &mut plan.next_id);
                let id = new.id;
                copies.model(model, &new);
                plan.insert_model(new);
                id
            }),
            _ => old.model,
        };
        let id = CloudId::new(&mut plan.next_id);
        copies.thing(Thing::Cloud(old.id), Thing::Cloud(id));
        plan.insert_cloud(Cloud {
            id,
            name: names.free(&old.name),
            model,
            position: old.position + offset,
            ..old.clone()
        });
        plan.made.push(Thing::Cloud(id));
    }
    copies.insert_tracks(&mut plan, offset);
    plan.done()
}

/// Gives each cloud whose model others use too a copy of it. The clouds look as before.
pub fn make_own(scene: &Scene, ids: &[CloudId]) -> Arrangement {
    let mut plan = Plan::new(scene);
    let mut names = model_names(scene);
    let mut users: BTreeMap<ModelId, usize> = BTreeMap::new();
    let mut copies = Copied::default();
    for cloud in &scene.clouds {
        *users.entry(cloud.model).or_default() += 1;
    }
    for old in chosen(&scene.clouds, ids) {
        let (Some(model), Some(count)) = (scene.model(old.model), users.get_mut(&old.model)) else { continue };
        if *count < 2 {
            continue;
        }
        *count -= 1;
        let new = copy_model(model, names.free(&model.name), &mut plan.next_id);
        copies.model(model, &new);
        let cloud = Cloud { model: new.id, ..old.clone() };
        plan.insert_model(new);
        plan.edits.push(Edit::Cloud(ListEdit::Replace(cloud)));
        plan.made.push(Thing::Cloud(old.id));
    }
    copies.insert_tracks(&mut plan, DVec3::ZERO);
    plan.done()
}

/// Copies of a model's boxes within it, `offset` metres in its space away.
pub fn boxes(scene: &Scene, model: ModelId, ids: &[BoxId], offset: DVec3) -> Arrangement {
    let mut plan = Plan::new(scene);
    let Some(model) = scene.model(model) else { return plan.done() };
    let mut copied = Copied::default();
    for old in chosen(&model.boxes, ids) {
        let (_, copies) = copy_parts([], [old], &mut plan.next_id);
        for mut new in copies {
            new.center += offset;
            // Within one model, the groups stay.
            new.group = old.group;
            new.sprite_edits.clone_from(&old.sprite_edits);
            copied.thing(Thing::Box(model.id, old.id), Thing::Box(model.id, new.id));
            plan.made.push(Thing::Box(model.id, new.id));
            plan.edits.push(Edit::Box(model.id, at_end(new)));
        }
    }
    copied.insert_tracks(&mut plan, DVec3::ZERO);
    plan.done()
}

/// Copies of things that lie in lists of the scene by themselves: cameras, paths, aircraft, props. A copy that would hide its
/// original steps aside; aircraft on a copied path stay on the old one. Clouds and models are copied by [`clouds`].
pub fn things(scene: &Scene, things: &[Thing]) -> Arrangement {
    let chosen: BTreeSet<Thing> = things.iter().copied().collect();
    let mut copies = Copies { plan: Plan::new(scene), chosen, copied: Copied::default() };
    for_each_kind(&mut copies);
    copies.copied.insert_tracks(&mut copies.plan, DVec3::ZERO);
    copies.plan.done()
}

struct Copies<'a> {
    plan: Plan<'a>,
    chosen: BTreeSet<Thing>,
    copied: Copied,
}

impl ForKind for Copies<'_> {
    fn kind<T: Listed>(&mut self) {
        let Self { plan, chosen, copied } = self;
        let list = T::list(plan.scene);
        let mut names = Names::new(list.iter().map(InScene::name));
        let is_whole = |thing: &Thing| {
            !matches!(thing, Thing::Model(_) | Thing::Cloud(_) | Thing::Track(_)) && chosen.contains(thing)
        };
        for thing in list.iter().map(|value| T::thing(value.id())).filter(is_whole) {
            let Some((mut edit, copy)) = Edit::copying(plan.scene, thing, &mut plan.next_id) else { continue };
            if let Some(new) = edit.value_mut() {
                *new.name_mut() = names.free(new.name());
                new.step_aside();
            }
            plan.edits.push(edit);
            plan.made.push(copy);
            copied.thing(thing, copy);
        }
    }
}

pub(super) fn model_names(scene: &Scene) -> Names {
    Names::new(scene.models.iter().map(|model| model.name.as_str()))
}

#[cfg(test)]
mod tests {
    use super::super::test_scenes::{applied, assert_same_looks, placed, two_clouds};
    use super::*;
    use crate::problem::scene_with_flight;
    use crate::scene::{PathId, SpriteEdit};

    #[test]
    fn linked_copies_share_the_model() {
        let scene = two_clouds();
        let ids = [scene.clouds[0].id, CloudId(9999), scene.clouds[0].id];
        let arrangement = clouds(&scene, &ids, DVec3::X * 700.0, Copy::Linked);
        let after = applied(&scene, &arrangement);
        assert_eq!((after.clouds.len(), after.models.len()), (3, 2));
        let new = &after.clouds[2];
        assert_eq!(arrangement.made, [Thing::Cloud(new.id)]);
        assert_eq!((new.model, new.position), (scene.clouds[0].model, scene.clouds[0].position + DVec3::X * 700.0));
        assert_ne!(new.name, scene.clouds[0].name);
    }

    #[test]
    fn own_copies_look_the_same_and_go_their_own_way() {
        let mut scene = two_clouds();
        scene.models[0].boxes[1].sprite_edits = vec![SpriteEdit {
            moved: Some(DVec3::ONE),
            tile: Some(7),
            group: Some(scene.models[0].groups[0].id),
            ..SpriteEdit::new(3)
        }];
        let ids: Vec<_> = scene.clouds.iter().map(|cloud| cloud.id).collect();
        let arrangement = clouds(&scene, &ids, DVec3::ZERO, Copy::Own);
        let after = applied(&scene, &arrangement);
        assert_eq!((after.clouds.len(), after.models.len()), (4, 4));
        for (old, new) in [(0, 2), (1, 3)] {
            assert_ne!(after.clouds[old].model, after.clouds[new].model);
            assert_same_looks(&placed(&after, old), &placed(&after, new));
        }
        // A copy of the copy still does.
        let again = applied(&after, &clouds(&after, &[after.clouds[2].id], DVec3::ZERO, Copy::Own));
        assert_same_looks(&placed(&again, 0), &placed(&again, 4));
    }

    #[test]
    fn a_shared_model_is_made_own_and_looks_the_same() {
        let scene = two_clouds();
        let linked = applied(&scene, &clouds(&scene, &[scene.clouds[0].id], DVec3::X, Copy::Linked));
        let both = [linked.clouds[0].id, linked.clouds[2].id];
        let arrangement = make_own(&linked, &both);
        let after = applied(&linked, &arrangement);
        assert_eq!(after.models.len(), linked.models.len() + 1, "the last user keeps the model");
        assert_ne!(after.clouds[0].model, after.clouds[2].model);
        assert_same_looks(&placed(&linked, 0), &placed(&after, 0));
        assert_eq!(make_own(&after, &both), Arrangement::default(), "nothing is shared now");
    }

    #[test]
    fn boxes_and_cameras() {
        let scene = two_clouds();
        let model = &scene.models[0];
        let arrangement = boxes(&scene, model.id, &[model.boxes[1].id, BoxId(9999)], DVec3::Z * 50.0);
        let after = applied(&scene, &arrangement);
        let new = after.models[0].boxes.last().expect("the copy");
        assert_eq!(arrangement.made, [Thing::Box(model.id, new.id)]);
        assert_eq!((new.center, new.group), (model.boxes[1].center + DVec3::Z * 50.0, model.boxes[1].group));
        let after = applied(&scene, &things(&scene, &[Thing::Camera(scene.cameras[0].id)]));
        assert_eq!(after.cameras[1].position, scene.cameras[0].position);
        assert_eq!(boxes(&scene, ModelId(9999), &[], DVec3::ZERO), Arrangement::default());
    }

    #[test]
    fn paths_and_aircraft() {
        let scene = scene_with_flight();
        let (path, leader) = (&scene.paths[0], &scene.aircraft[0]);
        let arrangement = things(&scene, &[Thing::Path(path.id), Thing::Path(PathId(9999))]);
        let after = applied(&scene, &arrangement);
        let new = after.paths.last().expect("the copy");
        assert_eq!(arrangement.made, [Thing::Path(new.id)]);
        assert_eq!((new.name.as_str(), after.aircraft.len()), ("through 2", 1));
        assert_eq!(new.keys, path.keys);
        let after = applied(&scene, &things(&scene, &[Thing::Aircraft(leader.id)]));
        let new = after.aircraft.last().expect("the copy");
        assert_eq!((new.path, new.ahead_s), (path.id, leader.ahead_s - 0.5));
        let whole = [Thing::Model(scene.models[0].id), Thing::Cloud(scene.clouds[0].id)];
        assert_eq!(things(&scene, &whole), Arrangement::default(), "these have ways of their own");
    }
}
