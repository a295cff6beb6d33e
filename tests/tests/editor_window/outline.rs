//! The outline: found by name and kind, chosen by clicks and arrow keys, renamed, put in another order; what is picked
//! elsewhere comes into sight, and models that nothing places are told.

use crate::{Script, Window, start};
use cloudwright::command::Command;
use cloudwright::editor::{Editor, Start};
use cloudwright::state::Item;
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::Scene;
use cloudwright_tests::small_scenes::crowd;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use tempfile::TempDir;

/// An editor with `scene` open, from a file in that folder.
pub(crate) fn with_scene(scene: &Scene) -> (Window, TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.cloudscene");
    std::fs::write(&path, scene_file::write(scene).expect("finite numbers")).expect("writable");
    let script = Script::default();
    let start = Start { scene: Some(path), ..start(script.clone(), None) };
    let harness = Harness::builder()
        .with_size([1280.0, 1200.0])
        .build_eframe(move |creation| Editor::new(&creation.egui_ctx, start));
    let mut window = Window { harness, script };
    window.settle();
    (window, folder)
}

/// So many clouds of three models, each thing of another name.
fn named_crowd(count: u32) -> Scene {
    let mut scene = crowd(count);
    for index in 0..scene.clouds.len() {
        scene.clouds[index].name = format!("cloud {index:03}");
    }
    for index in 0..scene.models.len() {
        let name = format!("body of {}", scene.models[index].name);
        scene.models[index].boxes[0].name = name;
    }
    scene
}

impl Window {
    fn has_row(&self, name: &str) -> bool {
        self.harness.query_by_role_and_label(Role::Button, name).is_some()
    }

    fn click_row(&mut self, name: &str, modifiers: Modifiers) {
        let at = self.node(Role::Button, name).rect().center();
        self.click(at, modifiers);
    }

    pub(crate) fn right_click(&mut self, at: egui::Pos2) {
        self.button(at, PointerButton::Secondary, true, Modifiers::NONE);
        self.button(at, PointerButton::Secondary, false, Modifiers::NONE);
        self.settle();
    }

    fn names(&self) -> Vec<String> {
        self.scene().clouds.iter().map(|cloud| cloud.name.clone()).collect()
    }

    fn chosen_names(&self) -> Vec<String> {
        let items = self.harness.state().selection().items().iter();
        items.filter_map(|item| Some(item.listed(self.scene())?.name().to_owned())).collect()
    }
}

#[test]
fn rows_are_found_by_name_and_by_kind() {
    let (mut window, _folder) = with_scene(&named_crowd(120));
    assert!(window.has_row("Clouds (120)") && window.has_row("cloud 000"));
    window.type_into(Role::TextInput, "Find in the outline", "D 11");
    assert!(window.has_row("Clouds (10 of 120)") && window.has_row("cloud 110") && !window.has_row("cloud 000"));
    assert!(window.has_row("Models (0 of 3)"));
    window.type_into(Role::TextInput, "Find in the outline", "zzz");
    assert!(window.has_row("Clouds (0 of 120)"));
    for _ in 0.."D 11zzz".len() {
        window.keys(Modifiers::NONE, Key::Backspace);
    }
    window.type_into(Role::TextInput, "Find in the outline", "BODY OF R");
    assert!(window.has_row("body of round") && window.has_row("round"), "with the model that it is of");
    assert!(!window.has_row("low"));
    for _ in 0.."BODY OF R".len() {
        window.keys(Modifiers::NONE, Key::Backspace);
    }
    window.node(Role::ComboBox, "Kinds shown").click();
    window.settle();
    window.press("Models");
    assert!(window.has_row("Models (3)") && !window.has_row("Clouds (120)") && window.has_row("body of flat"));
}

#[test]
fn what_is_picked_elsewhere_comes_into_sight() {
    let (mut window, _folder) = with_scene(&named_crowd(400));
    let scene = window.scene().clone();
    assert!(!window.has_row("cloud 333"));
    window.select([Item::Cloud(scene.clouds[333].id)]);
    assert!(window.has_row("cloud 333"));
    let model = &scene.models[2];
    window.select([Item::Sprite(model.id, model.boxes[0].id, 4)]);
    assert!(window.has_row("body of flat"), "a sprite by its box");
    // True indentation.
    let left = |name: &str| window.node(Role::Button, name).rect().left();
    assert!(left("Models (3)") < left("flat") && left("flat") + 8.0 < left("body of flat"));
    window.press("Fold flat");
    assert!(!window.has_row("body of flat"));
    window.select([]);
    window.select([Item::Box(model.id, model.boxes[0].id)]);
    assert!(window.has_row("body of flat"), "what is folded is unfolded for it");
}

#[test]
fn arrow_keys_go_through_the_rows() {
    let (mut window, _folder) = with_scene(&named_crowd(400));
    window.press("cloud 003");
    for _ in 0..3 {
        window.keys(Modifiers::NONE, Key::ArrowDown);
    }
    assert_eq!(window.chosen_names(), ["cloud 006"]);
    window.keys(Modifiers::NONE, Key::ArrowUp);
    window.keys(Modifiers::SHIFT, Key::ArrowUp);
    assert_eq!(window.chosen_names(), ["cloud 005", "cloud 004"]);
    for _ in 0..45 {
        window.harness.key_press(Key::ArrowDown);
        window.harness.run_steps(3);
    }
    assert_eq!(window.chosen_names(), ["cloud 049"]);
    assert!(window.has_row("cloud 049"), "and stay in sight");
    // With Shift all from the last one to it, with Ctrl one more or less.
    window.click_row("cloud 045", Modifiers::SHIFT);
    assert_eq!(window.chosen_names().len(), 5);
    window.click_row("cloud 047", Modifiers::COMMAND);
    assert_eq!(window.chosen_names().len(), 4);
    let model = window.scene().models[0].id;
    window.select([Item::Model(model)]);
    window.press("low");
    window.keys(Modifiers::NONE, Key::ArrowLeft);
    assert!(!window.has_row("body of low"));
    window.keys(Modifiers::NONE, Key::ArrowRight);
    assert!(window.has_row("body of low"));
}

#[test]
fn names_are_changed_in_the_row_or_many_at_once() {
    let (mut window, _folder) = with_scene(&named_crowd(40));
    let start = window.file();
    window.press("cloud 002");
    window.keys(Modifiers::NONE, Key::F2);
    window.harness.event(Event::Text("heap".into()));
    window.keys(Modifiers::NONE, Key::Enter);
    assert_eq!(window.names()[2], "heap");
    window.was_told("Name of");
    // By a double click, and not with Esc.
    let at = window.node(Role::Button, "cloud 004").rect().center();
    for _ in 0..2 {
        window.button(at, PointerButton::Primary, true, Modifiers::NONE);
        window.button(at, PointerButton::Primary, false, Modifiers::NONE);
    }
    window.settle();
    window.harness.event(Event::Text("nothing".into()));
    window.keys(Modifiers::NONE, Key::Escape);
    assert_eq!(window.names()[4], "cloud 004");
    window.keys(Modifiers::NONE, Key::F2);
    window.harness.event(Event::Text("something".into()));
    window.press("cloud 007");
    assert_eq!(window.names()[4], "something", "a click elsewhere takes it");
    window.command(Command::Undo);
    window.command(Command::Undo);
    assert_eq!(window.file(), start);
    // Many, in the order in which they stand.
    let ids: Vec<_> = window.scene().clouds.iter().map(|cloud| cloud.id).collect();
    window.select([3, 1, 2].map(|at| Item::Cloud(ids[at])));
    window.keys(Modifiers::NONE, Key::F2);
    window.node(Role::TextInput, "Pattern of the names").focus();
    window.settle();
    window.keys(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Text("tower ##".into()));
    window.set("First number", 7.0);
    assert!(window.shows("cloud 001 becomes tower 07"));
    window.press("Rename");
    assert_eq!(window.names()[1..4], ["tower 07", "tower 08", "tower 09"]);
    assert_eq!(window.undo_name().as_deref(), Some("Rename"));
    window.command(Command::Undo);
    assert_eq!(window.file(), start);
}

#[test]
fn rows_are_dragged_to_another_place() {
    let (mut window, _folder) = with_scene(&named_crowd(12));
    let start = window.file();
    let at = |window: &Window, name: &str| window.node(Role::Button, name).rect();
    let (from, to) = (at(&window, "cloud 001"), at(&window, "cloud 004"));
    let by = vec2(0.0, to.bottom() - from.center().y);
    window.drag(from.center(), by);
    assert_eq!(window.names()[..5], ["cloud 000", "cloud 002", "cloud 003", "cloud 004", "cloud 001"]);
    assert_eq!(window.undo_name().as_deref(), Some("Change the order"));
    window.command(Command::Undo);
    assert_eq!(window.file(), start);
    // Among their like only.
    let down: Vec2 = at(&window, "low").center() - from.center();
    window.drag(from.center(), down + vec2(0.0, 60.0));
    assert_eq!(window.file(), start);
    // Many at once, upwards.
    let ids: Vec<_> = window.scene().clouds.iter().map(|cloud| cloud.id).collect();
    window.select([6, 8].map(|at| Item::Cloud(ids[at])));
    let from = at(&window, "cloud 008").center();
    let by = vec2(0.0, at(&window, "cloud 000").top() - from.y);
    window.drag(from, by);
    assert_eq!(window.names()[..3], ["cloud 006", "cloud 008", "cloud 000"]);
}

#[test]
fn deleting_says_what_stays() {
    let (mut window, _folder) = with_scene(&named_crowd(3));
    assert!(!window.harness.state().can(Command::RemoveUnusedModels));
    window.press("cloud 001");
    window.command(Command::Delete);
    assert!(window.shows("Its model “round” stays") && window.harness.query_by_label("unused").is_some());
    window.command(Command::RemoveUnusedModels);
    assert_eq!(window.scene().models.len(), 2);
    assert!(window.shows("Removed 1 model that no cloud placed"));
    assert_eq!(window.undo_name().as_deref(), Some("Remove unused models"));
    assert!(!window.harness.state().can(Command::RemoveUnusedModels));
}

#[test]
fn the_right_button_offers_what_can_be_done() {
    let (mut window, _folder) = with_scene(&named_crowd(40));
    let start = window.file();
    let at = window.node(Role::Button, "cloud 003").rect().center();
    window.right_click(at);
    assert_eq!(window.chosen_names(), ["cloud 003"], "it is chosen");
    window.press("Rename…");
    window.harness.event(Event::Text("x".into()));
    window.keys(Modifiers::NONE, Key::Enter);
    assert_eq!(window.names()[3], "x");
    window.command(Command::Undo);
    // What is chosen already stays so.
    let ids: Vec<_> = window.scene().clouds.iter().map(|cloud| cloud.id).collect();
    window.select([1, 3].map(|at| Item::Cloud(ids[at])));
    window.right_click(at);
    window.press("Cut");
    assert_eq!(window.names().len(), 38);
    window.command(Command::Undo);
    assert_eq!(window.file(), start);
}

#[test]
fn in_the_picture_a_click_of_it_offers_and_a_drag_flies() {
    let mut window = crate::tools::opened();
    let cloud = window.scene().clouds[0].clone();
    let at = window.on_screen(window.middle_of(&cloud));
    let eye = window.harness.state().camera().clone();
    window.right_click(at);
    assert_eq!(window.primary(), Some(Item::Cloud(cloud.id)), "what lies there is chosen");
    assert_eq!(*window.harness.state().camera(), eye);
    window.press("Frame all");
    assert_ne!(*window.harness.state().camera(), eye);
    window.drag_with(PointerButton::Secondary, Modifiers::NONE, at, vec2(60.0, 0.0));
    assert!(!window.has_row("Frame all"), "no menu after a flight");
}

#[test]
fn a_tab_offers_the_panels() {
    let mut window = crate::tools::opened();
    let at = window.harness.get_by_label("\u{e1a0} History").rect().center();
    window.right_click(at);
    window.press("Chart");
    assert!(window.harness.query_all_by_label_contains("Measure").next().is_some());
}
