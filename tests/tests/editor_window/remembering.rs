//! What is remembered from one start to the next, and the ways to a scene that was open before.

use crate::{Script, Window, start};
use cloudwright::editor::{Editor, Reply};
use cloudwright::storage::Folders;
use egui::{DroppedFile, Key, Modifiers, ThemePreference};
use std::path::{Path, PathBuf};
use std::sync::Arc;

#[derive(Debug)]
struct Dropped(PathBuf);

impl DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Err("the editor reads it by its path".into())
    }
}

impl Window {
    fn save_at(&mut self, path: &Path) {
        self.answer(Reply::Path(path.into()));
        self.keys(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    }

    fn drop_files(&mut self, paths: &[&Path]) {
        for path in paths {
            self.harness.input_mut().dropped_files.push(Arc::new(Dropped(path.into())));
        }
        self.settle();
    }
}

#[test]
fn recent_scenes_are_offered_and_those_gone_are_not() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = || Some(Folders::within(home.path()));
    let [first, second] = ["first.cloudscene", "second.cloudscene"].map(|name| home.path().join(name));
    let mut window = Window::open_with(folders());
    window.settle();
    window.keys(Modifiers::COMMAND | Modifiers::SHIFT, Key::O);
    assert!(!window.shows("Open recent"), "there is none yet");
    window.save_at(&first);
    window.press("Add camera");
    window.save_at(&second);
    drop(window);
    let mut window = Window::open_with(folders());
    window.settle();
    window.keys(Modifiers::COMMAND | Modifiers::SHIFT, Key::O);
    window.keys(Modifiers::NONE, Key::Num2);
    assert_eq!((window.session().path(), window.scene().cameras.len()), (Some(first.as_path()), 1));
    std::fs::remove_file(&second).expect("there");
    window.press("Add camera");
    window.keys(Modifiers::COMMAND | Modifiers::SHIFT, Key::O);
    assert!(window.shows("gone from"));
    window.keys(Modifiers::NONE, Key::Num2);
    assert!(window.shows("gone from"), "what is gone can't be chosen");
    window.keys(Modifiers::NONE, Key::Num1);
    assert!(window.shows("Save the changes?"), "opening it would lose the camera");
    window.press("Don't save");
    assert_eq!(window.scene().cameras.len(), 1);
}

#[test]
fn revert_goes_back_to_the_file_after_a_question() {
    let home = tempfile::tempdir().expect("a folder");
    let mut window = Window::open();
    window.settle();
    window.save_at(&home.path().join("sky.cloudscene"));
    let saved = window.scene().clone();
    window.press("Add camera");
    let changed = window.scene().clone();
    let revert = |window: &mut Window, answer: &str| {
        window.press("File");
        window.press("Revert…");
        window.press(answer);
    };
    revert(&mut window, "Cancel");
    assert_eq!(window.scene(), &changed);
    revert(&mut window, "Revert");
    assert_eq!(window.scene(), &saved);
    assert!(!window.session().document().is_modified());
}

#[test]
fn a_dropped_scene_is_opened() {
    let home = tempfile::tempdir().expect("a folder");
    let [scene, picture] = ["sky.cloudscene", "sky.png"].map(|name| home.path().join(name));
    let mut window = Window::open();
    window.settle();
    window.press("Add camera");
    window.save_at(&scene);
    window.keys(Modifiers::COMMAND, Key::N);
    window.press("One small cloud");
    window.drop_files(&[&picture]);
    assert!(window.shows("sky.png is no scene"));
    window.drop_files(&[&scene, &picture]);
    assert!(window.shows("One scene at a time"));
    let folders = ["folder", "folder.cloudscene"].map(|name| home.path().join(name));
    folders.iter().for_each(|folder| std::fs::create_dir(folder).expect("writable"));
    window.drop_files(&[&folders[0]]);
    assert!(window.shows("folder is no scene"));
    window.drop_files(&[&folders[1]]);
    assert!(window.shows("The scene can't be opened"));
    window.press("OK");
    assert_eq!(window.session().path(), None);
    window.press("Add camera");
    window.drop_files(&[&scene]);
    assert!(window.shows("Save the changes?"));
    window.drop_files(&[&scene]);
    assert!(window.shows("answer the question first"));
    window.press("Don't save");
    assert_eq!(window.session().path(), Some(scene.as_path()));
}

#[test]
fn the_look_is_remembered_and_bad_settings_do_no_harm() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = Folders::within(home.path());
    // The harness has a look of its own, so the next start is asked without it.
    let look_at_start = || {
        let context = egui::Context::default();
        let _editor = Editor::new(&context, start(Script::default(), Some(folders.clone())));
        context.options(|options| options.theme_preference)
    };
    assert_eq!(look_at_start(), ThemePreference::System);
    let mut window = Window::open_with(Some(folders.clone()));
    window.settle();
    window.press("View");
    window.press("Dark or light");
    drop(window);
    assert_eq!(look_at_start(), ThemePreference::Light);
    std::fs::write(folders.config.join("settings.json"), "{\"version\": 99}").expect("writable");
    assert_eq!(look_at_start(), ThemePreference::System);
    let mut window = Window::open_with(Some(folders));
    window.settle();
    assert!(window.shows("the settings start anew"));
}

#[test]
fn a_scene_whose_atlas_is_gone_opens_all_the_same() {
    let home = tempfile::tempdir().expect("a folder");
    let path = home.path().join("sky.cloudscene");
    let mut window = Window::open();
    window.settle();
    window.save_at(&path);
    let text = std::fs::read_to_string(&path).expect("there");
    let mut file: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    file["scene"]["atlas"] = "gone.png".into();
    std::fs::write(&path, file.to_string()).expect("writable");
    let mut window = Window::open();
    window.settle();
    window.drop_files(&[&path]);
    assert!(window.shows("error at atlas"));
    window.press("OK");
    assert_eq!(window.scene().atlas.as_deref(), Some("gone.png"));
    window.press("Add camera");
    window.keys(Modifiers::COMMAND, Key::S);
    assert!(!window.session().document().is_modified(), "and is saved as it is");
}
