//! A name is nothing that shows: giving another one leaves picture and memory of the way as they were, on board of a path
//! and by hand, amid the sprites of a cloud. Colours do show.

use crate::{Script, Window, start};
use cloudwright::command::Command;
use cloudwright::editor::Editor;
use cloudwright::state::Item;
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::{CameraPath, PathId, PathKey, Scene};
use cloudwright_tests::small_scenes::heap;
use egui::accesskit::Role;
use egui::{ColorImage, Context, Event, FullOutput, ImageData, Key, Modifiers, PointerButton, TexturesDelta, vec2};
use egui_kittest::{Harness, TestRenderer};
use glam::DVec3;
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;
use std::time::Duration;

/// The pictures of the viewport, in the order in which they came.
#[derive(Clone, Default)]
struct Shown(Rc<RefCell<Vec<Arc<ColorImage>>>>);

impl TestRenderer for Shown {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        for changed in delta.set.values().flatten() {
            // Thumbnails and letters are smaller, or no whole textures.
            if let (ImageData::Color(image), None) = (&changed.image, changed.pos)
                && image.size[0] >= 400
                && image.size[0] != image.size[1]
            {
                self.0.borrow_mut().push(Arc::clone(image));
            }
        }
        delta.clear();
    }

    fn render(&mut self, _: &Context, _: &FullOutput) -> Result<image::RgbaImage, String> {
        Err("nothing is painted here".into())
    }
}

/// A heap, and a path into it.
fn scene() -> Scene {
    let mut scene = heap(60);
    let key = |time_s: f64, z: f64| PathKey {
        time_s,
        position: DVec3::new(60.0, 1010.0, z),
        heading_deg: 0.0,
        pitch_deg: 0.0,
        roll_deg: 0.0,
    };
    let id = PathId::new(&mut scene.next_id);
    scene.paths.push(CameraPath::new(id, "into", vec![key(0.0, 400.0), key(8.0, 0.0)]));
    scene
}

struct Flight {
    window: Window,
    shown: Shown,
    seen: usize,
}

impl Flight {
    /// On board, amid the heap's sprites.
    fn begin(folder: &tempfile::TempDir) -> Self {
        let path = folder.path().join("heap.cloudscene");
        std::fs::write(&path, scene_file::write(&scene()).expect("finite numbers")).expect("writable");
        let (script, shown) = (Script::default(), Shown::default());
        let start = cloudwright::editor::Start { scene: Some(path), ..start(script.clone(), None) };
        let harness = Harness::builder()
            .with_size([1280.0, 1200.0])
            .renderer(shown.clone())
            .build_eframe(move |creation| Editor::new(&creation.egui_ctx, start));
        let mut flight = Self { window: Window { harness, script }, shown, seen: 0 };
        flight.window.settle();
        flight.window.command(Command::FlightPanel);
        flight.window.node(Role::Slider, "Clock").set_value_accesskit(6.5);
        flight.window.settle();
        let eye = flight.window.harness.state().camera().position;
        assert!((eye.z - 75.0).abs() < 40.0, "on board, amid the heap: {eye}");
        flight
    }

    /// The newest picture, when no other has come for a while.
    fn picture(&mut self) -> Arc<ColorImage> {
        let (shown, seen) = (self.shown.clone(), self.seen);
        self.window.wait("a picture", move |_| shown.0.borrow().len() > seen);
        for _ in 0..60 {
            std::thread::sleep(Duration::from_millis(5));
            self.window.harness.step();
        }
        let pictures = self.shown.0.borrow();
        self.seen = pictures.len();
        Arc::clone(pictures.last().expect("a picture"))
    }

    fn name(&mut self, item: Item, more: &str) {
        self.window.select([item]);
        self.window.node(Role::TextInput, "Name").focus();
        self.window.settle();
        self.window.harness.event(Event::Text(more.into()));
        self.window.keys(Modifiers::NONE, Key::Enter);
    }
}

#[test]
fn a_name_given_in_flight_leaves_picture_and_memory_as_they_were() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut flight = Flight::begin(&folder);
    let (cloud, path) = (flight.window.scene().clouds[0].id, flight.window.scene().paths[0].id);
    let on_board = flight.picture();
    flight.name(Item::Cloud(cloud), "2");
    assert!(flight.window.scene().clouds[0].name.contains('2'), "it has the name");
    assert!(flight.picture() == on_board, "a cloud's name shows on board");
    flight.name(Item::Path(path), "2");
    assert!(flight.window.scene().paths[0].name.contains('2'));
    assert!(flight.picture() == on_board, "the path's name shows");
    // A hand takes over where the flight was, and remembers what it had seen.
    let middle = flight.window.viewport().center();
    flight.window.button(middle, PointerButton::Middle, true, Modifiers::NONE);
    flight.window.pointer(middle + vec2(8.0, 0.0), None);
    flight.window.button(middle + vec2(8.0, 0.0), PointerButton::Middle, false, Modifiers::NONE);
    flight.window.settle();
    let by_hand = flight.picture();
    assert!(by_hand != on_board, "it has turned");
    flight.name(Item::Cloud(cloud), "3");
    assert!(flight.window.scene().clouds[0].name.contains('3'));
    assert!(flight.picture() == by_hand, "a cloud's name shows by hand: sprites near the eye snapped");
}
