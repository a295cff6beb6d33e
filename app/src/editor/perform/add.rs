//! New clouds, boxes, placements and cameras.

use crate::command::Command;
use crate::editor::{Editor, Item, Selection, box_of, camera_of, starter};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::{BoxId, Camera, CameraId, Cloud, CloudBox, CloudId};
use glam::DVec3;

impl Editor {
    pub(super) fn add_cloud(&mut self) {
        let (edits, id) = starter::add_cloud(self.session.scene(), self.viewport.looked_at());
        self.edit_and_select(Command::AddCloud, edits, Selection::of([Item::Cloud(id)]));
    }

    pub(super) fn choose_preset(&mut self) {}

    pub(super) fn place_model(&mut self) {
        let scene = self.session.scene();
        let Some(model) = self.view.selection.model(scene) else { return };
        let mut counter = scene.next_id;
        let mut cloud = starter::placement(CloudId::new(&mut counter), model, self.viewport.looked_at());
        cloud.name = starter::free_name(&cloud.name, scene.clouds.iter().map(|cloud| cloud.name.as_str()));
        let id = cloud.id;
        let edits = vec![Edit::NextId(counter), insert_cloud(cloud)];
        self.edit_and_select(Command::PlaceModel, edits, Selection::of([Item::Cloud(id)]));
    }

    /// Beside the selected box, or in the model's middle.
    pub(super) fn add_box(&mut self) {
        let scene = self.session.scene();
        let Some(model) = self.view.selection.model(scene) else { return };
        let mut counter = scene.next_id;
        let id = BoxId::new(&mut counter);
        let beside = match self.view.selection.primary() {
            Some(Item::Box(model, id)) => box_of(scene, model, id).map(|b| b.center + DVec3::X * b.size.x),
            _ => None,
        };
        let middle = model.boxes.iter().map(|b| b.center).sum::<DVec3>() / (model.boxes.len().max(1) as f64);
        let new = CloudBox::new(id, beside.unwrap_or(middle));
        let mut selection = Selection::of([Item::Box(model.id, id)]);
        if let Some(cloud) = self.view.selection.cloud(scene) {
            selection = selection.through(cloud.id);
        }
        let edits = vec![Edit::NextId(counter), Edit::Box(model.id, ListEdit::Insert { at: usize::MAX, value: new })];
        self.edit_and_select(Command::AddBox, edits, selection);
    }

    pub(super) fn add_camera(&mut self) {
        let scene = self.session.scene();
        let mut counter = scene.next_id;
        let id = CameraId::new(&mut counter);
        let name = starter::free_name("camera", scene.cameras.iter().map(|camera| camera.name.as_str()));
        let camera = Camera { id, name, ..self.viewport.camera().clone() };
        let edits = vec![Edit::NextId(counter), Edit::Camera(ListEdit::Insert { at: usize::MAX, value: camera })];
        self.edit_and_select(Command::AddCamera, edits, Selection::of([Item::Camera(id)]));
    }

    pub(super) fn set_from_view(&mut self, id: CameraId) {
        let Some(old) = camera_of(self.session.scene(), id) else { return };
        let camera = Camera { id, name: old.name.clone(), ..self.viewport.camera().clone() };
        let done = self.session.edit("Set camera from view", vec![Edit::Camera(ListEdit::Replace(camera))]);
        self.report(done);
    }
}

pub(super) fn insert_cloud(cloud: Cloud) -> Edit {
    Edit::Cloud(ListEdit::Insert { at: usize::MAX, value: cloud })
}
