//! Shading groups, their light, the counts after culling, and fields that refuse.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::state::Item;
use cloudwright_core::scene::{CloudBox, CloudModel, GroupLight};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, vec2};
use egui_kittest::kittest::Queryable;

/// The panel of shading groups, with the starter's cloud selected.
fn with_groups() -> Window {
    let mut window = Window::open();
    window.settle();
    window.command(Command::GroupsPanel);
    let cloud = window.scene().clouds[0].id;
    window.select([Item::Cloud(cloud)]);
    window
}

fn model(window: &Window) -> &CloudModel {
    &window.scene().models[0]
}

fn box_named<'a>(window: &'a Window, name: &str) -> &'a CloudBox {
    model(window).boxes.iter().find(|each| each.name == name).expect("the starter has it")
}

fn select_boxes(window: &mut Window, names: &[&str]) {
    let id = model(window).id;
    let items: Vec<Item> = names.iter().map(|name| Item::Box(id, box_named(window, name).id)).collect();
    window.select(items);
}

#[test]
fn a_group_is_made_assigned_to_and_deleted() {
    let mut window = with_groups();
    let start = window.file();
    select_boxes(&mut window, &["left head", "right head"]);
    window.press("New group from selection");
    let group = model(&window).groups[0].clone();
    assert_eq!(group.name, "group");
    assert_eq!(box_named(&window, "left head").group, Some(group.id));
    assert_eq!(window.harness.state().selection().primary(), Some(Item::Group(model(&window).id, group.id)));
    let placed = &window.session().derived().clouds()[0];
    let count = placed.groups.iter().find(|each| each.key.to_string() == format!("group-{}", group.id));
    let count = count.expect("it has sprites").sprite_count;
    assert!(window.shows(&format!("{count} sprites of group")));

    select_boxes(&mut window, &["base"]);
    window.press("Assign selection to group");
    assert_eq!(box_named(&window, "base").group, Some(group.id));
    assert_eq!(window.undo_name().as_deref(), Some("Assign to shading group"));
    // A second click selects the members; so does the inspector.
    let row = window.node(Role::Button, "Shading of group").rect().center();
    let events = &mut window.harness.input_mut().events;
    events.push(Event::PointerMoved(row));
    for pressed in [true, false, true, false] {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        events.push(Event::PointerButton { pos: row, button, pressed, modifiers });
    }
    window.settle();
    assert_eq!(window.harness.state().selection().boxes().count(), 3);
    window.press("Shading of group");
    window.press("Select its members");
    assert_eq!(window.harness.state().selection().boxes().count(), 3);
    window.press("Delete group");
    assert!(model(&window).groups.is_empty() && model(&window).boxes.iter().all(|each| each.group.is_none()));
    for _ in 0..3 {
        window.command(Command::Undo);
    }
    assert_eq!(window.file(), start);
}

#[test]
fn automatic_groups_are_small() {
    let mut window = with_groups();
    let start = window.file();
    // 150 sprites in one lump of the base.
    select_boxes(&mut window, &["base"]);
    window.set("Sprites", 150.0);
    assert!(window.shows("sprites in one lump of base (its own): above 30 they look flat"));
    window.press("Group automatically");
    let placed = &window.session().derived().clouds()[0];
    assert!(placed.groups.iter().all(|group| group.sprite_count <= 30));
    assert_eq!(placed.groups.len(), placed.sprites.len().div_ceil(30));
    assert!(!window.shows("they look flat"));
    window.command(Command::Undo);
    window.command(Command::Undo);
    assert_eq!(window.file(), start);
    // A model that no cloud shows has no sprites.
    let (model, cloud) = (model(&window).id, window.scene().clouds[0].id);
    window.select([Item::Cloud(cloud)]);
    window.command(Command::Delete);
    window.select([Item::Model(model)]);
    let unplaced = window.file();
    window.command(Command::AutoGroup);
    assert!(window.shows("place it first"));
    assert_eq!(window.file(), unplaced);
}

#[test]
fn the_curve_is_dragged_for_all_that_is_selected() {
    let mut window = with_groups();
    let start = window.file();
    select_boxes(&mut window, &["left head", "right head"]);
    let lights = |window: &Window| ["left head", "right head"].map(|name| box_named(window, name).light);
    let before = lights(&window);
    let dot = window.node(Role::Slider, "Across").rect().center();
    window.pointer(dot, Some(true));
    for step in 1..=5_u8 {
        window.pointer(dot - vec2(0.0, f32::from(step) * 4.0), None);
    }
    assert!(window.session().document().is_open(), "it is shown at once");
    assert!(lights(&window)[0].c_med > before[0].c_med);
    window.pointer(dot - vec2(0.0, 20.0), Some(false));
    window.settle();
    let after = lights(&window);
    assert_eq!(after[0], GroupLight { c_med: after[0].c_med, ..before[0] }, "only what was dragged");
    assert_eq!(after[0].c_med, after[1].c_med);
    window.was_told("Across of 2 boxes to ");
    let dragged_to = window.node(Role::Slider, "Across").rect().center();
    assert!((dragged_to.y - (dot.y - 20.0)).abs() < 1.0, "the dot stays under the pointer");
    window.command(Command::Undo);
    assert_eq!((window.file(), window.undo_name()), (start, None));

    // By keys, by a screen reader, and by its field.
    window.node(Role::Slider, "Towards the sun").focus();
    window.settle();
    window.keys(Modifiers::NONE, Key::ArrowDown);
    assert!((lights(&window)[0].c_max - 0.95).abs() < 1e-9, "{:?}", lights(&window)[0]);
    window.node(Role::Slider, "Away from the sun").set_value_accesskit(0.2);
    window.settle();
    window.set("Across", 0.5);
    window.set("Pull to cloud", 0.1);
    let [left, right] = lights(&window);
    assert_eq!((left.c_min, left.c_med), (0.2, 0.5));
    assert_eq!(left, right);
}

#[test]
fn counts_follow_the_cull() {
    let mut window = with_groups();
    let counts = |window: &Window, name: &str| {
        let each = box_named(window, name);
        let placed = &window.session().derived().clouds()[0];
        let kept = placed.sprites.iter().filter(|sprite| sprite.box_id == each.id).count();
        format!("{kept} of {} sprites kept", each.sprite_count)
    };
    select_boxes(&mut window, &["body"]);
    let before = counts(&window, "body");
    assert!(window.shows(&before), "{before}");
    window.set("Sprites", 400.0);
    let after = counts(&window, "body");
    assert!(after != before && after.ends_with("of 400 sprites kept") && window.shows(&after), "{after}");
    let id = model(&window).id;
    let placed = &window.session().derived().clouds()[0];
    let whole = format!("{} of {} sprites kept", placed.sprites.len(), placed.candidate_count);
    let cloud = placed.id;
    window.select([Item::Model(id)]);
    assert!(window.shows(&whole));
    window.select([Item::Cloud(cloud)]);
    assert!(window.shows(&whole));
    // Another way to measure the cull radius, another count.
    window.select([Item::Model(id)]);
    window.set("Cull radius", 5.0);
    assert!(!window.shows(&whole) && window.shows("sprites kept"));
}

#[test]
fn a_field_refuses_with_its_range() {
    let mut window = with_groups();
    select_boxes(&mut window, &["body"]);
    let start = window.file();
    let type_in = |window: &mut Window, text: &str| {
        window.node(Role::SpinButton, "Sprites").focus();
        window.settle();
        window.harness.event(Event::Text(text.into()));
        window.settle();
        window.keys(Modifiers::NONE, Key::Enter);
    };
    type_in(&mut window, "-3");
    assert_eq!(window.file(), start);
    assert!(window.shows("-3 is outside 0 to 1000000"));
    // It goes by itself.
    window.harness.run_steps(400);
    assert!(!window.shows("is outside"));
    type_in(&mut window, "inf");
    assert!(window.shows("inf is outside"));
    type_in(&mut window, "31");
    assert_eq!(box_named(&window, "body").sprite_count, 31);
    assert!(!window.shows("is outside"));
}

#[test]
fn a_problem_leads_to_its_thing() {
    let mut window = with_groups();
    select_boxes(&mut window, &["base"]);
    window.set("Sprites", 150.0);
    window.command(Command::ProblemsPanel);
    let cloud = window.scene().clouds[0].clone();
    assert!(window.harness.query_by_label_contains("up to 30 read as one lump").is_some());
    window.press(&format!("Select “{}”", cloud.name));
    assert_eq!(window.harness.state().selection().primary(), Some(Item::Cloud(cloud.id)));
    window.command(Command::Undo);
    assert!(!window.shows("up to 30 read as one lump"), "it is looked for again after a change");
}
