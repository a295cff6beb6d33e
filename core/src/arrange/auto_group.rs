//! Shading groups by themselves: compact clusters of sprites, none of more than 30 (W).
//!
//! A crowd that needs k groups is cut across the longest side of its bounds so that ⌊k/2⌋ and ⌈k/2⌉ groups suffice for
//! the parts, each of which then holds its share of the sprites; so k is the least number possible, the groups are
//! equally large but for one or two sprites, and the same sprites give the same groups. Groups become named ones of the
//! model; the sprites that the cull drops stay in their boxes' own. What is saved is which *index* is in which group:
//! sprites strewn anew, or those of a cloud with another seed, are grouped by chance until they are grouped again.

use super::copy::{groups_of, groups_used};
use super::group::light_of;
use super::sprites::change_edits;
use super::{Arrangement, Names, Plan, Thing};
use crate::document::{Edit, ListEdit};
use crate::scene::{BoxId, CloudModel, GroupCenter, GroupId, GroupLight, ModelId, Scene, ShadingGroup};
use crate::sprites::{Candidate, PopulatedModel};
use glam::DVec3;
use std::collections::BTreeMap;

/// So many sprites of a group read as one lump.
pub const MOST_SPRITES: usize = 30;

/// Groups the kept sprites of a model anew, as `populated` has them: of the model's own seed or of that of the cloud
/// that the artist looks at.
///
/// A group takes the light of the box that most of its sprites come from. Groups that lose all they had go.
pub fn model(scene: &Scene, model: ModelId, populated: &PopulatedModel) -> Arrangement {
    let mut plan = Plan::new(scene);
    let Some(model) = scene.model(model).filter(|_| !populated.sprites.is_empty()) else { return plan.done() };
    let mut new = model.clone();
    for cloud_box in &mut new.boxes {
        groups_of(cloud_box).skip(1).for_each(|group| *group = None);
    }
    let (before, left) = (groups_used(&model.boxes), groups_used(&new.boxes));
    new.groups.retain(|group| left.contains(&group.id) || !before.contains(&group.id));

    let lights: BTreeMap<BoxId, GroupLight> = model.boxes.iter().map(|each| (each.id, light_of(model, each))).collect();
    let mut names = Names::new(new.groups.iter().map(|group| group.name.as_str()));
    let mut group_of_sprite: BTreeMap<BoxId, Vec<(u32, GroupId)>> = BTreeMap::new();
    for cluster in clusters(&populated.sprites) {
        let id = GroupId::new(&mut plan.next_id);
        let light = light(&cluster, &lights);
        new.groups.push(ShadingGroup { id, name: names.free("lump"), light });
        plan.made.push(Thing::Group(model.id, id));
        for sprite in cluster {
            group_of_sprite.entry(sprite.box_id).or_default().push((sprite.index, id));
        }
    }
    assign(&mut new, &group_of_sprite);
    plan.edits.push(Edit::Model(ListEdit::Replace(new)));
    plan.done()
}

fn assign(model: &mut CloudModel, group_of_sprite: &BTreeMap<BoxId, Vec<(u32, GroupId)>>) {
    for cloud_box in &mut model.boxes {
        let sprites = group_of_sprite.get(&cloud_box.id).map_or(&[][..], Vec::as_slice);
        change_edits(cloud_box, |edits| {
            for (index, group) in sprites {
                edits.of(*index).group = Some(*group);
            }
        });
    }
}

/// That of the box with the most sprites, the first of several. A centre put by hand was that of other sprites.
fn light(cluster: &[&Candidate], lights: &BTreeMap<BoxId, GroupLight>) -> GroupLight {
    let mut counts: BTreeMap<BoxId, usize> = BTreeMap::new();
    for sprite in cluster {
        *counts.entry(sprite.box_id).or_default() += 1;
    }
    let most = counts.into_iter().rev().max_by_key(|(_, count)| *count);
    let mut light = most.and_then(|(id, _)| lights.get(&id)).copied().unwrap_or_default();
    if let GroupCenter::At(_) = light.center {
        light.center = GroupCenter::Mean;
    }
    light
}

/// Deals the sprites out to as few clusters of at most [`MOST_SPRITES`] as hold them all.
fn clusters(sprites: &[Candidate]) -> Vec<Vec<&Candidate>> {
    let mut found = Vec::new();
    let mut open: Vec<Vec<&Candidate>> = vec![sprites.iter().collect()];
    while let Some(mut crowd) = open.pop() {
        let count = crowd.len().div_ceil(MOST_SPRITES);
        if count < 2 {
            found.extend((!crowd.is_empty()).then_some(crowd));
            continue;
        }
        let axis = longest_axis(&crowd);
        crowd.sort_by(|a, b| a.position[axis].total_cmp(&b.position[axis]));
        // No more than 30 for each of its groups come to either part.
        let upper = crowd.split_off((crowd.len() * (count / 2)).div_ceil(count));
        open.extend([upper, crowd]);
    }
    found
}

fn longest_axis(crowd: &[&Candidate]) -> usize {
    let (low, high) = crowd
        .iter()
        .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), s| (low.min(s.position), high.max(s.position)));
    (high - low).max_position()
}

#[cfg(test)]
mod tests {
    use super::super::test_scenes::{applied, placed, two_clouds};
    use super::*;
    use crate::sprites::{GroupKey, populate};
    use proptest::prelude::*;

    fn sprite(position: [f64; 3], index: u32) -> Candidate {
        Candidate {
            box_id: BoxId(1),
            index,
            position: position.into(),
            width: 1.0,
            height: 1.0,
            rotation: 0.0,
            tile: 0,
            moved: false,
            group: None,
            lump: 0,
        }
    }

    /// Of a coordinate's mean square deviation within clusters: how compact they are.
    fn spread(clusters: &[Vec<&Candidate>]) -> f64 {
        let of_one = |cluster: &Vec<&Candidate>| {
            let mean = cluster.iter().map(|s| s.position).sum::<DVec3>() / cluster.len() as f64;
            cluster.iter().map(|s| s.position.distance_squared(mean)).sum::<f64>()
        };
        clusters.iter().map(of_one).sum()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn few_clusters_none_too_large_and_all_sprites_once(
            places in prop::collection::vec(prop::array::uniform3(prop_oneof![-1e3..1e3, Just(0.0), Just(f64::NAN)]), 0..400),
        ) {
            let sprites: Vec<Candidate> = places.into_iter().zip(0..).map(|(place, i)| sprite(place, i)).collect();
            let found = clusters(&sprites);
            prop_assert_eq!(found.len(), sprites.len().div_ceil(MOST_SPRITES));
            let sizes = || found.iter().map(Vec::len);
            prop_assert!(sizes().all(|size| size <= MOST_SPRITES && size * 2 >= sizes().max().unwrap_or(0)));
            let mut all: Vec<u32> = found.iter().flatten().map(|s| s.index).collect();
            all.sort_unstable();
            prop_assert_eq!(all, (0..sprites.len() as u32).collect::<Vec<_>>());
        }
    }

    #[test]
    fn clusters_are_compact() {
        let model = &two_clouds().models[0];
        let mut wide = model.boxes[0].clone();
        wide.sprite_count = 300;
        let crowd = CloudModel {
            boxes: vec![wide].into(),
            cull_radius: crate::scene::CullRadius::Metres(0.0),
            ..model.clone()
        };
        let sprites = populate(&crowd, 1).sprites;
        let as_they_come: Vec<Vec<&Candidate>> = sprites.chunks(30).map(|chunk| chunk.iter().collect()).collect();
        let (got, random) = (spread(&clusters(&sprites)), spread(&as_they_come));
        assert!(got < 0.35 * random, "{got} against {random} of groups dealt by chance");
    }

    #[test]
    fn a_model_has_no_crowded_group_afterwards() {
        let mut scene = two_clouds();
        for cloud_box in &mut scene.models[0].boxes {
            cloud_box.sprite_count = 100;
        }
        scene.models[0].boxes[0].light.c_max = 2.5;
        let populated = populate(&scene.models[0], scene.models[0].seed);
        let arrangement = model(&scene, scene.models[0].id, &populated);
        let after = applied(&scene, &arrangement);
        let shown = placed(&after, 0);
        assert_eq!(shown.sprites.len(), populated.sprites.len());
        assert_eq!(shown.groups.len(), populated.sprites.len().div_ceil(MOST_SPRITES));
        assert_eq!(arrangement.made.len(), shown.groups.len());
        for group in shown.groups.iter() {
            assert!(matches!(group.key, GroupKey::Named(_)) && group.sprite_count <= MOST_SPRITES, "{group:?}");
        }
        assert!(shown.groups.iter().any(|group| group.c[2] == 2.5), "the light of its box");
        // Once more: the old groups make way for the new ones.
        let again = applied(&after, &model(&after, scene.models[0].id, &populated));
        assert_eq!(again.models[0].groups.len(), after.models[0].groups.len());
        let none = PopulatedModel { candidate_count: 0, sprites: Vec::new(), merging: std::sync::Arc::default() };
        assert_eq!(model(&scene, scene.models[0].id, &none), Arrangement::default());
    }
}
