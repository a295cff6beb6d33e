//! Boxes leave a cloud as a cloud of their own, with a model of their own, at the same place.
//!
//! Every box stays where it is in the world and keeps its sprites; what the cull had dropped beside the other part's
//! sprites comes back. Groups that both parts are in are copied, each part's with the centre of its own sprites, and
//! colour levels run over each part's own height. A model that other clouds use too stays as it is for them. Both parts
//! move by the same tracks.

use super::copied::Copied;
use super::copy::{copy_parts, groups_used};
use super::duplicate::model_names;
use super::{Arrangement, Names, Plan, Refusal, Thing, keys};
use crate::document::{Edit, ListEdit};
use crate::scene::{BoxId, Cloud, CloudBox, CloudId, CloudModel, ModelId, Scene, ShadingGroup};
use glam::DVec3;
use std::collections::BTreeSet;

/// Splits those boxes off a cloud.
///
/// # Errors
/// If the cloud has none of the boxes, or no others.
pub fn boxes(scene: &Scene, cloud: CloudId, ids: &[BoxId]) -> Result<Arrangement, Refusal> {
    let cloud = scene.cloud(cloud).ok_or(Refusal::NotAPart)?;
    let model = scene.model(cloud.model).ok_or(Refusal::NotAPart)?;
    let ids: BTreeSet<BoxId> = ids.iter().copied().collect();
    let (leaving, staying): (Vec<&CloudBox>, Vec<&CloudBox>) =
        model.boxes.iter().partition(|each| ids.contains(&each.id));
    if leaving.is_empty() || staying.is_empty() {
        return Err(Refusal::NotAPart);
    }
    let mut plan = Plan::new(scene);
    let mut names = model_names(scene);
    let (mut copied, mut gone) = (Copied::default(), BTreeSet::new());
    let mut part = |plan: &mut Plan<'_>, boxes: &[&CloudBox]| {
        let used = groups_used(boxes.iter().copied());
        let old = || model.groups.iter().filter(|group| used.contains(&group.id));
        let (groups, new_boxes) = copy_parts(old(), boxes.iter().copied(), &mut plan.next_id);
        let id = ModelId::new(&mut plan.next_id);
        copied.parts((model.id, old(), boxes.iter().copied()), (id, &groups, &new_boxes));
        let new = CloudModel { id, name: names.free(&model.name), groups, boxes: new_boxes, ..model.clone() };
        copied.levels(model.id, &new);
        plan.insert_model(new);
        id
    };

    if scene.clouds.iter().any(|other| other.model == model.id && other.id != cloud.id) {
        let rest = part(&mut plan, &staying);
        plan.edits.push(Edit::Cloud(ListEdit::Replace(Cloud { model: rest, ..cloud.clone() })));
    } else {
        let mut rest = model.clone();
        let (left, kept) = (groups_used(leaving.iter().copied()), groups_used(staying.iter().copied()));
        let leaves = |group: &ShadingGroup| left.contains(&group.id) && !kept.contains(&group.id);
        gone.extend(leaving.iter().map(|each| Thing::Box(model.id, each.id)));
        gone.extend(model.groups.iter().filter(|group| leaves(group)).map(|group| Thing::Group(model.id, group.id)));
        rest.boxes.retain(|each| !ids.contains(&each.id));
        rest.groups.retain(|group| !leaves(group));
        plan.edits.push(Edit::Model(ListEdit::Replace(rest)));
    }
    let off = part(&mut plan, &leaving);
    let name = Names::new(scene.clouds.iter().map(|each| each.name.as_str())).free(&cloud.name);
    let id = CloudId::new(&mut plan.next_id);
    plan.insert_cloud(Cloud { id, name, model: off, ..cloud.clone() });
    copied.thing(Thing::Cloud(cloud.id), Thing::Cloud(id));
    copied.insert_tracks(&mut plan, DVec3::ZERO);
    plan.edits.extend(keys::doomed(scene, &gone).into_iter().filter_map(Edit::removing));
    plan.made.push(Thing::Cloud(id));
    Ok(plan.done())
}

#[cfg(test)]
mod tests {
    use super::super::duplicate::{self, Copy};
    use super::super::join;
    use super::super::test_scenes::{applied, assert_same_looks, moved, placed, two_clouds, with_tracks};
    use super::*;
    use crate::scene::{CullRadius, GroupCenter};
    use crate::sprites::PlacedCloud;
    use glam::DVec3;

    fn airy() -> Scene {
        let mut scene = two_clouds();
        scene.models[1].cull_radius = CullRadius::Metres(0.0);
        // A mean would be that of each part's sprites.
        scene.models[1].groups[0].light.center = GroupCenter::At(DVec3::X);
        scene
    }

    /// Of the sprites, those of the box that stands at a place of its model's list.
    fn of_box(cloud: &PlacedCloud, box_id: BoxId) -> PlacedCloud {
        let sprites = cloud.sprites.iter().copied().filter(|sprite| sprite.box_id == box_id);
        PlacedCloud { sprites: sprites.collect(), ..cloud.clone() }
    }

    #[test]
    fn boxes_stay_where_they_are() {
        let scene = airy();
        let model = &scene.models[1];
        let arrangement = boxes(&scene, scene.clouds[1].id, &[model.boxes[1].id, BoxId(9999)]).expect("a part");
        let after = applied(&scene, &arrangement);
        assert_eq!((after.models.len(), after.clouds.len()), (3, 3));
        assert_eq!(arrangement.made, [Thing::Cloud(after.clouds[2].id)]);
        let (whole, rest, off) = (placed(&scene, 1), placed(&after, 1), placed(&after, 2));
        assert_same_looks(&of_box(&whole, model.boxes[1].id), &off);
        assert_same_looks(&of_box(&whole, model.boxes[2].id), &of_box(&rest, model.boxes[2].id));
        assert_eq!(rest.sprites.len() + off.sprites.len(), whole.sprites.len());
        // Joined again, they are what they were, but for the order.
        let joined = join::clouds(&after, &[after.clouds[1].id, after.clouds[2].id]).expect("two");
        assert_eq!(placed(&applied(&after, &joined), 1).sprites.len(), whole.sprites.len());
    }

    #[test]
    fn groups_that_none_is_left_in_go_along() {
        let scene = airy();
        let ids: Vec<_> = scene.models[1].boxes.as_slice()[1..].iter().map(|each| each.id).collect();
        let after = applied(&scene, &boxes(&scene, scene.clouds[1].id, &ids).expect("a part"));
        assert_eq!((after.models[1].groups.len(), after.models[2].groups.len()), (0, 1));
    }

    #[test]
    fn others_of_a_shared_model_stay_as_they_are() {
        let scene = airy();
        let linked = duplicate::clouds(&scene, &[scene.clouds[1].id], DVec3::X * 5000.0, Copy::Linked);
        let scene = applied(&scene, &linked);
        let arrangement = boxes(&scene, scene.clouds[1].id, &[scene.models[1].boxes[0].id]).expect("a part");
        let after = applied(&scene, &arrangement);
        assert_eq!((&after.models.as_slice()[..2], &after.clouds[2]), (scene.models.as_slice(), &scene.clouds[2]));
        let count = |i| placed(&after, i).sprites.len();
        assert_eq!(count(1) + count(3), placed(&scene, 1).sprites.len());
    }

    #[test]
    fn both_parts_move_as_the_whole_did() {
        let mut scene = airy();
        let (cloud, model) = (scene.clouds[1].id, scene.models[1].id);
        let group = scene.models[1].groups[0].id;
        let [a, b, c] = [0, 1, 2].map(|i| scene.models[1].boxes[i].id);
        let of_whole = |cloud: CloudId, model: ModelId| {
            [format!("cloud/{cloud}/opacity"), format!("model/{model}/color_levels/2/height")]
        };
        let of_box = |model: ModelId, id: BoxId| format!("model/{model}/box/{id}/light/c_med");
        let of_group = |model: ModelId, id| format!("model/{model}/group/{id}/light/c_max");
        with_tracks(&mut scene, &of_whole(cloud, model));
        with_tracks(&mut scene, &[a, b, c].map(|id| of_box(model, id)));
        with_tracks(&mut scene, &[of_group(model, group)]);
        let after = applied(&scene, &boxes(&scene, cloud, &[b, c]).expect("a part"));
        let off = &after.models[2];
        let all = of_whole(cloud, model).into_iter().chain(of_whole(after.clouds[2].id, off.id)).chain([
            of_box(model, a),
            of_box(off.id, off.boxes[0].id),
            of_box(off.id, off.boxes[1].id),
            of_group(off.id, off.groups[0].id),
        ]);
        assert_eq!(moved(&after), all.collect(), "the group left with its boxes");
        let linked = applied(&scene, &duplicate::clouds(&scene, &[cloud], DVec3::X * 5000.0, Copy::Linked));
        let after = applied(&linked, &boxes(&linked, cloud, &[b]).expect("a part"));
        let before = moved(&linked);
        let [rest, off] = [&after.models[2], &after.models[3]];
        let new = of_whole(after.clouds[3].id, off.id).into_iter().chain([
            format!("model/{}/color_levels/2/height", rest.id),
            of_box(rest.id, rest.boxes[0].id),
            of_box(rest.id, rest.boxes[1].id),
            of_box(off.id, off.boxes[0].id),
            of_group(rest.id, rest.groups[0].id),
            of_group(off.id, off.groups[0].id),
        ]);
        assert_eq!(moved(&after), before.into_iter().chain(new).collect(), "the other cloud's model stays");
    }

    #[test]
    fn none_and_all_are_refused() {
        let scene = airy();
        let all: Vec<_> = scene.models[1].boxes.iter().map(|each| each.id).collect();
        for ids in [&[][..], &[BoxId(9999)], &[scene.models[0].boxes[0].id], &all] {
            assert_eq!(boxes(&scene, scene.clouds[1].id, ids), Err(Refusal::NotAPart));
        }
        assert_eq!(boxes(&scene, CloudId(9999), &all), Err(Refusal::NotAPart));
    }
}
