//! Plugins written in the window: templates, examples, faults while typing, runs on the open scene, files.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::editor::Reply;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, ViewportCommand, ViewportEvent, ViewportId};

impl Window {
    fn with_script_panel() -> Self {
        let mut window = Self::open();
        window.settle();
        window.command(Command::ScriptPanel);
        window
    }

    /// From a menu of the panel.
    fn choose_script(&mut self, menu: &str, choice: &str) {
        self.press(menu);
        self.press(choice);
    }

    fn script(&self) -> String {
        self.node(Role::MultilineTextInput, "Script").value().unwrap_or_default()
    }

    /// At the end of the script.
    fn type_in_script(&mut self, text: &str) {
        self.node(Role::MultilineTextInput, "Script").focus();
        self.settle();
        self.harness.key_press_modifiers(Modifiers::COMMAND, Key::End);
        self.harness.step();
        self.node(Role::MultilineTextInput, "Script").type_text(text);
        self.settle();
    }
}

#[test]
fn templates_run_on_the_open_scene() {
    let mut window = Window::with_script_panel();
    let start = window.file();
    for (kind, name) in [("Generator", "New generator"), ("Look", "New look"), ("Weather", "New weather")] {
        window.choose_script("New plugin", kind);
        assert!(window.script().contains(&format!("name: \"{name}\"")));
        window.press("Run the script");
        window.wait(name, |window| window.undo_name().as_deref() == Some(name));
        window.settle();
        assert!(window.shows(" edit"), "it says what it did");
        window.command(Command::Undo);
        assert_eq!((window.file(), window.undo_name()), (start.clone(), None));
    }
    window.choose_script("New plugin", "Exporter");
    window.press("Run the script");
    window.wait("the text", |window| window.shows("and 50 more"));
    assert_eq!(window.undo_name(), None);
}

#[test]
fn faults_are_told_while_typing_and_after_a_run() {
    let mut window = Window::with_script_panel();
    window.choose_script("New plugin", "Look");
    window.type_in_script("fn");
    window.wait("the fault", |window| window.shows("line 14, column 3"));
    window.press("Run the script");
    assert_eq!(window.undo_name(), None);
    window.type_in_script(" more() { loop { } }\nfn other() { more(); }");
    window.wait("no fault", |window| !window.shows("line 14, column 3"));
    // Ctrl+Enter runs it from within the text.
    window.keys(Modifiers::COMMAND, Key::Enter);
    window.wait("the run", |window| window.undo_name().as_deref() == Some("New look"));
    window.choose_script("New plugin", "Weather");
    window.press("Don't save");
    window.type_in_script("const LOOP = { loop { } };");
    window.press("Run the script");
    window.wait("the end of a loop without end", Window::shows_an_end);
    assert_eq!(window.undo_name().as_deref(), Some("New look"), "and nothing came of it");
}

#[test]
fn examples_are_read_and_copied() {
    let mut window = Window::with_script_panel();
    window.choose_script("Open a script", "golden_hour");
    let example = window.script();
    assert!(example.contains("Golden hour"));
    window.type_in_script("// mine");
    assert_eq!(window.script(), example, "it can only be read");
    window.press("Copy the example");
    window.type_in_script("// mine");
    assert!(window.script().ends_with("// mine"));
}

#[test]
fn what_is_written_is_saved_reloaded_and_asked_about() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("plugins/mine.rhai");
    let mut window = Window::with_script_panel();
    window.choose_script("New plugin", "Look");
    window.type_in_script("// mine");
    let text = window.script();
    window.answer(Reply::Path(path.with_extension("")));
    window.press("Save the script");
    assert_eq!(std::fs::read_to_string(&path).expect("it is saved"), text);
    // Another program's change is taken over, or asked about.
    std::fs::write(&path, format!("{text} and theirs")).expect("writable");
    window.look_again();
    window.wait("theirs", |window| window.script().ends_with("and theirs"));
    window.type_in_script(" and mine");
    std::fs::write(&path, "// theirs").expect("writable");
    window.look_again();
    window.wait("the notice", |window| window.shows("Another program has changed the file"));
    assert!(window.script().ends_with("and mine"));
    // What is nowhere else is asked about.
    window.choose_script("New plugin", "Exporter");
    window.press("Cancel");
    assert!(window.script().ends_with("and mine"));
    let close = |window: &mut Window| {
        let viewport = window.harness.input_mut().viewports.entry(ViewportId::ROOT).or_default();
        viewport.events.push(ViewportEvent::Close);
        window.harness.step();
    };
    close(&mut window);
    let commands = &window.harness.output().viewport_output[&ViewportId::ROOT].commands;
    assert!(commands.contains(&ViewportCommand::CancelClose), "{commands:?}");
    window.settle();
    window.press("Don't save");
    assert_eq!(std::fs::read_to_string(&path).expect("there"), "// theirs");
}

#[test]
fn words_are_found() {
    let mut window = Window::with_script_panel();
    window.choose_script("New plugin", "Generator");
    let field = window.node(Role::TextInput, "Find in the script");
    field.focus();
    window.settle();
    window.node(Role::TextInput, "Find in the script").type_text("add_cloud");
    window.settle();
    assert!(window.shows("2 places"));
    window.harness.event(Event::Key {
        key: Key::Enter,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    });
    window.settle();
    // The first place is chosen: what is typed takes its place.
    window.node(Role::MultilineTextInput, "Script").type_text("ADD");
    window.settle();
    assert!(window.script().contains("`add_model` and `ADD` give"), "{}", window.script());
}

/// README's walk-through ends with a plugin that runs, and can be taken back in one step.
#[test]
fn the_readmes_plugin_runs_word_for_word() {
    let readme = std::fs::read_to_string(cloudwright_tests::root().join("README.md")).expect("it is there");
    let (_, rest) = readme.split_once("```rhai\n").expect("it shows a plugin");
    let (plugin, _) = rest.split_once("```").expect("the plugin ends");
    let mut window = Window::with_script_panel();
    let (start, clouds) = (window.file(), window.scene().clouds.len());
    window.choose_script("New plugin", "Generator");
    window.node(Role::MultilineTextInput, "Script").focus();
    window.settle();
    window.keys(Modifiers::COMMAND, Key::Enter);
    window.wait("the template's run", |window| window.undo_name().as_deref() == Some("New generator"));
    window.command(Command::Undo);
    window.node(Role::MultilineTextInput, "Script").focus();
    window.settle();
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Paste(plugin.into()));
    window.settle();
    assert_eq!(window.script(), plugin);
    window.keys(Modifiers::COMMAND, Key::Enter);
    window.wait("the run", |window| window.undo_name().as_deref() == Some("Ring of clouds"));
    assert_eq!(window.scene().clouds.len(), clouds + 12, "with its own values, not the template's");
    window.command(Command::Undo);
    assert_eq!((window.file(), window.undo_name()), (start, None));
}
