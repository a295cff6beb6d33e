//! Several clouds become one.
//!
//! The first one stays where it is; its model's colour levels and cull radius hold for all. The others' boxes come into
//! its model, where they lie in the world: turned by the difference of the headings, scaled with their sprites by the
//! quotient of the scales. They keep their category, key and seed, so that their sprites stay as they are, but for
//! those that the cull now drops because they lie too close to another cloud's; and their named groups come along.
//! Light may change nevertheless: levels run over the height of the whole, and pulled groups towards its middle.
//!
//! A model of the first that other clouds use too is copied first, so that those stay as they are. Models that none but
//! the joined clouds used go.
//!
//! Tracks of groups and boxes come along with them, and the first cloud's stay; those of what is gone go.

use super::copied::Copied;
use super::copy::{copy_model, copy_parts, groups_used};
use super::duplicate::model_names;
use super::{Arrangement, ModelSpace, Plan, Refusal, Thing, keys};
use crate::document::{Edit, ListEdit};
use crate::scene::{Cloud, CloudBox, CloudId, CloudModel, IdCounter, List, ModelId, Scene, ShadingGroup};
use glam::DVec3;
use std::collections::BTreeSet;

/// Joins `ids` into the first of them.
///
/// # Errors
/// If fewer than two of them are in the scene.
pub fn clouds(scene: &Scene, ids: &[CloudId]) -> Result<Arrangement, Refusal> {
    let mut seen = BTreeSet::new();
    let joined: Vec<(&Cloud, &CloudModel)> = ids
        .iter()
        .filter(|id| seen.insert(**id))
        .filter_map(|id| {
            let cloud = scene.cloud(*id)?;
            Some((cloud, scene.model(cloud.model)?))
        })
        .collect();
    let [(first, first_model), others @ ..] = joined.as_slice() else { return Err(Refusal::TooFewClouds) };
    if others.is_empty() {
        return Err(Refusal::TooFewClouds);
    }

    let mut plan = Plan::new(scene);
    let used_elsewhere: BTreeSet<ModelId> =
        scene.clouds.iter().filter(|cloud| !seen.contains(&cloud.id)).map(|cloud| cloud.model).collect();
    let is_shared = used_elsewhere.contains(&first.model);
    let mut whole = if is_shared {
        copy_model(first_model, model_names(scene).free(&first_model.name), &mut plan.next_id)
    } else {
        (*first_model).clone()
    };
    let whole_id = whole.id;
    let mut copied = Copied::default();
    if is_shared {
        copied.model(first_model, &whole);
    }
    let into = Whole { cloud: first, model: first_model, space: ModelSpace::of(first) };
    for (cloud, model) in others {
        let used = groups_used(&model.boxes);
        let old_groups: Vec<&ShadingGroup> = model.groups.iter().filter(|group| used.contains(&group.id)).collect();
        let (groups, boxes) = into.brought(cloud, model, &old_groups, &mut plan.next_id);
        copied.parts((model.id, old_groups, &model.boxes), (whole_id, &groups, &boxes));
        whole.groups.extend(groups);
        whole.boxes.extend(boxes);
    }
    if is_shared {
        plan.insert_model(whole);
        plan.edits.push(Edit::Cloud(ListEdit::Replace(Cloud { model: whole_id, ..(*first).clone() })));
    } else {
        plan.edits.push(Edit::Model(ListEdit::Replace(whole)));
    }
    let mut gone: BTreeSet<Thing> = others.iter().map(|(cloud, _)| Thing::Cloud(cloud.id)).collect();
    let theirs: BTreeSet<ModelId> = others.iter().map(|(cloud, _)| cloud.model).collect();
    let unused = theirs.into_iter().filter(|id| *id != first.model && !used_elsewhere.contains(id));
    gone.extend(unused.map(Thing::Model));
    copied.insert_tracks(&mut plan, DVec3::ZERO);
    gone.extend(keys::doomed(scene, &gone));
    plan.edits.extend(gone.into_iter().filter_map(Edit::removing));
    plan.made.push(Thing::Cloud(first.id));
    Ok(plan.done())
}

/// What the others come into.
struct Whole<'a> {
    cloud: &'a Cloud,
    model: &'a CloudModel,
    space: ModelSpace,
}

impl Whole<'_> {
    /// Another cloud's boxes in this model's space, under new ids, with the groups that they are in, `used`.
    fn brought(
        &self,
        cloud: &Cloud,
        model: &CloudModel,
        used: &[&ShadingGroup],
        counter: &mut IdCounter,
    ) -> (List<ShadingGroup>, List<CloudBox>) {
        let space = ModelSpace::of(cloud);
        let (mut groups, mut boxes) = copy_parts(used.iter().copied(), &model.boxes, counter);
        for group in &mut groups {
            group.light = self.space.light_from(&space, group.light);
        }
        let turn = self.space.turn.conjugate() * space.turn;
        let scale = space.scale / self.space.scale;
        let seed = |cloud: &Cloud, model: &CloudModel| cloud.seed.unwrap_or(model.seed);
        let seed_of_whole = seed(self.cloud, self.model);
        for each in &mut boxes {
            each.center = self.space.from_world(space.to_world(each.center));
            each.orientation = (turn * each.orientation).normalize();
            each.size *= scale;
            each.width = each.width.map(|width| width * scale);
            each.height = each.height.map(|height| height * scale);
            each.light = self.space.light_from(&space, each.light);
            each.category = Some(each.category.unwrap_or(model.category)).filter(|own| *own != self.model.category);
            each.seed = each.seed.or(Some(seed(cloud, model)).filter(|seed| *seed != seed_of_whole));
        }
        (groups, boxes)
    }
}

#[cfg(test)]
mod tests {
    use super::super::duplicate::{self, Copy};
    use super::super::test_scenes::{applied, assert_same_looks, moved, placed, two_clouds, with_tracks};
    use super::*;
    use crate::scene::{CullRadius, SpriteEdit};
    use crate::sprites::PlacedCloud;
    use glam::DVec3;

    /// Two clouds in which nothing is culled, so that the same sprites are kept before and after.
    fn airy() -> Scene {
        let mut scene = two_clouds();
        for model in &mut scene.models {
            model.cull_radius = CullRadius::Metres(0.0);
            let group = model.groups[0].id;
            model.boxes[0].sprite_edits =
                vec![SpriteEdit { moved: Some(DVec3::splat(0.7)), group: Some(group), ..SpriteEdit::new(2) }];
        }
        scene
    }

    /// One cloud's sprites, then the other's.
    fn both(a: &PlacedCloud, b: &PlacedCloud) -> PlacedCloud {
        let shift = b.origin - a.origin;
        let count = a.groups.len() as u32;
        let groups = b.groups.iter().map(|group| {
            let mut group = *group;
            group.center += shift.as_vec3();
            group
        });
        let sprites = b.sprites.iter().map(|sprite| {
            let mut sprite = *sprite;
            sprite.position += shift.as_vec3();
            sprite.group += count;
            sprite
        });
        PlacedCloud {
            groups: a.groups.iter().copied().chain(groups).collect(),
            sprites: a.sprites.iter().copied().chain(sprites).collect(),
            ..a.clone()
        }
    }

    #[test]
    fn every_sprite_stays_where_it_is() {
        let scene = airy();
        for ids in [[0, 1], [1, 0]].map(|order| order.map(|i: usize| scene.clouds[i].id)) {
            let arrangement = clouds(&scene, &ids).expect("there are two");
            let after = applied(&scene, &arrangement);
            assert_eq!((after.clouds.len(), after.models.len()), (1, 1));
            assert_eq!((after.clouds[0].id, arrangement.made.as_slice()), (ids[0], &[Thing::Cloud(ids[0])][..]));
            assert_eq!(after.models[0].groups.len(), 2);
            let [first, second] = ids.map(|id| scene.clouds.iter().position(|c| c.id == id).expect("it is there"));
            assert_same_looks(&both(&placed(&scene, first), &placed(&scene, second)), &placed(&after, 0));
        }
    }

    #[test]
    fn clouds_of_one_model_and_a_shared_first() {
        let scene = airy();
        let linked = applied(
            &scene,
            &duplicate::clouds(&scene, &[scene.clouds[0].id], DVec3::new(900.0, 5.0, 0.0), Copy::Linked),
        );
        // Both users of the model are joined: it is changed in place.
        let [a, b, c] = [0, 1, 2].map(|i| linked.clouds[i].id);
        let one = applied(&linked, &clouds(&linked, &[a, c, a]).expect("there are two"));
        assert_eq!((one.models.len(), one.models[0].id), (2, linked.models[0].id));
        assert_same_looks(&both(&placed(&linked, 0), &placed(&linked, 2)), &placed(&one, 0));
        // The third still uses it: it is copied, and the third stays as it is.
        let two = applied(&linked, &clouds(&linked, &[a, b]).expect("there are two"));
        assert_eq!((two.models.len(), two.clouds.len()), (2, 2));
        assert_same_looks(&placed(&linked, 2), &placed(&two, 1));
        assert_same_looks(&both(&placed(&linked, 0), &placed(&linked, 1)), &placed(&two, 0));
    }

    #[test]
    fn tracks_go_over_to_what_is_left() {
        let mut scene = airy();
        let [(a, m), (b, n)] = [0, 1].map(|i| (scene.clouds[i].id, scene.models[i].id));
        let [g, h] = [0, 1].map(|i| scene.models[i].groups[0].id);
        let first_box = scene.models[1].boxes[0].id;
        let of_first = [
            format!("cloud/{a}/position"),
            format!("model/{m}/color_levels/2/height"),
            format!("model/{m}/group/{g}/light/c_max"),
        ];
        let of_second = [
            format!("cloud/{b}/position"),
            format!("model/{n}/color_levels/2/height"),
            format!("model/{n}/group/{h}/light/c_max"),
            format!("model/{n}/box/{first_box}/light/c_med"),
        ];
        with_tracks(&mut scene, &of_first);
        with_tracks(&mut scene, &of_second);
        let after = applied(&scene, &clouds(&scene, &[a, b]).expect("two"));
        let whole = &after.models[0];
        let brought = [
            format!("model/{m}/group/{}/light/c_max", whole.groups[1].id),
            format!("model/{m}/box/{}/light/c_med", whole.boxes[3].id),
        ];
        assert_eq!(moved(&after), of_first.iter().chain(&brought).cloned().collect());
        // The first one's model is another cloud's too: its copy moves alike, and it itself as before.
        let linked = applied(&scene, &duplicate::clouds(&scene, &[a], DVec3::X * 900.0, Copy::Linked));
        let after = applied(&linked, &clouds(&linked, &[a, b]).expect("two"));
        let whole = after.models.as_slice().last().expect("the copy");
        let (c, own) = (linked.clouds[2].id, whole.id);
        let all = [
            format!("cloud/{c}/position"),
            format!("model/{own}/color_levels/2/height"),
            format!("model/{own}/group/{}/light/c_max", whole.groups[0].id),
            format!("model/{own}/group/{}/light/c_max", whole.groups[1].id),
            format!("model/{own}/box/{}/light/c_med", whole.boxes[3].id),
        ];
        assert_eq!(moved(&after), of_first.iter().chain(&all).cloned().collect());
    }

    #[test]
    fn fewer_than_two_are_refused() {
        let scene = airy();
        let id = scene.clouds[0].id;
        for ids in [&[][..], &[id], &[id, id], &[id, CloudId(9999)]] {
            assert_eq!(clouds(&scene, ids), Err(Refusal::TooFewClouds));
        }
    }
}
