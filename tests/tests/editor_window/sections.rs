//! Parts of panels are folded away, stay so for other things and over starts, and unfold again.

use crate::Window;
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
