//! Cut, copy and paste by their keys, within a scene and between two, of things, boxes and keys; and of anything else.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::editor::Reply;
use cloudwright::state::Item;
use cloudwright_core::arrange::clip;
use cloudwright_core::formats::{scene_clip, scene_file};
use cloudwright_core::scene::{Prop, PropId, Scene};
use cloudwright_tests::small_scenes::crowd;
use egui::{ColorImage, Event, Key, Modifiers, OutputCommand};
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl Window {
    /// Copies or cuts by its keys; what then stands on the clipboard.
    pub(crate) fn clipped(&mut self, event: Event) -> String {
        self.harness.event(event);
        self.harness.step();
        let mut copied = None;
        // A frame may be drawn in several passes.
        for command in &self.harness.output().platform_output.commands {
            if let OutputCommand::CopyText(text) = command {
                copied = Some(text.clone());
            }
        }
        self.settle();
        copied.expect("something was copied")
    }

    /// As the system does when the keys of *Paste* are pressed.
    pub(crate) fn paste(&mut self, text: &str) {
        self.harness.event(Event::Paste(text.into()));
        self.settle();
    }

    fn counts(&self) -> [usize; 4] {
        let scene = self.scene();
        [scene.models.len(), scene.clouds.len(), scene.cameras.len(), boxes(scene)]
    }

    fn steps(&self) -> usize {
        self.session().document().history().len()
    }
}

fn boxes(scene: &Scene) -> usize {
    scene.models.first().map_or(0, |model| model.boxes.len())
}

fn opened() -> Window {
    let mut window = Window::open();
    window.settle();
    window
}

type Choose = fn(&Scene) -> Vec<Item>;

#[test]
fn each_kind_is_copied_cut_and_pasted_as_one_step() {
    let cases: [(Choose, [usize; 4], &str); 4] = [
        (|scene| vec![Item::Cloud(scene.clouds[0].id)], [1, 2, 1, 4], "1 cloud"),
        (|scene| vec![Item::Model(scene.models[0].id)], [2, 1, 1, 4], "1 model"),
        (|scene| vec![Item::Camera(scene.cameras[0].id)], [1, 1, 2, 4], "1 camera"),
        (|scene| vec![Item::Box(scene.models[0].id, scene.models[0].boxes[1].id)], [1, 1, 1, 5], "1 box"),
    ];
    for (choose, wanted, what) in cases {
        let mut window = opened();
        let start = window.file();
        let items = choose(window.scene());
        window.select(items.clone());
        let text = window.clipped(Event::Copy);
        assert!(text.contains("\"cloudwright-clip\""), "{text}");
        assert_eq!(window.file(), start, "copying changes nothing");
        window.paste(&text);
        assert_eq!(window.counts(), wanted, "{items:?}");
        assert_eq!((window.steps(), window.undo_name()), (1, Some(format!("Paste {what}"))));
        assert!(window.shows(&format!("Pasted {what}")));
        let selected = window.harness.state().selection().items().to_vec();
        assert!(selected.len() == 1 && selected != items, "what was pasted is selected: {selected:?}");
        window.command(Command::Undo);
        assert_eq!(window.file(), start);
        // Cut and paste.
        window.select(items);
        let text = window.clipped(Event::Cut);
        assert_ne!(window.file(), start);
        assert_eq!((window.steps(), window.undo_name().as_deref()), (1, Some("Cut")));
        if boxes(window.scene()) == 3 {
            let cloud = Item::Cloud(window.scene().clouds[0].id);
            window.select([cloud]);
        }
        window.paste(&text);
        let counts = window.counts();
        assert!(counts[1..].iter().zip(&[1, 1, 4]).all(|(count, was)| count <= was), "{counts:?}");
        assert_eq!(counts[0], 1, "there as before");
    }
}

#[test]
fn clouds_come_into_another_scene() {
    let mut window = opened();
    let cloud = Item::Cloud(window.scene().clouds[0].id);
    window.select([cloud]);
    let text = window.clipped(Event::Copy);
    let mut other = opened();
    other.command(Command::SelectAll);
    other.command(Command::Delete);
    other.command(Command::Undo);
    other.command(Command::Reroll);
    let at = other.scene().clouds[0].position;
    other.paste(&text);
    assert_eq!(other.counts(), [1, 2, 1, 4], "the same model is shared");
    assert!(other.scene().clouds[1].position.x > at.x, "beside the one that stands there");
    let model = Item::Model(other.scene().models[0].id);
    other.select([model]);
    other.command(Command::Reroll);
    other.paste(&text);
    assert_eq!(other.counts()[..2], [2, 3], "it is another one now");
    other.was_told("Paste 1 cloud and 1 model");
    assert!(other.shows("Pasted 1 cloud and 1 model"));
}

#[test]
fn boxes_need_a_model() {
    let mut window = opened();
    let model = window.scene().models[0].clone();
    window.select(model.boxes.iter().map(|each| Item::Box(model.id, each.id)));
    let text = window.clipped(Event::Copy);
    window.select([]);
    let start = window.file();
    window.paste(&text);
    assert_eq!(window.file(), start);
    assert!(window.shows("choose a cloud or a model to paste boxes into"));
    window.select([Item::Model(model.id)]);
    window.paste(&text);
    assert_eq!(window.counts()[3], 8);
}

#[test]
fn anything_else_is_told_and_changes_nothing() {
    let mut window = opened();
    let cloud = Item::Cloud(window.scene().clouds[0].id);
    window.select([cloud]);
    let text = window.clipped(Event::Copy);
    let (start, steps) = (window.file(), window.steps());
    let novel = "Call me Ishmael. Some years ago—never mind how long precisely. ".repeat(20_000);
    let cases = [
        (novel.as_str(), "no part of a scene"),
        (&text[..text.len() / 2], "broken"),
        (&text.replace("\"version\": 1", "\"version\": 7"), "version 7"),
        (&text.replace("\"scale\": 1", "\"scale\": -1"), "At clouds[0].scale"),
        (&start, "whole scene"),
    ];
    for (pasted, words) in cases {
        window.paste(pasted);
        assert!(window.shows(words), "{words}");
        assert_eq!((window.file(), window.steps()), (start.clone(), steps), "{words}");
    }
    window.harness.event(Event::PasteImage(Arc::new(ColorImage::filled([4, 4], egui::Color32::RED))));
    window.settle();
    assert!(window.shows("a picture is on the clipboard"));
    assert_eq!(window.file(), start);
    window.paste(&text);
    assert!(!window.shows("a picture is on the clipboard"), "what went well takes the complaints away");
}

#[test]
fn an_empty_clipboard_is_told() {
    let mut window = opened();
    let start = window.file();
    window.command(Command::Paste);
    assert!(window.shows("the clipboard is empty"));
    assert_eq!(window.file(), start);
}

#[test]
fn a_pasted_prop_without_its_file_is_told_with_where_that_was() {
    let (mut window, folder) = crate::outline::with_scene(&crowd(1));
    let file = folder.path().join("hill.glb");
    std::fs::write(&file, include_bytes!("../../../assets/models/aircraft.glb")).expect("writable");
    let mut other = Scene::default();
    let prop = Prop::new(PropId::new(&mut other.next_id), "hill.glb", glam::DVec3::ZERO);
    let thing = Item::Prop(prop.id);
    other.props.push(prop);
    let clip = clip::things(&other, &[thing]).expect("a prop");
    window.paste(&scene_clip::write(&clip).expect("finite"));
    assert!(window.scene().props.len() == 1 && !window.shows("hill.glb”"), "it lies there");
    window.select([Item::Prop(window.scene().props[0].id)]);
    let text = window.clipped(Event::Copy);
    std::fs::remove_file(&file).expect("it is there");
    window.paste(&text);
    assert_eq!(window.scene().props.len(), 2);
    assert!(window.shows("“hill.glb”") && window.shows("copied from"));
}

/// A scene with one prop, whose model lies beside it, in a folder of that name.
fn hill_in(home: &Path, name: &str, model: &[u8]) -> PathBuf {
    let folder = home.join(name);
    std::fs::create_dir(&folder).expect("writable");
    std::fs::write(folder.join("hill.glb"), model).expect("writable");
    let mut scene = crowd(1);
    scene.props.push(Prop::new(PropId::new(&mut scene.next_id), "hill.glb", glam::DVec3::ZERO));
    let path = folder.join("scene.cloudscene");
    std::fs::write(&path, scene_file::write(&scene).expect("finite")).expect("writable");
    path
}

#[test]
fn a_pasted_props_model_is_shown_at_once_and_saved_along() {
    const MODEL: &[u8] = include_bytes!("../../../assets/models/aircraft.glb");
    let home = tempfile::tempdir().expect("a folder");
    let from = hill_in(home.path(), "from", MODEL);
    let mut window = opened();
    let copy = |window: &mut Window| {
        window.harness.state_mut().open_path(&from);
        window.settle();
        window.select([Item::Prop(window.scene().props[0].id)]);
        window.clipped(Event::Copy)
    };
    let text = copy(&mut window);
    // Into a scene without a folder.
    window.command(Command::New);
    window.press("Clear sky");
    window.paste(&text);
    assert!(window.shows("Pasted 1 prop") && !window.shows("hill.glb”"), "it is found where it was copied");
    let to = home.path().join("to");
    std::fs::create_dir(&to).expect("writable");
    window.answer(Reply::Path(to.join("sky.cloudscene")));
    window.keys(Modifiers::COMMAND, Key::S);
    assert!(window.shows("copied beside it: hill.glb"));
    assert!(std::fs::read(to.join("hill.glb")).expect("copied") == MODEL);
    // Into one that has another file of that name.
    let text = copy(&mut window);
    let mut other = MODEL.to_vec();
    other.push(0);
    let path = hill_in(home.path(), "other", &other);
    window.harness.state_mut().open_path(&path);
    window.settle();
    window.paste(&text);
    assert!(window.shows("“hill.glb” beside this scene is another file"));
    window.keys(Modifiers::COMMAND, Key::S);
    assert!(std::fs::read(path.with_file_name("hill.glb")).expect("there") == other, "it stays");
}

#[test]
fn in_a_field_the_keys_are_the_texts() {
    let mut window = opened();
    let cloud = Item::Cloud(window.scene().clouds[0].id);
    window.select([cloud]);
    let text = window.clipped(Event::Copy);
    let start = window.file();
    window.node(egui::accesskit::Role::TextInput, "Name").focus();
    window.settle();
    window.harness.event(Event::Cut);
    window.settle();
    window.paste("x");
    window.keys(Modifiers::NONE, Key::Escape);
    assert_eq!(window.file(), start);
    window.keys(Modifiers::COMMAND, Key::X);
    assert_eq!(window.scene().clouds.len(), 0, "by its keys where the system has no words for them");
    window.paste(&text);
    assert_eq!(window.scene().clouds.len(), 1);
}
