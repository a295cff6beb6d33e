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

use super::copy::{copy_model, copy_parts, groups_used};
use super::duplicate::model_names;
use super::{Arrangement, ModelSpace, Plan, Refusal, Thing};
use crate::document::{Edit, ListEdit};
use crate::scene::{Cloud, CloudBox, CloudId, CloudModel, IdCounter, List, ModelId, Scene, ShadingGroup};
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
    let into = Whole { cloud: first, model: first_model, space: ModelSpace::of(first) };
    for (cloud, model) in others {
        let (groups, boxes) = into.brought(cloud, model, &mut plan.next_id);
        whole.groups.extend(groups);
        whole.boxes.extend(boxes);
    }
    let whole_id = whole.id;
    if is_shared {
        plan.insert_model(whole);
        plan.edits.push(Edit::Cloud(ListEdit::Replace(Cloud { model: whole_id, ..(*first).clone() })));
    } else {
        plan.edits.push(Edit::Model(ListEdit::Replace(whole)));
    }
    plan.edits.extend(others.iter().map(|(cloud, _)| Edit::Cloud(ListEdit::Remove(cloud.id))));
    let theirs: BTreeSet<ModelId> = others.iter().map(|(cloud, _)| cloud.model).collect();
    let unused = theirs.into_iter().filter(|id| *id != first.model && !used_elsewhere.contains(id));
    plan.edits.extend(unused.map(|id| Edit::Model(ListEdit::Remove(id))));
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
    /// Another cloud's boxes in this model's space, under new ids, with the groups that they are in.
    fn brought(
        &self,
        cloud: &Cloud,
        model: &CloudModel,
        counter: &mut IdCounter,
    ) -> (List<ShadingGroup>, List<CloudBox>) {
        let space = ModelSpace::of(cloud);
        let used = groups_used(&model.boxes);
        let (mut groups, mut boxes) =
            copy_parts(model.groups.iter().filter(|group| used.contains(&group.id)), &model.boxes, counter);
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
    use super::super::test_scenes::{applied, assert_same_looks, placed, two_clouds};
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
                vec![SpriteEdit { index: 2, moved: Some(DVec3::splat(0.7)), dropped: false, group: Some(group) }];
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
    fn fewer_than_two_are_refused() {
        let scene = airy();
        let id = scene.clouds[0].id;
        for ids in [&[][..], &[id], &[id, id], &[id, CloudId(9999)]] {
            assert_eq!(clouds(&scene, ids), Err(Refusal::TooFewClouds));
        }
    }
}
