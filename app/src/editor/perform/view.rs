//! What changes how the scene is looked at, and nothing in it.

use crate::editor::Editor;
use crate::state::{Choose, Item, Selection, ViewChange, ViewState};
use cloudwright_core::scene::{CameraId, Folder};
use std::collections::BTreeSet;

impl Editor {
    pub(super) fn change_view(&mut self, change: ViewChange) {
        let view = &mut self.view;
        match change {
            ViewChange::Hidden(item, on) => set(&mut view.hidden, item, on),
            ViewChange::Locked(item, on) => set(&mut view.locked, item, on),
            ViewChange::Renaming(item) => view.renaming = item,
            ViewChange::BaseAltitude(metres) => view.base_altitude_m = Some(metres),
            ViewChange::Snap(snap) => view.snap = snap,
            ViewChange::TimeSpeed(hours_a_minute) => self.time_play.set_speed(hours_a_minute),
            ViewChange::Clock(change) => self.change_clock(change),
            ViewChange::PathKey(key) => view.path_key = key,
            ViewChange::Sorting(sorting) => view.sorting = sorting,
            ViewChange::Method(method) => view.method = method,
            ViewChange::Lens(lens) => view.lens = lens,
        }
    }

    pub(super) fn look_through(&mut self, id: CameraId) {
        if let Some(camera) = self.session.scene().cameras.with_id(id) {
            // As its tracks have it now.
            let camera = self.session.derived().timeline().camera_at(camera, self.clock.time_s());
            self.viewport.look_through(&camera, &self.session);
        }
    }

    /// The selected camera; else the one after the last that was looked through.
    pub(super) fn look_through_next(&mut self) {
        let cameras = &self.session.scene().cameras;
        let selected = self.view.selection.items().iter().rev().find_map(as_camera);
        let seen = cameras.iter().position(|camera| Some(camera.id) == self.last_camera);
        let next = cameras.get(seen.map_or(0, |at| (at + 1) % cameras.len()));
        if let Some(id) = selected.or(next.map(|camera| camera.id)) {
            self.last_camera = Some(id);
            self.look_through(id);
        }
    }

    /// The selected camera, or the scene's first.
    pub(super) fn align_camera(&mut self) {
        let selected = self.view.selection.items().iter().rev().find_map(as_camera);
        if let Some(id) = selected.or(self.session.scene().cameras.first().map(|camera| camera.id)) {
            self.set_from_view(id);
        }
    }

    /// All boxes of the model whose box is selected; else all clouds that can be picked.
    pub(super) fn select_all(&mut self) {
        let scene = self.session.scene();
        let through = self.view.selection.cloud(scene).map(|cloud| cloud.id);
        let items: Vec<Item> = match self.view.selection.primary() {
            Some(Item::Box(model, _) | Item::Sprite(model, ..)) => {
                let boxes = scene.model(model).map(|model| model.boxes.as_slice()).unwrap_or_default();
                boxes.iter().map(|each| Item::Box(model, each.id)).collect()
            }
            _ => {
                let clouds = scene.clouds.iter().filter(|cloud| self.view.can_pick(scene, cloud));
                clouds.map(|cloud| Item::Cloud(cloud.id)).collect()
            }
        };
        self.view.selection.choose(items, through, Choose::Only);
    }

    /// Hides what of the selection shows; if nothing does, shows it again.
    pub(super) fn toggle_hidden(&mut self) {
        let items = hideable(&self.view.selection);
        toggle(&mut self.view.hidden, items);
        self.toggle_folders(|folder| &mut folder.hidden);
    }

    /// Locks what of the selection is free; if nothing is, frees it again.
    pub(super) fn toggle_locked(&mut self) {
        let items = hideable(&self.view.selection);
        toggle(&mut self.view.locked, items);
        self.toggle_folders(|folder| &mut folder.locked);
    }

    /// Shows only the selected clouds and those of selected folders; all again if it is those already, or none is selected.
    pub(super) fn toggle_solo(&mut self) {
        let selection = &self.view.selection;
        let folders = selection.all::<Folder>().map(Item::Folder);
        let clouds: BTreeSet<Item> = selection.clouds().map(Item::Cloud).chain(folders).collect();
        self.view.solo = if clouds == self.view.solo { BTreeSet::new() } else { clouds };
    }

    /// Esc shows again what solo left out, unless it is another thing's.
    pub(in crate::editor) fn leave_solo_on_escape(&mut self, context: &egui::Context) {
        let taken = self.is_asking() || self.gesture_dropped || self.viewport.has_keys() || context.text_edit_focused();
        let taken = taken || context.dragged_id().is_some() || self.view.renaming.is_some() || self.time_play.runs();
        let is_in_solo = !self.view.solo.is_empty() && !self.clock.plays() && !self.viewport.is_on_board();
        if is_in_solo && !taken && context.input(|input| input.key_pressed(egui::Key::Escape)) {
            self.view.solo.clear();
        }
    }

    pub(super) fn show_all(&mut self) {
        let ViewState { hidden, locked, solo, .. } = &mut self.view;
        for set in [hidden, locked, solo] {
            set.clear();
        }
    }
}

fn as_camera(item: &Item) -> Option<CameraId> {
    if let Item::Camera(id) = item { Some(*id) } else { None }
}

fn hideable(selection: &Selection) -> Vec<Item> {
    selection.items().iter().copied().filter(|item| ViewState::can_hide(*item)).collect()
}

fn toggle(set: &mut BTreeSet<Item>, items: Vec<Item>) {
    if items.iter().all(|item| set.contains(item)) {
        set.retain(|item| !items.contains(item));
    } else {
        set.extend(items);
    }
}

fn set(set: &mut BTreeSet<Item>, item: Item, on: bool) {
    if on {
        set.insert(item);
    } else {
        set.remove(&item);
    }
}
