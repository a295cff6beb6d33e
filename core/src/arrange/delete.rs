//! Any mix of things out of the scene, with what hangs on them.
//!
//! A model takes its clouds along, a path its aircraft, and everything its tracks; a group sets free the boxes and sprites
//! that were in it, a folder its clouds; a sprite is dropped by hand, so that it stays away when others are strewn. A model
//! whose last cloud goes stays: it can be placed again.

use super::copy::groups_of;
use super::sprites::change_edits;
use super::{Arrangement, Plan, folders, keys};
use crate::document::{Edit, ListEdit};
use crate::scene::{CloudModel, ForKind, Listed, ModelId, Scene, Thing, for_each_kind};
use std::collections::BTreeSet;

/// Takes `things` out.
pub fn things(scene: &Scene, things: &[Thing]) -> Arrangement {
    let mut doom = Doom { scene, doomed: things.iter().copied().collect() };
    for_each_kind(&mut doom);
    let mut doomed = doom.doomed;
    doomed.extend(keys::doomed(scene, &doomed));
    let mut plan = Plan::new(scene);
    let listed = doomed.iter().filter(|thing| thing.listed(scene).is_some());
    plan.edits.extend(listed.filter_map(|thing| Edit::removing(*thing)));
    let mut freed = Freed { plan: &mut plan, doomed: &doomed };
    for_each_kind(&mut freed);
    for model in scene.models.iter().filter(|model| !doomed.contains(&Thing::Model(model.id))) {
        from_model(&mut plan, model, &doomed);
    }
    plan.done()
}

/// The models that no cloud places: what stays of them is their names in the outline, and their use in times to come.
pub fn unused_models(scene: &Scene) -> Vec<Thing> {
    let placed: BTreeSet<ModelId> = scene.clouds.iter().map(|cloud| cloud.model).collect();
    scene.models.iter().filter(|model| !placed.contains(&model.id)).map(|model| Thing::Model(model.id)).collect()
}

/// Dooms what hangs on what is doomed.
struct Doom<'s> {
    scene: &'s Scene,
    doomed: BTreeSet<Thing>,
}

impl ForKind for Doom<'_> {
    fn kind<T: Listed>(&mut self) {
        let on_doomed = |value: &&T| value.hangs_on().is_some_and(|(_, on)| self.doomed.contains(&on));
        let more: Vec<Thing> = T::list(self.scene).iter().filter(on_doomed).map(|value| T::thing(value.id())).collect();
        self.doomed.extend(more);
    }
}

/// Takes what stays out of the folders that are doomed.
struct Freed<'p, 's> {
    plan: &'p mut Plan<'s>,
    doomed: &'p BTreeSet<Thing>,
}

impl ForKind for Freed<'_, '_> {
    fn kind<T: Listed>(&mut self) {
        for value in T::list(self.plan.scene) {
            let thing = T::thing(value.id());
            let goes = value.kept_in().is_some_and(|(_, folder)| self.doomed.contains(&folder));
            if goes && !self.doomed.contains(&thing) {
                self.plan.edits.extend(folders::kept(self.plan.scene, thing, None));
            }
        }
    }
}

fn from_model(plan: &mut Plan<'_>, model: &CloudModel, doomed: &BTreeSet<Thing>) {
    for old in &model.boxes {
        if doomed.contains(&Thing::Box(model.id, old.id)) {
            plan.edits.push(Edit::Box(model.id, ListEdit::Remove(old.id)));
            continue;
        }
        let mut new = old.clone();
        for group in groups_of(&mut new) {
            *group = group.filter(|id| !doomed.contains(&Thing::Group(model.id, *id)));
        }
        let sprites = Thing::Sprite(model.id, old.id, 0)..=Thing::Sprite(model.id, old.id, u32::MAX);
        change_edits(&mut new, |edits| {
            for thing in doomed.range(sprites) {
                if let Thing::Sprite(_, _, index) = *thing
                    && index < old.sprite_count
                {
                    edits.of(index).dropped = true;
                }
            }
        });
        // That edits now stand in order is no change.
        let mut in_order = old.clone();
        change_edits(&mut in_order, |_| {});
        if new != in_order {
            plan.replace_box(model.id, new);
        }
    }
    for group in &model.groups {
        if doomed.contains(&Thing::Group(model.id, group.id)) {
            plan.edits.push(Edit::Group(model.id, ListEdit::Remove(group.id)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_scenes::{applied, moved, two_clouds, with_tracks};
    use super::*;
    use crate::problem::scene_with_flight;
    use crate::scene::{PathId, SpriteEdit};

    #[test]
    fn any_mix_goes_and_nothing_points_at_it() {
        let mut scene = two_clouds();
        let mut camera = scene.cameras[0].clone();
        camera.id = crate::scene::CameraId::new(&mut scene.next_id);
        camera.name = "second".into();
        scene.cameras.push(camera);
        let (first, second) = (scene.models[0].id, scene.models[1].id);
        let (group, boxes) = (scene.models[1].groups[0].id, scene.models[1].boxes.clone());
        let edit = |index| SpriteEdit { group: Some(group), ..SpriteEdit::new(index) };
        scene.models[1].boxes[0].sprite_edits = vec![edit(5), edit(2)];
        let doomed = [
            Thing::Model(first),
            Thing::Box(second, boxes[1].id),
            Thing::Group(second, group),
            Thing::Sprite(second, boxes[0].id, 5),
            Thing::Sprite(second, boxes[2].id, 99_999),
            Thing::Camera(scene.cameras[0].id),
            Thing::Model(ModelId(9999)),
        ];
        let after = applied(&scene, &things(&scene, &doomed));
        assert_eq!(after.models.len(), 1);
        assert_eq!(after.clouds.as_slice(), &scene.clouds.as_slice()[1..]);
        assert_eq!(after.cameras.as_slice(), &scene.cameras.as_slice()[1..]);
        let model = &after.models[0];
        assert_eq!((model.groups.len(), model.boxes.len()), (0, 2));
        let dropped = SpriteEdit { dropped: true, ..SpriteEdit::new(5) };
        assert_eq!(model.boxes[0].sprite_edits, [dropped]);
        assert_eq!((model.boxes[1].group, model.boxes[1].sprite_edits.len()), (None, 0));
    }

    #[test]
    fn tracks_go_with_what_they_move() {
        let mut scene = two_clouds();
        let (model, cloud, camera) = (scene.models[1].id, scene.clouds[1].id, scene.cameras[0].id);
        let (group, other) = (scene.models[1].groups[0].id, scene.clouds[0].id);
        let properties = [
            format!("cloud/{cloud}/opacity"),
            format!("model/{model}/color_levels/2/height"),
            format!("model/{model}/group/{group}/light/c_max"),
            format!("camera/{camera}/position"),
            format!("cloud/{other}/position"),
            "sky/exposure_ev".into(),
        ];
        with_tracks(&mut scene, &properties);
        let cleared = keys::cleared_of(&scene, &[Thing::Model(model), Thing::Cloud(other)]);
        let after = applied(&scene, &Arrangement { edits: cleared.edits, made: Vec::new() });
        assert_eq!(moved(&after), [0, 3, 5].map(|at| properties[at].clone()).into(), "the things themselves stay");
        for (thing, gone) in [
            (Thing::Cloud(cloud), vec![0]),
            (Thing::Group(model, group), vec![2]),
            (Thing::Model(model), vec![0, 1, 2]),
            (Thing::Camera(camera), vec![3]),
        ] {
            let after = applied(&scene, &things(&scene, &[thing]));
            let left: Vec<&str> = after.tracks.iter().map(|track| track.property.as_str()).collect();
            let kept = properties.iter().enumerate().filter(|(at, _)| !gone.contains(at));
            assert_eq!(left, kept.map(|(_, property)| property.as_str()).collect::<Vec<_>>(), "{thing:?}");
        }
    }

    #[test]
    fn a_path_takes_its_aircraft_along() {
        let mut scene = scene_with_flight();
        let mut other = scene.paths[0].clone();
        (other.id, other.name) = (PathId::new(&mut scene.next_id), "other".into());
        scene.paths.push(other);
        let after = applied(&scene, &things(&scene, &[Thing::Path(scene.paths[0].id)]));
        assert_eq!((after.paths.as_slice(), after.aircraft.as_slice()), (&scene.paths.as_slice()[1..], &[][..]));
        let after = applied(&scene, &things(&scene, &[Thing::Aircraft(scene.aircraft[0].id)]));
        assert_eq!((after.paths.len(), after.aircraft.len()), (2, 0), "the path stays");
    }

    #[test]
    fn a_cloud_leaves_its_model_and_what_is_gone_is_passed_over() {
        let mut scene = two_clouds();
        // In no order: still no change.
        let edit = |index| SpriteEdit { dropped: true, ..SpriteEdit::new(index) };
        scene.models[1].boxes[0].sprite_edits = vec![edit(5), edit(2)];
        let after = applied(&scene, &things(&scene, &[Thing::Cloud(scene.clouds[0].id)]));
        assert_eq!((&after.models, after.clouds.len()), (&scene.models, 1));
        assert_eq!(things(&scene, &[Thing::Model(ModelId(9999))]), Arrangement::default());
        assert_eq!((unused_models(&scene), unused_models(&after)), (vec![], vec![Thing::Model(scene.models[0].id)]));
        assert_eq!(applied(&after, &things(&after, &unused_models(&after))).models.len(), 1);
        let sprite = Thing::Sprite(scene.models[1].id, scene.models[1].boxes[0].id, 5);
        assert_eq!(things(&scene, &[sprite]), Arrangement::default(), "it is dropped already");
    }
}
