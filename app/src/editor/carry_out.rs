//! Actions and commands, carried out: the one arm a command.

use super::dialogs::Dialog;
use super::file_flow::Intent;
use super::{Action, Ask, Editor, Selection, box_of, starter};
use crate::command::Command;
use cloudwright_core::document::{Edit, EditError, ListEdit};
use cloudwright_core::scene::{BoxId, Camera, CameraId, Cloud, CloudBox, CloudId};
use glam::DVec3;

impl Editor {
    /// Does what panels and viewport asked for, and shows the outcome in the next frame.
    pub(super) fn carry_out(&mut self, actions: Vec<Action>, context: &egui::Context) {
        if !actions.is_empty() {
            context.request_repaint();
        }
        for action in actions {
            match action {
                Action::Command(command) => self.perform(command, context),
                Action::Select(selection) => self.select(selection),
                Action::LookThrough(id) => {
                    if let Some(camera) = self.session.scene().cameras.iter().find(|camera| camera.id == id) {
                        self.viewport.look_through(camera, &self.session);
                    }
                }
                Action::SetFromView(id) => self.set_from_view(id),
                Action::Change { name, edit, live } => self.change(name, *edit, live),
            }
        }
    }

    fn change(&mut self, name: &str, edit: Edit, live: bool) {
        if self.gesture_dropped {
            return;
        }
        let mut done = self.session.drag(name, edit);
        if done.is_ok() && !live {
            done = self.session.commit();
        }
        self.report(done);
    }

    fn report(&mut self, done: Result<(), EditError>) {
        match done {
            Ok(()) => self.notice = None,
            Err(error) => self.tell_error(error.to_string()),
        }
    }

    /// Whether a command has something to work on now.
    pub fn can(&self, command: Command) -> bool {
        let document = self.session.document();
        let scene = document.scene();
        match command {
            Command::OpenRecent => !self.desk.settings().recent().is_empty(),
            Command::Revert => self.session.path().is_some() && document.is_modified(),
            Command::Undo => document.undo_name().is_some() || document.is_open(),
            Command::Redo => document.redo_name().is_some(),
            Command::AddBox | Command::PlaceModel => self.selection.model(scene).is_some(),
            Command::Duplicate => !matches!(self.selection, Selection::Nothing | Selection::Model(_)),
            Command::Delete => self.selection != Selection::Nothing,
            Command::FrameSelection => !matches!(self.selection, Selection::Nothing | Selection::Camera(_)),
            Command::FrameAll => !self.session.derived().clouds().is_empty(),
            _ => true,
        }
    }

    /// Does a command of the table, if it has something to work on.
    pub fn perform(&mut self, command: Command, context: &egui::Context) {
        if !self.can(command) {
            return;
        }
        match command {
            Command::New => self.want(Intent::New, context),
            Command::Open => self.ask(Ask::Open, context),
            Command::OpenRecent => self.list_recent(context),
            Command::Save => self.save(context),
            Command::SaveAs => self.save_as(context),
            Command::Revert => self.dialogs.open(Dialog::Revert),
            Command::Quit => self.want(Intent::Quit, context),
            Command::Undo => {
                self.session.undo();
                self.select(self.selection);
            }
            Command::Redo => {
                self.session.redo();
                self.select(self.selection);
            }
            Command::AddCloud => self.add_cloud(),
            Command::PlaceModel => self.place_model(),
            Command::AddBox => self.add_box(),
            Command::AddCamera => self.add_camera(),
            Command::Duplicate => self.duplicate(),
            Command::Delete => self.delete(),
            Command::FrameSelection => self.viewport.frame(self.selection, &self.session),
            Command::FrameAll => self.viewport.frame(Selection::Nothing, &self.session),
            Command::ShowBoxes => self.viewport.show_all_boxes ^= true,
            Command::SwitchTheme => crate::theme::switch(context),
        }
    }

    /// Edits as one undo point; what they made is selected.
    fn edit_and_select(&mut self, command: Command, edits: Vec<Edit>, selection: Selection) {
        let done = self.session.edit(command.row().help, edits);
        if done.is_ok() {
            self.select(selection);
        }
        self.report(done);
    }

    fn add_cloud(&mut self) {
        let (edits, id) = starter::add_cloud(self.session.scene(), self.viewport.looked_at());
        self.edit_and_select(Command::AddCloud, edits, Selection::Cloud(id));
    }

    fn place_model(&mut self) {
        let scene = self.session.scene();
        let Some(model) = self.selection.model(scene) else { return };
        let mut counter = scene.next_id;
        let mut cloud = starter::placement(CloudId::new(&mut counter), model, self.viewport.looked_at());
        cloud.name = starter::free_name(&cloud.name, scene.clouds.iter().map(|cloud| cloud.name.as_str()));
        let id = cloud.id;
        let edits = vec![Edit::NextId(counter), insert_cloud(cloud)];
        self.edit_and_select(Command::PlaceModel, edits, Selection::Cloud(id));
    }

    /// Beside the selected box, or in the model's middle.
    fn add_box(&mut self) {
        let scene = self.session.scene();
        let Some(model) = self.selection.model(scene) else { return };
        let mut counter = scene.next_id;
        let id = BoxId::new(&mut counter);
        let beside = match self.selection {
            Selection::Box(model, id) => box_of(scene, model, id).map(|b| b.center + DVec3::X * b.size.x),
            _ => None,
        };
        let middle = model.boxes.iter().map(|b| b.center).sum::<DVec3>() / (model.boxes.len().max(1) as f64);
        let new = CloudBox::new(id, beside.unwrap_or(middle));
        let selection = Selection::Box(model.id, id);
        let edits = vec![Edit::NextId(counter), Edit::Box(model.id, ListEdit::Insert { at: usize::MAX, value: new })];
        self.edit_and_select(Command::AddBox, edits, selection);
    }

    fn add_camera(&mut self) {
        let scene = self.session.scene();
        let mut counter = scene.next_id;
        let id = CameraId::new(&mut counter);
        let name = starter::free_name("camera", scene.cameras.iter().map(|camera| camera.name.as_str()));
        let camera = Camera { id, name, ..self.viewport.camera().clone() };
        let edits = vec![Edit::NextId(counter), Edit::Camera(ListEdit::Insert { at: usize::MAX, value: camera })];
        self.edit_and_select(Command::AddCamera, edits, Selection::Camera(id));
    }

    fn set_from_view(&mut self, id: CameraId) {
        let Some(old) = self.session.scene().cameras.iter().find(|camera| camera.id == id) else { return };
        let camera = Camera { id, name: old.name.clone(), ..self.viewport.camera().clone() };
        let done = self.session.edit("Set camera from view", vec![Edit::Camera(ListEdit::Replace(camera))]);
        self.report(done);
    }

    fn duplicate(&mut self) {
        let scene = self.session.scene();
        let mut counter = scene.next_id;
        let (edit, selection) = match self.selection {
            Selection::Box(model, id) => {
                let Some(old) = box_of(scene, model, id) else { return };
                let id = BoxId::new(&mut counter);
                let center = old.center + DVec3::X * old.size.x;
                let new = CloudBox { id, center, ..old.clone() };
                (Edit::Box(model, ListEdit::Insert { at: usize::MAX, value: new }), Selection::Box(model, id))
            }
            Selection::Cloud(id) => {
                let Some(old) = scene.cloud(id) else { return };
                let id = CloudId::new(&mut counter);
                let width = self.session.derived().clouds().iter().find(|cloud| cloud.id == old.id);
                let aside = width.map_or(500.0, |cloud| f64::from(cloud.reach) * 1.5);
                let name = starter::free_name(&old.name, scene.clouds.iter().map(|cloud| cloud.name.as_str()));
                let new = Cloud { id, name, position: old.position + DVec3::X * aside, ..old.clone() };
                (insert_cloud(new), Selection::Cloud(id))
            }
            Selection::Camera(id) => {
                let Some(old) = scene.cameras.iter().find(|camera| camera.id == id) else { return };
                let id = CameraId::new(&mut counter);
                let name = starter::free_name(&old.name, scene.cameras.iter().map(|camera| camera.name.as_str()));
                let new = Camera { id, name, ..old.clone() };
                (Edit::Camera(ListEdit::Insert { at: usize::MAX, value: new }), Selection::Camera(id))
            }
            Selection::Nothing | Selection::Model(_) => return,
        };
        self.edit_and_select(Command::Duplicate, vec![Edit::NextId(counter), edit], selection);
    }

    /// A model goes with its clouds.
    fn delete(&mut self) {
        let edits = match self.selection {
            Selection::Nothing => return,
            Selection::Box(model, id) => vec![Edit::Box(model, ListEdit::Remove(id))],
            Selection::Cloud(id) => vec![Edit::Cloud(ListEdit::Remove(id))],
            Selection::Camera(id) => vec![Edit::Camera(ListEdit::Remove(id))],
            Selection::Model(id) => {
                let clouds = self.session.scene().clouds.iter().filter(|cloud| cloud.model == id);
                let clouds = clouds.map(|cloud| Edit::Cloud(ListEdit::Remove(cloud.id)));
                clouds.chain([Edit::Model(ListEdit::Remove(id))]).collect()
            }
        };
        self.edit_and_select(Command::Delete, edits, Selection::Nothing);
    }
}

fn insert_cloud(cloud: Cloud) -> Edit {
    Edit::Cloud(ListEdit::Insert { at: usize::MAX, value: cloud })
}
