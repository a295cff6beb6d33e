//! Several things selected: what differs is shown as mixed, and what is set there all of them get.

use super::*;
use cloudwright_core::scene::{Cloud, CullRadius};

/// The field's text.
fn shown(window: &Window, role: Role, label: &str) -> String {
    window.node(role, label).value().unwrap_or_default()
}

fn type_in(window: &mut Window, role: Role, label: &str, text: &str) {
    window.node(role, label).focus();
    window.settle();
    window.harness.event(Event::Text(text.into()));
    window.settle();
    window.keys(Modifiers::NONE, Key::Enter);
}

fn choose(window: &mut Window, label: &str, choice: &str) {
    window.node(Role::ComboBox, label).click();
    window.settle();
    window.press(choice);
}

/// Two clouds of one model, the second of another scale, name, seed and formation; both selected, the first as the
/// primary.
fn two_clouds() -> Window {
    let mut window = Window::open();
    window.settle();
    let first = Item::Cloud(window.scene().clouds[0].id);
    window.select([first]);
    window.command(Command::Duplicate);
    let second = Item::Cloud(window.scene().clouds[1].id);
    window.select([second]);
    window.set("Scale", 3.0);
    window.set("Seed", 77.0);
    type_in(&mut window, Role::TextInput, "Name", "second");
    choose(&mut window, "Formation", "forms");
    window.select([second, first]);
    window
}

#[test]
fn what_differs_is_mixed_until_it_is_set() {
    let mut window = two_clouds();
    let start = window.file();
    let both = |window: &Window, is: fn(&Cloud) -> bool| window.scene().clouds.iter().all(is);
    for (role, label, same) in [
        (Role::SpinButton, "Scale", false),
        (Role::SpinButton, "Seed", false),
        (Role::SpinButton, "Heading", true),
        (Role::ComboBox, "Formation", false),
        (Role::ComboBox, "Model", true),
    ] {
        assert_eq!(shown(&window, role, label) != "mixed", same, "{label}");
    }
    assert_eq!(shown(&window, Role::TextInput, "Name"), "");
    // The value that the primary has already is a value like any other.
    type_in(&mut window, Role::SpinButton, "Scale", "1");
    assert!(both(&window, |cloud| cloud.scale == 1.0));
    assert_ne!(shown(&window, Role::SpinButton, "Scale"), "mixed");
    window.command(Command::Undo);
    assert_eq!(window.file(), start, "one step");

    type_in(&mut window, Role::SpinButton, "Seed", "5");
    assert!(both(&window, |cloud| cloud.seed == Some(5)));
    type_in(&mut window, Role::TextInput, "Name", "twin");
    assert!(both(&window, |cloud| cloud.name == "twin"));
    choose(&mut window, "Formation", "always whole");
    assert!(both(&window, |cloud| cloud.formation.is_none()));
}

#[test]
fn a_field_that_is_left_as_it_was_changes_nothing() {
    let mut window = two_clouds();
    let start = window.file();
    for (role, label) in [(Role::SpinButton, "Scale"), (Role::SpinButton, "Seed"), (Role::TextInput, "Name")] {
        window.node(role, label).focus();
        window.settle();
        window.keys(Modifiers::NONE, Key::Enter);
        assert_eq!(window.file(), start, "{label}");
    }
}

/// A share and metres have one label, and are two properties: what is set in the one is no value of the other's.
#[test]
fn what_has_the_same_label_alone_is_left_as_it_is() {
    let mut window = Window::open();
    window.settle();
    let first = Item::Cloud(window.scene().clouds[0].id);
    window.select([first]);
    window.command(Command::DuplicateOwn);
    let models: Vec<Item> = window.scene().models.iter().map(|model| Item::Model(model.id)).collect();
    let share = window.scene().models[0].cull_radius;
    window.select([models[1]]);
    choose(&mut window, "Cull by", "metres");
    window.select(models);
    window.set("Cull radius", 500.0);
    let radii = [0, 1].map(|at| window.scene().models[at].cull_radius);
    assert_eq!(radii, [share, CullRadius::Metres(500.0)]);
}
