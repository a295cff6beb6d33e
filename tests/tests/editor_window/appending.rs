//! *Append from scene…*: a scene put together from two others.

use crate::outline::with_scene;
use cloudwright::command::Command;
use cloudwright::editor::Reply;
use cloudwright_core::formats::scene_file;
use cloudwright_tests::small_scenes::{crowd, heap};
use egui::accesskit::Role;
use egui::{Key, Modifiers};

#[test]
fn chosen_clouds_come_in_with_their_models() {
    let mut other = crowd(9);
    for index in 0..9 {
        other.clouds[index].name = format!("small {index}");
    }
    let (mut window, folder) = with_scene(&heap(20));
    let start = window.file();
    let path = folder.path().join("other.cloudscene");
    std::fs::write(&path, scene_file::write(&other).expect("finite numbers")).expect("writable");
    window.answer(Reply::Path(path.clone()));
    window.command(Command::Append);
    assert!(window.shows("Append from other.cloudscene") && window.shows("9 of 9 clouds"));
    window.press("None");
    for name in ["small 0", "small 3", "small 4"] {
        window.node(Role::CheckBox, name).click();
        window.settle();
    }
    window.press("Append");
    let scene = window.scene();
    assert_eq!((scene.clouds.len(), scene.models.len(), scene.cameras.len()), (4, 3, 1));
    assert_eq!(scene.clouds[2].position, other.clouds[3].position, "where it stands there");
    assert_eq!(window.undo_name().as_deref(), Some("Append from scene"));
    assert_eq!(window.harness.state().selection().items().len(), 3);
    // Once more: the models are here already, and no cloud hides another.
    window.answer(Reply::Path(path));
    window.command(Command::Append);
    window.keys(Modifiers::NONE, Key::Enter);
    let scene = window.scene();
    assert_eq!((scene.clouds.len(), scene.models.len()), (13, 4), "one model is new");
    window.command(Command::Undo);
    window.command(Command::Undo);
    assert_eq!(window.file(), start);
}

#[test]
fn what_is_no_scene_changes_nothing() {
    let (mut window, folder) = with_scene(&heap(20));
    let start = window.file();
    for (name, text, words) in [
        ("novel.cloudscene", "It was a dark and stormy night.", "line 1"),
        ("newer.cloudscene", "{\"format\": \"cloudwright-scene\", \"version\": 99}", "version 99"),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("writable");
        window.answer(Reply::Path(path));
        window.command(Command::Append);
        assert!(window.shows(words), "{name}");
        window.press("OK");
    }
    window.answer(Reply::Path(folder.path().join("gone.cloudscene")));
    window.command(Command::Append);
    assert!(window.shows("The scene can't be read"));
    assert_eq!(window.file(), start);
}
