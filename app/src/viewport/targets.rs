//! What a gizmo works on: the selected things as they were when the drag began, and where each goes.
//!
//! Every frame of a drag starts from there, so nothing drifts. Boxes and sprites are moved in the world of the cloud
//! that they are seen in. What is locked or hidden stays. A thing whose whole is selected too moves with the whole.

use super::places::Places;
use crate::state::{Item, Reading, Tool, ViewState, box_of, group_of};
use cloudwright_core::arrange::{ModelSpace, fill, sprites};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::{BOX_SIZE, CLOUD_SCALE, POSITION};
use cloudwright_core::scene::{
    BoxId, Cloud, CloudBox, CloudId, GroupCenter, InScene, ModelId, PoseMut, Scene, ShadingGroup,
};
use cloudwright_core::sprites::GroupKey;
use glam::{DQuat, DVec3, EulerRot};
use std::f64::consts::PI;

/// What the hand does to the targets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Act {
    /// Metres in the world.
    Move(DVec3),
    /// About an axis in the world, radians.
    Turn(DVec3, f64),
    /// Factors along the axes of a single box; of anything else along x for all.
    Stretch(DVec3),
}

/// The selected things, from the beginning of a drag.
#[derive(Debug, Clone)]
pub(super) struct Targets {
    /// Where they are seen, and how far the air has carried them there.
    clouds: Vec<(Cloud, DVec3)>,
    boxes: Vec<(ModelSpace, ModelId, CloudBox)>,
    /// Cameras, paths and what else has poses, each in an edit that would leave it as it was, with the pose that is
    /// worked on, if it is one.
    posed: Vec<(Edit, Option<usize>)>,
    /// With their places in the world.
    sprites: Vec<(Cloud, sprites::SpriteId, DVec3)>,
    /// A group whose centre is moved, and where it lies in the world.
    group: Option<(ModelSpace, ModelId, ShadingGroup, DVec3)>,
    /// Whether sprites go along with the size of their box.
    keeps_fill: bool,
    /// The middle of all, in the world.
    pub(super) pivot: DVec3,
    /// The axes that they are moved along: a single box's own, else the world's.
    pub(super) turn: DQuat,
}

impl Targets {
    /// What `tool` can work on of the selection; none if there is nothing.
    pub(super) fn of(tool: Tool, reading: &Reading<'_>) -> Option<Self> {
        let (view, scene) = (reading.view, reading.session.scene());
        let mut targets = Self {
            clouds: Vec::new(),
            boxes: Vec::new(),
            posed: Vec::new(),
            sprites: Vec::new(),
            group: None,
            keeps_fill: view.keep_fill,
            pivot: DVec3::ZERO,
            turn: DQuat::IDENTITY,
        };
        let (seen, mut places) = (Places::of(reading), Vec::new());
        for item in view.selection.items() {
            places.extend(targets.add(*item, tool, &seen, reading, scene));
        }
        targets.pivot = places.iter().copied().reduce(|a, b| a + b)? / places.len() as f64;
        if let ([(space, _, only)], 1) = (targets.boxes.as_slice(), places.len()) {
            targets.turn = (space.turn * only.orientation).normalize();
        }
        targets.pivot.is_finite().then_some(targets)
    }

    /// Adds one thing; its place in the world.
    fn add(
        &mut self,
        item: Item,
        tool: Tool,
        places: &Places<'_>,
        reading: &Reading<'_>,
        scene: &Scene,
    ) -> Option<DVec3> {
        let view = reading.view;
        match item {
            Item::Cloud(id) => {
                let cloud = scene.cloud(id).filter(|cloud| view.can_pick(scene, cloud))?;
                let now = places.seen(cloud).into_owned();
                let middle = places.middle(cloud);
                self.clouds.push((now, places.drift(cloud)));
                Some(middle)
            }
            Item::Box(model, id) => {
                let cloud = seen_in(model, view, scene)?;
                let each = box_of(scene, model, id).filter(|_| may_move(item, model, view, scene))?;
                let space = ModelSpace::of(&places.seen(cloud));
                self.boxes.push((space, model, each.clone()));
                Some(space.to_world(each.center))
            }
            Item::Sprite(model, id, index) if tool == Tool::Move => {
                let cloud = seen_in(model, view, scene)?;
                let its_box = Item::Box(model, id);
                if view.selection.contains(its_box) || !may_move(its_box, model, view, scene) {
                    return None;
                }
                let placed = reading.session.placed(cloud.id)?;
                let sprite = placed.sprites.iter().find(|sprite| (sprite.box_id, sprite.index) == (id, index))?;
                let place = placed.origin + sprite.position.as_dvec3();
                self.sprites.push((cloud.clone(), (id, index), place));
                Some(place)
            }
            Item::Group(model, id) if tool == Tool::Move && view.selection.primary() == Some(item) => {
                let cloud = seen_in(model, view, scene)?;
                let group = group_of(scene, model, id).filter(|_| may_move(item, model, view, scene))?;
                let space = ModelSpace::of(cloud);
                let place = match group.light.center {
                    GroupCenter::At(place) => space.to_world(place),
                    _ => {
                        let placed = reading.session.placed(cloud.id)?;
                        let found = placed.groups.iter().find(|group| group.key == GroupKey::Named(id))?;
                        placed.origin + found.center.as_dvec3()
                    }
                };
                self.group = Some((space, model, group.clone(), place));
                Some(place)
            }
            _ if tool != Tool::Scale => {
                let mut edit = Edit::replacing(scene, item)?;
                let places: Vec<DVec3> = edit.value_mut()?.poses_mut().iter().map(|pose| *pose.position).collect();
                let key = if let Item::Path(id) = item { view.key_of(id) } else { None };
                let key = key.filter(|index| *index < places.len());
                let middle = || Some(places.iter().copied().reduce(|a, b| a + b)? / places.len() as f64);
                let place = key.map_or_else(middle, |index| places.get(index).copied())?;
                self.posed.push((edit, key));
                Some(place)
            }
            _ => None,
        }
    }

    /// Whether only turns about the vertical make sense.
    pub(super) fn stay_upright(&self) -> bool {
        !self.clouds.is_empty()
    }

    /// Whether it is one box, which may be stretched along its axes.
    pub(super) fn is_single_box(&self) -> bool {
        self.boxes.len() == 1 && self.clouds.is_empty() && self.posed.is_empty()
    }

    /// Whether that box of that cloud goes along: itself, with its cloud, or with its model.
    pub(super) fn moves(&self, cloud: CloudId, model: ModelId, id: BoxId) -> bool {
        let its_cloud = self.clouds.iter().any(|(each, _)| each.id == cloud);
        its_cloud || self.boxes.iter().any(|(_, of, each)| (*of, each.id) == (model, id))
    }

    /// How far each box and cloud reaches along `direction` from the world's origin, both ways, metres.
    pub(super) fn reaches(&self, direction: DVec3, scene: &Scene) -> Vec<f64> {
        let box_reach = |space: &ModelSpace, each: &CloudBox| {
            let along = |axis: usize| (space.turn * (each.orientation * DVec3::AXES[axis])).dot(direction).abs();
            let half = (0..3).map(|axis| along(axis) * each.size[axis] * 0.5).sum::<f64>() * space.scale;
            let middle = space.to_world(each.center).dot(direction);
            [middle - half, middle + half]
        };
        let of_boxes = self.boxes.iter().map(|(space, _, each)| box_reach(space, each));
        let of_clouds = self.clouds.iter().filter_map(|(cloud, _)| {
            let space = ModelSpace::of(cloud);
            let reaches = scene.model(cloud.model)?.boxes.iter().map(|each| box_reach(&space, each));
            reaches.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
        });
        of_boxes.chain(of_clouds).flatten().collect()
    }

    /// The clouds where `act` brings them, without what the air does.
    pub(super) fn moved_clouds(&self, act: Act) -> impl Iterator<Item = Cloud> {
        self.clouds.iter().map(move |(cloud, drift)| {
            let moved = self.cloud(cloud, act);
            let position = if *drift == DVec3::ZERO { moved.position } else { short(moved.position - *drift) };
            Cloud { position, ..moved }
        })
    }

    /// What brings all but clouds where `act` says. `scene` is the one of this frame.
    pub(super) fn edits(&self, act: Act, scene: &Scene) -> Vec<Edit> {
        let mut edits = Vec::new();
        edits.extend(
            self.boxes
                .iter()
                .map(|(space, model, each)| Edit::Box(*model, ListEdit::Replace(self.cloud_box(space, each, act)))),
        );
        edits.extend(self.posed.iter().map(|(edit, key)| {
            let mut edit = edit.clone();
            if let Some(value) = edit.value_mut() {
                self.carry(value, *key, act);
            }
            edit
        }));
        edits.extend(self.group.as_ref().map(|(space, model, group, place)| {
            let mut group = group.clone();
            group.light.center = GroupCenter::At(space.from_world(self.place(*place, act)));
            Edit::Group(*model, ListEdit::Replace(group))
        }));
        // All sprites of a cloud at once: an edit replaces a whole box.
        let mut rest = self.sprites.as_slice();
        while let Some((cloud, ..)) = rest.first() {
            let count = rest.iter().take_while(|(of, ..)| of.id == cloud.id).count();
            let (these, others) = rest.split_at(count);
            let places: Vec<_> = these.iter().map(|(_, id, place)| (*id, self.place(*place, act))).collect();
            edits.extend(sprites::moved_in_world(scene, cloud, &places).edits);
            rest = others;
        }
        edits
    }

    /// Where a place of the world goes.
    fn place(&self, place: DVec3, act: Act) -> DVec3 {
        let from_pivot = place - self.pivot;
        let new = match act {
            Act::Move(by) => place + by,
            Act::Turn(axis, angle) => self.pivot + DQuat::from_axis_angle(axis, angle) * from_pivot,
            Act::Stretch(by) => self.pivot + from_pivot * by.x,
        };
        let bound = DVec3::splat(POSITION.max);
        if new.is_finite() { short(new).clamp(-bound, bound) } else { place }
    }

    fn cloud(&self, old: &Cloud, act: Act) -> Cloud {
        let mut new = Cloud { position: self.place(old.position, act), ..old.clone() };
        match act {
            Act::Move(_) => {}
            Act::Turn(axis, angle) => new.heading_deg = turned(old.heading_deg, axis.y.signum() * angle),
            Act::Stretch(by) => {
                new.scale = short_number(old.scale * by.x, 1e6).clamp(CLOUD_SCALE.min, CLOUD_SCALE.max);
            }
        }
        new
    }

    fn cloud_box(&self, space: &ModelSpace, old: &CloudBox, act: Act) -> CloudBox {
        let place = |act| short(space.from_world(self.place(space.to_world(old.center), act)));
        match act {
            Act::Move(_) => CloudBox { center: place(act), ..old.clone() },
            Act::Turn(axis, angle) => {
                let turn = space.turn.conjugate() * DQuat::from_axis_angle(axis, angle) * space.turn;
                CloudBox { center: place(act), orientation: (turn * old.orientation).normalize(), ..old.clone() }
            }
            Act::Stretch(by) => {
                let by = if self.is_single_box() { by } else { DVec3::splat(by.x) };
                let size = short(old.size * by).clamp(DVec3::splat(BOX_SIZE.min), DVec3::splat(BOX_SIZE.max));
                let center = if self.is_single_box() { old.center } else { place(act) };
                let resized = if self.keeps_fill { fill::resized(old, size) } else { CloudBox { size, ..old.clone() } };
                CloudBox { center, ..resized }
            }
        }
    }

    /// One pose of a thing, or all of them.
    fn carry(&self, value: &mut dyn InScene, key: Option<usize>, act: Act) {
        let poses = value.poses_mut().into_iter().enumerate();
        for (_, pose) in poses.filter(|(index, _)| key.is_none_or(|key| key == *index)) {
            self.carry_pose(pose, act);
        }
    }

    fn carry_pose(&self, pose: PoseMut<'_>, act: Act) {
        *pose.position = self.place(*pose.position, act);
        let (Act::Turn(axis, angle), Some([heading_deg, pitch_deg, roll_deg])) = (act, pose.attitude_deg) else {
            return;
        };
        if axis.y.abs() > 1.0 - 1e-9 {
            *heading_deg = turned(*heading_deg, axis.y.signum() * angle);
            return;
        }
        let [heading, pitch, roll] = [*heading_deg, *pitch_deg, *roll_deg].map(f64::to_radians);
        let turn = DQuat::from_axis_angle(axis, angle) * DQuat::from_euler(EulerRot::YXZ, -heading, pitch, -roll);
        let (yaw, pitch, roll) = turn.normalize().to_euler(EulerRot::YXZ);
        let degrees = |radians: f64| short_number(radians.to_degrees(), 1e6);
        (*heading_deg, *pitch_deg, *roll_deg) = (degrees(-yaw), degrees(pitch), degrees(-roll));
    }
}

/// A heading after a turn about the world's up. Headings turn clockwise from above, which is negative about +y.
fn turned(heading_deg: f64, angle: f64) -> f64 {
    let heading = short_number(heading_deg - angle * 180.0 / PI, 1e6);
    (heading + 180.0).rem_euclid(360.0) - 180.0
}

/// To the tenth of a millimetre: no hand is finer, and snapped numbers stay short.
fn short(place: DVec3) -> DVec3 {
    (place * 1e4).round() / 1e4
}

fn short_number(number: f64, parts: f64) -> f64 {
    (number * parts).round() / parts
}

/// The cloud in which a model's boxes are moved.
fn seen_in<'s>(model: ModelId, view: &ViewState, scene: &'s Scene) -> Option<&'s Cloud> {
    let picked = view.selection.cloud(scene).filter(|cloud| cloud.model == model);
    let cloud = picked.or_else(|| scene.clouds.iter().find(|cloud| cloud.model == model))?;
    (view.can_pick(scene, cloud) && cloud.scale > 0.0).then_some(cloud)
}

/// Neither locked nor hidden, nor moved along with a cloud of its model.
fn may_move(item: Item, model: ModelId, view: &ViewState, scene: &Scene) -> bool {
    let with_cloud = view.selection.clouds().any(|id| scene.cloud(id).is_some_and(|cloud| cloud.model == model));
    !with_cloud && !view.locked.contains(&item) && !view.hidden.contains(&item)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::camera::View;
    use cloudwright_core::scene::{BoxId, Camera, CameraPath, PathKey};

    fn carried<T: InScene + Clone>(targets: &Targets, old: &T, key: Option<usize>, act: Act) -> T {
        let mut new = old.clone();
        targets.carry(&mut new, key, act);
        new
    }

    fn targets(pivot: DVec3) -> Targets {
        Targets {
            clouds: Vec::new(),
            boxes: Vec::new(),
            posed: Vec::new(),
            sprites: Vec::new(),
            group: None,
            keeps_fill: true,
            pivot,
            turn: DQuat::IDENTITY,
        }
    }

    #[test]
    fn boxes_move_in_the_world_through_their_cloud() {
        let space = ModelSpace { origin: DVec3::new(1e6, 0.0, 1e6), turn: DQuat::from_rotation_y(0.7), scale: 3.0 };
        let old = CloudBox::new(BoxId(1), DVec3::new(10.0, 20.0, 30.0));
        let targets = targets(space.to_world(old.center));
        let by = DVec3::new(50.0, -25.0, 100.0);
        let new = targets.cloud_box(&space, &old, Act::Move(by));
        let moved = space.to_world(new.center) - space.to_world(old.center);
        assert!(moved.distance(by) < 1e-3, "{moved}");
        let new = targets.cloud_box(&space, &old, Act::Turn(DVec3::X, 0.5));
        let axis = |each: &CloudBox| space.turn * each.orientation * DVec3::Y;
        assert!((axis(&new) - DQuat::from_rotation_x(0.5) * axis(&old)).length() < 1e-9);
        assert!(space.to_world(new.center).distance(targets.pivot) < 1e-3, "about its own middle");
    }

    #[test]
    fn cameras_turn_as_the_world_would() {
        let mut old = Camera::free(DVec3::new(5.0, 6.0, 7.0));
        (old.heading_deg, old.pitch_deg, old.roll_deg) = (33.0, -12.0, 8.0);
        let axis = DVec3::new(0.6, 0.0, 0.8);
        let new = carried(&targets(old.position), &old, None, Act::Turn(axis, 0.4));
        let turn = DQuat::from_axis_angle(axis, 0.4);
        let (a, b) = (View::new(&old, 9, 9), View::new(&new, 9, 9));
        for (a, b) in [(a.forward, b.forward), (a.up, b.up), (a.right, b.right)] {
            assert!((turn * a.as_dvec3()).distance(b.as_dvec3()) < 1e-5, "{b}");
        }
        let level = carried(&targets(old.position), &old, None, Act::Turn(DVec3::NEG_Y, 0.5_f64.to_radians()));
        assert_eq!((level.heading_deg, level.pitch_deg, level.roll_deg), (33.5, -12.0, 8.0));
    }

    #[test]
    fn a_key_turns_alone_and_a_path_as_a_whole() {
        let key = |i: i32| PathKey {
            time_s: f64::from(i),
            position: DVec3::X * (100.0 * f64::from(i)),
            heading_deg: 90.0,
            pitch_deg: 0.0,
            roll_deg: 0.0,
        };
        let path = CameraPath::free((0..3).map(key).collect());
        let pivot = path.keys[1].position;
        let turn = Act::Turn(DVec3::NEG_Y, 90_f64.to_radians());
        let alone = carried(&targets(pivot), &path, Some(1), turn);
        assert_eq!((alone.keys[0], alone.keys[2]), (path.keys[0], path.keys[2]));
        assert_eq!((alone.keys[1].position, alone.keys[1].heading_deg), (pivot, -180.0));
        let whole = carried(&targets(pivot), &path, None, turn);
        for (key, z) in whole.keys.iter().zip([-100.0, 0.0, 100.0]) {
            assert!(key.position.distance(DVec3::new(100.0, 0.0, z)) < 1e-3 && key.heading_deg == -180.0, "{key:?}");
        }
    }

    #[test]
    fn bad_numbers_move_nothing() {
        let targets = targets(DVec3::ZERO);
        let place = DVec3::new(1.0, 2.0, 3.0);
        assert_eq!(targets.place(place, Act::Move(DVec3::NAN)), place);
        assert_eq!(targets.place(place, Act::Move(DVec3::splat(1e30))), DVec3::splat(POSITION.max));
    }
}
