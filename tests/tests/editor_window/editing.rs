//! Values, history, and things added and taken out.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::state::{Item, Selection};
use cloudwright_core::scene::CloudBox;
use egui::accesskit::Role;
use egui::{Key, Modifiers, vec2};

/// A window with the starter's box “body” selected.
fn with_box() -> Window {
    let mut window = Window::open();
    window.settle();
    window.press("body");
    assert!(matches!(window.harness.state().selection().primary(), Some(Item::Box(..))));
    window
}

#[test]
fn more_sprites_in_a_box() {
    let mut window = with_box();
    let (scene, sprites) = (window.scene().clone(), window.sprites());
    window.set("Sprites", 300.0);
    assert!(window.sprites() > sprites, "{} and {sprites}", window.sprites());
    window.was_told("Sprites of ");
    let changed = window.scene().clone();
    window.press("Undo");
    assert_eq!((window.scene(), window.sprites()), (&scene, sprites));
    assert_eq!(window.undo_name(), None);
    window.press("Redo");
    assert_eq!(window.scene(), &changed);
    window.keys(Modifiers::COMMAND, Key::Z);
    assert_eq!(window.scene(), &scene);
    window.keys(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(window.scene(), &changed);
}

#[test]
fn a_drag_is_one_step() {
    let mut window = with_box();
    let scene = window.scene().clone();
    let field = window.node(Role::SpinButton, "Sprites").rect().center();
    window.pointer(field, Some(true));
    for step in 1..=10_u8 {
        window.pointer(field + vec2(f32::from(step) * 12.0, 0.0), None);
    }
    let shown = window.sprites();
    assert!(window.session().document().is_open() && shown > 0);
    assert_ne!(window.scene(), &scene, "what is dragged shows at once");
    window.pointer(field + vec2(120.0, 0.0), Some(false));
    window.settle();
    window.was_told("Sprites of ");
    window.press("Undo");
    assert_eq!((window.scene(), window.undo_name()), (&scene, None));
}

#[test]
fn escape_takes_a_drag_back() {
    for (role, label) in [(Role::SpinButton, "Sprites"), (Role::Slider, "Time of day")] {
        let mut window = with_box();
        let scene = window.scene().clone();
        window.command(Command::SkyPanel);
        let field = window.node(role, label).rect().center();
        window.pointer(field, Some(true));
        window.pointer(field + vec2(30.0, 0.0), None);
        window.pointer(field + vec2(40.0, 0.0), None);
        assert_ne!(window.scene(), &scene, "{label}");
        window.harness.key_press(Key::Escape);
        window.harness.step();
        window.pointer(field + vec2(50.0, 0.0), None);
        window.pointer(field + vec2(60.0, 0.0), None);
        assert_eq!(window.scene(), &scene, "{label}: the rest of the drag is ignored");
        window.pointer(field + vec2(60.0, 0.0), Some(false));
        window.settle();
        assert_eq!((window.scene(), window.undo_name()), (&scene, None), "{label}");
    }
}

#[test]
fn values_out_of_range_are_not_taken() {
    let mut window = with_box();
    let scene = window.scene().clone();
    for bad in [f64::NAN, f64::INFINITY, -1.0, 1e12] {
        window.set("Sprites", bad);
        window.set("Size y", bad);
    }
    assert_eq!(window.scene(), &scene);
    window.set("Width from", 5000.0);
    let Some(Item::Box(model, id)) = window.harness.state().selection().primary() else { panic!("a box is selected") };
    let model = window.scene().model(model).expect("it is there");
    let width = model.boxes.iter().find(|each| each.id == id).expect("it is there").width;
    assert_eq!(width, [5000.0, 5000.0], "the smallest pushes the largest along");
}

#[test]
fn too_many_sprites_are_refused_with_a_reason() {
    let mut window = with_box();
    for _ in 0..4 {
        window.harness.state_mut().select(Selection::default());
        window.settle();
        window.press("Add cloud");
    }
    window.press("body");
    let model = window.scene().models[0].id;
    window.harness.state_mut().select(Selection::of([Item::Model(model)]));
    window.settle();
    for _ in 0..4 {
        window.harness.state_mut().select(Selection::of([Item::Model(model)]));
        window.command(Command::PlaceModel);
    }
    window.press("body");
    let (scene, sprites) = (window.scene().clone(), window.sprites());
    window.set("Sprites", 1e6);
    assert_eq!((window.scene(), window.sprites()), (&scene, sprites));
    assert!(window.shows("lower sprite_count"));
}

#[test]
fn time_of_day_changes_the_light_only() {
    let mut window = Window::open();
    window.settle();
    window.command(Command::SkyPanel);
    let before = window.session().derived().version();
    window.node(Role::Slider, "Time of day").set_value_accesskit(18.5);
    window.settle();
    assert_eq!(window.scene().time_of_day_h, 18.5);
    assert_eq!(window.session().derived().version(), before, "no sprite is computed again");
}

#[test]
fn things_are_added_duplicated_and_deleted() {
    let mut window = Window::open();
    window.settle();
    let start = window.scene().clone();
    window.press("Add cloud");
    assert_eq!((window.scene().models.len(), window.scene().clouds.len()), (2, 2));
    window.press("Add box");
    assert_eq!(window.scene().models[1].boxes.len(), 2);
    window.keys(Modifiers::COMMAND, Key::D);
    assert_eq!(window.scene().models[1].boxes.len(), 3);
    window.keys(Modifiers::NONE, Key::Delete);
    assert_eq!(window.scene().models[1].boxes.len(), 2);
    window.press("Add camera");
    assert_eq!(window.scene().cameras.len(), 2);
    let model = window.scene().models[0].id;
    window.harness.state_mut().select(Selection::of([Item::Model(model)]));
    window.settle();
    window.keys(Modifiers::NONE, Key::Delete);
    assert_eq!((window.scene().models.len(), window.scene().clouds.len()), (1, 1), "a model goes with its clouds");
    for _ in 0..6 {
        window.keys(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(window.scene(), &start);
    assert!(!window.session().document().is_modified());
}

/// A box that is pulled long keeps its density: more and larger sprites, no crumbs.
#[test]
fn a_resized_box_stays_filled_unless_that_is_switched_off() {
    let mut window = with_box();
    let before = window.primary_box();
    window.set("Size x", before.size.x * 10.0);
    let long = window.primary_box();
    assert!(long.sprite_count > before.sprite_count && long.width[1] > before.width[1] * 1.5, "{long:?}");
    window.was_told("Size x of body from ");
    window.press("Undo");
    assert_eq!(window.primary_box(), before);
    window.command(Command::KeepFill);
    window.set("Size x", before.size.x * 10.0);
    assert_eq!(window.primary_box().sprite_count, before.sprite_count);
    window.press("Fit sprites to box");
    assert!((window.primary_box().sprite_count, window.primary_box().width) > (before.sprite_count, before.width));
}

#[test]
fn a_lower_box_keeps_its_base() {
    let mut window = with_box();
    let before = window.primary_box();
    window.set("Size y", before.size.y * 0.5);
    let base = |each: &CloudBox| each.center.y - each.size.y * 0.5;
    assert!((base(&window.primary_box()) - base(&before)).abs() < 1e-6);
}

#[test]
fn density_and_relative_size_are_another_way_to_say_it() {
    let mut window = with_box();
    window.press("Fit sprites to box");
    let before = window.primary_box();
    window.set("Density", 2.0);
    let doubled = window.primary_box().sprite_count;
    assert!(doubled.abs_diff(before.sprite_count * 2) <= 1, "{doubled}");
    window.set("Sprite size", 0.5);
    assert!((window.primary_box().width[1] - before.width[1] * 0.5).abs() < 0.2);
    assert_eq!(window.primary_box().sprite_count, doubled);
    window.was_told("Sprite size · body");
}

#[test]
fn what_no_command_matches_is_said() {
    let mut window = with_box();
    window.command(Command::Palette);
    window.harness.event(egui::Event::Text("xyzzy".into()));
    window.settle();
    assert!(window.shows("No command matches “xyzzy”"));
}
