//! Paths, keys, the clock and recording, by the Flight panel. The clock is view state: only keys and paths change the
//! scene, each as one step.

use crate::Window;
use crate::off_frame::is_idle;
use crate::tools::opened;
use cloudwright::command::Command;
use cloudwright::editor::{Ask, Reply};
use cloudwright::state::Item;
use cloudwright_core::flight::PathCurve;
use cloudwright_core::scene::{Camera, CameraPath};
use egui::accesskit::Role;
use egui::{Key, Modifiers, PointerButton, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use glam::DVec3;

/// Of a frame here, seconds.
const FRAME_S: f64 = 0.25;

impl Window {
    fn path(&self) -> &CameraPath {
        self.scene().paths.first().expect("a path")
    }

    fn clock_s(&self) -> f64 {
        self.node(Role::Slider, "Clock").accesskit_node().numeric_value().expect("a time")
    }

    fn put_clock(&mut self, time_s: f64) {
        self.node(Role::Slider, "Clock").set_value_accesskit(time_s);
        self.settle();
    }

    fn view_now(&self) -> Camera {
        self.harness.state().camera().clone()
    }

    fn orbit(&mut self, by: egui::Vec2) {
        let middle = self.viewport().center();
        self.drag_with(PointerButton::Middle, Modifiers::NONE, middle, by);
    }
}

/// A window with the Flight panel, and a path of three keys that was made by its buttons.
pub(crate) fn with_path() -> Window {
    let mut window = opened();
    window.command(Command::FlightPanel);
    window.press("New path");
    for _ in 0..2 {
        window.orbit(vec2(150.0, 30.0));
        window.press("Add key after the last");
    }
    window
}

fn same_place(a: &Camera, b: &Camera) -> bool {
    // Keys are kept to the millimetre and to a ten-thousandth of a degree.
    a.position.distance(b.position) < 2e-3 && (a.heading_deg - b.heading_deg).abs() < 2e-4
}

#[test]
fn a_path_is_made_of_views() {
    let mut window = opened();
    let start = window.file();
    window.command(Command::FlightPanel);
    assert!(window.shows("No paths yet"));
    let first = window.view_now();
    window.press("New path");
    assert_eq!(window.undo_name().as_deref(), Some("Add path"));
    assert!(window.shows("it stands still"));
    window.press("Play flight");
    assert!(window.shows("leads nowhere yet"), "one key can't be flown");
    assert!(window.harness.query_by_role_and_label(Role::Button, "Pause flight").is_none());
    window.orbit(vec2(150.0, 30.0));
    let second = window.view_now();
    window.press("Add key after the last");
    let path = window.path();
    assert_eq!(path.keys.len(), 2);
    for (key, camera) in path.keys.iter().zip([&first, &second]) {
        let key = Camera { heading_deg: key.heading_deg, ..Camera::free(key.position) };
        assert!(same_place(&key, camera), "{key:?} for {camera:?}");
    }
    // The default speed of a leg is 80 m/s.
    let chord_m = first.position.distance(second.position);
    assert!((path.keys[1].time_s - (chord_m / 80.0).max(0.5)).abs() < 1e-3);
    window.press("Go to key 1");
    assert!(same_place(&window.view_now(), &first));
    for _ in 0..2 {
        window.command(Command::Undo);
    }
    assert_eq!(window.file(), start);
}

#[test]
fn play_flies_and_escape_gives_the_view_back() {
    let mut window = with_path();
    let (scene, before) = (window.file(), window.view_now());
    let curve = PathCurve::new(window.path());
    window.press("Play flight");
    let (time_s, seen) = (window.clock_s(), window.view_now());
    assert!(time_s > 0.0 && time_s < curve.duration_s());
    assert!(window.shows("HDG"), "instruments");
    // The view of a frame is that of the clock when the frame began.
    window.harness.step();
    assert!((window.clock_s() - time_s - FRAME_S).abs() < 1e-6 || window.clock_s() == curve.duration_s());
    assert!(window.view_now() != seen, "it goes on");
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(same_place(&window.view_now(), &before));
    let stopped_s = window.clock_s();
    window.settle();
    assert_eq!(window.clock_s(), stopped_s);
    window.wait("a window that does nothing", is_idle);
    assert_eq!(window.file(), scene, "nothing was changed");
}

#[test]
fn scrubbing_goes_both_ways_to_the_same_view() {
    let mut window = with_path();
    let curve = PathCurve::new(window.path());
    for time_s in [0.3, curve.duration_s(), 0.3, 0.0, 0.7] {
        window.put_clock(time_s);
        assert!(same_place(&window.view_now(), &curve.camera_at(time_s)), "at {time_s} s");
    }
    window.command(Command::FlightEnd);
    assert_eq!(window.clock_s(), curve.duration_s());
    window.command(Command::SecondBack);
    assert!((window.clock_s() - (curve.duration_s() - 1.0).max(0.0)).abs() < 1e-9);
    window.command(Command::FlightStart);
    assert_eq!(window.clock_s(), 0.0);
    window.wait("a window that does nothing", is_idle);
}

#[test]
fn a_hand_ends_the_flight_where_it_is() {
    let mut window = with_path();
    window.put_clock(0.4);
    window.press("Play flight");
    let seen = window.view_now();
    let middle = window.viewport().center();
    window.button(middle, PointerButton::Middle, true, Modifiers::NONE);
    window.pointer(middle + vec2(4.0, 0.0), None);
    window.pointer(middle + vec2(8.0, 0.0), None);
    window.button(middle + vec2(8.0, 0.0), PointerButton::Middle, false, Modifiers::NONE);
    window.settle();
    let (stopped_s, stayed) = (window.clock_s(), window.view_now());
    assert!(window.harness.query_by_role_and_label(Role::Button, "Pause flight").is_none(), "it is over");
    window.keys(Modifiers::NONE, Key::Escape);
    assert_eq!((window.clock_s(), window.view_now()), (stopped_s, stayed.clone()), "nothing to give back");
    let length_m = PathCurve::new(window.path()).duration_s() * 200.0;
    assert!(stayed.position.distance(seen.position) < length_m.max(100.0));
}

#[test]
fn a_loop_begins_anew_and_without_it_the_end_is_the_end() {
    let mut window = with_path();
    let length_s = PathCurve::new(window.path()).duration_s();
    let frames = (length_s / FRAME_S).ceil() as usize + 2;
    window.press("Play flight");
    window.harness.run_steps(frames);
    assert_eq!(window.clock_s(), length_s);
    window.settle();
    window.press("Loop flight");
    window.press("Play flight");
    window.harness.run_steps(frames);
    assert!(window.clock_s() < length_s && window.shows("Pause flight"), "it goes round");
    window.set("Speed of play", 0.5);
    let at_s = window.clock_s();
    window.harness.step();
    let passed_s = (window.clock_s() - at_s).rem_euclid(length_s);
    assert!((passed_s - 0.5 * FRAME_S).abs() < 1e-6, "{passed_s} s a frame");
}

#[test]
fn keys_are_timed_and_deleted_and_a_path_may_go_while_it_is_flown() {
    let mut window = with_path();
    let made = window.path().clone();
    window.set("Speed from key 1", 720.0);
    // 200 m/s: the later keys move in time.
    let timed = window.path().clone();
    assert!(timed.keys[1].time_s < made.keys[1].time_s);
    assert!((timed.keys[2].time_s - timed.keys[1].time_s - made.keys[2].time_s + made.keys[1].time_s).abs() < 1e-6);
    let last_s = timed.keys[2].time_s;
    window.set("Time of key 2", last_s + 5.0);
    assert_eq!(window.path(), &timed, "not beyond the next key");
    window.set("Time of key 3", last_s + 5.0);
    assert_eq!(window.path().keys[2].time_s, last_s + 5.0);
    window.press("Delete key 2");
    assert_eq!((window.path().keys.len(), window.undo_name().as_deref()), (2, Some("Delete key")));
    window.command(Command::Undo);
    assert_eq!(window.path().keys.len(), 3);
    window.press("Key 3");
    window.keys(Modifiers::NONE, Key::Delete);
    assert_eq!(window.path().keys.len(), 2, "the key that is worked on, not its path");
    window.put_clock(0.2);
    window.press("Key at clock");
    assert_eq!(window.path().keys.len(), 3);
    window.press("Key at clock");
    assert_eq!(window.path().keys.len(), 3, "it moves the one that is there");
    window.press("Play flight");
    window.press("Delete path");
    assert!(window.scene().paths.is_empty() && window.shows("No paths yet"));
    window.settle();
    assert!(window.shows("Play flight"), "it does not go on");
}

#[test]
fn a_flight_by_hand_is_recorded_as_one_step() {
    let mut window = opened();
    window.command(Command::FlightPanel);
    window.press("Record");
    window.press("Stop recording");
    assert!(window.scene().paths.is_empty() && window.shows("Nothing was flown"));
    window.press("Record");
    let middle = window.viewport().center();
    let start = window.view_now();
    window.button(middle, PointerButton::Secondary, true, Modifiers::NONE);
    window.harness.key_down(Key::W);
    window.harness.run_steps(8);
    window.harness.key_up(Key::W);
    window.button(middle, PointerButton::Secondary, false, Modifiers::NONE);
    window.harness.run_steps(12);
    let end = window.view_now();
    assert!(end.position.distance(start.position) > 50.0);
    window.settle();
    window.press("Stop recording");
    assert_eq!(window.undo_name().as_deref(), Some("Record flight"));
    let path = window.path().clone();
    let (first, last) = (path.keys[0], path.keys[path.keys.len() - 1]);
    assert!(first.position.distance(start.position) < 1e-2 && last.position.distance(end.position) < 1e-2);
    // Eleven frames or so of flying, and the gliding.
    assert!(last.time_s >= 8.0 * FRAME_S && last.time_s < 30.0 * FRAME_S, "{} s", last.time_s);
    window.command(Command::Undo);
    assert!(window.scene().paths.is_empty());
}

#[test]
fn aircraft_fly_along_the_path_with_a_model_beside_the_scene() {
    let home = tempfile::tempdir().expect("a folder");
    let mut window = with_path();
    window.press("Add aircraft to the path");
    let id = window.scene().aircraft[0].id;
    assert_eq!(window.scene().aircraft[0].path, window.path().id);
    window.set("aircraft ahead", 2.5);
    assert_eq!(window.scene().aircraft[0].ahead_s, 2.5);
    let choose = |window: &mut Window, file: &std::path::Path| {
        window.answer(Reply::Path(file.into()));
        window.harness.get_all_by_label("Model of aircraft").next().expect("a menu").click();
        window.settle();
        window.press("From a file…");
    };
    let model = home.path().join("jet.glb");
    std::fs::write(&model, b"glTF").expect("a file");
    choose(&mut window, &model);
    assert!(window.shows("Save the scene first"));
    window.script.answers.borrow_mut().clear();
    let file = home.path().join("flight.cloudscene");
    window.answer(Reply::Path(file));
    window.command(Command::SaveAs);
    let elsewhere = tempfile::tempdir().expect("a folder").keep().join("jet.glb");
    std::fs::write(&elsewhere, b"glTF").expect("a file");
    choose(&mut window, &elsewhere);
    assert!(window.shows("lie beside the scene"));
    choose(&mut window, &model);
    assert!(matches!(window.script.asked.borrow().last(), Some(Ask::Model(of, _)) if *of == Item::Aircraft(id)));
    assert_eq!(window.scene().aircraft[0].model.as_deref(), Some("jet.glb"));
    window.press("Delete aircraft");
    assert!(window.scene().aircraft.is_empty());
}

#[test]
fn the_clock_is_no_change_and_a_formation_is() {
    let mut window = opened();
    window.command(Command::FlightPanel);
    window.put_clock(12.0);
    window.press("Play flight");
    window.harness.run_steps(4);
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(window.clock_s() > 12.0);
    assert!(!window.session().document().is_modified());
    window.set("Speed of play", 4.0);
    assert!(!window.session().document().is_modified());
    let cloud = window.scene().clouds[0].id;
    window.select([Item::Cloud(cloud)]);
    window.node(Role::ComboBox, "Formation").click();
    window.settle();
    window.harness.get_by_label("forms").click();
    window.settle();
    window.set("Begins at", 30.0);
    window.set("Edges take", 50.0);
    assert!(window.file().contains("\"formation\""), "it is in the file");
    let formation = window.scene().clouds[0].formation.expect("it forms");
    assert_eq!((formation.start_s, formation.edges_s), (30.0, 50.0));
    window.command(Command::FlightEnd);
    // The core takes 20 s, and the edges begin half-way.
    assert_eq!(window.clock_s(), 30.0 + 10.0 + 50.0);
    let eye: DVec3 = window.view_now().position;
    assert!(eye.is_finite());
}
