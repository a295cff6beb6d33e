//! Camera paths in the viewport: picked, and their keys moved by the gizmo.

use crate::Window;
use crate::tools::opened;
use cloudwright::command::Command;
use cloudwright::state::Item;
use cloudwright_core::camera::View;
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::{CameraPath, PathId, PathKey};
use egui::{Event, Modifiers, PointerButton, Pos2, vec2};
use glam::DVec3;

/// A window with a path of three keys across the first camera's view, 600 m ahead, below the clouds.
fn with_path_in_view() -> (Window, tempfile::TempDir) {
    let mut scene = opened().scene().clone();
    let view = View::new(&scene.cameras[0], 1, 1);
    let (right, up) = (view.right.as_dvec3(), view.up.as_dvec3());
    let middle = view.eye + view.forward.as_dvec3() * 600.0 - up * 150.0;
    let key = |i: i32| PathKey {
        time_s: f64::from(i) * 5.0,
        position: middle + right * 130.0 * f64::from(i - 1) + up * 10.0 * f64::from(i % 2),
        heading_deg: scene.cameras[0].heading_deg,
        pitch_deg: 0.0,
        roll_deg: 0.0,
    };
    let keys = (0..3).map(key).collect();
    let id = PathId::new(&mut scene.next_id);
    scene.paths.push(CameraPath::new(id, "across", keys));
    let home = tempfile::tempdir().expect("a folder");
    let file = home.path().join("across.cloudscene");
    std::fs::write(&file, scene_file::write(&scene).expect("a sound scene")).expect("a file");
    let mut window = opened();
    window.harness.state_mut().open_path(&file);
    window.settle();
    window.command(Command::FlightPanel);
    (window, home)
}

impl Window {
    fn key_place(&self, index: usize) -> DVec3 {
        self.scene().paths[0].keys[index].position
    }

    fn key_on_screen(&self, index: usize) -> Pos2 {
        self.on_screen(self.key_place(index))
    }
}

#[test]
fn a_click_picks_a_path_or_its_key() {
    let (mut window, _home) = with_path_in_view();
    let path = window.scene().paths[0].id;
    let between = window.key_on_screen(0) + (window.key_on_screen(1) - window.key_on_screen(0)) * 0.5;
    window.click(between, Modifiers::NONE);
    assert_eq!((window.primary(), window.harness.state().view().path_key), (Some(Item::Path(path)), None));
    window.click(window.key_on_screen(1), Modifiers::NONE);
    assert_eq!(window.harness.state().view().path_key, Some((path, 1)));
    window.click(window.key_on_screen(1) + vec2(0.0, 60.0), Modifiers::NONE);
    assert_eq!(window.harness.state().view().path_key, None, "beside");
}

#[test]
fn the_gizmo_moves_a_key_alone_or_the_whole_path() {
    let (mut window, _home) = with_path_in_view();
    let start = window.scene().clone();
    window.click(window.key_on_screen(1), Modifiers::NONE);
    window.press("Move");
    let before: Vec<DVec3> = (0..3).map(|index| window.key_place(index)).collect();
    // The arrow upwards.
    window.drag(window.key_on_screen(1) - vec2(0.0, 52.0), vec2(0.0, -60.0));
    let after: Vec<DVec3> = (0..3).map(|index| window.key_place(index)).collect();
    assert!(after[1].y > before[1].y + 10.0, "{} from {}", after[1], before[1]);
    assert_eq!((after[0], after[2]), (before[0], before[2]));
    window.was_told("Move path key 2 by ");
    window.press("Undo");
    assert_eq!((window.scene(), window.undo_name()), (&start, None));
    window.select([Item::Path(start.paths[0].id)]);
    window.command(Command::SelectNone);
    window.select([Item::Path(start.paths[0].id)]);
    let middle = before.iter().copied().sum::<DVec3>() / 3.0;
    window.drag(window.on_screen(middle) - vec2(0.0, 52.0), vec2(0.0, -60.0));
    for (index, before) in before.iter().enumerate() {
        assert!(window.key_place(index).y > before.y + 10.0, "key {index}");
    }
}

#[test]
fn a_double_click_goes_to_a_key() {
    let (mut window, _home) = with_path_in_view();
    let (place, at) = (window.key_place(2), window.key_on_screen(2));
    // In one frame: a frame here is too long for a double click.
    for pressed in [true, false, true, false] {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        let events = &mut window.harness.input_mut().events;
        events.extend([Event::PointerMoved(at), Event::PointerButton { pos: at, button, pressed, modifiers }]);
    }
    window.settle();
    assert!(window.harness.state().camera().position.distance(place) < 1e-6);
    assert!(!window.session().document().is_modified());
}
