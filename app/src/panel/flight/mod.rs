//! Camera paths: which one, the clock that it is flown by, its keys, and the aircraft on it.

mod keys;
mod traffic;
mod transport;

use crate::command::Command;
use crate::state::{Action, Item, Reading, ViewChange};
use crate::theme::icon;
use crate::widget::{name_it, section};
use cloudwright_core::draw_list::Sorting;
use cloudwright_core::flight::PathCurve;
use cloudwright_core::scene::CameraPath;
use egui::{Button, ComboBox, Response, ScrollArea, Ui};
use glam::DVec3;

/// Of a path's length, pieces that it is measured in.
const PIECES: u32 = 512;

const NO_PATHS: &str =
    "No paths yet. Move the view to where a flight is to begin, and add a path; or record one by flying.";

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        let scene = reading.session.scene();
        transport::show(ui, reading, actions);
        let path = reading.clock.path(scene);
        section(ui, "Path", |ui| {
            choose(ui, path, reading, actions);
            match path {
                Some(path) => {
                    ui.weak(extent(path, reading));
                    keys::show(ui, path, reading, actions);
                }
                None => drop(ui.weak(NO_PATHS)),
            }
        });
        if let Some(path) = path {
            section(ui, "Aircraft", |ui| traffic::show(ui, path, reading, actions));
            section(ui, "View", |ui| sorting(ui, reading, actions));
        }
    });
}

/// Which path, and what is done with paths.
fn choose(ui: &mut Ui, path: Option<&CameraPath>, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        if let Some(path) = path {
            let combo = ComboBox::from_id_salt("path").selected_text(name_of(path)).show_ui(ui, |ui| {
                for each in &reading.session.scene().paths {
                    if ui.selectable_label(each.id == path.id, name_of(each)).clicked() {
                        actions.push(Action::select(Item::Path(each.id)));
                    }
                }
            });
            name_it(ui, &combo.response, "Path to fly");
            combo.response.on_hover_text("Its name and field of view are in the inspector.");
        }
        button(ui, Command::AddPath, icon::PLUS, "New path", false, actions);
        if let Some(path) = path {
            for (command, glyph, name) in
                [(Command::Duplicate, icon::COPY_SIMPLE, "Copy path"), (Command::Delete, icon::TRASH, "Delete path")]
            {
                if on_path(ui, glyph, name).clicked() {
                    // What these commands work on is the selection, the whole path and no key.
                    actions.push(Action::select(Item::Path(path.id)));
                    actions.push(Action::View(ViewChange::PathKey(None)));
                    actions.push(Action::Command(command));
                }
            }
        }
        let (glyph, name) =
            if reading.is_recording { (icon::STOP, "Stop recording") } else { (icon::RECORD, "Record") };
        button(ui, Command::RecordFlight, glyph, name, reading.is_recording, actions);
    });
    if reading.is_recording {
        ui.label("Recording what is flown in the viewport. Stop makes a new path of it.");
    }
}

fn on_path(ui: &mut Ui, glyph: &str, name: &str) -> Response {
    let response = ui.button(glyph);
    name_it(ui, &response, name);
    response.on_hover_text(name)
}

/// A command's button.
fn button(ui: &mut Ui, command: Command, glyph: &str, name: &str, on: bool, actions: &mut Vec<Action>) {
    let response = ui.add(Button::new(glyph).selected(on));
    name_it(ui, &response, name);
    if response.on_hover_text(command.row().tooltip(ui.ctx())).clicked() {
        actions.push(Action::Command(command));
    }
}

/// "42.0 s, 3.4 km, 12 keys".
fn extent(path: &CameraPath, reading: &Reading<'_>) -> String {
    let keys = match path.keys.len() {
        1 => "1 key".into(),
        count => format!("{count} keys"),
    };
    let curve = PathCurve::new(path);
    if curve.duration_s() <= 0.0 {
        return format!("{keys}: it stands still, so give it another one");
    }
    let at = |piece: u32| curve.at(curve.duration_s() * f64::from(piece) / f64::from(PIECES)).position;
    let length_m: f64 = (1..=PIECES).map(|piece| DVec3::distance(at(piece - 1), at(piece))).sum();
    format!("{:.1} s, {}, {keys}", curve.duration_s(), reading.units.distance(length_m))
}

fn sorting(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        ui.label("Sprites are sorted");
        let all = [(Sorting::EachFrame, "for each picture"), (Sorting::Crossfade, "now and then, faded over")];
        let present = reading.view.sorting;
        let shown = all.iter().find(|(each, _)| *each == present).map_or("", |(_, name)| name);
        let combo = ComboBox::from_id_salt("sorting").selected_text(shown).show_ui(ui, |ui| {
            for (each, name) in all {
                if ui.selectable_label(each == present, name).clicked() {
                    actions.push(Action::View(ViewChange::Sorting(each)));
                }
            }
        });
        name_it(ui, &combo.response, "Sorting");
        combo.response.on_hover_text(
            "Sorted for each picture, sprites that change places may pop; faded over, all is drawn twice for a while.",
        );
    });
}

fn name_of(path: &CameraPath) -> String {
    if path.name.is_empty() { format!("path {}", path.id) } else { path.name.clone() }
}
