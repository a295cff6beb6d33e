//! Camera paths, their keys, and aircraft.

use crate::command::Command;
use crate::editor::recording::key_of;
use crate::editor::{Ask, Editor};
use crate::state::{Item, Selection};
use cloudwright_core::arrange::Names;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::flight::leg_speed_mps;
use cloudwright_core::property::LEG_SPEED_MPS;
use cloudwright_core::scene::{Aircraft, AircraftId, CameraPath, PathId, PathKey, Prop};
use std::path::Path;

/// A key after the last one comes so much later at least, seconds.
const LEAST_LEG_S: f64 = 0.5;
/// Towards a key after the only one: a light aircraft's.
const USUAL_SPEED_MPS: f64 = 80.0;
/// Of a time that the hand gives, seconds: a millisecond. Keys nearer to each other are one.
const TIME_STEP_S: f64 = 0.001;

impl Editor {
    /// A path of one key, with the view's field of view.
    pub(super) fn add_path(&mut self) {
        let scene = self.session.scene();
        let mut counter = scene.next_id;
        let id = PathId::new(&mut counter);
        let name = Names::new(scene.paths.iter().map(|path| path.name.as_str())).free("path");
        let camera = self.viewport.camera();
        let field_of_view_deg = camera.field_of_view_deg;
        let path = CameraPath { field_of_view_deg, ..CameraPath::new(id, &name, vec![key_of(camera, 0.0)]) };
        let edits = vec![Edit::NextId(counter), Edit::Path(ListEdit::Insert { at: usize::MAX, value: path })];
        self.edit_and_select(Command::AddPath, edits, Selection::of([Item::Path(id)]));
    }

    /// The view becomes a key behind the last one, so much later as the way takes at the speed of the leg before.
    pub(super) fn key_after_last(&mut self) {
        let Some(path) = self.clock.path(self.session.scene()) else { return };
        let mut path = path.clone();
        let here = key_of(self.viewport.camera(), 0.0);
        let time_s = path.keys.last().map_or(0.0, |last| {
            let before = path.keys.len().checked_sub(2).and_then(|leg| leg_speed_mps(&path.keys, leg));
            let speed = before.filter(|speed| *speed > LEG_SPEED_MPS.min).unwrap_or(USUAL_SPEED_MPS);
            to_step(last.time_s + (last.position.distance(here.position) / speed).max(LEAST_LEG_S))
        });
        path.keys.push(PathKey { time_s, ..here });
        let index = path.keys.len() - 1;
        self.replace_path(Command::KeyAfterLast.row().label(), path, Some(index));
    }

    /// The view becomes a key at the clock's time; one that is there already goes to where the view is.
    pub(super) fn key_at_clock(&mut self) {
        let Some(path) = self.clock.path(self.session.scene()) else { return };
        let mut path = path.clone();
        let start_s = path.keys.first().map_or(0.0, |first| first.time_s);
        let key = key_of(self.viewport.camera(), to_step(start_s + self.clock.time_s()));
        let there = path.keys.iter().position(|each| (each.time_s - key.time_s).abs() < 1.5 * TIME_STEP_S);
        let index = there.unwrap_or_else(|| path.keys.iter().filter(|each| each.time_s < key.time_s).count());
        match path.keys.get_mut(index).filter(|_| there.is_some()) {
            Some(old) => *old = PathKey { time_s: old.time_s, ..key },
            None => path.keys.insert(index, key),
        }
        self.replace_path(Command::KeyAtClock.row().label(), path, Some(index));
    }

    /// Takes the key that is worked on out of its path. False if it is the only one, or none is.
    pub(super) fn delete_key(&mut self) -> bool {
        let Some((id, index)) = self.view.path_key else { return false };
        let is_primary = self.view.selection.primary() == Some(Item::Path(id));
        let path = self.session.scene().path(id).filter(|path| is_primary && path.keys.len() > 1);
        let Some(mut path) = path.filter(|path| index < path.keys.len()).cloned() else { return false };
        path.keys.remove(index);
        self.replace_path("Delete key", path, None);
        true
    }

    fn replace_path(&mut self, name: &str, path: CameraPath, key: Option<usize>) {
        let id = path.id;
        let done = self.session.edit(name, vec![Edit::Path(ListEdit::Replace(path))]);
        if done.is_ok() {
            self.view.path_key = key.map(|index| (id, index));
            self.select(Selection::of([Item::Path(id)]));
        }
        self.report(done);
    }

    /// The built-in aircraft, before the camera on the chosen path.
    pub(super) fn add_aircraft(&mut self) {
        let scene = self.session.scene();
        let Some(path) = self.clock.path(scene) else { return };
        let mut counter = scene.next_id;
        let id = AircraftId::new(&mut counter);
        let name = Names::new(scene.aircraft.iter().map(|aircraft| aircraft.name.as_str())).free("aircraft");
        let value = Aircraft::new(id, &name, path.id);
        let edits = vec![Edit::NextId(counter), Edit::Aircraft(ListEdit::Insert { at: usize::MAX, value })];
        self.edit_and_select(Command::AddAircraft, edits, Selection::of([Item::Aircraft(id)]));
    }

    /// Asks for the file of the model of an aircraft or a prop, which lies beside the scene's.
    pub(super) fn choose_model(&mut self, of: Item, context: &egui::Context) {
        match self.session.path() {
            Some(scene) => self.ask(Ask::Model(of, scene.into()), context),
            None => self.tell_error("Save the scene first: a model lies beside the scene's file"),
        }
    }

    /// Whether a file lies in the scene's folder, where the scene can name it.
    pub(in crate::editor) fn lies_beside(&self, file: &Path) -> bool {
        let folder = |path: &Path| std::path::absolute(path).ok()?.parent()?.canonicalize().ok();
        self.session.path().and_then(folder).is_some_and(|beside| folder(file) == Some(beside))
    }

    /// Gives an aircraft or a prop the model of that file.
    pub(in crate::editor) fn use_model(&mut self, of: Item, file: &Path) {
        let scene = self.session.scene();
        let replacing = |model: String| match of {
            Item::Aircraft(id) => {
                let aircraft = Aircraft { model: Some(model), ..scene.aircraft.with_id(id)?.clone() };
                Some(("Aircraft's model", Edit::Aircraft(ListEdit::Replace(aircraft))))
            }
            Item::Prop(id) => {
                let prop = Prop { model, ..scene.props.with_id(id)?.clone() };
                Some(("Prop's model", Edit::Prop(ListEdit::Replace(prop))))
            }
            _ => None,
        };
        let is_beside = self.lies_beside(file);
        let name = file.file_name().and_then(|name| name.to_str());
        match name.filter(|_| is_beside && file.is_file()) {
            Some(name) => {
                let Some((what, edit)) = replacing(name.into()) else { return };
                let done = self.session.edit(what, vec![edit]);
                self.report(done);
            }
            None => self.tell_error(format!(
                "{} doesn't lie beside the scene's file: copy it there, and choose it there",
                file.display()
            )),
        }
    }
}

fn to_step(time_s: f64) -> f64 {
    (time_s / TIME_STEP_S).round() * TIME_STEP_S
}
