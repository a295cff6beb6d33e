//! The scene's clock: it plays between marks, and what is drawn, picked and shown goes by it.

use crate::Window;
use crate::timeline::{RULER, with_exposure};
use crate::tools::opened;
use cloudwright::command::Command;
use cloudwright::state::Item;
use egui::accesskit::Role;
use egui::{Modifiers, Pos2, vec2};
use egui_kittest::kittest::NodeT;

#[test]
fn it_plays_between_its_marks() {
    let mut window = with_exposure();
    window.put_timeline(4.0);
    window.command(Command::MarkOut);
    window.put_timeline(2.0);
    window.command(Command::MarkIn);
    window.command(Command::LoopFlight);
    window.command(Command::PlayFlight);
    let mut times = Vec::new();
    for _ in 0..24 {
        window.harness.step();
        times.push(window.timeline_s());
    }
    assert!(times.iter().all(|time_s| (2.0..=4.0).contains(time_s)), "{times:?}");
    assert!(times.windows(2).any(|pair| pair[1] < pair[0]), "it goes round: {times:?}");
    window.command(Command::PlayFlight);
    window.command(Command::ClearMarks);
    // A drag in the ruler scrubs, and stops at a key.
    let x = window.key_named("key of Exposure at 20 s").x;
    let ruler = window.node(Role::Slider, RULER).rect();
    window.drag(Pos2::new(x - 60.0, ruler.center().y), vec2(62.0, 0.0));
    assert_eq!(window.timeline_s(), 20.0);
}

#[test]
fn the_shading_curve_and_the_view_go_by_the_clock() {
    let mut window = opened();
    let (cloud, model) = (window.scene().clouds[0].clone(), window.scene().models[0].clone());
    window.command(Command::GroupsPanel);
    window.command(Command::TimelinePanel);
    window.select([Item::Box(model.id, model.boxes[0].id)]);
    window.ask("Key Across");
    window.command(Command::AutoKey);
    window.put_timeline(10.0);
    let dot = |window: &Window| window.node(Role::Slider, "Across").accesskit_node().numeric_value().expect("a share");
    let before = dot(&window);
    window.node(Role::Slider, "Across").set_value_accesskit(before - 0.4);
    window.settle();
    let track = format!("model/{}/box/{}/light/c_med", model.id, model.boxes[0].id);
    assert_eq!(window.times(&track), [0.0, 10.0], "a dot that is dragged sets a key");
    assert_eq!(window.scene().models[0].boxes[0].light, model.boxes[0].light);
    window.put_timeline(5.0);
    assert!((dot(&window) - before + 0.2).abs() < 1e-6, "half way");

    window.select([Item::Cloud(cloud.id)]);
    window.ask("Key Position");
    window.put_timeline(20.0);
    window.set("Position x", cloud.position.x + 5000.0);
    let mut eye = |time_s: f64| {
        window.put_timeline(time_s);
        window.command(Command::FrameSelection);
        window.harness.state().camera().position
    };
    let way = eye(20.0) - eye(5.0);
    assert!((way.x - 5000.0).abs() < 1.0 && way.y.abs() < 1.0, "{way}");
}

#[test]
fn a_camera_is_drawn_and_picked_where_its_tracks_have_it() {
    let mut window = opened();
    window.command(Command::TimelinePanel);
    window.command(Command::AddCamera);
    let camera = window.scene().cameras.as_slice().last().expect("it was added").clone();
    window.select([Item::Camera(camera.id)]);
    window.ask("Key Position");
    window.command(Command::AutoKey);
    window.put_timeline(10.0);
    let ahead = window.view().ray(200.0, 100.0);
    let place = camera.position + ahead.as_dvec3() * 300.0;
    for (axis, value) in ["Position x", "Position y", "Position z"].into_iter().zip(place.to_array()) {
        window.set(axis, value);
    }
    window.command(Command::ShowBoxes);
    window.select([]);
    let at = window.on_screen(place);
    window.click(at, Modifiers::NONE);
    assert_eq!(window.primary(), Some(Item::Camera(camera.id)));
    window.put_timeline(0.0);
    window.select([]);
    window.click(at, Modifiers::NONE);
    assert_ne!(window.primary(), Some(Item::Camera(camera.id)), "by then it is here");
}
