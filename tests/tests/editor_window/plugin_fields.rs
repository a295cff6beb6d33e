//! Fields of a plugin's dialog that are more than a line: camera paths by name, curves, weather reports.

use crate::Window;
use crate::plugins::Home;
use cloudwright::command::Command;
use cloudwright_scripts::PluginKind;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Pos2};
use egui_kittest::kittest::Queryable;

/// An edit with a parameter of each kind that has a field of several lines, or a thing's name.
const LARGE: &str = r#"const PLUGIN = #{ name: "Large", kind: "edit", sentence: "Prints.", parameters: [
    #{ name: "way", label: "Way", kind: "path" },
    #{ name: "day", label: "Over day", kind: "curve", unit: "°C", min: -10, max: 30, soft_min: 0, soft_max: 20, initial: [[0, 0], [10, 20]] },
    #{ name: "report", label: "Report", kind: "metar" },
] };
fn run(parameters) {
    set("time_of_day_h", 9.0);
    print(`${parameters.way} ${parameters.day} ${parameters.report} at 5: ${curve_at(parameters.day, 5)}`);
}
"#;

#[test]
fn paths_curves_and_reports_have_fields_of_their_own() {
    let home = Home::with(&[("large.rhai", LARGE)]);
    let mut window = home.open();
    window.command(Command::AddPath);
    let path = window.scene().paths[0].clone();
    window.ask_plugin(PluginKind::Edit, "Large");
    let printed = |window: &mut Window, words: &str| window.wait(words, |window| window.shows(words));
    printed(&mut window, "0 [[0.0, 0.0], [10.0, 20.0]]  at 5: 10.0");
    window.node(Role::ComboBox, "Way").click();
    window.settle();
    window.harness.get_all_by_label(&path.name).last().expect("a choice").click();
    printed(&mut window, &format!("{} [[", path.id.0));
    // By the numbers of a point, by keys, and by the pointer.
    window.node(Role::Slider, "Over day point 2").focus();
    window.settle();
    window.set("Over day y", 30.0);
    printed(&mut window, "[[0.0, 0.0], [10.0, 30.0]]");
    window.set("Over day y", 31.0);
    assert!(window.shows("31 is outside -10 to 30 °C"));
    window.set("Over day x", 8.0);
    printed(&mut window, "[[0.0, 0.0], [8.0, 30.0]]");
    window.node(Role::Slider, "Over day point 1").focus();
    window.settle();
    window.keys(Modifiers::NONE, Key::Insert);
    printed(&mut window, "[[0.0, 0.0], [4.0, 15.0], [8.0, 30.0]]");
    window.node(Role::Slider, "Over day point 2").focus();
    window.settle();
    window.keys(Modifiers::NONE, Key::ArrowRight);
    window.keys(Modifiers::NONE, Key::ArrowDown);
    printed(&mut window, "[4.5, 13.5]");
    let [first, middle] =
        ["Over day point 1", "Over day point 2"].map(|name| window.node(Role::Slider, name).rect().center());
    window.pointer(middle, None);
    window.pointer(middle, Some(true));
    window.pointer(first, None);
    window.pointer(first, Some(false));
    printed(&mut window, "[[0.0, 0.0], [0.01, 0.0], [8.0, 30.0]]");
    window.keys(Modifiers::NONE, Key::Delete);
    printed(&mut window, "[[0.0, 0.0], [8.0, 30.0]]");
    // A double click on the ground, and a right click on a point.
    let [first, last] =
        ["Over day point 1", "Over day point 2"].map(|name| window.node(Role::Slider, name).rect().center());
    let middle = first.lerp(last, 0.5);
    window.pointer(middle, None);
    window.clicks(middle, PointerButton::Primary, 2);
    assert!(window.harness.query_by_role_and_label(Role::Slider, "Over day point 3").is_some(), "another point");
    printed(&mut window, "[8.0, 30.0]]");
    window.clicks(middle, PointerButton::Secondary, 1);
    printed(&mut window, "[[0.0, 0.0], [8.0, 30.0]]");
    window.node(Role::Slider, "Over day point 1").focus();
    window.settle();
    for _ in 0..2 {
        window.keys(Modifiers::NONE, Key::Delete);
    }
    assert!(window.harness.query_by_role_and_label(Role::Slider, "Over day point 1").is_some(), "one is left");
    window.press("Reset Over day");
    printed(&mut window, "[[0.0, 0.0], [10.0, 20.0]]");
    // While it is typed, spaces at its end stay.
    window.node(Role::MultilineTextInput, "Report").focus();
    window.settle();
    for typed in ["EDDF 171220Z 24012KT ", "9999 F"] {
        window.harness.event(Event::Text(typed.into()));
        window.settle();
    }
    assert!(window.shows("column 27: “F” can't be read"));
    window.harness.event(Event::Text("EW040".into()));
    printed(&mut window, "EDDF 171220Z 24012KT 9999 FEW040 at 5");
    assert!(!window.shows("can't be read"));
}

impl Window {
    /// Clicks there, within one frame.
    fn clicks(&mut self, pos: Pos2, button: PointerButton, count: usize) {
        for pressed in [true, false].repeat(count) {
            let event = Event::PointerButton { pos, button, pressed, modifiers: Modifiers::NONE };
            self.harness.input_mut().events.push(event);
        }
        self.settle();
    }
}
