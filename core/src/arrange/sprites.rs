//! Single sprites by hand: move, drop, and give back to chance.
//!
//! What is changed by hand is saved in its box by the sprite's index, its place as a share of the box. So it survives
//! whatever else is changed about the box: it goes along when the box is moved, turned or stretched, and stays when the
//! other sprites are strewn anew.

use super::{Arrangement, ModelSpace, Plan, Thing};
use crate::property::SPRITE_PLACE;
use crate::scene::{BoxId, Cloud, CloudBox, CloudModel, ModelId, Scene, SpriteEdit};
use glam::DVec3;
use std::collections::BTreeMap;

/// A sprite of a model: its box and its index there.
pub type SpriteId = (BoxId, u32);

/// Moves sprites of a model to places in its space, metres.
pub fn moved(scene: &Scene, model: ModelId, places: &[(SpriteId, DVec3)]) -> Arrangement {
    changed(scene, model, places, |cloud_box, edit, place| {
        if let Some(place) = place_in_box(cloud_box, place) {
            (edit.moved, edit.dropped) = (Some(place), false);
        }
    })
}

/// Moves sprites of a cloud, and with it of its model, to places in the world, metres.
pub fn moved_in_world(scene: &Scene, cloud: &Cloud, places: &[(SpriteId, DVec3)]) -> Arrangement {
    let space = ModelSpace::of(cloud);
    let places: Vec<_> = places.iter().map(|&(sprite, place)| (sprite, space.from_world(place))).collect();
    moved(scene, cloud.model, &places)
}

/// Takes sprites out.
pub fn dropped(scene: &Scene, model: ModelId, sprites: &[SpriteId]) -> Arrangement {
    let sprites: Vec<_> = sprites.iter().map(|&sprite| (sprite, ())).collect();
    changed(scene, model, &sprites, |_, edit, ()| edit.dropped = true)
}

/// The same, in a model that is in no document.
pub(crate) fn drop_from(model: &mut CloudModel, sprites: &[SpriteId]) {
    let mut of_box: BTreeMap<BoxId, Vec<u32>> = BTreeMap::new();
    for &(id, index) in sprites {
        of_box.entry(id).or_default().push(index);
    }
    for at in 0..model.boxes.len() {
        if let Some(indices) = of_box.get(&model.boxes[at].id) {
            change_edits(&mut model.boxes[at], |edits| indices.iter().for_each(|&i| edits.of(i).dropped = true));
        }
    }
}

/// Gives sprites back the places and looks that chance gave them, dropped ones included. They stay in the groups they are
/// in.
pub fn reset(scene: &Scene, model: ModelId, sprites: &[SpriteId]) -> Arrangement {
    let sprites: Vec<_> = sprites.iter().map(|&sprite| (sprite, ())).collect();
    changed(scene, model, &sprites, |_, edit, ()| {
        *edit = SpriteEdit { group: edit.group, ..SpriteEdit::new(edit.index) };
    })
}

/// Where a point of the model's space lies in the box, −½ to ½ along each axis; 0 along an axis without extent, so
/// sprites of a flat box stay in its plane. None if the point is no number.
fn place_in_box(cloud_box: &CloudBox, point: DVec3) -> Option<DVec3> {
    let along = cloud_box.orientation.conjugate() * (point - cloud_box.center);
    let share = |along: f64, extent: f64| {
        if extent > 0.0 { (along / extent).clamp(SPRITE_PLACE.min, SPRITE_PLACE.max) } else { 0.0 }
    };
    let [x, y, z] = [0, 1, 2].map(|axis| share(along[axis], cloud_box.size[axis]));
    point.is_finite().then(|| DVec3::new(x, y, z)).filter(|place| place.is_finite())
}

/// Changes the edits of sprites that their boxes have.
fn changed<T: Copy>(
    scene: &Scene,
    model: ModelId,
    sprites: &[(SpriteId, T)],
    change: impl Fn(&CloudBox, &mut SpriteEdit, T),
) -> Arrangement {
    let mut plan = Plan::new(scene);
    let mut of_box: BTreeMap<BoxId, Vec<(u32, T)>> = BTreeMap::new();
    for &((id, index), value) in sprites {
        of_box.entry(id).or_default().push((index, value));
    }
    for old in scene.model(model).into_iter().flat_map(|model| &model.boxes) {
        let Some(sprites) = of_box.get(&old.id) else { continue };
        let sprites = sprites.iter().filter(|(index, _)| *index < old.sprite_count);
        let mut new = old.clone();
        change_edits(&mut new, |edits| {
            for &(index, value) in sprites {
                change(old, edits.of(index), value);
                plan.made.push(Thing::Sprite(model, old.id, index));
            }
        });
        if new != *old {
            plan.replace_box(model, new);
        }
    }
    plan.done()
}

/// The hand-made changes of a box's sprites by index.
pub(super) struct SpriteEdits(BTreeMap<u32, SpriteEdit>);

impl SpriteEdits {
    /// That sprite's; empty if it has none yet.
    pub(super) fn of(&mut self, index: u32) -> &mut SpriteEdit {
        self.0.entry(index).or_insert(SpriteEdit::new(index))
    }
}

/// Lets `change` at the box's sprite edits; those that say nothing are left out then, and the rest stand by index.
pub(super) fn change_edits(cloud_box: &mut CloudBox, change: impl FnOnce(&mut SpriteEdits)) {
    let edits = std::mem::take(&mut cloud_box.sprite_edits);
    let mut edits = SpriteEdits(edits.into_iter().map(|edit| (edit.index, edit)).collect());
    change(&mut edits);
    let says_something = |edit: &SpriteEdit| *edit != SpriteEdit::new(edit.index);
    cloud_box.sprite_edits = edits.0.into_values().filter(says_something).collect();
}

#[cfg(test)]
mod tests {
    use super::super::test_scenes::{applied, placed, two_clouds};
    use super::*;
    use crate::sprites::candidates;

    #[test]
    fn moves_to_a_place_in_the_world_and_survives_regeneration() {
        let scene = two_clouds();
        let (cloud, cloud_box) = (&scene.clouds[1], &scene.models[1].boxes[2]);
        let place = cloud.position + DVec3::new(1234.5, -67.0, 890.0);
        let arrangement = moved_in_world(&scene, cloud, &[((cloud_box.id, 4), place), ((cloud_box.id, 9999), place)]);
        assert_eq!(arrangement.made, [Thing::Sprite(cloud.model, cloud_box.id, 4)]);
        let mut after = applied(&scene, &arrangement);
        after.models[1].seed = 1234;
        after.models[1].boxes[2].sprite_count += 17;
        after.models[1].boxes[2].key = Some(77);
        after.clouds[1].seed = None;
        let again = placed(&after, 1);
        let sprite = again.sprites.iter().find(|s| s.box_id == cloud_box.id && s.index == 4).expect("never culled");
        assert!((again.origin + sprite.position.as_dvec3()).distance(place) < 1e-2);
    }

    #[test]
    fn drop_and_reset() {
        let scene = two_clouds();
        let (model, id) = (&scene.models[0], scene.models[0].boxes[0].id);
        let without = applied(&scene, &dropped(&scene, model.id, &[(id, 7), (id, 2)]));
        let indices = |scene: &Scene| {
            let of_box = candidates(&scene.models[0], 1).into_iter().filter(|c| c.box_id == id);
            of_box.map(|c| c.index).collect::<Vec<_>>()
        };
        assert_eq!(indices(&without).len() + 2, indices(&scene).len());
        assert!(!indices(&without).contains(&7));
        let half = applied(&without, &moved(&without, model.id, &[((id, 7), DVec3::ONE)]));
        assert!(indices(&half).contains(&7), "what is moved is there again");
        assert_eq!(applied(&half, &reset(&half, model.id, &[(id, 2), (id, 7)])).models, scene.models);
        assert_eq!(reset(&scene, model.id, &[(id, 2)]).edits, []);
    }

    #[test]
    fn degenerate_boxes_and_places() {
        let mut scene = two_clouds();
        scene.models[0].boxes[0].size = DVec3::new(100.0, 0.0, 1e-300);
        let (model, id) = (scene.models[0].id, scene.models[0].boxes[0].id);
        let after = applied(&scene, &moved(&scene, model, &[((id, 0), DVec3::new(30.0, 999.0, 5.0))]));
        let place = after.models[0].boxes[0].sprite_edits[0].moved.expect("moved");
        assert!(place.is_finite() && place.y == 0.0, "{place}");
        for bad in [DVec3::NAN, DVec3::INFINITY, DVec3::new(0.0, f64::NEG_INFINITY, 0.0)] {
            assert_eq!(moved(&scene, model, &[((id, 0), bad)]).edits, []);
        }
        let flat = Cloud { scale: 0.0, ..scene.clouds[0].clone() };
        assert_eq!(moved_in_world(&scene, &flat, &[((id, 0), DVec3::ONE)]).edits, []);
        assert_eq!(dropped(&scene, ModelId(9999), &[(id, 0)]), Arrangement::default());
    }
}
