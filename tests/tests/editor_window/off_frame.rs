//! Slow work is never in the way, and an idle window does nothing.

use crate::Window;
use cloudwright::state::Item;
use cloudwright_core::derived::Derived;
use egui::ViewportId;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use std::time::Duration;

/// With the box “body” selected, in a model that keeps nearly all its sprites: culling most is quick.
fn with_dense_box() -> Window {
    let mut window = Window::open();
    window.settle();
    let model = window.scene().models[0].id;
    window.select([Item::Model(model)]);
    window.set("Cull radius", 0.01);
    window.press("body");
    window
}

fn set_in_one_frame(window: &mut Window, sprites: f64) {
    window.node(Role::SpinButton, "Sprites").set_value_accesskit(sprites);
    window.harness.step();
}

#[test]
fn a_huge_cloud_arrives_later() {
    let mut window = with_dense_box();
    let sprites = window.sprites();
    set_in_one_frame(&mut window, 60_000.0);
    window.was_told("Sprites of ");
    assert!(window.session().pending().is_some(), "the frame did not wait");
    assert_eq!(window.sprites(), sprites, "the last good cloud is shown");
    window.wait("the cloud", |window| window.session().pending().is_none());
    assert!(window.session().derived().clouds() == Derived::new(window.scene()).clouds());
    // The clouds were taken up at the end of a frame.
    window.harness.step();
    assert!(window.harness.query_by_label("Progress").is_none());
}

#[test]
fn what_takes_long_can_be_cancelled() {
    let mut window = with_dense_box();
    let (scene, sprites) = (window.scene().clone(), window.sprites());
    set_in_one_frame(&mut window, 1e6);
    assert!(window.harness.query_by_label("Progress").is_none(), "not before half a second");
    window.wait("a bar", |window| window.harness.query_by_label("Progress").is_some());
    window.press("Cancel");
    assert_eq!((window.scene(), window.sprites()), (&scene, sprites));
    assert!(window.session().pending().is_none() && !window.shows("Progress"));
    assert_eq!(
        window.session().document().redo_name(),
        Some("Sprites of body from 70 to 1000000"),
        "nobody's work is lost"
    );
}

/// What light comes through is worked out beside the window; until it is, edited sprites keep that of before.
#[test]
fn light_comes_later() {
    let mut window = with_dense_box();
    let model = window.scene().models[0].id;
    window.select([Item::Model(model)]);
    window.set("Self-shadow", 1.0);
    let has_light = |window: &Window| {
        let derived = window.session().derived();
        let cloud = &derived.clouds()[0];
        !derived.is_unbaked() && cloud.baked().is_some_and(|baked| baked.sprites() == cloud.sprites.all().len())
    };
    window.wait("light", has_light);
    let sprites = window.sprites();
    window.press("body");
    set_in_one_frame(&mut window, 300.0);
    assert!(window.sprites() > sprites, "the frame shows them");
    assert!(window.session().derived().clouds()[0].baked().is_some(), "by what was known");
    window.wait("their light", has_light);
    window.select([Item::Model(model)]);
    window.set("Self-shadow", 0.0);
    window.set("Halo", 0.0);
    assert!(window.session().derived().clouds()[0].baked().is_none(), "by their groups alone");
}

/// No repaint asked for, no picture drawn.
pub(crate) fn is_idle(window: &Window) -> bool {
    let output = window.harness.output();
    let delay = output.viewport_output.get(&ViewportId::ROOT).map(|viewport| viewport.repaint_delay);
    delay == Some(Duration::MAX) && output.textures_delta.set.is_empty()
}

#[test]
fn an_idle_window_does_nothing() {
    let mut window = Window::open();
    let mut idle_frames = 0;
    for _ in 0..12_000 {
        window.harness.step();
        idle_frames = if is_idle(&window) { idle_frames + 1 } else { 0 };
        if idle_frames == 40 {
            break;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    assert_eq!(idle_frames, 40, "it comes to rest");
    for frame in 0..30 {
        window.harness.step();
        assert!(is_idle(&window), "frame {frame} of an idle window");
    }
    window.press("body");
    window.wait("rest after a click", is_idle);
}
