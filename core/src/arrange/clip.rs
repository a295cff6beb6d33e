//! What is copied to be pasted: a part of a scene that stands by itself, in this scene, another one, or none.
//!
//! Clouds are with their models and folders, aircraft with their paths, and all with its tracks. How it is put into a
//! scene again is [`transfer`]'s; how it is written as text, [`crate::formats::scene_clip`]'s.

use super::copied::Copied;
use super::copy::{copy_parts, groups_of, groups_used};
use super::{Arrangement, Names, Plan, Refusal, at_end, keys, transfer};
use crate::document::Edit;
// The types that the rows name, with the rest of the room.
use crate::scene::*;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// A part of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Clip {
    /// What it is.
    pub holds: Holds,
    /// It, in lists as a scene has them; the rest of the scene says nothing.
    pub scene: Scene,
}

/// What a clip is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Holds {
    /// What stands in lists of a scene, each with what it hangs on.
    Things,
    /// Boxes, in a model with nothing but them and their shading groups.
    Boxes,
    /// Keys, in tracks with nothing but them.
    Keys,
}

macro_rules! lists {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        /// Those of the scene's things that are among `kept`, and nothing else.
        fn part(scene: &Scene, kept: &BTreeSet<Thing>) -> Scene {
            Scene {
                next_id: scene.next_id,
                $($list: scene.$list.iter().filter(|value| kept.contains(&Thing::$Kind(value.id))).cloned().collect(),)*
                ..Scene::default()
            }
        }

        /// All that stands in the scene's lists, but for tracks.
        fn all(scene: &Scene) -> Vec<Thing> {
            let all = [$(scene.$list.iter().map(|value| Thing::$Kind(value.id)).collect::<Vec<_>>(),)*];
            all.into_iter().flatten().filter(|thing| !matches!(thing, Thing::Track(_))).collect()
        }
    };
}
kinds!(lists);

/// Those of `things` that stand in lists of the scene; none if none does.
pub fn things(scene: &Scene, things: &[Thing]) -> Option<Clip> {
    let listed: Vec<Thing> = things.iter().copied().filter(|thing| thing.listed(scene).is_some()).collect();
    let scene = part(scene, &transfer::with_needs(scene, &listed));
    (!listed.is_empty()).then_some(Clip { holds: Holds::Things, scene })
}

/// Boxes of a model; none if none is there.
pub fn boxes(scene: &Scene, model: ModelId, ids: &[BoxId]) -> Option<Clip> {
    let whole = scene.model(model)?;
    let boxes: List<CloudBox> = super::chosen(&whole.boxes, ids).cloned().collect();
    let used = groups_used(&boxes);
    let groups: List<ShadingGroup> = whole.groups.iter().filter(|group| used.contains(&group.id)).cloned().collect();
    if boxes.is_empty() {
        return None;
    }
    let parts = boxes.iter().map(|each| Thing::Box(model, each.id));
    let parts = parts.chain(groups.iter().map(|group| Thing::Group(model, group.id))).collect();
    let mut part = part(scene, &keys::doomed(scene, &parts).into_iter().collect());
    part.models.push(CloudModel { boxes, groups, ..whole.clone() });
    Some(Clip { holds: Holds::Boxes, scene: part })
}

/// Keys of tracks; none if none is chosen.
pub fn keys(scene: &Scene, chosen: &BTreeSet<keys::KeyPlace>) -> Option<Clip> {
    let tracks = keys::copied(scene, chosen);
    let holds = Holds::Keys;
    (!tracks.is_empty()).then(|| Clip { holds, scene: Scene { tracks, ..part(scene, &BTreeSet::new()) } })
}

/// Puts things or boxes into `scene`: boxes into the model `model`. Keys are put by [`keys::pasted`], which knows the time.
///
/// # Errors
/// If boxes have no model to go into.
pub fn pasted(scene: &Scene, clip: &Clip, model: Option<ModelId>) -> Result<Arrangement, Refusal> {
    match clip.holds {
        Holds::Things => Ok(transfer::things(&clip.scene, &pasted_for_themselves(&clip.scene), scene)),
        Holds::Boxes => {
            let model = model.and_then(|id| scene.model(id)).ok_or(Refusal::NoModel)?;
            Ok(boxes_into(scene, model, &clip.scene))
        }
        Holds::Keys => Ok(Arrangement::default()),
    }
}

/// Boxes of one model moved into the model `into`, with their shading groups and tracks: as if cut and pasted there.
pub fn moved(scene: &Scene, things: &[Thing], into: ModelId) -> Arrangement {
    let of = |thing: &Thing| if let Thing::Box(model, id) = thing { Some((*model, *id)) } else { None };
    let Some((from, _)) = things.iter().find_map(of).filter(|(from, _)| *from != into) else {
        return Arrangement::default();
    };
    let ids: Vec<BoxId> = things.iter().filter_map(of).filter(|(model, _)| *model == from).map(|(_, id)| id).collect();
    let pasted = boxes(scene, from, &ids).and_then(|clip| pasted(scene, &clip, Some(into)).ok());
    let Some(mut moved) = pasted else { return Arrangement::default() };
    let gone: Vec<Thing> = ids.into_iter().map(|id| Thing::Box(from, id)).collect();
    moved.edits.extend(super::delete::things(scene, &gone).edits);
    moved
}

/// All but what is there for others' sake.
fn pasted_for_themselves(clip: &Scene) -> Vec<Thing> {
    let mut things = all(clip);
    let on = |thing: &Thing| {
        let value = thing.listed(clip);
        let named = [value.and_then(InScene::hangs_on), value.and_then(InScene::kept_in)];
        named.into_iter().flatten().map(|(_, on)| on)
    };
    let needed: BTreeSet<Thing> = things.iter().flat_map(on).collect();
    things.retain(|thing| !needed.contains(thing));
    things
}

/// The boxes of all models of `clip`, as copies in `model`: groups that it has already are shared. Where one would lie on
/// another, all come beside them.
fn boxes_into(scene: &Scene, model: &CloudModel, clip: &Scene) -> Arrangement {
    let mut plan = Plan::new(scene);
    let mut copied = Copied::default();
    let mut names = Names::new(model.boxes.iter().map(|each| each.name.as_str()));
    for from in &clip.models {
        let offset = aside(from, model);
        let (shared, own): (Vec<_>, Vec<_>) = from.groups.iter().partition(|group| model.groups.contains(group));
        let shared: BTreeSet<GroupId> = shared.into_iter().map(|group| group.id).collect();
        let (groups, mut boxes) = copy_parts(own.iter().copied(), &from.boxes, &mut plan.next_id);
        copied.parts((from.id, own, &from.boxes), (model.id, &groups, &boxes));
        for (new, old) in boxes.iter_mut().zip(&from.boxes) {
            new.center += offset;
            if !old.name.is_empty() {
                new.name = names.free(&old.name);
            }
            let mut old = old.clone();
            for (new, old) in groups_of(new).zip(groups_of(&mut old)) {
                *new = new.or_else(|| old.filter(|id| shared.contains(id)));
            }
        }
        plan.edits.extend(groups.into_iter().map(|group| Edit::Group(model.id, at_end(group))));
        plan.made.extend(boxes.iter().map(|each| Thing::Box(model.id, each.id)));
        plan.edits.extend(boxes.into_iter().map(|each| Edit::Box(model.id, at_end(each))));
    }
    copied.insert_tracks_of(clip, &mut plan, DVec3::ZERO);
    plan.done()
}

/// As many widths of all boxes to the east, in the model's space, that none lies on one of `into`.
fn aside(from: &CloudModel, into: &CloudModel) -> DVec3 {
    let ends = from.boxes.iter().map(|each| [each.center.x - 0.5 * each.size.x, each.center.x + 0.5 * each.size.x]);
    let ends = ends.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]).unwrap_or_default();
    let offset = |steps: usize| DVec3::X * (ends[1] - ends[0]) * steps as f64;
    let lies_on = |each: &CloudBox, steps: usize| {
        let center = each.center + offset(steps);
        into.boxes.iter().any(|other| other.center == center && other.size == each.size)
    };
    let is_free = |steps: &usize| !from.boxes.iter().any(|each| lies_on(each, *steps));
    (0..=into.boxes.len()).find(is_free).map_or(DVec3::ZERO, offset)
}

#[cfg(test)]
mod tests {
    use super::super::test_scenes::{applied, assert_same_looks, moved, placed, two_clouds, with_tracks};
    use super::*;
    use crate::problem::{check, scene_with_flight};

    fn paste(scene: &Scene, clip: &Clip, model: Option<ModelId>) -> (Scene, Vec<Thing>) {
        let arrangement = pasted(scene, clip, model).expect("it can be pasted");
        (applied(scene, &arrangement), arrangement.made)
    }

    /// Another scene with one cloud of a model of its own, whose ids are others'.
    fn other_scene() -> Scene {
        let mut scene = scene_with_flight();
        scene.models[0].name = "heap".into();
        scene.clouds[0].name = "cloud".into();
        scene
    }

    #[test]
    fn clouds_come_into_another_scene_with_their_models_and_tracks() {
        let mut scene = two_clouds();
        let (cloud, model) = (scene.clouds[1].id, scene.models[1].id);
        let group = scene.models[1].groups[0].id;
        let tracks = [
            format!("cloud/{cloud}/opacity"),
            format!("model/{model}/group/{group}/light/c_max"),
            format!("cloud/{}/opacity", scene.clouds[0].id),
        ];
        with_tracks(&mut scene, &tracks);
        let clip = things(&scene, &[Thing::Cloud(cloud)]).expect("a cloud");
        assert_eq!((clip.scene.clouds.len(), clip.scene.models.len(), clip.scene.tracks.len()), (1, 1, 2));
        let other = other_scene();
        let (after, made) = paste(&other, &clip, None);
        assert_eq!((after.clouds.len(), after.models.len()), (2, 2));
        let new = &after.clouds[1];
        assert_eq!(made, [Thing::Cloud(new.id)]);
        assert_eq!(
            (new.position, new.name.as_str(), after.models[1].name.as_str()),
            (scene.clouds[1].position, "cloud 2", "heap 2")
        );
        assert_same_looks(&placed(&after, 1), &placed(&scene, 1));
        assert_eq!(moved(&after).len(), 2, "and its tracks, of its own things");
        // Once more: the model is shared, and the cloud comes beside its like.
        let (twice, _) = paste(&after, &clip, None);
        assert_eq!((twice.clouds.len(), twice.models.len(), twice.tracks.len()), (3, 2, 3));
        assert_eq!(twice.clouds[2].model, new.model);
        assert!(twice.clouds[2].position.x > new.position.x + 500.0);
        // A model that was changed since is another one.
        let mut changed = after.clone();
        changed.models[1].boxes[0].sprite_count += 1;
        assert_eq!(paste(&changed, &clip, None).0.models.len(), 3);
        let mut unkeyed = after.clone();
        unkeyed.tracks.retain(|track| !track.property.starts_with("model"));
        assert_eq!(paste(&unkeyed, &clip, None).0.models.len(), 3, "it does not move as this one does");
    }

    #[test]
    fn what_is_chosen_for_itself_is_copied() {
        let scene = scene_with_flight();
        let (model, path, aircraft, camera) =
            (scene.models[0].id, scene.paths[0].id, scene.aircraft[0].id, scene.cameras[0].id);
        let chosen = [Thing::Model(model), Thing::Aircraft(aircraft), Thing::Camera(camera)];
        let clip = things(&scene, &chosen).expect("some");
        let (after, made) = paste(&scene, &clip, None);
        assert_eq!((after.models.len(), after.paths.len(), after.aircraft.len(), after.cameras.len()), (2, 1, 2, 2));
        assert_eq!(after.aircraft[1].path, path, "its path is there");
        assert_eq!(made.len(), 3);
        assert_ne!(after.aircraft[1].ahead_s, after.aircraft[0].ahead_s, "it would hide its like");
        assert_eq!(check(&after).len(), check(&scene).len());
        // In another scene, the path comes along, and nothing has to step aside.
        let bare = Scene { cameras: List::new(), ..Scene::default() };
        let (after, _) = paste(&bare, &clip, None);
        assert_eq!((after.paths.len(), after.aircraft.len()), (1, 1));
        assert_eq!(after.aircraft[0].ahead_s, scene.aircraft[0].ahead_s);
        assert_eq!(things(&scene, &[Thing::Box(model, scene.models[0].boxes[0].id)]), None, "a box is in no list");
    }

    #[test]
    fn boxes_come_into_the_model_that_is_told() {
        let scene = two_clouds();
        let (first, second) = (&scene.models[0], &scene.models[1]);
        let ids: Vec<BoxId> = first.boxes.iter().map(|each| each.id).collect();
        let clip = boxes(&scene, first.id, &ids[..2]).expect("boxes");
        assert_eq!(pasted(&scene, &clip, None), Err(Refusal::NoModel));
        let (after, made) = paste(&scene, &clip, Some(second.id));
        let model = &after.models[1];
        assert_eq!((model.boxes.len(), model.groups.len(), made.len()), (5, 2, 2));
        assert_eq!(model.boxes[3].center, first.boxes[0].center);
        assert_eq!(model.boxes[4].group, Some(model.groups[1].id));
        // In the model that they are of, they share its groups and come beside.
        let (after, _) = paste(&scene, &clip, Some(first.id));
        let model = &after.models[0];
        assert_eq!((model.boxes.len(), model.groups.len()), (5, 1));
        assert_eq!(model.boxes[4].group, first.boxes[1].group);
        assert!(model.boxes[3].center.x > first.boxes[0].center.x);
        assert_eq!(check(&after), []);
    }

    #[test]
    fn boxes_are_moved_into_another_model() {
        let mut scene = two_clouds();
        let [first, second] = [0, 1].map(|at| scene.models[at].id);
        let chosen = scene.models[0].boxes[1].id;
        with_tracks(&mut scene, &[format!("model/{first}/box/{chosen}/light/c_max")]);
        let arrangement = super::moved(&scene, &[Thing::Box(first, chosen)], second);
        let after = applied(&scene, &arrangement);
        assert_eq!(after.models.iter().map(|model| model.boxes.len()).collect::<Vec<_>>(), [2, 4]);
        let new = &after.models[1].boxes[3];
        assert_eq!(arrangement.made, [Thing::Box(second, new.id)]);
        assert_eq!((new.size, new.key), (scene.models[0].boxes[1].size, Some(chosen.0)), "it looks as before");
        assert_eq!((after.models[1].groups.len(), new.group), (2, Some(after.models[1].groups[1].id)));
        assert_eq!(after.tracks.len(), 1);
        assert_eq!(after.tracks[0].property, format!("model/{second}/box/{}/light/c_max", new.id));
        assert_eq!(super::moved(&scene, &[Thing::Box(first, chosen)], first), Arrangement::default());
        assert_eq!(super::moved(&scene, &[Thing::Cloud(scene.clouds[0].id)], second), Arrangement::default());
    }

    #[test]
    fn keys_are_alone_in_their_tracks() {
        let mut scene = two_clouds();
        with_tracks(&mut scene, &["sky/exposure_ev".into(), "sky/gain".into()]);
        let clip = keys(&scene, &[(scene.tracks[1].id, 0)].into()).expect("a key");
        assert_eq!((clip.holds, clip.scene.tracks.len(), clip.scene.clouds.len()), (Holds::Keys, 1, 0));
        assert_eq!(keys(&scene, &BTreeSet::new()), None);
    }
}
