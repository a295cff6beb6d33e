//! How the scene is looked at: from its sides, along parallel rays, through a camera, above the ground. None of it changes
//! the scene.

use crate::Window;
use crate::off_frame::is_idle;
use crate::tools::opened;
use cloudwright::command::Command;
use cloudwright::state::Item;
use cloudwright_core::camera::View;
use cloudwright_core::scene::Camera;
use egui::accesskit::Role;
use egui::{Key, Modifiers, PointerButton, vec2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;

impl Window {
    /// Whether the view has the cloud in its middle, within some points.
    fn shows_cloud_within(&self, points: f32) -> bool {
        let size = self.viewport().size();
        let view = View::new(&self.eye(), size.x as u32, size.y as u32);
        let middle = self.middle_of(&self.scene().clouds[0]);
        let at = view.project((middle - view.eye).as_vec3()).expect("before the eye");
        (vec2(at.x, at.y) - size * 0.5).length() < points
    }

    fn look_deg(&self) -> [f64; 2] {
        let Camera { heading_deg, pitch_deg, .. } = self.eye();
        [heading_deg, pitch_deg]
    }
}

#[test]
fn the_view_stops_above_the_ground() {
    let mut window = opened();
    let ground_m = window.scene().ground.as_ref().expect("there is one").altitude_m;
    let middle = window.viewport().center();
    window.pointer(middle, None);
    for _ in 0..8 {
        window.wheel(-10.0);
    }
    let low = window.eye();
    assert!((low.position.y - ground_m - 2.0).abs() < 1e-6, "{low:?}");
    let far = window.eye().position.z;
    window.wheel(-10.0);
    assert_eq!(window.eye().position.z, far, "there it stops");
    window.drag_with(PointerButton::Middle, Modifiers::NONE, middle, vec2(0.0, -200.0));
    window.drag_with(PointerButton::Middle, Modifiers::SHIFT, middle, vec2(0.0, -200.0));
    assert!(window.eye().position.y >= ground_m + 2.0 - 1e-6, "{:?}", window.eye());
    window.wheel(3.0);
    assert!(window.eye().position.y > ground_m + 2.5, "and back");
}

#[test]
fn handles_hide_while_the_clock_plays() {
    let mut window = opened();
    let start = window.scene().clone();
    let cloud = start.clouds[0].clone();
    window.press("body");
    assert!(window.shows("Face +x"));
    window.select([Item::Cloud(cloud.id)]);
    window.press("Move");
    let arrow = window.on_screen(window.middle_of(&cloud)) + vec2(52.0, 0.0);
    window.command(Command::PlayFlight);
    window.press("body");
    assert!(!window.shows("Face +x"));
    window.select([Item::Cloud(cloud.id)]);
    window.drag(arrow, vec2(80.0, 0.0));
    assert_eq!(window.scene(), &start);
    window.command(Command::PlayFlight);
    window.select([Item::Cloud(cloud.id)]);
    window.drag(arrow, vec2(80.0, 0.0));
    assert_ne!(window.scene(), &start, "and are back");
}

#[test]
fn each_side_has_a_key_and_keeps_what_is_looked_at() {
    let mut window = opened();
    let scene = window.scene().clone();
    window.keys(Modifiers::NONE, Key::A);
    let distance = |window: &Window| window.eye().position.distance(window.middle_of(&window.scene().clouds[0]));
    let start_m = distance(&window);
    let opposite = Modifiers::COMMAND | Modifiers::CTRL;
    for (modifiers, key, look) in [
        (Modifiers::NONE, Key::Num1, [0.0, 0.0]),
        (opposite, Key::Num1, [180.0, 0.0]),
        (Modifiers::NONE, Key::Num3, [-90.0, 0.0]),
        (opposite, Key::Num3, [90.0, 0.0]),
        (Modifiers::NONE, Key::Num7, [0.0, -90.0]),
    ] {
        window.keys(modifiers, key);
        assert_eq!(window.look_deg(), look, "{key:?}");
        assert!(window.shows_cloud_within(2.0), "{look:?}");
        assert!((distance(&window) - start_m).abs() < 1.0, "{look:?}");
    }
    // From below there is less room.
    window.keys(opposite, Key::Num7);
    assert_eq!(window.look_deg(), [0.0, 90.0]);
    assert!(window.eye().position.y >= 2.0 && window.shows_cloud_within(2.0), "{:?}", window.eye());
    // What is selected is looked at, wherever the view turned about.
    window.keys(Modifiers::NONE, Key::Num1);
    let middle = window.viewport().center();
    window.drag_with(PointerButton::Middle, Modifiers::SHIFT, middle, vec2(600.0, 0.0));
    window.drag_with(PointerButton::Middle, Modifiers::SHIFT, middle, vec2(600.0, 0.0));
    assert!(!window.shows_cloud_within(300.0));
    window.select([Item::Cloud(scene.clouds[0].id)]);
    window.keys(Modifiers::NONE, Key::Num3);
    assert!(window.look_deg() == [-90.0, 0.0] && window.shows_cloud_within(2.0), "{:?}", window.eye());
    assert_eq!(window.scene(), &scene);
}

#[test]
fn the_compass_is_clicked_and_dragged() {
    let mut window = opened();
    window.keys(Modifiers::NONE, Key::A);
    window.select([Item::Cloud(window.scene().clouds[0].id)]);
    window.press("Look from the east");
    assert_eq!(window.look_deg(), [-90.0, 0.0]);
    assert!(window.harness.query_by_label("from the east").is_some() && window.shows_cloud_within(2.0));
    window.press("Look from the east");
    assert_eq!(window.look_deg(), [90.0, 0.0], "a second click looks from the opposite side");
    window.press("Look from the top");
    assert_eq!(window.look_deg(), [0.0, -90.0]);
    let ball = window.harness.get_by_label("Compass").rect();
    window.drag(ball.center() + vec2(12.0, 12.0), vec2(15.0, -10.0));
    let [heading_deg, pitch_deg] = window.look_deg();
    assert!((heading_deg - 27.0).abs() < 6.0 && (pitch_deg + 72.0).abs() < 6.0, "{heading_deg}° {pitch_deg}°");
    assert!(window.shows_cloud_within(2.0), "about what is looked at");
    assert!(window.primary().is_some(), "a drag there is no marquee");
    assert!(!window.session().document().is_modified());
}

#[test]
fn parallel_rays_are_for_looking_and_not_for_cameras() {
    let mut window = opened();
    window.keys(Modifiers::NONE, Key::A);
    window.keys(Modifiers::NONE, Key::Num7);
    let before = window.eye();
    window.keys(Modifiers::NONE, Key::Num5);
    assert!(window.shows("from the top, orthographic"));
    assert_eq!(window.eye(), before, "a camera that is added sees the same at the same size");
    // A box drawn there is as large as the same drag makes it at what is looked at.
    let viewport = window.viewport();
    let view = View::new(&before, viewport.width() as u32, viewport.height() as u32);
    window.press("Box tool");
    let from = viewport.center() + vec2(60.0, 70.0);
    window.drag(from, vec2(100.0, 80.0));
    window.pointer(from + vec2(100.0, 30.0), None);
    window.keys(Modifiers::NONE, Key::Enter);
    let drawn = window.primary_box();
    let middle_m = window.middle_of(&window.scene().clouds[0]).y;
    let metres_a_point = f64::from(view.pixel()) * (before.position.y - middle_m);
    let wanted = DVec3::new(100.0, 0.0, 80.0) * metres_a_point;
    assert!((drawn.size.x / wanted.x - 1.0).abs() < 0.02, "{} for {}", drawn.size.x, wanted.x);
    assert!((drawn.size.z / wanted.z - 1.0).abs() < 0.02, "{} for {}", drawn.size.z, wanted.z);
    window.press("Undo");
    // From the side, a press finds the cloud where it shows.
    window.press("Select");
    window.keys(Modifiers::NONE, Key::Num1);
    window.click(viewport.center(), Modifiers::NONE);
    assert_eq!(window.primary(), Some(Item::Cloud(window.scene().clouds[0].id)));
    window.pointer(viewport.center(), None);
    window.wheel(2.0);
    assert!(window.shows_cloud_within(4.0) && window.shows("orthographic"));
    window.keys(Modifiers::NONE, Key::Num5);
    assert!(!window.shows("orthographic"));
    window.wait("a window that does nothing", is_idle);
}

const SIDES: [&str; 3] = ["Viewport from the top", "Viewport from the south", "Viewport from the east"];

/// In each of three orthographic views a grab moves the cloud along the picture and never across it, and a click finds it.
#[test]
fn four_views_have_all_tools_each() {
    let mut window = opened();
    let cloud = window.scene().clouds[0].id;
    let whole = window.viewport();
    window.keys(Modifiers::NONE, Key::Num4);
    let free = window.viewport();
    assert!(free.width() < 0.51 * whole.width() && free.height() < 0.51 * whole.height(), "{free:?} of {whole:?}");
    window.keys(Modifiers::NONE, Key::A);
    for (label, stays) in SIDES.into_iter().zip([DVec3::Y, DVec3::Z, DVec3::X]) {
        let place = window.harness.get_by_label(label).rect();
        assert!(!place.intersects(free.shrink(1.0)), "{label} lies over the free view");
        window.select([]);
        window.click(place.center(), Modifiers::NONE);
        assert_eq!(window.primary(), Some(Item::Cloud(cloud)), "{label}: the cloud is in the middle");
        let before = window.scene().clouds[0].position;
        window.pointer(place.center(), None);
        window.command(Command::GrabPlace);
        window.pointer(place.center() + vec2(30.0, -20.0), None);
        window.pointer(place.center() + vec2(30.0, -20.0), Some(true));
        window.pointer(place.center() + vec2(30.0, -20.0), Some(false));
        window.settle();
        let moved = window.scene().clouds[0].position - before;
        assert!(moved.dot(stays).abs() < 1e-3 * moved.length(), "{label}: {moved}");
        let others = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().filter(|axis| *axis != stays);
        assert!(others.into_iter().all(|axis| moved.dot(axis).abs() > 1.0), "{label}: {moved}");
        window.press("Undo");
        // The middle button moves what can't be turned, and F brings it back.
        let look = window.look_deg();
        window.drag_with(PointerButton::Middle, Modifiers::NONE, place.center(), vec2(0.4 * place.width(), 0.0));
        window.select([]);
        window.click(place.center(), Modifiers::NONE);
        assert_eq!(window.primary(), None, "{label}: it went with the hand");
        window.keys(Modifiers::NONE, Key::A);
        window.click(place.center(), Modifiers::NONE);
        assert_eq!(window.primary(), Some(Item::Cloud(cloud)), "{label}: it is back");
        assert_eq!(window.look_deg(), look, "the free view is another");
    }
    window.wait("a window that does nothing", is_idle);
    window.keys(Modifiers::NONE, Key::Num4);
    assert_eq!(window.viewport(), whole);
    assert!(SIDES.iter().all(|label| window.harness.query_by_label(label).is_none()));
}

#[test]
fn haze_is_left_out_of_the_view_alone() {
    let mut window = opened();
    let scene = window.scene().clone();
    assert!(window.harness.state().view().haze);
    window.command(Command::Haze);
    assert!(!window.harness.state().view().haze);
    assert_eq!(window.scene(), &scene);
    window.command(Command::Haze);
    assert!(window.harness.state().view().haze);
}

/// Merged sprites are the view's own way; a scene, and what is written of it, is as without them.
#[test]
fn all_sprites_are_drawn_if_asked() {
    let mut window = opened();
    let scene = window.scene().clone();
    assert!(!window.harness.state().view().all_sprites);
    window.command(Command::AllSprites);
    assert!(window.harness.state().view().all_sprites);
    assert_eq!(window.scene(), &scene);
}

#[test]
fn a_camera_that_is_looked_through_has_a_frame_and_is_followed() {
    let mut window = opened();
    assert!(!window.shows("1920 × 1080"), "the window opens with a view of its own");
    window.press("Cameras");
    window.press("Look through main");
    assert!(window.shows("main · 1920 × 1080"));
    assert_eq!(window.eye(), window.scene().cameras[0]);
    // It is changed by its fields, and the view goes with it.
    window.press("main");
    window.set("Heading", 25.0);
    assert_eq!((window.eye().heading_deg, window.scene().cameras[0].heading_deg), (25.0, 25.0));
    assert!(window.shows("main · 1920 × 1080"));
    window.press("Undo");
    assert_eq!(window.eye(), window.scene().cameras[0]);
    let middle = window.viewport().center();
    window.drag_with(PointerButton::Middle, Modifiers::NONE, middle, vec2(60.0, 0.0));
    assert!(!window.shows("1920 × 1080"), "a hand has left it");
    assert_ne!(window.eye(), window.scene().cameras[0]);
    assert!(!window.session().document().is_modified());
}

#[test]
fn the_chosen_camera_has_a_picture_in_the_corner() {
    let mut window = opened();
    assert!(!window.shows("What main sees"));
    window.press("main");
    window.keys(Modifiers::NONE, Key::Num7);
    let picture = window.node(Role::Button, "What main sees").rect();
    assert!(window.viewport().contains_rect(picture), "{picture}");
    assert!((picture.width() / picture.height() - 16.0 / 9.0).abs() < 0.02, "{picture}");
    window.wait("a window that does nothing", is_idle);
    window.command(Command::CameraPicture);
    assert!(!window.shows("What main sees"));
    window.command(Command::CameraPicture);
    window.press("What main sees");
    assert_eq!(window.eye(), window.scene().cameras[0]);
    assert!(window.shows("main · 1920 × 1080") && !window.shows("What main sees"));
    assert_eq!(window.primary(), Some(Item::Camera(window.scene().cameras[0].id)), "and is still chosen");
}

/// In small views, which have none, and in larger ones, where it has its corner to itself.
#[test]
fn the_compass_lies_over_no_handle_of_a_level() {
    for size in [[1280.0, 800.0], [1600.0, 1000.0], [1920.0, 1200.0]] {
        let mut window = Window::open_sized(None, size);
        window.settle();
        window.command(Command::LevelsPanel);
        window.select([Item::Cloud(window.scene().clouds[0].id)]);
        window.command(Command::QuadView);
        window.command(Command::FrameSelection);
        let middle = window.viewport().center();
        window.pointer(middle, None);
        for _ in 0..4 {
            let compass = window.harness.query_all_by_label("Compass").map(|node| node.rect()).next();
            let levels: Vec<_> =
                window.harness.query_all_by_label_contains("on the cloud").map(|node| node.rect()).collect();
            assert!(!levels.is_empty());
            assert!(compass.is_none_or(|it| levels.iter().all(|level| !level.intersects(it))), "{size:?}: {compass:?}");
            assert_eq!(compass.is_some(), window.viewport().width() >= 400.0, "{size:?}");
            window.wheel(1.0);
        }
    }
}

#[test]
fn a_box_has_handles_of_its_own_in_each_of_four_views() {
    let mut window = opened();
    let model = window.scene().models[0].clone();
    window.select([Item::Box(model.id, model.boxes[1].id)]);
    window.command(Command::QuadView);
    window.command(Command::FrameSelection);
    let faces = window.harness.query_all_by_label_contains("Face").count();
    assert!(faces > 12, "{faces}");
}
