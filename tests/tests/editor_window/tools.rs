//! The tools in the viewport: things moved by handles, picked and marked. Boxes are drawn in drawing_boxes.rs.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::state::Item;
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::camera::View;
use cloudwright_core::scene::{Cloud, CloudBox, GroupCenter, GroupId, List};
use cloudwright_core::sprites::GroupKey;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, Vec2, pos2, vec2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;

impl Window {
    pub(crate) fn viewport(&self) -> Rect {
        self.harness.get_by_label("Viewport").rect()
    }

    pub(crate) fn primary(&self) -> Option<Item> {
        self.harness.state().selection().primary()
    }

    pub(crate) fn primary_box(&self) -> CloudBox {
        let Some(Item::Box(model, id)) = self.primary() else { panic!("{:?}", self.primary()) };
        let model = self.scene().model(model).expect("it is there");
        model.boxes.iter().find(|each| each.id == id).expect("it is there").clone()
    }

    /// The view that the window opens with, and keeps until someone moves it: the first camera's.
    pub(crate) fn view(&self) -> View {
        let size = self.viewport().size();
        View::new(&self.scene().cameras[0], size.x as u32, size.y as u32)
    }

    /// Where a place in the world shows.
    pub(crate) fn on_screen(&self, place: DVec3) -> Pos2 {
        let view = self.view();
        let at = view.project((place - view.eye).as_vec3()).expect("before the eye");
        self.viewport().min + vec2(at.x, at.y)
    }

    pub(crate) fn button(&mut self, at: Pos2, button: PointerButton, pressed: bool, modifiers: Modifiers) {
        self.harness.event(Event::PointerMoved(at));
        self.harness.event(Event::PointerButton { pos: at, button, pressed, modifiers });
        self.harness.step();
    }

    /// A drag in several steps with a button and modifiers held.
    pub(crate) fn drag_with(&mut self, button: PointerButton, modifiers: Modifiers, from: Pos2, by: Vec2) {
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.button(from, button, true, modifiers);
        for step in 1..=5_u8 {
            self.pointer(from + by * (f32::from(step) / 5.0), None);
        }
        self.button(from + by, button, false, modifiers);
        self.harness.event(Event::ModifiersChanged(Modifiers::NONE));
        self.settle();
    }

    pub(crate) fn drag(&mut self, from: Pos2, by: Vec2) {
        self.drag_with(PointerButton::Primary, Modifiers::NONE, from, by);
    }

    pub(crate) fn click(&mut self, at: Pos2, modifiers: Modifiers) {
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.button(at, PointerButton::Primary, true, modifiers);
        self.button(at, PointerButton::Primary, false, modifiers);
        self.harness.event(Event::ModifiersChanged(Modifiers::NONE));
        self.settle();
    }

    /// The middle of a cloud's sprites, in the world.
    pub(crate) fn middle_of(&self, cloud: &Cloud) -> DVec3 {
        self.session().derived().clouds().iter().find(|placed| placed.id == cloud.id).expect("placed").origin
    }
}

pub(crate) fn opened() -> Window {
    let mut window = Window::open();
    window.settle();
    window
}

#[test]
fn an_arrow_moves_a_cloud_by_steps() {
    let mut window = opened();
    let start = window.scene().clone();
    let cloud = start.clouds[0].clone();
    window.select([Item::Cloud(cloud.id)]);
    window.press("Move");
    window.press("Snap");
    let pivot = window.on_screen(window.middle_of(&cloud));
    window.drag(pivot + vec2(52.0, 0.0), vec2(120.0, 3.0));
    let moved = window.scene().clouds[0].position - cloud.position;
    assert!(moved.x >= 100.0 && moved.x % 50.0 == 0.0, "{moved}");
    assert_eq!((moved.y, moved.z), (0.0, 0.0));
    window.was_told("Position x of ");
    window.press("Undo");
    assert_eq!((window.scene(), window.undo_name()), (&start, None));
    // The arrow upwards, freely: Ctrl does the opposite of the switch.
    let arrow = pivot - vec2(0.0, 52.0);
    window.drag_with(PointerButton::Primary, Modifiers::COMMAND | Modifiers::CTRL, arrow, vec2(2.0, -77.0));
    let moved = window.scene().clouds[0].position - cloud.position;
    let wanted = 77.0 * f64::from(window.view().pixel()) * 3200.0;
    assert!((moved.y - wanted).abs() < wanted * 0.1 && moved.y % 50.0 != 0.0, "{moved} for {wanted}");
    assert_eq!((moved.x, moved.z), (0.0, 0.0));
}

#[test]
fn escape_drops_a_move() {
    let mut window = opened();
    let start = window.scene().clone();
    window.select([Item::Cloud(start.clouds[0].id)]);
    window.press("Move");
    let arrow = window.on_screen(window.middle_of(&start.clouds[0])) + vec2(52.0, 0.0);
    window.pointer(arrow, Some(true));
    window.pointer(arrow + vec2(40.0, 0.0), None);
    window.pointer(arrow + vec2(60.0, 0.0), None);
    assert_ne!(window.scene(), &start);
    window.harness.key_press(Key::Escape);
    window.harness.step();
    window.pointer(arrow + vec2(90.0, 0.0), None);
    window.pointer(arrow + vec2(90.0, 0.0), Some(false));
    window.settle();
    assert_eq!((window.scene(), window.undo_name()), (&start, None));
}

#[test]
fn rings_turn_and_circles_scale_about_the_middle() {
    let mut window = opened();
    let start = window.scene().clone();
    let cloud = start.clouds[0].clone();
    let middle = window.middle_of(&cloud);
    let pivot = window.on_screen(middle);
    window.select([Item::Cloud(cloud.id)]);
    window.press("Scale");
    window.press("Snap");
    // The circle's radius: the gizmo's size, its line's width and 5 points.
    let radius = 84.0 + 3.5 + 5.0;
    window.drag(pivot + vec2(radius, 0.0), vec2(radius * 0.5, 0.0));
    assert!((window.scene().clouds[0].scale - 1.5).abs() < 1e-9, "{}", window.scene().clouds[0].scale);
    assert!(window.middle_of(&cloud).distance(middle) < 0.01, "the middle stays");
    window.was_told("Scale of ");
    window.press("Undo");
    window.press("Rotate");
    // The ring about the vertical, seen from below: its near side is a flat arc above the pivot.
    let near = window.on_screen(middle + DVec3::Z * 84.0 * 3200.0 * f64::from(window.view().pixel()));
    window.drag(near, vec2(-70.0, 0.0));
    let turned = window.scene().clouds[0].heading_deg;
    assert!(turned.abs() >= 15.0 && turned % 15.0 == 0.0, "{turned}");
    window.was_told("Heading of ");
    assert!(window.middle_of(&cloud).distance(middle) < 0.01);
}

#[test]
fn a_face_is_dragged_and_the_opposite_one_stays() {
    let mut window = opened();
    window.press("body");
    let before = window.primary_box();
    let face = window.harness.get_by_label("Face +x").rect().center();
    window.drag(face, vec2(60.0, 0.0));
    let after = window.primary_box();
    assert!(after.size.x > before.size.x + 50.0 && after.size.y == before.size.y);
    let west = |each: &CloudBox| each.center.x - each.size.x * 0.5;
    assert!((west(&after) - west(&before)).abs() < 1e-6);
    window.was_told("Size x of body from ");
    window.press("Undo");
    assert_eq!(window.primary_box(), before);
    window.harness.get_by_label("Face −y").focus();
    window.settle();
    window.keys(Modifiers::NONE, Key::ArrowUp);
    let after = window.primary_box();
    assert_eq!((after.size.y, after.center.y), (before.size.y + 50.0, before.center.y - 25.0));
}

/// Three clouds side by side, with the view on all of them.
fn with_three_clouds() -> Window {
    let mut window = opened();
    for x in [-1000.0, 1000.0] {
        window.select([]);
        window.press("Add cloud");
        for (field, value) in [("Position x", x), ("Position y", 1000.0), ("Position z", 0.0)] {
            window.set(field, value);
        }
    }
    window.select([Item::Camera(window.scene().cameras[0].id)]);
    window.keys(Modifiers::NONE, Key::A);
    // The first camera goes where the view is, for the test to know it.
    window.press("Set from view");
    window.select([]);
    window
}

#[test]
fn a_marquee_selects_what_lies_in_it() {
    let mut window = with_three_clouds();
    let clouds = window.scene().clouds.clone();
    let at: Vec<Pos2> = clouds.iter().map(|cloud| window.on_screen(window.middle_of(cloud))).collect();
    let around = |a: Pos2, b: Pos2| Rect::from_two_pos(a, b).expand(30.0);
    let west = around(at[0], at[1]);
    window.drag(west.left_top(), west.size());
    let selected = |window: &Window| window.harness.state().selection().items().to_vec();
    assert_eq!(selected(&window), [Item::Cloud(clouds[0].id), Item::Cloud(clouds[1].id)]);
    let east = around(at[2], at[2]);
    window.drag_with(PointerButton::Primary, Modifiers::SHIFT, east.left_top(), east.size());
    assert_eq!(selected(&window).len(), 3);
    let all = around(at[0], at[2]);
    window.drag_with(PointerButton::Primary, Modifiers::COMMAND | Modifiers::CTRL, all.left_top(), all.size());
    assert_eq!(selected(&window), [Item::Cloud(clouds[1].id)], "the two in it are no longer selected");
    window.click(at[0], Modifiers::SHIFT);
    assert_eq!(selected(&window).len(), 2);
    // Several things are moved about their middle.
    window.press("Scale");
    window.press("Snap");
    let pivot = at[0] + (at[1] - at[0]) * 0.5;
    window.drag(pivot + vec2(92.5, 0.0), vec2(92.5, 0.0));
    let scene = window.scene();
    assert_eq!([0, 1, 2].map(|i| scene.clouds[i].scale), [2.0, 2.0, 1.0]);
    let gap = |clouds: &List<Cloud>| (clouds[0].position - clouds[1].position).length();
    assert!((gap(&scene.clouds) / gap(&clouds) - 2.0).abs() < 1e-3);
}

#[test]
fn clicks_on_one_place_go_through_all_that_lies_there() {
    let mut window = opened();
    let cloud = window.scene().clouds[0].clone();
    // Where the left head stands on the body.
    let at = window.on_screen(cloud.position + DVec3::new(-220.0, 310.0, 0.0));
    let mut seen = Vec::new();
    loop {
        window.click(at, Modifiers::NONE);
        let item = window.primary().expect("something lies there");
        if seen.contains(&item) {
            assert_eq!(item, seen[0], "after the last one the first comes again");
            break;
        }
        seen.push(item);
    }
    assert_eq!(seen[0], Item::Cloud(cloud.id));
    assert!(seen.len() >= 3 && seen[1..].iter().all(|item| matches!(item, Item::Box(..))), "{seen:?}");
    // Elsewhere, who works on boxes gets a box.
    window.click(at, Modifiers::NONE);
    window.click(at + vec2(12.0, 0.0), Modifiers::NONE);
    assert!(matches!(window.primary(), Some(Item::Box(..))));
}

#[test]
fn hidden_and_locked_things_are_not_picked() {
    let mut window = opened();
    let cloud = window.scene().clouds[0].clone();
    let at = window.on_screen(window.middle_of(&cloud));
    for command in [Command::Hide, Command::Lock] {
        window.select([Item::Cloud(cloud.id)]);
        window.command(command);
        window.click(at, Modifiers::NONE);
        assert_eq!(window.primary(), None, "{command:?}");
        let all = window.viewport().shrink(20.0);
        window.drag(pos2(all.left(), all.center().y - 200.0), vec2(all.width(), 300.0));
        assert_eq!(window.primary(), None, "{command:?}");
        window.select([Item::Cloud(cloud.id)]);
        window.press("Move");
        window.drag(at + vec2(52.0, 0.0), vec2(100.0, 0.0));
        assert_eq!(window.scene().clouds[0], cloud, "{command:?}");
        window.press("Select");
        window.command(Command::ShowAll);
    }
    // A hidden box is passed through, the cloud is not.
    let boxes: Vec<Item> = window.scene().models[0].boxes.iter().map(|each| Item::Box(cloud.model, each.id)).collect();
    window.select(boxes[1..].iter().copied());
    window.command(Command::Hide);
    window.select([]);
    for _ in 0..4 {
        window.click(at, Modifiers::NONE);
        assert!(window.primary().is_none_or(|item| !boxes[1..].contains(&item)));
    }
}

#[test]
fn a_sprite_is_moved_by_hand_and_stays() {
    let mut window = opened();
    window.press("body");
    let (model, id) = (window.scene().models[0].id, window.primary_box().id);
    window.keys(Modifiers::NONE, Key::M);
    let place = |window: &Window, index| {
        let cloud = &window.session().derived().clouds()[0];
        let sprite = cloud.sprites.iter().find(|sprite| (sprite.box_id, sprite.index) == (id, index));
        cloud.origin + sprite.expect("kept").position.as_dvec3()
    };
    let first = window.session().derived().clouds()[0].sprites.iter().find(|sprite| sprite.box_id == id);
    let index = first.expect("it has some").index;
    let at = window.on_screen(place(&window, index));
    window.click(at, Modifiers::NONE);
    let Some(Item::Sprite(of, its_box, index)) = window.primary() else { panic!("{:?}", window.primary()) };
    assert_eq!(of, model);
    let place = |window: &Window| {
        let cloud = &window.session().derived().clouds()[0];
        let sprite = cloud.sprites.iter().find(|sprite| (sprite.box_id, sprite.index) == (its_box, index));
        cloud.origin + sprite.expect("kept").position.as_dvec3()
    };
    let before = place(&window);
    window.press("Move");
    window.press("Snap");
    let pivot = window.on_screen(before);
    window.drag(pivot + vec2(52.0, 0.0), vec2(90.0, 0.0));
    let moved = place(&window) - before;
    assert!(moved.x > 90.0 && (moved.x / 50.0 - (moved.x / 50.0).round()).abs() < 1e-3, "{moved}");
    assert!(moved.y.abs() < 0.01 && moved.z.abs() < 0.01, "{moved}");
    assert_eq!(window.undo_name().as_deref(), Some("Move"));
    let there = place(&window);
    window.select([Item::Box(model, its_box)]);
    window.set("Sprites", 160.0);
    assert!(place(&window).distance(there) < 0.01, "the others are strewn, this one stays");
}

#[test]
fn a_group_center_is_moved_by_hand() {
    let mut window = opened();
    window.press("body");
    window.command(Command::NewGroup);
    let model = window.scene().models[0].id;
    let Some(group) = window.scene().models[0].groups.first().map(|group| group.id) else { panic!("a group") };
    window.select([Item::Group(model, group)]);
    window.press("Move");
    let placed = &window.session().derived().clouds()[0];
    let found = placed.groups.iter().find(|each| each.key == GroupKey::Named(group)).expect("it has sprites");
    let center = placed.origin + found.center.as_dvec3();
    let at = window.on_screen(center);
    window.drag(at - vec2(0.0, 52.0), vec2(0.0, -60.0));
    let GroupCenter::At(moved) = window.scene().models[0].groups[0].light.center else { panic!("put by hand") };
    let moved = ModelSpace::of(&window.scene().clouds[0]).to_world(moved) - center;
    assert!(moved.y > 50.0 && moved.x.abs() < 0.1 && moved.z.abs() < 0.1, "{moved}");
    window.was_told("Move · ");
    let scene = window.scene().clone();
    // A group that is gone has no handle.
    window.select([Item::Group(model, GroupId(999))]);
    window.drag(at, vec2(50.0, 0.0));
    assert_eq!(window.scene(), &scene);
}

#[test]
fn far_from_the_origin_all_works_as_well() {
    let mut window = opened();
    window.select([Item::Cloud(window.scene().clouds[0].id)]);
    window.set("Position x", 1e6);
    window.set("Position z", -1e6);
    window.keys(Modifiers::NONE, Key::F);
    window.select([Item::Camera(window.scene().cameras[0].id)]);
    window.press("Set from view");
    window.select([]);
    let cloud = window.scene().clouds[0].clone();
    let at = window.on_screen(window.middle_of(&cloud));
    window.click(at, Modifiers::NONE);
    assert_eq!(window.primary(), Some(Item::Cloud(cloud.id)));
    window.press("Move");
    window.press("Snap");
    window.drag(at + vec2(52.0, 0.0), vec2(150.0, 0.0));
    let moved = window.scene().clouds[0].position - cloud.position;
    assert!(moved.x >= 50.0 && moved.x % 50.0 == 0.0 && moved.y == 0.0 && moved.z == 0.0, "{moved}");
    window.press("Select");
    window.press("body");
    let before = window.primary_box();
    let face = window.harness.get_by_label("Face +y").rect().center();
    window.drag(face, vec2(0.0, -40.0));
    assert!(window.primary_box().size.y > before.size.y + 10.0);
    window.press("Box tool");
    window.keys(Modifiers::NONE, Key::Enter);
    let cloud = &window.scene().clouds[0];
    let drawn = window.primary_box();
    let place = ModelSpace::of(cloud).to_world(drawn.center);
    assert!(place.distance(window.middle_of(cloud)) < 2000.0, "{place}");
}

#[test]
fn cameras_are_chosen_in_the_viewport() {
    let mut window = opened();
    window.press("Cameras");
    window.press("Add camera from view");
    assert_eq!(window.scene().cameras.len(), 2);
    window.press("Cameras");
    window.press("Look through main");
    window.press("Box tool");
    window.set("Base altitude", 1500.0);
    window.select([]);
    window.keys(Modifiers::NONE, Key::Enter);
    assert_eq!(window.scene().clouds[1].position.y, 1500.0);
}
