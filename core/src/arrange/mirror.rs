//! Boxes of a model as in a mirror, which stands in the middle of those that are mirrored.
//!
//! With M the reflection in the model's space, a box at c, turned by R, of size s, comes to M c, turned by M R M: again
//! a rotation, and as the size stays, a point p of the box's own space comes to M p. So hand-moved sprites and centres
//! put by hand are mirrored truly, and the range of the sprites' own turn changes its sign. Strewn sprites keep their
//! random places *within* the box: they fill the mirrored box, but are no mirror image of what filled the old one.
//!
//! Mirroring a cloud mirrors its model's boxes, in all its clouds; [`super::duplicate::make_own`] parts them first.

use super::copy::groups_used;
use super::{Arrangement, Plan, Thing, chosen};
use crate::document::{Edit, ListEdit};
use crate::scene::{BoxId, CloudBox, CloudId, CloudModel, GroupCenter, GroupLight, ModelId, Scene, ShadingGroup};
use glam::{DMat3, DQuat, DVec3};

/// Along which of the model's axes left and right are exchanged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Axis {
    /// East and west, for a cloud that looks north.
    X,
    /// Up and down.
    Y,
    /// North and south, for a cloud that looks north.
    Z,
}

/// Mirrors boxes of a model. Named groups go with them if no other box is in them.
pub fn boxes(scene: &Scene, model: ModelId, ids: &[BoxId], axis: Axis) -> Arrangement {
    let mut plan = Plan::new(scene);
    if let Some(model) = scene.model(model) {
        let all: Vec<&CloudBox> = chosen(&model.boxes, ids).collect();
        mirror(&mut plan, model, &all, axis);
        plan.made.extend(all.iter().map(|each| Thing::Box(model.id, each.id)));
    }
    plan.done()
}

/// Mirrors all boxes of the clouds' models, each model once.
pub fn clouds(scene: &Scene, ids: &[CloudId], axis: Axis) -> Arrangement {
    let mut plan = Plan::new(scene);
    let models: Vec<ModelId> = chosen(&scene.clouds, ids).map(|cloud| cloud.model).collect();
    for model in chosen(&scene.models, &models) {
        mirror(&mut plan, model, &model.boxes.iter().collect::<Vec<_>>(), axis);
    }
    plan.made.extend(chosen(&scene.clouds, ids).map(|cloud| Thing::Cloud(cloud.id)));
    plan.done()
}

fn mirror(plan: &mut Plan<'_>, model: &CloudModel, boxes: &[&CloudBox], axis: Axis) {
    let Some(middle) = middle(boxes) else { return };
    let mirror = Mirror { axis, middle };
    let others = groups_used(model.boxes.iter().filter(|each| boxes.iter().all(|one| one.id != each.id)));
    let groups = groups_used(boxes.iter().copied());
    for group in model.groups.iter().filter(|group| groups.contains(&group.id) && !others.contains(&group.id)) {
        let light = mirror.light(group.light);
        if light != group.light {
            plan.edits.push(Edit::Group(model.id, ListEdit::Replace(ShadingGroup { light, ..group.clone() })));
        }
    }
    for old in boxes {
        plan.replace_box(model.id, mirror.cloud_box(old));
    }
}

/// Of the bounds, along the model's axes, of all that the boxes hold.
fn middle(boxes: &[&CloudBox]) -> Option<DVec3> {
    let bounds = boxes.iter().map(|each| {
        let turn = DMat3::from_quat(each.orientation);
        let half = each.size * 0.5;
        let reach = turn.x_axis.abs() * half.x + turn.y_axis.abs() * half.y + turn.z_axis.abs() * half.z;
        (each.center - reach, each.center + reach)
    });
    let (low, high) = bounds.reduce(|(a, b), (low, high)| (a.min(low), b.max(high)))?;
    Some((low + high) * 0.5)
}

struct Mirror {
    axis: Axis,
    middle: DVec3,
}

impl Mirror {
    /// Changes the sign along the axis. Adding 0 turns −0 into 0.
    fn vector(&self, v: DVec3) -> DVec3 {
        let signs = match self.axis {
            Axis::X => DVec3::new(-1.0, 1.0, 1.0),
            Axis::Y => DVec3::new(1.0, -1.0, 1.0),
            Axis::Z => DVec3::new(1.0, 1.0, -1.0),
        };
        v * signs + 0.0
    }

    fn point(&self, p: DVec3) -> DVec3 {
        self.middle + self.vector(p - self.middle)
    }

    /// M R M. An axis of rotation is a pseudovector: it is mirrored with the opposite sign.
    fn turn(&self, q: DQuat) -> DQuat {
        let axis = self.vector(-DVec3::new(q.x, q.y, q.z));
        DQuat::from_xyzw(axis.x, axis.y, axis.z, q.w)
    }

    fn light(&self, light: GroupLight) -> GroupLight {
        let center = match light.center {
            GroupCenter::At(point) => GroupCenter::At(self.point(point)),
            center => center,
        };
        GroupLight { center, ..light }
    }

    fn cloud_box(&self, old: &CloudBox) -> CloudBox {
        let mut new = old.clone();
        new.center = self.point(old.center);
        new.orientation = self.turn(old.orientation);
        let [from, to] = old.rotation_deg;
        // A full turn is one whichever way it runs.
        if to - from < 360.0 {
            new.rotation_deg = [0.0 - to, 0.0 - from];
        }
        new.light = self.light(old.light);
        for edit in &mut new.sprite_edits {
            edit.moved = edit.moved.map(|place| self.vector(place));
            edit.rotation_deg = edit.rotation_deg.map(|deg| 0.0 - deg);
        }
        new
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_scenes::{applied, two_clouds};
    use super::*;
    use crate::scene::SpriteEdit;
    use crate::sprites::candidates;

    /// A scene whose first model's boxes have a few sprites moved by hand.
    fn with_moved_sprites() -> Scene {
        let mut scene = two_clouds();
        for cloud_box in &mut scene.models[0].boxes {
            cloud_box.rotation_deg = [-5.0, 20.0];
            cloud_box.light.center = GroupCenter::At(DVec3::new(7.0, 8.0, 9.0));
            let places = [DVec3::new(0.5, -0.25, 0.1), DVec3::new(-0.4, 0.3, 0.7)];
            cloud_box.sprite_edits = (0..)
                .zip(places)
                .map(|(index, place)| SpriteEdit {
                    moved: Some(place),
                    rotation_deg: Some(12.0),
                    ..SpriteEdit::new(index)
                })
                .collect();
        }
        scene
    }

    /// Its centre, if put by hand.
    fn by_hand(light: GroupLight) -> DVec3 {
        if let GroupCenter::At(center) = light.center { center } else { DVec3::NAN }
    }

    fn moved_sprites(model: &CloudModel) -> Vec<DVec3> {
        candidates(model, 1).iter().filter(|c| c.moved).map(|c| c.position).collect()
    }

    #[test]
    fn what_hands_placed_is_mirrored_through_the_middle() {
        let scene = with_moved_sprites();
        let model = &scene.models[0];
        let middle = middle(&model.boxes.iter().collect::<Vec<_>>()).expect("there are boxes");
        for (axis, i) in [(Axis::X, 0), (Axis::Y, 1), (Axis::Z, 2)] {
            let after = applied(&scene, &clouds(&scene, &[scene.clouds[0].id], axis));
            let flip = |mut p: DVec3| {
                p[i] = 2.0 * middle[i] - p[i];
                p
            };
            let (old, new) = (moved_sprites(model), moved_sprites(&after.models[0]));
            assert_eq!(old.len(), 6);
            for (old, new) in old.iter().zip(&new) {
                assert!(flip(*old).distance(*new) < 1e-9, "{axis:?}: {old} to {new}");
            }
            for (old, new) in model.boxes.iter().zip(&after.models[0].boxes) {
                assert_eq!(new.rotation_deg, [-20.0, 5.0]);
                assert!(by_hand(new.light).distance(flip(DVec3::new(7.0, 8.0, 9.0))) < 1e-9);
                assert!(new.orientation.is_normalized() && new.size == old.size);
            }
            assert!(by_hand(after.models[0].groups[0].light).distance(flip(DVec3::new(10.0, 20.0, 1.0))) < 1e-9);
            assert_eq!(after.models[1], scene.models[1]);
        }
    }

    #[test]
    fn twice_is_as_before() {
        let scene = with_moved_sprites();
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let ids: Vec<_> = scene.models[0].boxes.iter().map(|each| each.id).collect();
            let once = applied(&scene, &boxes(&scene, scene.models[0].id, &ids, axis));
            let twice = applied(&once, &boxes(&once, scene.models[0].id, &ids, axis));
            for (a, b) in moved_sprites(&scene.models[0]).iter().zip(moved_sprites(&twice.models[0])) {
                assert!(a.distance(b) < 1e-9, "{a} and {b}");
            }
            assert_eq!(scene.models[0].boxes[2].orientation, twice.models[0].boxes[2].orientation);
        }
    }

    #[test]
    fn a_group_that_others_are_in_stays() {
        let scene = with_moved_sprites();
        let model = &scene.models[0];
        let arrangement = boxes(&scene, model.id, &[model.boxes[1].id, BoxId(9999)], Axis::X);
        let after = applied(&scene, &arrangement);
        assert_eq!(after.models[0].groups, model.groups);
        assert_eq!(after.models[0].boxes[2], model.boxes[2]);
        assert_eq!(boxes(&scene, model.id, &[], Axis::X), Arrangement::default());
    }
}
