//! Files of other programs, by the menu: written off the frame, with what they don't carry; read as one undo point.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::editor::Reply;
use cloudwright::state::Item;
use cloudwright_tests::root;
use egui::accesskit::{Role, Toggled};
use egui_kittest::kittest::{NodeT, Queryable};
use std::path::Path;

impl Window {
    fn choose_format(&mut self, title: &str) {
        self.node(Role::ComboBox, "Format").click();
        self.settle();
        // Whether or not it is scrolled into view.
        self.harness.get_all_by_label(title).last().expect("a format").click_accesskit();
        self.settle();
    }

    /// Exports by the command to a file of that name, and reads what was written.
    fn export_to(&mut self, path: &Path) -> Vec<u8> {
        self.answer(Reply::Path(path.into()));
        self.press("Export…");
        self.wait("the file", |window| window.shows("Written: "));
        assert!(self.shows(&format!("Written: {}", path.display())));
        self.press("OK");
        std::fs::read(path).expect("it was written")
    }

    /// What could not be carried is told, if there is anything.
    fn end_import(&mut self) {
        if self.harness.query_by_role_and_label(Role::Button, "OK").is_some() {
            self.press("OK");
        }
    }

    fn import(&mut self, path: &Path) {
        self.answer(Reply::Path(path.into()));
        self.command(Command::Import);
    }
}

#[test]
fn a_scene_leaves_in_the_format_that_is_chosen() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = Window::open();
    window.settle();
    let start = window.file();
    window.command(Command::Export);
    assert!(window.shows("Of this scene it does not carry: "), "before it is written");
    let [instanced, plain] = ["sky.glb", "plain.glb"].map(|name| folder.path().join(name));
    let bytes = window.export_to(&instanced);
    assert!(bytes.starts_with(b"glTF"));
    window.command(Command::Export);
    window.node(Role::CheckBox, "Plain").click();
    window.settle();
    let has_instances = |bytes: &[u8]| String::from_utf8_lossy(bytes).contains("EXT_mesh_gpu_instancing");
    assert!(has_instances(&bytes) && !has_instances(&window.export_to(&plain)), "the option holds");
    window.command(Command::Export);
    let plain = window.node(Role::CheckBox, "Plain").accesskit_node().toggled();
    assert_eq!(plain, Some(Toggled::True), "what was chosen is remembered");
    window.choose_format("Sprites as a table (.csv)");
    let table = String::from_utf8(window.export_to(&folder.path().join("sprites.csv"))).expect("text");
    assert_eq!(table.lines().count(), 1 + window.sprites());
    // A plugin that exports stands there too, and asks for itself.
    window.command(Command::Export);
    window.choose_format("Sprite table (plugin)");
    window.wait("the plugin's own question", |window| {
        window.harness.query_by_role_and_label(Role::SpinButton, "Units a metre").is_some()
    });
    window.press("Cancel");
    assert_eq!((window.file(), window.undo_name()), (start, None));
}

#[test]
fn what_is_there_is_not_written_over() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = folder.path().join("sky.cloudscene");
    let mut window = Window::open();
    window.settle();
    window.answer(Reply::Path(scene.clone()));
    window.press("Save");
    let saved = std::fs::read(&scene).expect("it was saved");
    window.command(Command::Export);
    for name in [&scene, &folder.path().join("none/sky.glb")] {
        window.answer(Reply::Path(name.clone()));
        window.press("Export…");
        // Of this file: the last refusal stands there until the name is given.
        let refusal = format!("Nothing was written: {}", name.display());
        window.wait("a refusal", |window| window.shows(&refusal));
        assert_eq!(std::fs::read(&scene).expect("still there"), saved);
    }
    // Nobody was asked about the file beside the one whose name was given.
    window.choose_format("Flight Simulator 2004 cloud (.cld)");
    let beside = folder.path().join("sky_2.cld");
    std::fs::write(&beside, "mine").expect("written");
    window.answer(Reply::Path(folder.path().join("sky.cld")));
    window.press("Export…");
    let refusal = format!("Nothing was written: {}", beside.display());
    window.wait("an answer", |window| window.shows(&refusal) || window.shows("Written: "));
    assert_eq!(std::fs::read(&beside).expect("still there"), b"mine");
    window.press(if window.shows("Written: ") { "OK" } else { "Cancel" });
}

#[test]
fn clouds_come_in_as_one_undo_point() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("cumulus.cld");
    let mut window = Window::open();
    window.settle();
    window.command(Command::Export);
    window.choose_format("Flight Simulator 2004 cloud (.cld)");
    window.export_to(&path);
    let (start, clouds) = (window.file(), window.scene().clouds.len());
    window.import(&path);
    window.press("Import");
    window.wait("the clouds", |window| window.scene().clouds.len() > clouds);
    window.settle();
    assert_eq!(window.undo_name().as_deref(), Some("Import"));
    assert_eq!(window.harness.state().selection().clouds().count(), window.scene().clouds.len() - clouds);
    window.end_import();
    window.command(Command::Undo);
    assert_eq!((window.file(), window.undo_name()), (start.clone(), None));
    // What is broken, or of no kind, changes nothing.
    let bytes = std::fs::read(&path).expect("there");
    std::fs::write(&path, &bytes[..40]).expect("written");
    window.import(&path);
    window.press("Import");
    window.wait("a refusal", |window| window.shows("Nothing came in"));
    window.press("Cancel");
    window.import(&root().join("README.md"));
    assert!(window.shows("Nothing was imported"));
    window.press("OK");
    assert_eq!((window.file(), window.undo_name()), (start, None));
}

#[test]
fn a_model_stands_on_the_ground_and_has_its_values() {
    let folder = tempfile::tempdir().expect("a folder");
    let [scene, tower, mast] = ["sky.cloudscene", "tower.glb", "mast.glb"].map(|name| folder.path().join(name));
    for model in [&tower, &mast] {
        std::fs::copy(root().join("assets/models/aircraft.glb"), model).expect("it ships");
    }
    let mut window = Window::open();
    window.settle();
    window.answer(Reply::Path(scene));
    window.press("Save");
    let start = window.file();
    window.import(&tower);
    window.press("Import");
    window.wait("the prop", |window| window.scene().props.len() == 1);
    window.settle();
    window.end_import();
    let prop = |window: &Window| window.scene().props[0].clone();
    assert_eq!((prop(&window).name.as_str(), prop(&window).position.y), ("tower", 0.0));
    assert_eq!(window.harness.state().selection().items(), [Item::Prop(prop(&window).id)]);
    window.set("Scale", 2.5);
    assert_eq!(prop(&window).scale, 2.5);
    window.answer(Reply::Path(mast));
    window.press("Model of tower");
    assert_eq!((prop(&window).model.as_str(), window.undo_name().as_deref()), ("mast.glb", Some("Prop's model")));
    for _ in 0..3 {
        window.command(Command::Undo);
    }
    assert_eq!((window.file(), window.undo_name().as_deref()), (start, Some("Name by its file")));
}

#[test]
fn a_whole_scene_comes_in_the_place_of_another_and_is_unsaved() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sky.glb");
    let mut window = Window::open();
    window.settle();
    let start = window.file();
    window.command(Command::Export);
    window.export_to(&path);
    window.command(Command::AddCamera);
    assert_ne!(window.file(), start);
    window.import(&path);
    window.press("Import");
    window.wait("the question", |window| window.shows("Don't save"));
    assert_ne!(window.file(), start, "what is unsaved is asked about first");
    window.press("Don't save");
    window.settle();
    assert_eq!(window.file(), start);
    assert!(window.session().document().is_modified(), "it has no file of its own");
}

#[test]
fn a_weather_preset_becomes_a_sky_and_can_be_stopped() {
    let mut window = Window::open();
    window.settle();
    let start = window.file();
    let preset = root().join("tests/wpr/Thunderstorms.WPR");
    window.import(&preset);
    window.press("Import");
    window.press("Stop");
    assert_eq!((window.file(), window.undo_name()), (start.clone(), None));
    window.press("Import");
    window.wait("the sky", |window| window.undo_name().as_deref() == Some("Weather from a preset"));
    window.settle();
    window.end_import();
    window.command(Command::Undo);
    assert_eq!((window.file(), window.undo_name()), (start, None));
}
