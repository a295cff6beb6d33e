//! New clouds, boxes, placements and cameras.

use crate::command::Command;
use crate::editor::Editor;
use crate::starter;
use crate::state::{Item, Selection, box_of};
use cloudwright_core::arrange::Names;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::preset::Preset;
use cloudwright_core::scene::{BoxId, Camera, CameraId, Cloud, CloudBox, CloudId};
use glam::DVec3;

impl Editor {
    pub(super) fn add_cloud(&mut self) {
        let (edits, id) = starter::add_cloud(self.session.scene(), self.viewport.looked_at());
        self.edit_and_select(Command::AddCloud, edits, Selection::of([Item::Cloud(id)]));
    }

    /// A cloud of a preset, with a model of its own, where the view looks.
    pub(in crate::editor) fn add_preset(&mut self, preset: &Preset) {
        let (edits, id) = preset.place(self.session.scene(), self.viewport.looked_at());
        self.edit_and_select(Command::AddPreset, edits, Selection::of([Item::Cloud(id)]));
    }

    pub(super) fn place_model(&mut self) {
        let scene = self.session.scene();
        let Some(model) = self.view.selection.model(scene) else { return };
        let mut counter = scene.next_id;
        let mut cloud = Cloud::new(CloudId::new(&mut counter), model, self.viewport.looked_at());
        cloud.name = Names::new(scene.clouds.iter().map(|cloud| cloud.name.as_str())).free(&cloud.name);
        let id = cloud.id;
        let edits = vec![Edit::NextId(counter), Edit::Cloud(ListEdit::Insert { at: usize::MAX, value: cloud })];
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
        let name = starter::names_of_boxes(model).free(starter::BOX);
        let new = CloudBox { name, ..CloudBox::new(id, beside.unwrap_or(middle)) };
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
        let name = Names::new(scene.cameras.iter().map(|camera| camera.name.as_str())).free("camera");
        let camera = Camera { id, name, ..self.viewport.camera().clone() };
        let edits = vec![Edit::NextId(counter), Edit::Camera(ListEdit::Insert { at: usize::MAX, value: camera })];
        self.edit_and_select(Command::AddCamera, edits, Selection::of([Item::Camera(id)]));
    }

    pub(super) fn set_from_view(&mut self, id: CameraId) {
        let Some(old) = self.session.scene().cameras.with_id(id) else { return };
        let camera = Camera { id, name: old.name.clone(), ..self.viewport.camera().clone() };
        let done = self.session.edit("Set camera from view", vec![Edit::Camera(ListEdit::Replace(camera))]);
        self.report(done);
    }
}
