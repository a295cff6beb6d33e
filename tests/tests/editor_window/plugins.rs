//! Plugins from their menu: a dialog from what they say of themselves, shown as they would be, one undo point or nothing.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::editor::{Ask, Reply};
use cloudwright::storage::Folders;
use cloudwright_core::scene::Scene;
use cloudwright_scripts::shipped::{self, SHIPPED};
use cloudwright_scripts::{Patience, Plugin, PluginKind};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// A user with plugins of his own.
pub(crate) struct Home {
    folder: tempfile::TempDir,
}

impl Home {
    pub(crate) fn with(files: &[(&str, &str)]) -> Self {
        let home = Self { folder: tempfile::tempdir().expect("a folder") };
        std::fs::create_dir_all(home.folders().plugins()).expect("writable");
        files.iter().for_each(|(name, text)| home.put(name, text));
        home
    }

    fn folders(&self) -> Folders {
        Folders::within(self.folder.path())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folders().plugins().join(name)
    }

    fn put(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).expect("writable");
    }

    pub(crate) fn open(&self) -> Window {
        let mut window = Window::open_with(Some(self.folders()));
        window.settle();
        window
    }
}

/// An edit of the hour, with a parameter of each kind.
const MINE: &str = r#"const PLUGIN = #{ name: "Mine", kind: "edit", sentence: "Sets the hour.", parameters: [
    #{ name: "hour_h", label: "Hour", kind: "number", unit: "h", min: 0, max: 23, soft_min: 6, soft_max: 18, initial: 9, help: "Which." },
    #{ name: "high_m", label: "High", kind: "number", unit: "m", min: 0, max: 20000, initial: 3048 },
    #{ name: "often", label: "Often", kind: "integer", min: 1, max: 9, initial: 2 },
    #{ name: "more", label: "More", kind: "flag" },
    #{ name: "word", label: "Word", kind: "text", initial: "as is", shown_if: #{ more: true } },
    #{ name: "way", label: "Way", kind: "choice", choices: ["at_once", "slowly"] },
    #{ name: "tint", label: "Tint", kind: "color", initial: [1, 0.5, 0] },
    #{ name: "seed", label: "Seed", kind: "seed" },
    #{ name: "cloud", label: "Cloud", kind: "cloud" },
    #{ name: "model", label: "Model", kind: "model" },
] };
fn run(parameters) {
    set("time_of_day_h", parameters.hour_h);
    print(`${parameters.high_m} ${parameters.often} ${parameters.more} ${parameters.word} ${parameters.way} ${parameters.seed} ${parameters.cloud} ${parameters.model}`);
}
"#;

fn description(name: &str) -> Plugin {
    Plugin::read(shipped::named(name).expect("it ships").source).expect("a plugin")
}

fn menu(kind: PluginKind) -> &'static str {
    match kind {
        PluginKind::Generator => "Generators",
        PluginKind::Edit => "Edits",
        PluginKind::Look => "Looks",
        PluginKind::Weather => "Weather",
        PluginKind::Exporter => "Exporters",
    }
}

impl Window {
    /// Opens the menu of plugins at a submenu. Both may still be without what was just read.
    fn open_plugins(&mut self, submenu: &str) {
        self.open_plugins_with(submenu, None);
    }

    fn open_plugins_with(&mut self, submenu: &str, entry: Option<&str>) {
        self.wait("the plugins", |window| window.harness.query_by_label("Plugins").is_some());
        for _ in 0..2_000 {
            self.press("Plugins");
            if self.offers(submenu) {
                self.press(submenu);
                if entry.is_none_or(|entry| self.offers(entry)) {
                    return;
                }
            }
            self.press("Plugins");
            std::thread::sleep(Duration::from_millis(5));
        }
        panic!("there is no {} in {submenu}", entry.unwrap_or("submenu"));
    }

    fn offers(&self, button: &str) -> bool {
        self.harness.query_by_role_and_label(Role::Button, button).is_some()
    }

    pub(crate) fn ask_plugin(&mut self, kind: PluginKind, name: &str) {
        self.open_plugins_with(menu(kind), Some(name));
        self.press(name);
    }

    /// Frames until the user's folder was looked at again, which happens at once when the window gets the focus.
    pub(crate) fn look_again(&mut self) {
        for focused in [false, true] {
            self.harness.input_mut().focused = focused;
            self.harness.event(Event::WindowFocused(focused));
            self.harness.step();
        }
    }

    fn value_of(&self, role: Role, label: &str) -> String {
        self.node(role, label).value().unwrap_or_default()
    }
}

#[test]
fn the_menu_has_all_that_ship_by_their_names() {
    let mut window = Window::open();
    window.settle();
    for kind in PluginKind::ALL {
        let plugins = SHIPPED.iter().map(|shipped| description(shipped.name).description);
        let names: Vec<String> = plugins.filter(|plugin| plugin.kind == *kind).map(|plugin| plugin.name).collect();
        if names.is_empty() {
            continue;
        }
        window.open_plugins(menu(*kind));
        for name in names {
            window.node(Role::Button, &name);
        }
        window.keys(Modifiers::NONE, Key::Escape);
    }
    window.keys(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
    let field = window.node(Role::TextInput, "Find a command");
    field.type_text("scatter");
    window.settle();
    window.node(Role::Button, "Generators: Scatter clouds…").click();
    window.settle();
    assert!(window.shows("Strews a cloud model"), "from the palette too");
}

/// Each by its labels from its menu, on a scene with clouds and a path, all clouds selected; and taken back in one step.
#[test]
#[ignore = "minutes: each is a process of a debug build, and a large scene"]
fn each_that_ships_runs_from_its_menu_and_is_taken_back() {
    let mut window = Window::open();
    window.answer(Reply::Path(cloudwright_tests::scene_path("fair_weather")));
    window.command(Command::Open);
    window.settle();
    let start = window.file();
    for shipped in SHIPPED {
        let plugin = description(shipped.name).description;
        if plugin.kind == PluginKind::Exporter {
            continue;
        }
        window.command(Command::SelectAll);
        window.ask_plugin(plugin.kind, &plugin.name);
        window.press("OK");
        window.wait(&plugin.name, |window| window.undo_name().as_deref() == Some(&plugin.name));
        assert_ne!(window.file(), start, "{}", plugin.name);
        window.command(Command::Undo);
        assert_eq!((window.file(), window.undo_name()), (start.clone(), None), "{}", plugin.name);
    }
}

#[test]
fn what_is_shown_becomes_one_undo_point() {
    let mut window = Window::open();
    window.settle();
    let (start, clouds) = (window.file(), window.scene().clouds.len());
    window.ask_plugin(PluginKind::Generator, "Scatter clouds");
    window.set("Count", 5.0);
    window.wait("a preview", |window| window.scene().clouds.len() == clouds + 5);
    assert_eq!(window.undo_name(), None, "it is only shown");
    window.set("Count", 7.0);
    window.wait("the next preview", |window| window.scene().clouds.len() == clouds + 7);
    window.press("OK");
    assert_eq!((window.undo_name().as_deref(), window.scene().clouds.len()), (Some("Scatter clouds"), clouds + 7));
    assert_eq!(window.harness.state().selection().clouds().count(), 7, "what was made is selected");
    let made = window.file();
    window.command(Command::Undo);
    assert_eq!((window.file(), window.undo_name()), (start, None));
    window.command(Command::Redo);
    assert_eq!(window.file(), made);
    // What was chosen is remembered.
    window.command(Command::RunAgain);
    assert_eq!(window.value_of(Role::SpinButton, "Count"), "7");
    window.press("Reset Count");
    assert_eq!(window.value_of(Role::SpinButton, "Count"), "24");
}

#[test]
fn the_same_scene_as_a_run_without_a_window() {
    let mut window = Window::open();
    window.settle();
    let scene: Scene = window.scene().clone();
    window.ask_plugin(PluginKind::Generator, "Scatter clouds");
    window.press("Re-roll Seed");
    let seed = window.value_of(Role::SpinButton, "Seed");
    window.press("OK");
    window.wait("it is done", |window| window.undo_name().is_some());
    let plugin = description("scatter_clouds");
    let mut values = plugin.values();
    values.set(&plugin.description.parameters, "seed", &seed).expect("a seed");
    let mut document = cloudwright_core::document::Document::new(scene.clone());
    let outcome = plugin.run(&scene, &values, &Patience::usual()).expect("it runs");
    outcome.apply(&plugin, &mut document).expect("it fits");
    assert_eq!(window.scene(), document.scene());
}

#[test]
fn cancel_and_escape_leave_nothing() {
    let mut window = Window::open();
    window.settle();
    let (start, selection) = (window.file(), window.harness.state().selection().clone());
    for by_key in [false, true] {
        window.ask_plugin(PluginKind::Generator, "Scatter clouds");
        window.wait("a preview", |window| window.session().document().is_open());
        if by_key {
            window.keys(Modifiers::NONE, Key::Escape);
        } else {
            window.press("Cancel");
        }
        assert!(!window.shows("Strews a cloud model"));
        assert_eq!((window.file(), window.undo_name()), (start.clone(), None));
        assert_eq!(window.harness.state().selection(), &selection);
    }
    // In a field, Esc ends the typing.
    window.ask_plugin(PluginKind::Generator, "Scatter clouds");
    window.node(Role::SpinButton, "Count").focus();
    window.settle();
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(window.shows("Strews a cloud model"));
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(!window.shows("Strews a cloud model"));
}

#[test]
fn every_kind_of_parameter_has_a_field() {
    let home = Home::with(&[("mine.rhai", MINE)]);
    let mut window = home.open();
    window.ask_plugin(PluginKind::Edit, "Mine");
    window.wait("a preview", |window| window.shows("3048.0 2 false as is at_once 1 0 0"));
    assert!(window.harness.query_by_label("Word").is_none(), "it is shown only if More is on");
    window.node(Role::CheckBox, "More").click();
    window.settle();
    window.node(Role::TextInput, "Word").focus();
    window.settle();
    window.keys(Modifiers::COMMAND, Key::A);
    window.node(Role::TextInput, "Word").type_text("other");
    window.keys(Modifiers::NONE, Key::Enter);
    window.set("High", 100.0);
    window.set("Often", 9.0);
    window.set("Tint brightness", 2.0);
    window.set("Hour", 30.0);
    assert!(window.shows("30 is outside 0 to 23 h"), "beyond the hard range");
    window.set("Hour", 20.0);
    window.press("Re-roll Seed");
    let seed = window.value_of(Role::SpinButton, "Seed");
    let [cloud, model] = [window.scene().clouds[0].name.clone(), window.scene().models[0].name.clone()];
    for (list, choice) in [("Way", "slowly"), ("Cloud", &cloud), ("Model", &model)] {
        window.node(Role::ComboBox, list).click();
        window.settle();
        window.harness.get_all_by_label(choice).last().expect("a choice").click();
        window.settle();
    }
    let ids = (window.scene().clouds[0].id.0, window.scene().models[0].id.0);
    let printed = format!("100.0 9 true other slowly {seed} {} {}", ids.0, ids.1);
    window.wait(&printed, |window| window.shows(&printed));
    window.press("OK");
    assert_eq!(window.scene().time_of_day_h, 20.0, "beyond the soft range");
    // In feet, the metres stay what they were.
    window.command(Command::SwitchUnits);
    window.command(Command::RunAgain);
    assert_eq!(window.value_of(Role::SpinButton, "High"), "328.1 ft");
    window.wait("a run", |window| window.shows("100.0 9"));
    window.set("High", 10_000.0);
    window.wait("the feet in metres", |window| window.shows("3048.0 9"));
    for label in ["Tint", "Word"] {
        window.press(&format!("Reset {label}"));
    }
    window.wait("what it began with", |window| window.shows("3048.0 9 true as is"));
}

#[test]
fn the_last_run_can_be_had_with_other_values() {
    let mut window = Window::open();
    window.settle();
    let (start, clouds) = (window.file(), window.scene().clouds.len());
    window.ask_plugin(PluginKind::Generator, "Scatter clouds");
    window.set("Count", 3.0);
    window.press("OK");
    window.wait("it is done", |window| window.undo_name().is_some());
    window.settle();
    window.node(Role::Window, "Last run: Scatter clouds");
    window.press("Show");
    window.set("Count", 6.0);
    window.wait("the other run", |window| window.scene().clouds.len() == clouds + 6);
    assert_eq!(window.session().document().history().done_count(), 1, "in the place of the first");
    window.command(Command::Undo);
    assert_eq!((window.file(), window.undo_name()), (start, None));
    assert!(!window.shows("Last run"), "undone, there is nothing to change");
    window.command(Command::Redo);
    assert!(window.shows("Last run"));
    window.press("Add camera");
    assert!(!window.shows("Last run"), "something else was changed since");
}

#[test]
fn a_broken_one_is_listed_with_what_is_wrong() {
    let home = Home::with(&[
        ("broken.rhai", "const PLUGIN = #{ kind: \"edit\", sentence: \"B.\",\n  name: 7 };"),
        ("scatter.rhai", shipped::named("scatter_clouds").expect("it ships").source),
    ]);
    let mut window = home.open();
    window.open_plugins("Can't be read");
    let wrong = "line 2, column 9: name is a whole number, where a text";
    assert!(window.shows(wrong));
    window.press("broken.rhai");
    assert!(window.shows("error at line 2, column 9"));
    window.press("OK");
    // Two of one name are told apart by where they are from.
    window.open_plugins("Generators");
    window.node(Role::Button, "Scatter clouds (shipped)");
    window.press("Scatter clouds (scatter.rhai)");
    assert!(window.shows(&home.path("scatter.rhai").display().to_string()));
}

#[test]
fn files_that_come_change_and_go_are_noticed() {
    let home = Home::with(&[]);
    let mut window = home.open();
    home.put("mine.rhai", MINE);
    window.look_again();
    window.ask_plugin(PluginKind::Edit, "Mine");
    window.set("Hour", 11.0);
    home.put("mine.rhai", &MINE.replace("label: \"Often\"", "label: \"How often\""));
    window.look_again();
    window.wait("the change", |window| window.shows("was read again"));
    window.harness.step();
    window.node(Role::SpinButton, "How often");
    assert_eq!(window.value_of(Role::SpinButton, "Hour"), "11.00 h", "what was chosen stays");
    home.put("mine.rhai", "const PLUGIN = 7;");
    window.look_again();
    window.wait("the fault", |window| window.shows("can't be read: line 1, column 16"));
    std::fs::remove_file(home.path("mine.rhai")).expect("there");
    window.look_again();
    window.wait("that it is gone", |window| window.shows("Its file is gone"));
    window.set("Hour", 14.0);
    window.press("OK");
    window.wait("it is done", |window| window.undo_name().as_deref() == Some("Mine"));
    assert_eq!(window.scene().time_of_day_h, 14.0);
    assert!(!window.harness.state().can(Command::RunAgain), "it is gone");
}

#[test]
fn a_script_without_end_is_not_waited_for() {
    let endless = MINE.replace("fn run(parameters) {", "fn run(parameters) { if parameters.often == 5 { loop { } }");
    let home = Home::with(&[("mine.rhai", &endless)]);
    let mut window = home.open();
    let start = window.file();
    window.ask_plugin(PluginKind::Edit, "Mine");
    window.wait("a preview", |window| window.session().document().is_open());
    window.set("Often", 5.0);
    let begun = Instant::now();
    let mut frames = 0;
    while begun.elapsed() < Duration::from_millis(500) {
        window.harness.step();
        frames += 1;
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(frames > 3 && window.shows("running…"), "{frames} frames went on");
    // Other values don't wait for it.
    window.set("Often", 6.0);
    window.wait("the next run", |window| window.shows("3048.0 6"));
    assert!(begun.elapsed() < Patience::USUAL + Duration::from_millis(500), "it was stopped");
    window.set("Often", 5.0);
    window.wait("its end", Window::shows_an_end);
    assert!(window.shows("line "), "with its place");
    assert!(!window.session().document().is_open(), "and nothing is shown of it");
    window.node(Role::Button, "OK").click();
    window.settle();
    assert_eq!((window.file(), window.undo_name()), (start, None));
    window.press("Cancel");
}

#[test]
fn exporters_write_the_file_that_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let [scene, table] = ["sky.cloudscene", "sky.xyz"].map(|name| folder.path().join(name));
    let mut window = Window::open();
    window.settle();
    window.answer(Reply::Path(scene.clone()));
    window.press("Save");
    let saved = std::fs::read(&scene).expect("it was saved");
    for name in [&scene, &folder.path().join("other.cloudscene"), &folder.path().join("none/sky.xyz")] {
        window.ask_plugin(PluginKind::Exporter, "Sprite table");
        window.answer(Reply::Path(name.clone()));
        window.press("Export…");
        window.wait("a refusal", |window| window.shows("Nothing was exported"));
        window.press("OK");
        assert_eq!(std::fs::read(&scene).expect("still there"), saved);
    }
    window.ask_plugin(PluginKind::Exporter, "Sprite table");
    window.node(Role::CheckBox, "Line of heads").click();
    window.answer(Reply::Cancelled);
    window.press("Export…");
    window.wait("the question", |window| window.script.asked.borrow().len() == 5);
    assert_eq!(window.script.asked.borrow()[4], Ask::Export(table.clone()), "with the exporter's own ending");
    assert!(window.shows("Export…"), "not to name a file leaves the dialog");
    window.answer(Reply::Path(table.clone()));
    window.press("Export…");
    window.wait("the file", |_| table.exists());
    window.settle();
    assert!(window.shows("Exported") && !window.shows("Export…"));
    let text = std::fs::read_to_string(&table).expect("text");
    assert!(text.starts_with("x y z width height"), "{text}");
    assert_eq!(text.lines().count(), window.sprites() + 1);
    assert_eq!(window.undo_name().as_deref(), Some("Name by its file"), "saved before; exporting is no change");
}
