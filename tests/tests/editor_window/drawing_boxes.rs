//! The box tool.

use crate::Window;
use crate::tools::opened;
use cloudwright::command::Command;
use cloudwright::state::Item;
use egui::{Key, Modifiers, Pos2, Vec2, vec2};
use glam::DVec3;

/// From where and how far a footprint is dragged: the plane lies above the eye.
fn footprint(window: &Window) -> (Pos2, Vec2) {
    let middle = window.viewport().center();
    (middle + vec2(-90.0, -120.0), vec2(180.0, -70.0))
}

#[test]
fn a_box_is_drawn_in_one_step() {
    let mut window = opened();
    let (start, sprites) = (window.scene().clone(), window.sprites());
    window.press("Box tool");
    let (from, by) = footprint(&window);
    window.drag(from, by);
    assert!(window.session().document().is_open(), "the height is still to be pulled");
    assert!(window.sprites() > sprites, "the cloud is under the hand already");
    let low = window.scene().models[1].boxes[0].size.y;
    window.pointer(from + by - vec2(0.0, 60.0), None);
    window.pointer(from + by - vec2(0.0, 90.0), None);
    let high = window.scene().models[1].boxes[0].size.y;
    assert!(high > low * 1.2, "{high} and {low}");
    window.click(from + by - vec2(0.0, 90.0), Modifiers::NONE);
    assert!(!window.session().document().is_open());
    assert_eq!((window.scene().models.len(), window.scene().clouds.len()), (2, 2));
    let (drawn, cloud) = (window.primary_box(), &window.scene().clouds[1]);
    assert_eq!(window.primary(), Some(Item::Box(cloud.model, drawn.id)));
    assert!((cloud.position.y - 1000.0).abs() < 1e-6 && (drawn.center.y - drawn.size.y * 0.5).abs() < 1e-6);
    // The corners lie under the pointer.
    let corners = [vec2(-0.5, 0.5), vec2(0.5, -0.5)].map(|side| {
        let half = DVec3::new(f64::from(side.x) * drawn.size.x, 0.0, f64::from(side.y) * drawn.size.z);
        [half, DVec3 { z: -half.z, ..half }].map(|half| window.on_screen(cloud.position + half))
    });
    for (end, corners) in [(from, corners[0]), (from + by, corners[1])] {
        assert!(corners.iter().any(|corner| corner.distance(end) < 2.0), "{corners:?} for {end}");
    }
    assert!(window.sprites() >= sprites + 10);
    assert_eq!(window.undo_name().as_deref(), Some("Draw box of cloud"));
    window.press("Undo");
    assert_eq!((window.scene(), window.undo_name()), (&start, None));
}

/// Where the base's plane is met far before the cloud that is drawn into, the box is drawn at the cloud.
#[test]
fn over_its_cloud_a_box_is_drawn_at_the_cloud() {
    let mut window = opened();
    window.select([Item::Cloud(window.scene().clouds[0].id)]);
    window.press("Box tool");
    let middle_m = window.middle_of(&window.scene().clouds[0]);
    let top = window.on_screen(middle_m + DVec3::Y * 150.0);
    // A ray to the cloud's top meets the plane on half its way.
    let eye = window.eye().position;
    window.set("Base altitude", ((eye.y + middle_m.y + 150.0) * 0.5).round());
    assert!(middle_m.distance(eye) > 1500.0, "{eye}");
    window.drag(top - vec2(30.0, 0.0), vec2(60.0, 3.0));
    assert!(window.session().document().is_open());
    window.keys(Modifiers::NONE, Key::Enter);
    let (drawn, cloud) = (window.primary_box(), &window.scene().clouds[0]);
    assert_eq!(window.primary(), Some(Item::Box(cloud.model, drawn.id)), "it is the cloud's");
    let off = cloud.position + drawn.center - middle_m;
    assert!(DVec3 { y: 0.0, ..off }.length() < 100.0, "{off} from the cloud's middle");
}

#[test]
fn escape_drops_a_box_at_any_stage() {
    for stage in 0..3 {
        let mut window = opened();
        let start = window.scene().clone();
        window.press("Box tool");
        let (from, by) = footprint(&window);
        window.pointer(from, Some(true));
        window.pointer(from + by * 0.5, None);
        window.pointer(from + by, None);
        if stage > 0 {
            window.pointer(from + by, Some(false));
        }
        if stage > 1 {
            window.pointer(from + by - vec2(0.0, 50.0), None);
        }
        assert_ne!(window.scene(), &start, "stage {stage}");
        window.harness.key_press(Key::Escape);
        window.harness.step();
        assert_eq!(window.scene(), &start, "stage {stage}: the counter of ids too");
        window.pointer(from + by - vec2(0.0, 80.0), None);
        window.pointer(from + by - vec2(0.0, 90.0), Some(false));
        window.settle();
        assert_eq!((window.scene(), window.undo_name()), (&start, None), "stage {stage}");
    }
}

#[test]
fn what_is_no_box_leaves_nothing() {
    let mut window = opened();
    let start = window.scene().clone();
    window.press("Box tool");
    let (from, by) = footprint(&window);
    window.drag(from, vec2(2.0, 1.0));
    // There and back again.
    window.pointer(from, Some(true));
    window.pointer(from + by, None);
    window.pointer(from + vec2(1.0, 0.0), None);
    window.pointer(from + vec2(1.0, 0.0), Some(false));
    window.settle();
    assert_eq!((window.scene(), window.undo_name()), (&start, None));
    // Another tool ends it as it is.
    window.drag(from, by);
    window.keys(Modifiers::NONE, Key::Q);
    assert!(!window.session().document().is_open());
    assert_eq!(window.undo_name().as_deref(), Some("Draw box of cloud"));
    window.press("Undo");
    assert_eq!(window.scene(), &start);
}

#[test]
fn a_box_can_be_drawn_where_its_base_is_out_of_sight() {
    let mut window = opened();
    window.press("Box tool");
    // Towards the ground, the plane above the eye is never met: the hand says how wide the box is where the view looks.
    let ground = window.viewport().center_bottom() - vec2(60.0, 60.0);
    window.drag(ground, vec2(120.0, 0.0));
    window.click(ground + vec2(120.0, -40.0), Modifiers::NONE);
    let (drawn, cloud) = (window.primary_box(), &window.scene().clouds[1]);
    assert!((cloud.position.y - 1000.0).abs() < 1e-6, "it stands at the base altitude");
    assert!(drawn.size.x > 300.0 && (drawn.size.z / drawn.size.x - 0.6).abs() < 0.01, "{:?}", drawn.size);
    let ends = [-0.5, 0.5].map(|side| window.on_screen(cloud.position + DVec3::X * (side * drawn.size.x)).x);
    // The base lies some hundred metres above the hand, and so, with the view pitched by 6°, a few per cent farther away.
    assert!((ends[0] - ground.x).abs() < 6.0 && (ends[1] - ground.x - 120.0).abs() < 6.0, "{ends:?}");
}

#[test]
fn boxes_go_into_the_selected_cloud_unless_it_is_locked() {
    let mut window = opened();
    let cloud = window.scene().clouds[0].clone();
    window.select([Item::Cloud(cloud.id)]);
    window.press("Box tool");
    // By the keyboard: a box in the middle of the view.
    window.keys(Modifiers::NONE, Key::Enter);
    assert_eq!((window.scene().models.len(), window.scene().models[0].boxes.len()), (1, 5));
    assert_eq!(window.undo_name().as_deref(), Some("Draw box of cumulus"));
    assert_eq!(window.primary_box().size, DVec3::splat(500.0));
    let low = window.primary_box().center.y - 250.0;
    assert!((cloud.position.y + low - 1000.0).abs() < 1e-6);
    window.keys(Modifiers::NONE, Key::Enter);
    assert_eq!(window.scene().models[0].boxes.len(), 6, "the new box's cloud takes the next one");
    window.was_told("Draw box 2 of cumulus");
    window.command(Command::AddBox);
    assert_eq!(window.primary_box().name, "box 3");
    window.command(Command::Undo);
    window.select([Item::Cloud(cloud.id)]);
    window.command(Command::Lock);
    let (from, by) = footprint(&window);
    window.drag(from, by);
    window.click(from + by, Modifiers::NONE);
    assert_eq!((window.scene().models.len(), window.scene().clouds.len()), (2, 2));
}
