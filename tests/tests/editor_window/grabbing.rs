//! What a hand takes hold of: gizmos and handles by a press near them, and the selection by Blender's keys.

use crate::Window;
use crate::tools::opened;
use cloudwright::command::Command;
use cloudwright::state::Item;
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::scene::CloudBox;
use egui::epaint::TextShape;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Shape, pos2, vec2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;

/// The selected cloud, and where its middle shows.
fn with_cloud() -> (Window, DVec3, Pos2) {
    let mut window = opened();
    let cloud = window.scene().clouds[0].clone();
    window.select([Item::Cloud(cloud.id)]);
    let middle = window.middle_of(&cloud);
    let pivot = window.on_screen(middle);
    (window, middle, pivot)
}

/// The far side of the ring about the vertical is not drawn, its near side is a flat arc above the pivot: a press so many
/// points above or below it turns the cloud, is no press at all, or begins a marquee.
#[test]
fn a_ring_seen_from_its_edge_is_taken_from_nine_points_away() {
    for (off, turns, keeps) in
        [(0.0, true, true), (-8.0, true, true), (8.0, true, true), (-16.0, false, true), (-40.0, false, false)]
    {
        let (mut window, middle, _) = with_cloud();
        window.press("Rotate");
        let pixel = f64::from(window.view().pixel());
        let near = window.on_screen(middle + DVec3::Z * 84.0 * 3200.0 * pixel) + vec2(0.0, off);
        // Over nothing, a marquee that holds nothing takes the selection away.
        window.drag(near, vec2(-60.0, 0.0));
        assert_eq!(window.scene().clouds[0].heading_deg != 0.0, turns, "{off}: turned");
        assert_eq!(window.primary().is_some(), keeps, "{off}: selected");
    }
}

#[test]
fn the_hand_keeps_its_distance_from_the_arrow_that_it_took() {
    let (mut window, _, pivot) = with_cloud();
    window.press("Move");
    let pixel = f64::from(window.view().pixel()) * 3200.0;
    // Eight points beside the arrow to the right.
    window.drag(pivot + vec2(60.0, 8.0), vec2(50.0, 0.0));
    let moved = window.scene().clouds[0].position.x;
    assert!((moved - 50.0 * pixel).abs() < 0.02 * 50.0 * pixel, "{moved} for {}", 50.0 * pixel);
}

#[test]
fn face_handles_are_taken_from_nine_points_away() {
    let mut window = opened();
    window.press("body");
    let before = window.primary_box();
    let face = window.harness.get_by_label("Face +x").rect().center();
    window.drag(face + vec2(8.0, 7.0), vec2(60.0, 0.0));
    assert!(window.primary_box().size.x > before.size.x + 50.0);
}

/// One box beside the body, 400 m wide and 430 m tall, its middle 900 m east of the body's and level with it; it is selected, and the
/// hand snaps.
fn beside_the_body() -> (Window, ModelSpace) {
    let mut window = opened();
    window.press("body");
    let body = window.primary_box();
    window.press("Add box");
    for (axis, middle) in ["x", "y", "z"].iter().zip((body.center + DVec3::X * 900.0).to_array()) {
        window.set(&format!("Centre {axis}"), middle);
        window.set(&format!("Size {axis}"), 400.0);
    }
    // No top of another box is as high above the body's base.
    window.set("Size y", 430.0);
    window.press("Snap");
    let space = ModelSpace::of(&window.scene().clouds[0]);
    (window, space)
}

fn body_of(window: &Window) -> CloudBox {
    window.scene().models[0].boxes.iter().find(|each| each.name == "body").expect("it stays").clone()
}

/// Three points short of the body's side, or of its base, the hand is drawn onto it; with Ctrl it is not.
#[test]
fn faces_and_boxes_snap_onto_those_of_others() {
    let (mut window, space) = beside_the_body();
    let body = body_of(&window);
    let wanted_x = body.center.x + body.size.x * 0.5;
    let west = |each: &CloudBox| each.center.x - each.size.x * 0.5;
    let handle = |window: &Window| window.harness.get_by_label("Face −x").rect().center();
    let to = |window: &Window| {
        let mine = window.primary_box();
        let at = |x: f64| window.on_screen(space.to_world(mine.center.with_x(x)));
        at(wanted_x) - at(west(&mine)) + vec2(3.0, 0.0)
    };
    let (from, by) = (handle(&window), to(&window));
    let before = window.primary_box();
    window.drag(from, by);
    let after = window.primary_box();
    assert!((west(&after) - wanted_x).abs() < 1e-6, "{} for {wanted_x}", west(&after));
    let east = |each: &CloudBox| each.center.x + each.size.x * 0.5;
    assert!((east(&after) - east(&before)).abs() < 1e-6, "the other side stays");
    window.press("Undo");
    let (from, by) = (handle(&window), to(&window));
    window.drag_with(PointerButton::Primary, Modifiers::COMMAND | Modifiers::CTRL, from, by);
    assert!((west(&window.primary_box()) - wanted_x).abs() > 1.0);
    window.press("Undo");
    // Moved downwards by a key, it comes to stand on the level of the body's base; by figures it goes where they say.
    window.command(Command::SwitchKeymap);
    let base = |each: &CloudBox| each.center.y - each.size.y * 0.5;
    let mine = window.primary_box();
    let at = |window: &Window, y: f64| window.on_screen(space.to_world(mine.center.with_y(y)));
    let by = at(&window, base(&body)) - at(&window, base(&mine)) + vec2(0.0, 3.0);
    let from = at(&window, mine.center.y);
    window.hover(from);
    window.type_keys(&[Key::G, Key::Y]);
    window.hover(from + by);
    window.confirm(from + by);
    let moved = window.primary_box();
    assert!((base(&moved) - base(&body)).abs() < 1e-6, "{} for {}", base(&moved), base(&body));
    assert_eq!((moved.center.x, moved.size), (mine.center.x, mine.size));
    window.hover(from);
    window.type_keys(&[Key::G, Key::Y, Key::Num7]);
    window.confirm(from);
    assert!((window.primary_box().center.y - moved.center.y - 7.0).abs() < 1e-6);
}

/// Whether something in the picture has that name beside it.
fn named(window: &Window, name: &str) -> bool {
    let (shapes, picture) = (&window.harness.output().shapes, window.viewport());
    let is_name = |text: &TextShape| text.galley.text() == name && picture.contains(text.pos);
    shapes.iter().any(|shape| matches!(&shape.shape, Shape::Text(text) if is_name(text)))
}

/// Over a cloud its name shows, over nothing none does; nor over what is selected already, but for the box that the next
/// press takes.
#[test]
fn the_pointer_shows_what_a_press_would_take() {
    let (mut window, _, pivot) = with_cloud();
    let name = window.scene().clouds[0].name.clone();
    window.select([]);
    let shows = |window: &mut Window, at: Pos2| {
        window.hover(at);
        named(window, &name)
    };
    assert!(shows(&mut window, pivot));
    let sky = window.viewport().left_top() + vec2(40.0, 200.0);
    assert!(!shows(&mut window, sky), "the sky");
    assert!(shows(&mut window, pivot));
    window.click(pivot, Modifiers::NONE);
    assert_eq!(window.primary(), Some(Item::Cloud(window.scene().clouds[0].id)), "what was shown was taken");
    assert!(!shows(&mut window, pivot), "a box is next");
    window.press("Box tool");
    assert!(!shows(&mut window, pivot), "that tool takes nothing");
}

/// In Blender's keymap.
fn blender() -> (Window, DVec3, Pos2) {
    let (mut window, middle, pivot) = with_cloud();
    window.command(Command::SwitchKeymap);
    window.settle();
    (window, middle, pivot)
}

impl Window {
    /// A press and release of the primary button where the pointer is.
    fn confirm(&mut self, at: Pos2) {
        self.button(at, PointerButton::Primary, true, Modifiers::NONE);
        self.button(at, PointerButton::Primary, false, Modifiers::NONE);
        self.settle();
    }

    fn hover(&mut self, at: Pos2) {
        self.harness.event(Event::PointerMoved(at));
        self.harness.step();
        self.harness.step();
    }

    fn type_keys(&mut self, keys: &[Key]) {
        for key in keys {
            self.harness.key_press(*key);
            self.harness.step();
        }
    }
}

#[test]
fn g_moves_with_the_pointer_and_is_one_undo_step() {
    let (mut window, _, pivot) = blender();
    let start = window.scene().clone();
    let pixel = f64::from(window.view().pixel()) * 3200.0;
    let from = pivot + vec2(200.0, 130.0);
    window.hover(from);
    window.type_keys(&[Key::G]);
    window.hover(from + vec2(30.0, -10.0));
    window.hover(from + vec2(80.0, -40.0));
    assert_ne!(window.scene(), &start, "shown while the pointer moves");
    window.confirm(from + vec2(80.0, -40.0));
    let moved = window.scene().clouds[0].position - start.clouds[0].position;
    assert!((moved.x - 80.0 * pixel).abs() < 80.0 * pixel * 0.02, "{moved}");
    assert_eq!(window.primary(), Some(Item::Cloud(start.clouds[0].id)), "the click was the gesture's end alone");
    assert!(window.undo_name().is_some());
    window.keys(Modifiers::COMMAND, Key::Z);
    assert_eq!((window.scene(), window.undo_name()), (&start, None));
}

/// Keys after the first, how far it goes, turns or grows.
#[test]
fn axes_and_figures_say_where_to() {
    use Key::{Enter, Minus, Num0, Num1, Num2, Num5, Period};
    for (first, keys, moved, turned, scale) in [
        (Key::G, &[Key::X, Num1, Num2, Num5, Enter][..], DVec3::X * 125.0, 0.0, 1.0),
        (Key::G, &[Key::Y, Minus, Num2, Num0, Enter], DVec3::Y * -20.0, 0.0, 1.0),
        // Twice the same axis is none: a number alone is along x.
        (Key::G, &[Key::Z, Key::Z, Num5, Enter], DVec3::X * 5.0, 0.0, 1.0),
        (Key::G, &[Key::Z, Num5, Enter], DVec3::Z * 5.0, 0.0, 1.0),
        (Key::R, &[Num2, Num5, Enter], DVec3::ZERO, -25.0, 1.0),
        (Key::S, &[Num1, Period, Num5, Enter], DVec3::ZERO, 0.0, 1.5),
        (Key::G, &[Key::X, Num1, Num2, Num5, Key::Escape], DVec3::ZERO, 0.0, 1.0),
    ] {
        let (mut window, middle, pivot) = blender();
        let start = window.scene().clouds[0].clone();
        window.hover(pivot + vec2(150.0, 100.0));
        window.type_keys(&[first]);
        window.harness.step();
        window.type_keys(keys);
        window.settle();
        let cloud = window.scene().clouds[0].clone();
        assert!((window.middle_of(&cloud) - middle - moved).length() < 0.01, "{first:?} {keys:?}");
        assert!((cloud.heading_deg - start.heading_deg - turned).abs() < 1e-6, "{first:?}: {}", cloud.heading_deg);
        assert!((cloud.scale - scale).abs() < 1e-9, "{first:?}: {}", cloud.scale);
        let undoable = *keys.last().expect("some") == Enter;
        assert_eq!(window.undo_name().is_some(), undoable, "{first:?} {keys:?}");
        // Keys are commands again.
        window.type_keys(&[Key::X]);
        window.settle();
        assert!(window.scene().clouds.is_empty(), "X takes it out");
    }
}

#[test]
fn the_right_button_drops_it_and_nothing_else() {
    let (mut window, _, pivot) = blender();
    let start = window.scene().clone();
    let camera = window.harness.state().camera().clone();
    window.hover(pivot + vec2(150.0, 100.0));
    window.type_keys(&[Key::S]);
    window.hover(pivot + vec2(250.0, 180.0));
    assert_ne!(window.scene(), &start);
    let at = pivot + vec2(250.0, 180.0);
    window.button(at, PointerButton::Secondary, true, Modifiers::NONE);
    window.pointer(at + vec2(40.0, 0.0), None);
    window.button(at + vec2(40.0, 0.0), PointerButton::Secondary, false, Modifiers::NONE);
    window.settle();
    assert_eq!((window.scene(), window.undo_name()), (&start, None));
    assert_eq!(window.harness.state().camera(), &camera, "nothing flew");
}

#[test]
fn from_a_menu_it_begins_where_the_pointer_comes_in() {
    let (mut window, _, pivot) = with_cloud();
    let start = window.scene().clone();
    window.hover(pos2(2.0, 2.0));
    window.command(Command::GrabPlace);
    window.hover(pivot);
    assert_eq!(window.scene(), &start, "the way from the menu does not count");
    window.hover(pivot + vec2(40.0, 0.0));
    assert_ne!(window.scene(), &start);
}

#[test]
fn the_own_keymap_keeps_its_keys() {
    let (mut window, _, _) = with_cloud();
    window.keys(Modifiers::NONE, Key::G);
    assert!(window.harness.state().view().group_view);
    window.command(Command::SwitchKeymap);
    window.settle();
    window.keys(Modifiers::SHIFT, Key::G);
    assert!(!window.harness.state().view().group_view, "it has other keys there");
}
