//! New, open, save and the questions before.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::editor::{Ask, Reply};
use cloudwright::opening;
use cloudwright::saving;
use cloudwright::storage::Over;
use cloudwright_core::scene::Scene;
use egui::accesskit::Role;
use egui::{Key, Modifiers, ViewportCommand, ViewportEvent, ViewportId};
use egui_kittest::kittest::Queryable;

#[test]
fn what_is_saved_comes_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = Window::open();
    window.settle();
    window.press("body");
    window.set("Sprites", 77.0);
    // A name without an ending gets the scene files' own.
    window.answer(Reply::Path(folder.path().join("sky")));
    window.press("Save");
    let path = folder.path().join("sky.cloudscene");
    assert!(!window.session().document().is_modified());
    assert_eq!(window.session().path(), Some(path.as_path()));
    let saved = opening::open_scene(&path).expect("a sound scene");
    assert_eq!(&saved, window.scene());
    window.set("Sprites", 12.0);
    window.keys(Modifiers::COMMAND, Key::S);
    assert_eq!(window.script.asked.borrow().len(), 1, "the second time it knows where");
    for (command, ask) in [(Command::Open, Ask::Open(path.clone())), (Command::Import, Ask::Arrive(path.clone()))] {
        window.answer(Reply::Cancelled);
        window.command(command);
        assert_eq!(window.script.asked.borrow().last(), Some(&ask), "it begins in the scene's folder");
    }
    let mut again = Window::open();
    again.answer(Reply::Path(path));
    again.keys(Modifiers::COMMAND, Key::O);
    assert_eq!(again.scene(), window.scene());
    assert_eq!(again.sprites(), window.sprites());
    assert!(!again.session().document().is_modified());
}

#[test]
fn a_broken_file_leaves_the_document_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bad.cloudscene");
    std::fs::write(&path, "{ \"format\": \"cloudwright-scene\", \"version\": 1, \"scene\": 3 }").expect("writable");
    let mut window = Window::open();
    window.settle();
    let scene = window.scene().clone();
    for (path, words) in [(path, "error at line 1"), (folder.path().join("none.cloudscene"), "no such file")] {
        window.answer(Reply::Path(path));
        window.keys(Modifiers::COMMAND, Key::O);
        assert!(window.shows(words), "the problem is listed: {words}");
        assert_eq!((window.scene(), window.session().path()), (&scene, None));
        window.press("OK");
        assert!(!window.shows(words));
    }
    window.press("body");
    window.set("Sprites", 5.0);
    assert_ne!(window.scene(), &scene, "and work goes on");
}

#[test]
fn unsaved_changes_are_asked_about() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = Window::open();
    window.settle();
    let start = window.scene().clone();
    let change = |window: &mut Window| {
        window.press("body");
        window.set("Sprites", 5.0);
    };
    change(&mut window);
    let changed = window.scene().clone();
    window.press("New");
    window.press("Cancel");
    assert_eq!(window.scene(), &changed);
    let new = |window: &mut Window| {
        window.keys(Modifiers::COMMAND, Key::N);
        window.press("One small cloud");
    };
    new(&mut window);
    window.press("Cancel");
    assert_eq!(window.scene(), &changed);
    new(&mut window);
    window.press("Don't save");
    assert_eq!(window.scene(), &start);
    change(&mut window);
    // Saving needs a name; without one, nothing is thrown away.
    window.answer(Reply::Cancelled);
    new(&mut window);
    window.node_in_dialog_save();
    assert_eq!(window.scene(), &changed);
    let path = folder.path().join("kept.cloudscene");
    window.answer(Reply::Path(path.clone()));
    new(&mut window);
    window.node_in_dialog_save();
    assert_eq!(window.scene(), &start, "saved, and then new");
    let named = Scene { name: "kept".into(), ..changed };
    assert_eq!(opening::open_scene(&path).expect("a sound scene"), named, "nobody had given it a name");
}

impl Window {
    /// The dialog's “Save”; the toolbar has one too.
    fn node_in_dialog_save(&mut self) {
        let saves: Vec<_> = self.harness.get_all_by_role_and_label(Role::Button, "Save").collect();
        saves.last().expect("the dialog is open").click();
        self.settle();
    }
}

#[test]
fn where_no_dialog_can_be_shown_a_path_can_be_typed() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("typed.cloudscene");
    let mut window = Window::open();
    window.settle();
    window.answer(Reply::NoDialog);
    window.keys(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    assert_eq!(*window.script.asked.borrow(), [Ask::Save("Untitled.cloudscene".into())]);
    let field = window.harness.get_by_role_and_label(Role::TextInput, "Path of the file");
    field.focus();
    window.settle();
    window.keys(Modifiers::COMMAND, Key::A);
    let field = window.harness.get_by_role_and_label(Role::TextInput, "Path of the file");
    field.type_text(&path.display().to_string());
    window.settle();
    window.keys(Modifiers::NONE, Key::Enter);
    assert_eq!(&opening::open_scene(&path).expect("a sound scene"), window.scene());
}

#[test]
fn a_scene_that_cannot_be_saved_stays_unsaved() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = Window::open();
    window.settle();
    window.press("Add camera");
    window.answer(Reply::Path(folder.path().join("none/a.cloudscene")));
    window.press("Save");
    assert!(window.shows("make the folder first"));
    assert!(window.session().document().is_modified() && window.session().path().is_none());
}

#[test]
fn closing_the_window_asks_first() {
    let mut window = Window::open();
    window.settle();
    let close = |window: &mut Window| {
        let root = window.harness.input_mut().viewports.entry(ViewportId::ROOT).or_default();
        root.events.push(ViewportEvent::Close);
        window.harness.step();
        let out = &window.harness.output().viewport_output[&ViewportId::ROOT];
        out.commands.contains(&ViewportCommand::CancelClose)
    };
    assert!(!close(&mut window), "nothing to lose");
    window.press("Add camera");
    assert!(close(&mut window));
    window.settle();
    assert!(window.shows("Save the changes?"));
    window.press("Cancel");
    assert!(!window.shows("Save the changes?"));
    assert!(close(&mut window), "asked again");
    window.settle();
    window.press("Don't save");
    assert!(!close(&mut window), "answered");
}

/// Reading it would wait for somebody at the pipe's other end.
#[cfg(unix)]
#[test]
fn a_pipe_is_refused_and_not_waited_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("pipe.cloudscene");
    assert!(std::process::Command::new("mkfifo").arg(&path).status().expect("mkfifo runs").success());
    let mut window = Window::open();
    window.settle();
    let scene = window.scene().clone();
    window.answer(Reply::Path(path));
    window.keys(Modifiers::COMMAND, Key::O);
    assert!(window.shows("it is a pipe, not a file"));
    window.press("OK");
    assert_eq!(window.scene(), &scene);
}

#[test]
fn saved_into_another_folder_a_scene_takes_its_atlas_along() {
    const ATLAS: &[u8] = include_bytes!("../../../assets/atlas/clouds.png");
    let home = tempfile::tempdir().expect("a folder");
    let [old, new] = ["old", "new"].map(|name| home.path().join(name));
    let mut window = Window::open();
    window.settle();
    for folder in [&old, &new] {
        std::fs::create_dir(folder).expect("writable");
    }
    let mut scene = window.scene().clone();
    scene.atlas = Some("own.png".into());
    std::fs::write(old.join("own.png"), ATLAS).expect("writable");
    saving::save(&scene, None, &old.join("sky.cloudscene"), Over::Nothing).expect("writable");
    window.answer(Reply::Path(old.join("sky.cloudscene")));
    window.keys(Modifiers::COMMAND, Key::O);
    let save_as = |window: &mut Window, name: &str| {
        window.answer(Reply::Path(new.join(name)));
        window.keys(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    };
    save_as(&mut window, "sky.cloudscene");
    assert!(window.shows("copied beside it: own.png"));
    assert!(std::fs::read(new.join("own.png")).expect("copied") == ATLAS);
    assert_eq!(window.session().path(), Some(new.join("sky.cloudscene").as_path()));
    // Back to the old one: another file of that name is left as it is, and so is the document's own.
    window.answer(Reply::Path(old.join("sky.cloudscene")));
    window.keys(Modifiers::COMMAND, Key::O);
    std::fs::write(new.join("own.png"), "precious").expect("writable");
    save_as(&mut window, "other.cloudscene");
    assert!(window.shows("another file than the scene's atlas"));
    window.press("OK");
    assert!(
        std::fs::read(new.join("own.png")).expect("there") == b"precious" && !new.join("other.cloudscene").exists()
    );
    assert_eq!(window.session().path(), Some(old.join("sky.cloudscene").as_path()));
}
