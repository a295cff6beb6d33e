//! Selection both ways, and what is done in the viewport. None of it changes the scene.

use crate::Window;
use cloudwright::state::Item;
use egui::accesskit::Role;
use egui::{Key, Modifiers, PointerButton, vec2};
use egui_kittest::kittest::Queryable;

#[test]
fn a_click_selects_a_cloud_and_then_a_box() {
    let mut window = Window::open();
    window.settle();
    window.keys(Modifiers::NONE, Key::A);
    let cloud = window.scene().clouds[0].id;
    let middle = window.harness.get_by_label("Viewport").rect().center();
    let click = |window: &mut Window, at| {
        window.pointer(at, Some(true));
        window.pointer(at, Some(false));
        window.settle();
    };
    click(&mut window, middle);
    assert_eq!(window.harness.state().selection().primary(), Some(Item::Cloud(cloud)));
    click(&mut window, middle);
    assert!(matches!(window.harness.state().selection().primary(), Some(Item::Box(..))));
    let corner = window.harness.get_by_label("Viewport").rect().left_top() + vec2(5.0, 5.0);
    click(&mut window, corner);
    assert!(window.harness.state().selection().is_empty());
    window.press("left head");
    assert!(matches!(window.harness.state().selection().primary(), Some(Item::Box(..))));
    assert!(window.node(Role::SpinButton, "Sprites").value().is_some_and(|value| value == "28"));
}

#[test]
fn turning_the_view_is_no_change() {
    let mut window = Window::open();
    window.settle();
    let scene = window.scene().clone();
    let middle = window.viewport().center();
    let (alt, none, shift) = (Modifiers::ALT, Modifiers::NONE, Modifiers::SHIFT);
    for (button, modifiers, turns, moves) in [
        (PointerButton::Middle, none, true, true),
        (PointerButton::Primary, alt, true, true),
        (PointerButton::Middle, shift, false, true),
        (PointerButton::Primary, alt | shift, false, true),
        (PointerButton::Secondary, none, true, false),
        (PointerButton::Primary, none, false, false),
    ] {
        window.press("Cameras");
        window.press("Look through main");
        window.drag_with(button, modifiers, middle, vec2(120.0, 50.0));
        window.keys(Modifiers::SHIFT, Key::B);
        assert_eq!(window.scene(), &scene);
        assert!(!window.session().document().is_modified());
        // A camera put there tells how the view was moved.
        window.press("Add camera");
        let [main, new] = window.scene().cameras.as_slice() else { panic!("two cameras") };
        assert_eq!((main.heading_deg - new.heading_deg).abs() > 5.0, turns, "{button:?} {modifiers:?}");
        assert_eq!(main.position != new.position, moves, "{button:?} {modifiers:?}");
        window.press("Undo");
    }
}

#[test]
fn looking_through_a_camera_and_back() {
    let mut window = Window::open();
    window.settle();
    window.press("main");
    window.keys(Modifiers::NONE, Key::A);
    window.press("Set from view");
    assert_eq!(window.undo_name().as_deref(), Some("Set camera from view"));
    let moved = window.scene().cameras[0].clone();
    window.press("Undo");
    assert_ne!(window.scene().cameras[0], moved);
    window.press("Look through");
    window.press("Set from view");
    assert_eq!(window.undo_name(), None, "the view is where the camera was");
}

#[test]
fn keys_work_on_the_viewport_and_leave_text_alone() {
    let mut window = Window::open();
    window.settle();
    let middle = window.harness.get_by_label("Viewport").rect().center();
    window.pointer(middle, Some(true));
    window.pointer(middle, Some(false));
    window.settle();
    window.keys(Modifiers::NONE, Key::ArrowRight);
    window.press("Add camera");
    let cameras = &window.scene().cameras;
    assert!(cameras[1].heading_deg > cameras[0].heading_deg, "an arrow key turns the view");
    // Delete in a text field takes a letter, not the camera.
    let field = window.harness.get_by_role_and_label(Role::TextInput, "Name");
    field.focus();
    window.settle();
    window.keys(Modifiers::NONE, Key::Delete);
    window.keys(Modifiers::NONE, Key::B);
    assert_eq!(window.scene().cameras.len(), 2);
}
