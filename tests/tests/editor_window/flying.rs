//! Flying in the viewport, by the right button, keys and wheel. None of it changes the scene.

use crate::Window;
use crate::off_frame::is_idle;
use crate::tools::opened;
use cloudwright::command::Command;
use cloudwright::state::Tool;
use cloudwright::storage::Folders;
use cloudwright_core::camera::View;
use cloudwright_core::scene::Camera;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, TouchPhase, vec2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;

/// Of a frame here, seconds; one event comes a frame.
const FRAME_S: f64 = 0.25;
/// What flight begins with, metres a second.
const SPEED_M_S: f64 = 60.0;

impl Window {
    pub(crate) fn eye(&self) -> Camera {
        self.harness.state().camera().clone()
    }

    fn hold(&mut self, pressed: bool) {
        let middle = self.viewport().center();
        self.button(middle, PointerButton::Secondary, pressed, Modifiers::NONE);
    }

    fn key(&mut self, key: Key, pressed: bool, repeat: bool) {
        let modifiers = Modifiers::NONE;
        self.harness.event(Event::Key { key, pressed, repeat, modifiers, physical_key: None });
        self.harness.step();
    }

    fn modifiers(&mut self, modifiers: Modifiers) {
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.harness.run_steps(12);
    }

    pub(crate) fn wheel(&mut self, notches: f32) {
        self.harness.event(Event::MouseWheel {
            unit: MouseWheelUnit::Line,
            delta: vec2(0.0, notches),
            phase: TouchPhase::Move,
            source: MouseWheelSource::Unknown,
            modifiers: Modifiers::NONE,
        });
        self.harness.run_steps(12);
    }

    fn tool(&self) -> Tool {
        self.harness.state().view().tool
    }
}

fn forward(camera: &Camera) -> DVec3 {
    View::new(camera, 1, 1).forward.as_dvec3()
}

#[test]
fn w_flies_while_the_button_is_held_and_is_a_command_else() {
    let mut window = opened();
    let (scene, start) = (window.scene().clone(), window.eye());
    window.hold(true);
    window.key(Key::W, true, false);
    window.harness.run_steps(7);
    let flown = window.eye().position - start.position;
    // Eight frames of relaxing to the speed, with 0.3 s of inertia, in closed form.
    let wanted = SPEED_M_S * (8.0 * FRAME_S - 0.3 * (1.0 - (-8.0 * FRAME_S / 0.3_f64).exp()));
    assert!(flown.distance(forward(&start) * wanted) < 0.01, "{flown} is not {wanted} m ahead");
    window.key(Key::W, true, true);
    window.hold(false);
    window.key(Key::W, true, true);
    assert_eq!(window.tool(), Tool::Select, "the key is the flight's until it is let go");
    window.key(Key::W, false, false);
    assert!(window.shows("HDG"), "it glides");
    window.harness.run_steps(12);
    assert!(!window.shows("HDG"), "it rests");
    window.wait("a window that does nothing", is_idle);
    // What is lost while gathering speed is gained while gliding. The button was let go in the second frame of two.
    let flown = window.eye().position - start.position;
    assert!(flown.distance(forward(&start) * SPEED_M_S * FRAME_S * 10.0) < 0.01, "{flown}");
    assert_eq!((window.scene(), window.tool()), (&scene, Tool::Select));
    window.keys(Modifiers::NONE, Key::W);
    assert_eq!(window.tool(), Tool::Move);
}

#[test]
fn each_key_has_its_direction() {
    let mut window = opened();
    window.hold(true);
    let view = View::new(&window.eye(), 1, 1);
    let (ahead, right) = (view.forward.as_dvec3(), view.right.as_dvec3());
    for (key, direction) in
        [(Key::W, ahead), (Key::S, -ahead), (Key::D, right), (Key::A, -right), (Key::E, DVec3::Y), (Key::Q, -DVec3::Y)]
    {
        let start = window.eye().position;
        window.key(key, true, false);
        window.key(key, false, false);
        window.harness.run_steps(12);
        let flown = window.eye().position - start;
        // One frame's wish; axes are f32.
        assert!(flown.distance(direction * SPEED_M_S * FRAME_S) < 1e-3, "{key:?}: {flown}");
    }
    assert_eq!(window.tool(), Tool::Select);
}

#[test]
fn the_mouse_turns_the_head_and_a_click_alone_does_nothing() {
    let mut window = opened();
    let start = window.eye();
    window.hold(true);
    window.hold(false);
    window.settle();
    assert_eq!(window.eye(), start);
    assert!(!window.shows("HDG"));
    let middle = window.viewport().center();
    window.drag_with(PointerButton::Secondary, Modifiers::NONE, middle, vec2(100.0, -50.0));
    window.harness.run_steps(4);
    let turned = window.eye();
    assert_eq!(turned.position, start.position);
    let [right, up] = [turned.heading_deg - start.heading_deg, turned.pitch_deg - start.pitch_deg];
    // A fifth of a degree a point.
    assert!((right - 20.0).abs() < 0.1 && (up - 10.0).abs() < 0.1, "{right}° to the right and {up}° up");
}

#[test]
fn the_wheel_sets_the_speed_and_the_instruments_show_it() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = || Some(Folders::within(home.path()));
    let mut window = Window::open_with(folders());
    window.settle();
    window.hold(true);
    window.key(Key::W, true, false);
    window.harness.run_steps(12);
    assert!(window.shows("· 216 km/h ·"), "60 m/s");
    window.wheel(1.0);
    assert!(window.shows("· 270 km/h ·"), "a quarter more");
    for (modifiers, speed) in [
        (Modifiers::SHIFT, "· 1\u{202F}080 km/h ·"),
        (Modifiers::CTRL, "· 68 km/h ·"),
        (Modifiers::NONE, "· 270 km/h ·"),
    ] {
        window.modifiers(modifiers);
        assert!(window.shows(speed), "{speed} with {modifiers:?}");
    }
    window.command(Command::SwitchUnits);
    let altitude = window.eye().position.y / 0.3048;
    assert!(window.shows("· 146 kt ·"), "75 m/s");
    let shown = window.harness.get_by_label_contains("ALT ").value().expect("a text").replace('\u{202F}', "");
    let feet = shown.trim_start_matches("ALT ").split(' ').next().and_then(|feet| feet.parse::<f64>().ok());
    // It is rounded to tens.
    assert!(feet.is_some_and(|feet| (feet - altitude).abs() <= 5.0), "{shown} for {altitude}");
    drop(window);
    let mut window = Window::open_with(folders());
    window.settle();
    window.hold(true);
    window.key(Key::W, true, false);
    assert!(window.shows(" kt ·"), "units are remembered");
}

#[test]
fn escape_stops_at_once_and_drops_nothing_else() {
    let mut window = opened();
    window.command(Command::PlayTime);
    window.hold(true);
    window.key(Key::W, true, false);
    window.harness.run_steps(4);
    window.key(Key::Escape, true, false);
    let stopped = window.eye();
    window.key(Key::Escape, false, false);
    window.key(Key::W, true, true);
    window.harness.run_steps(4);
    assert_eq!(window.eye(), stopped, "until the button is pressed anew");
    assert_eq!(window.tool(), Tool::Select, "the button is still down");
    window.key(Key::W, false, false);
    window.hold(false);
    window.command(Command::PlayTime);
    window.command(Command::KeepHour);
    assert_eq!(window.undo_name().as_deref(), Some("Keep this hour"), "the time ran on");
}

#[test]
fn letters_fly_and_are_not_typed() {
    let mut window = opened();
    window.press("main");
    window.node(Role::TextInput, "Name").focus();
    window.settle();
    let start = window.eye();
    window.hold(true);
    window.harness.event(Event::Text("w".into()));
    window.key(Key::W, true, false);
    window.harness.run_steps(4);
    assert_ne!(window.eye().position, start.position);
    assert_eq!(window.scene().cameras[0].name, "main");
}
