//! What is done with things that are there: duplicate, mirror, join, split, delete.

use super::add::insert_cloud;
use crate::command::Command;
use crate::editor::{Editor, Item, Selection, box_of, camera_of, starter};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::{BoxId, Camera, CameraId, Cloud, CloudBox, CloudId};
use glam::DVec3;

impl Editor {
    pub(super) fn duplicate(&mut self) {
        let scene = self.session.scene();
        let mut counter = scene.next_id;
        let (edit, item) = match self.view.selection.primary() {
            Some(Item::Box(model, id)) => {
                let Some(old) = box_of(scene, model, id) else { return };
                let id = BoxId::new(&mut counter);
                let center = old.center + DVec3::X * old.size.x;
                let new = CloudBox { id, center, ..old.clone() };
                (Edit::Box(model, ListEdit::Insert { at: usize::MAX, value: new }), Item::Box(model, id))
            }
            Some(Item::Cloud(id)) => {
                let Some(old) = scene.cloud(id) else { return };
                let id = CloudId::new(&mut counter);
                let aside = self.session.placed(old.id).map_or(500.0, |cloud| f64::from(cloud.reach) * 1.5);
                let name = starter::free_name(&old.name, scene.clouds.iter().map(|cloud| cloud.name.as_str()));
                let new = Cloud { id, name, position: old.position + DVec3::X * aside, ..old.clone() };
                (insert_cloud(new), Item::Cloud(id))
            }
            Some(Item::Camera(id)) => {
                let Some(old) = camera_of(scene, id) else { return };
                let id = CameraId::new(&mut counter);
                let name = starter::free_name(&old.name, scene.cameras.iter().map(|camera| camera.name.as_str()));
                let new = Camera { id, name, ..old.clone() };
                (Edit::Camera(ListEdit::Insert { at: usize::MAX, value: new }), Item::Camera(id))
            }
            _ => return,
        };
        self.edit_and_select(Command::Duplicate, vec![Edit::NextId(counter), edit], Selection::of([item]));
    }

    pub(super) fn duplicate_own(&mut self) {}

    pub(super) fn make_own(&mut self) {}

    pub(super) fn mirror(&mut self, _command: Command) {}

    pub(super) fn join(&mut self) {}

    pub(super) fn split(&mut self) {}

    pub(super) fn reroll(&mut self) {}

    pub(super) fn reset_sprites(&mut self) {}

    /// A model goes with its clouds.
    pub(super) fn delete(&mut self) {
        let mut edits = Vec::new();
        for item in self.view.selection.items() {
            match *item {
                Item::Box(model, id) => edits.push(Edit::Box(model, ListEdit::Remove(id))),
                Item::Cloud(id) => edits.push(Edit::Cloud(ListEdit::Remove(id))),
                Item::Camera(id) => edits.push(Edit::Camera(ListEdit::Remove(id))),
                Item::Model(id) => {
                    let clouds = self.session.scene().clouds.iter().filter(|cloud| cloud.model == id);
                    edits.extend(clouds.map(|cloud| Edit::Cloud(ListEdit::Remove(cloud.id))));
                    edits.push(Edit::Model(ListEdit::Remove(id)));
                }
                Item::Group(..) | Item::Sprite(..) => {}
            }
        }
        self.edit_and_select(Command::Delete, edits, Selection::default());
    }
}
