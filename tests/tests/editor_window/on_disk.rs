//! The document's file, changed behind the editor's back.

use crate::Window;
use cloudwright::editor::Reply;
use cloudwright::opening;
use cloudwright::saving;
use cloudwright::storage::Over;
use cloudwright_core::scene::Scene;
use egui::{Event, Key, Modifiers};
use std::path::Path;

impl Window {
    /// With the starter scene, saved at `path`.
    fn saved_at(path: &Path) -> Self {
        let mut window = Self::open();
        window.settle();
        window.answer(Reply::Path(path.into()));
        window.press("Save");
        window
    }

    /// Frames until the watcher has seen what is there; it looks at once when the window gets the focus.
    fn wait_for(&mut self, what: &str, seen: impl Fn(&Self) -> bool) {
        for focused in [false, true] {
            self.harness.input_mut().focused = focused;
            self.harness.event(Event::WindowFocused(focused));
            self.harness.step();
        }
        for _ in 0..1000 {
            if seen(self) {
                return self.settle();
            }
            std::thread::sleep(std::time::Duration::from_millis(10));
            self.harness.step();
        }
        panic!("never seen: {what}");
    }
}

fn another_program_writes(path: &Path, name: &str) -> Scene {
    let mut scene = opening::open_scene(path).expect("a sound scene");
    scene.name = name.into();
    saving::save(&scene, None, path, Over::Anything).expect("writable");
    scene
}

#[test]
fn an_unmodified_document_follows_its_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sky.cloudscene");
    let mut window = Window::saved_at(&path);
    let theirs = another_program_writes(&path, "theirs");
    window.wait_for("the new scene", |window| window.scene().name == "theirs");
    assert_eq!(window.scene(), &theirs);
    assert!(window.shows("changed by another program") && !window.session().document().is_modified());
    std::fs::write(&path, "{").expect("writable");
    window.wait_for("the broken file", |window| window.shows("Problems in"));
    window.press("OK");
    assert_eq!(window.scene(), &theirs, "a broken file takes nothing away");
    assert!(window.session().document().is_modified(), "and what is here is not what is there");
    std::fs::remove_file(&path).expect("there");
    window.wait_for("that it is gone", |window| window.shows("is gone"));
    window.keys(Modifiers::COMMAND, Key::S);
    assert_eq!(opening::open_scene(&path).expect("written again"), theirs);
}

#[test]
fn a_modified_document_is_asked_about() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sky.cloudscene");
    let mut window = Window::saved_at(&path);
    window.press("Add camera");
    let mine = window.scene().clone();
    another_program_writes(&path, "theirs");
    window.wait_for("the question", |window| window.shows("The file has changed"));
    window.press("Keep mine");
    assert_eq!(window.scene(), &mine);
    window.keys(Modifiers::COMMAND, Key::Z);
    assert!(window.session().document().is_modified(), "the file is not the scene that was saved");
    window.keys(Modifiers::COMMAND, Key::S);
    assert!(!window.session().document().is_modified(), "the question was answered already");
    window.press("Add camera");
    let theirs = another_program_writes(&path, "theirs again");
    window.wait_for("the question", |window| window.shows("The file has changed"));
    window.press("Load theirs");
    assert_eq!(window.scene(), &theirs);
}

#[test]
fn a_newer_file_is_not_overwritten_unasked() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sky.cloudscene");
    let mut window = Window::saved_at(&path);
    // Without the focus nobody looks, and so the save itself has to.
    window.harness.input_mut().focused = false;
    window.press("Add camera");
    let theirs = another_program_writes(&path, "theirs");
    window.keys(Modifiers::COMMAND, Key::S);
    assert!(window.shows("Replace the file?") && window.shows("another program changed it"));
    window.press("Cancel");
    assert_eq!(opening::open_scene(&path).expect("a sound scene"), theirs);
    assert!(window.session().document().is_modified());
    window.keys(Modifiers::COMMAND, Key::S);
    window.press("Replace");
    assert_eq!(&opening::open_scene(&path).expect("a sound scene"), window.scene());
    assert!(!window.session().document().is_modified());
}

#[test]
fn ones_own_saves_are_no_news() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sky.cloudscene");
    let mut window = Window::saved_at(&path);
    for _ in 0..3 {
        window.press("Add camera");
        window.keys(Modifiers::COMMAND, Key::S);
        let revision = window.undo_name();
        // The watcher looks at once, and again when what it saw should have settled.
        for focused in [false, true] {
            window.harness.input_mut().focused = focused;
            window.harness.step();
        }
        std::thread::sleep(std::time::Duration::from_millis(450));
        window.settle();
        assert_eq!(window.undo_name(), revision, "it was not loaded anew");
        assert!(!window.shows("The file has changed"));
    }
}
