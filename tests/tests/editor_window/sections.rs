//! Parts of panels are folded away, stay so for other things and over starts, and unfold again.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::state::Item;
use cloudwright::storage::Folders;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;

impl Window {
    fn fold(&mut self, title: &str) {
        self.node(Role::DisclosureTriangle, title).click();
        self.settle();
    }

    fn has_field(&self, label: &str) -> bool {
        self.harness.query_by_role_and_label(Role::SpinButton, label).is_some()
    }
}

#[test]
fn what_is_folded_stays_folded() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = || Some(Folders::within(home.path()));
    let box_of = |window: &Window, at: usize| {
        let model = &window.scene().models[0];
        Item::Box(model.id, model.boxes[at].id)
    };
    let mut window = Window::open_with(folders());
    window.select([box_of(&window, 0)]);
    assert!(window.has_field("Sprites") && window.has_field("Density"));
    window.fold("Sprites");
    window.harness.run_steps(8);
    assert!(!window.has_field("Sprites") && !window.has_field("Density"), "folded");
    assert!(window.has_field("Turn"), "and no other part");
    window.select([box_of(&window, 1)]);
    assert!(!window.has_field("Density"), "for another box too");
    drop(window);
    let mut window = Window::open_with(folders());
    window.select([box_of(&window, 2)]);
    assert!(!window.has_field("Density"), "and at the next start");
    window.fold("Sprites");
    assert!(window.has_field("Density"));
}

#[test]
fn a_cloud_has_parts_too() {
    let mut window = Window::open();
    let cloud = window.scene().clouds[0].id;
    window.select([Item::Cloud(cloud)]);
    for (part, field) in [("Place", "Scale"), ("Look and wind", "Opacity")] {
        assert!(window.has_field(field));
        window.fold(part);
        window.harness.run_steps(8);
        assert!(!window.has_field(field), "{part} is folded");
    }
}

/// In a window of 1600 × 1000 nothing that is changed often has to be scrolled to.
#[test]
fn what_is_changed_most_is_in_sight() {
    let mut window = Window::open_sized(None, [1600.0, 1000.0]);
    window.settle();
    let model = window.scene().models[0].clone();
    window.select([Item::Box(model.id, model.boxes[0].id)]);
    let below = window.node(Role::Button, "Help on Levels").rect().top();
    for field in ["Density", "Sprite size", "Sprites", "Width from", "Height to"] {
        let field = window.node(Role::SpinButton, field).rect();
        assert!(field.bottom() < below, "{field} ends below {below}");
    }
    // Of a cloud that is drawn box by box.
    for _ in 0..14 {
        window.command(Command::AddBox);
    }
    window.command(Command::GroupsPanel);
    let bottom = 1000.0 - 32.0;
    for field in ["Towards the sun", "Across", "Away from the sun"] {
        let field = window.node(Role::SpinButton, field).rect();
        assert!(field.bottom() < bottom, "{field} ends below {bottom}");
    }
    let rows = window.harness.query_all_by_label_contains("Shading of").count();
    assert!(rows >= 14, "{rows}: the list scrolls by itself");
}
