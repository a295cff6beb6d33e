//! Boxes and single sprites into shading groups, and out of them.
//!
//! A box takes all its sprites along, those too that had been put elsewhere one by one. A single sprite without a group
//! of its own is in its box's.

use super::copy::groups_of;
use super::sprites::change_edits;
use super::{Arrangement, Plan, Thing, at_end};
use crate::document::Edit;
use crate::scene::{CloudBox, CloudModel, GroupId, GroupLight, ModelId, Scene, ShadingGroup};
use std::collections::BTreeSet;

/// Where boxes and sprites are put.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Destination {
    /// A new group of that name, lit like the first of the boxes.
    New(String),
    /// A group of the model's.
    Existing(GroupId),
    /// Each box is a group of its own again; a sprite is in its box's again.
    Own,
}

/// Puts those of `things` that are boxes or sprites of `model` into one group of it.
pub fn put(scene: &Scene, model: ModelId, things: &[Thing], destination: &Destination) -> Arrangement {
    let mut plan = Plan::new(scene);
    let Some(model) = scene.model(model) else { return plan.done() };
    let chosen: BTreeSet<Thing> = things.iter().copied().collect();
    let sprites_of = |each: &CloudBox| {
        let all = Thing::Sprite(model.id, each.id, 0)..=Thing::Sprite(model.id, each.id, u32::MAX);
        let index = |thing: &Thing| if let Thing::Sprite(_, _, index) = *thing { Some(index) } else { None };
        chosen.range(all).filter_map(index).filter(|index| *index < each.sprite_count).collect::<Vec<u32>>()
    };
    let is_whole = |each: &CloudBox| chosen.contains(&Thing::Box(model.id, each.id));
    let Some(first) = model.boxes.iter().find(|each| is_whole(each) || !sprites_of(each).is_empty()) else {
        return plan.done();
    };
    let group = match destination {
        Destination::New(name) => {
            let id = GroupId::new(&mut plan.next_id);
            let group = ShadingGroup { id, name: name.clone(), light: light_of(model, first) };
            plan.edits.push(Edit::Group(model.id, at_end(group)));
            plan.made.push(Thing::Group(model.id, id));
            Some(id)
        }
        Destination::Existing(id) if model.groups.iter().any(|group| group.id == *id) => {
            plan.made.push(Thing::Group(model.id, *id));
            Some(*id)
        }
        Destination::Existing(_) => return plan.done(),
        Destination::Own => None,
    };
    for old in &model.boxes {
        let mut new = old.clone();
        if is_whole(old) {
            groups_of(&mut new).for_each(|each| *each = None);
            new.group = group;
            change_edits(&mut new, |_| {});
        } else {
            let sprites = sprites_of(old);
            if sprites.is_empty() {
                continue;
            }
            change_edits(&mut new, |edits| sprites.iter().for_each(|index| edits.of(*index).group = group));
        }
        if new != *old {
            plan.replace_box(model.id, new);
        }
    }
    plan.done()
}

/// How the group that a box is in takes the light.
pub(super) fn light_of(model: &CloudModel, cloud_box: &CloudBox) -> GroupLight {
    let named = model.groups.iter().find(|group| Some(group.id) == cloud_box.group);
    named.map_or(cloud_box.light, |group| group.light)
}

#[cfg(test)]
mod tests {
    use super::super::test_scenes::{applied, placed, two_clouds};
    use super::*;
    use crate::sprites::GroupKey;

    #[test]
    fn boxes_and_sprites_into_a_new_group_and_out_again() {
        let scene = two_clouds();
        let model = &scene.models[0];
        let things = [
            Thing::Box(model.id, model.boxes[1].id),
            Thing::Sprite(model.id, model.boxes[0].id, 0),
            Thing::Sprite(model.id, model.boxes[0].id, 1),
            Thing::Sprite(model.id, model.boxes[0].id, 99_999),
            Thing::Cloud(scene.clouds[0].id),
        ];
        let arrangement = put(&scene, model.id, &things, &Destination::New("top".into()));
        let after = applied(&scene, &arrangement);
        let group = after.models[0].groups.last().expect("the new one");
        assert_eq!(arrangement.made, [Thing::Group(model.id, group.id)]);
        assert_eq!((group.name.as_str(), group.light), ("top", model.boxes[0].light));
        let shown = placed(&after, 0);
        for sprite in shown.sprites.iter() {
            let in_group = shown.groups[sprite.group as usize].key == GroupKey::Named(group.id);
            let wanted = sprite.box_id == model.boxes[1].id || sprite.box_id == model.boxes[0].id && sprite.index < 2;
            assert_eq!(in_group, wanted, "{sprite:?}");
        }
        let back = applied(&after, &put(&after, model.id, &things, &Destination::Own));
        assert_eq!(back.models[0].boxes[0], model.boxes[0]);
        assert_eq!(back.models[0].boxes[1].group, None);
    }

    #[test]
    fn a_box_takes_its_sprites_along() {
        let scene = two_clouds();
        let (model, group) = (&scene.models[0], scene.models[0].groups[0].id);
        let id = model.boxes[0].id;
        let sprite = Thing::Sprite(model.id, id, 4);
        let first = applied(&scene, &put(&scene, model.id, &[sprite], &Destination::Existing(group)));
        assert_eq!(first.models[0].boxes[0].sprite_edits[0].group, Some(group));
        let second =
            applied(&first, &put(&first, model.id, &[Thing::Box(model.id, id)], &Destination::New("x".into())));
        assert_eq!(second.models[0].boxes[0].sprite_edits, []);
    }

    #[test]
    fn what_is_gone_makes_no_group() {
        let scene = two_clouds();
        let model = scene.models[0].id;
        let box_of_other = Thing::Box(scene.models[1].id, scene.models[1].boxes[0].id);
        for things in [&[][..], &[box_of_other], &[Thing::Sprite(model, scene.models[0].boxes[0].id, 99_999)]] {
            assert_eq!(put(&scene, model, things, &Destination::New("x".into())), Arrangement::default());
        }
        let own = Thing::Box(model, scene.models[0].boxes[0].id);
        assert_eq!(put(&scene, model, &[own], &Destination::Existing(GroupId(9999))), Arrangement::default());
    }
}
