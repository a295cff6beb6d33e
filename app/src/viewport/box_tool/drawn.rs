//! A box that is being drawn: its footprint and height in the world, and the edits that bring it into the scene.

use crate::starter::{BOX, names_of_boxes};
use crate::state::Reading;
use cloudwright_core::arrange::{ModelSpace, Names, fill};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::BOX_SIZE;
use cloudwright_core::scene::{BoxId, Category, Cloud, CloudBox, CloudId, CloudModel, ModelId, Scene};
use glam::{DQuat, DVec3};

/// Of a box that is not measured, metres.
const SIDE_M: f64 = 500.0;
/// Of the footprint's shorter side: the height before it is pulled.
const HEIGHT_SHARE: f64 = 0.4;
/// Where the box goes.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Target {
    /// Into that cloud's model, along its axes.
    Cloud(Box<Cloud>),
    /// Into a cloud and a model of its own.
    New,
}

impl Target {
    /// The cloud that the selection is seen in, unless it is hidden or locked.
    pub(super) fn of(reading: &Reading<'_>) -> Self {
        let scene = reading.session.scene();
        let cloud = reading.view.selection.cloud(scene).filter(|cloud| reading.view.can_pick(scene, cloud));
        let cloud = cloud.filter(|cloud| scene.model(cloud.model).is_some() && cloud.scale > 0.0);
        cloud.map_or(Self::New, |cloud| Self::Cloud(Box::new(cloud.clone())))
    }

    pub(super) fn space(&self) -> ModelSpace {
        match self {
            Self::Cloud(cloud) => ModelSpace::of(cloud),
            Self::New => ModelSpace { origin: DVec3::ZERO, turn: DQuat::IDENTITY, scale: 1.0 },
        }
    }
}

/// A box in the making.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Drawn {
    pub(super) target: Target,
    /// A corner of the footprint, in the world.
    pub(super) from: DVec3,
    /// The opposite corner.
    pub(super) to: DVec3,
    pub(super) height_m: f64,
    least_m: f64,
    /// What it became in the scene, once it is there.
    pub(super) made: Option<Made>,
    name: String,
}

/// A box in the scene and the cloud that it was drawn in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Made {
    pub(super) model: ModelId,
    pub(super) cloud: CloudId,
    pub(super) id: BoxId,
}

impl Drawn {
    pub(super) fn new(target: Target, from: DVec3) -> Self {
        Self { target, from, to: from, height_m: 1.0, least_m: 1.0, made: None, name: String::new() }
    }

    /// Its footprint reaches from where it began to `to`, in steps of `snap_m` if given.
    pub(super) fn drag_to(&mut self, to: DVec3, snap_m: Option<f64>) {
        let space = self.target.space();
        let snapped = |place: DVec3| {
            let Some(step) = snap_m else { return place };
            let local = space.turn.conjugate() * (place - space.origin);
            let local = DVec3 { x: (local.x / step).round() * step, z: (local.z / step).round() * step, ..local };
            space.origin + space.turn * local
        };
        self.least_m = snap_m.unwrap_or(1.0);
        (self.from, self.to) = (snapped(self.from), snapped(to));
        let size = self.size_m();
        self.pull_to(size.x.min(size.z) * HEIGHT_SHARE, snap_m);
    }

    /// Another height, in steps of `snap_m` if given.
    pub(super) fn pull_to(&mut self, height_m: f64, snap_m: Option<f64>) {
        let least = snap_m.unwrap_or(1.0);
        let height = snap_m.map_or(height_m, |step| (height_m / step).round() * step);
        self.height_m = height.clamp(least, BOX_SIZE.max);
    }

    /// Its footprint is a square about a point, its height as that.
    pub(super) fn stand_about(&mut self, middle: DVec3) {
        let base_m = self.from.y;
        let half = self.target.space().turn * DVec3::new(SIDE_M * 0.5, 0.0, SIDE_M * 0.5);
        (self.from, self.to) = (middle - half, middle + half);
        (self.from.y, self.to.y) = (base_m, base_m);
        self.height_m = SIDE_M;
    }

    /// Along the axes of the model's space, metres in the world.
    pub(super) fn size_m(&self) -> DVec3 {
        let across = self.target.space().turn.conjugate() * (self.to - self.from);
        let side = |metres: f64| metres.abs().clamp(self.least_m, BOX_SIZE.max);
        DVec3::new(side(across.x), self.height_m, side(across.z))
    }

    /// The middle of the footprint, in the world.
    fn middle(&self) -> DVec3 {
        (self.from + self.to) * 0.5
    }

    /// Puts it into the scene; once that was done, in the place of what was drawn before.
    pub(super) fn edits(&mut self, scene: &Scene) -> Vec<Edit> {
        match self.made {
            Some(made) => self.again(made, scene),
            None => self.anew(scene),
        }
    }

    fn anew(&mut self, scene: &Scene) -> Vec<Edit> {
        let at_end = usize::MAX;
        let mut counter = scene.next_id;
        let Target::Cloud(cloud) = &self.target else {
            let name = Names::new(scene.models.iter().map(|model| model.name.as_str())).free("cloud");
            let mut model = CloudModel::new(ModelId::new(&mut counter), &name, Category::CumulusHumilis);
            let cloud = Cloud::new(CloudId::new(&mut counter), &model, self.middle());
            let made = Made { model: model.id, cloud: cloud.id, id: BoxId::new(&mut counter) };
            self.name = names_of_boxes(&model).free(BOX);
            model.boxes.push(self.cloud_box(made.id));
            self.made = Some(made);
            return vec![
                Edit::NextId(counter),
                Edit::Model(ListEdit::Insert { at: at_end, value: model }),
                Edit::Cloud(ListEdit::Insert { at: at_end, value: cloud }),
            ];
        };
        let made = Made { model: cloud.model, cloud: cloud.id, id: BoxId::new(&mut counter) };
        self.name = scene.model(cloud.model).map_or_else(|| BOX.into(), |model| names_of_boxes(model).free(BOX));
        let new = self.cloud_box(made.id);
        self.made = Some(made);
        vec![Edit::NextId(counter), Edit::Box(made.model, ListEdit::Insert { at: at_end, value: new })]
    }

    fn again(&self, made: Made, scene: &Scene) -> Vec<Edit> {
        let mut edits = vec![Edit::Box(made.model, ListEdit::Replace(self.cloud_box(made.id)))];
        if self.target == Target::New {
            let moved = scene.cloud(made.cloud).map(|cloud| Cloud { position: self.middle(), ..cloud.clone() });
            edits.extend(moved.map(|cloud| Edit::Cloud(ListEdit::Replace(cloud))));
        }
        edits
    }

    /// In its model's space.
    fn cloud_box(&self, id: BoxId) -> CloudBox {
        let up = DVec3::Y * (self.height_m * 0.5);
        let drawn = match &self.target {
            Target::New => filled(id, up, self.size_m(), 1.0),
            Target::Cloud(cloud) => {
                let space = ModelSpace::of(cloud);
                filled(id, space.from_world(self.middle() + up), self.size_m(), space.scale)
            }
        };
        CloudBox { name: self.name.clone(), ..drawn }
    }
}

/// A box whose sprites fill it whatever its size: metres in the world, of which `scale` are one in the model.
fn filled(id: BoxId, center: DVec3, size_m: DVec3, scale: f64) -> CloudBox {
    fill::filled(&CloudBox { size: size_m / scale, ..CloudBox::new(id, center) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::starter::starter_scene;
    use cloudwright_core::document::Document;

    fn cloud_of(document: &Document) -> Cloud {
        document.scene().clouds[0].clone()
    }

    #[test]
    fn lies_where_it_was_drawn_whatever_the_cloud_is_like() {
        let mut scene = starter_scene();
        let cloud = &mut scene.clouds[0];
        (cloud.heading_deg, cloud.scale) = (40.0, 2.5);
        cloud.position = DVec3::new(1e6, 800.0, -3e6);
        let mut document = Document::new(scene);
        let target = Target::Cloud(Box::new(cloud_of(&document)));
        let from = DVec3::new(1e6 + 300.0, 1200.0, -3e6 + 50.0);
        let mut drawn = Drawn::new(target, from);
        drawn.drag_to(from + DVec3::new(400.0, 0.0, 700.0), None);
        drawn.pull_to(99.0, None);
        let first = drawn.edits(document.scene());
        document.edit("Box", first).expect("sound");
        drawn.pull_to(330.0, None);
        let again = drawn.edits(document.scene());
        document.edit("Box", again).expect("sound");
        let made = document.scene().models[0].boxes.last().expect("made").clone();
        assert_eq!((document.scene().models[0].boxes.len(), Some(made.id)), (5, drawn.made.map(|made| made.id)));
        let space = ModelSpace::of(&cloud_of(&document));
        for (share, corner) in [(-0.5, drawn.from), (0.5, drawn.to + DVec3::Y * 330.0)] {
            // Which of the four corners it is depends on the heading: the height and the distance don't.
            let end = space.to_world(made.center + DVec3::Y * (share * made.size.y));
            assert!((end.y - corner.y).abs() < 1e-6, "{end}");
        }
        let middle = space.to_world(made.center);
        assert!(middle.distance((from + drawn.to) * 0.5 + DVec3::Y * 165.0) < 1e-6);
        let across = (made.size * 2.5).with_y(0.0).length();
        assert!((across - DVec3::new(400.0, 0.0, 700.0).length()).abs() < 1e-6);
    }

    #[test]
    fn snaps_and_never_vanishes() {
        let mut drawn = Drawn::new(Target::New, DVec3::new(12.0, 1000.0, 13.0));
        drawn.drag_to(DVec3::new(14.0, 1000.0, 180.0), Some(50.0));
        assert_eq!(drawn.size_m(), DVec3::new(50.0, 50.0, 200.0));
        drawn.pull_to(-400.0, None);
        assert_eq!(drawn.height_m, 1.0);
        drawn.pull_to(f64::INFINITY, Some(50.0));
        assert_eq!(drawn.height_m, BOX_SIZE.max);
    }
}
