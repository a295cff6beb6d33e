//! Layouts of the panels are kept by name; one that is not understood leaves the usual one, and a word.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::storage::{Folders, Settings};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use serde_json::{Value, json};

impl Window {
    fn has_tab(&self, name: &str) -> bool {
        self.shows(&format!("Help on {name}"))
    }

    fn below_the_picture(&self) -> bool {
        let [picture, keys] = ["Viewport", "Help on Timeline"].map(|label| self.harness.query_by_label(label));
        matches!((picture, keys), (Some(picture), Some(keys)) if keys.rect().top() > picture.rect().bottom())
    }

    fn save_layout(&mut self, name: &str) {
        self.command(Command::SaveLayout);
        self.type_into(Role::TextInput, "Name", name);
        self.press("Keep layout");
    }
}

#[test]
fn a_layout_is_saved_chosen_and_deleted() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = Folders::within(home.path());
    let mut window = Window::open_with(Some(folders.clone()));
    window.settle();
    window.command(Command::Layouts);
    assert!(!window.shows("Use layout"), "there is none yet");
    window.command(Command::TimelinePanel);
    assert!(window.below_the_picture());
    window.save_layout("animating");
    assert!(window.shows("kept as “animating”"));
    window.command(Command::ResetLayout);
    assert!(!window.below_the_picture());
    window.command(Command::Layouts);
    window.press("Use layout animating");
    assert!(window.below_the_picture());
    drop(window);
    let mut window = Window::open_with(Some(folders.clone()));
    window.command(Command::ResetLayout);
    window.press("Window");
    window.press("Layouts…");
    window.press("Use layout animating");
    assert!(window.below_the_picture(), "after another start");
    window.command(Command::Layouts);
    window.press("Delete layout animating");
    window.press("Done");
    window.command(Command::Layouts);
    assert!(!window.shows("Use layout"));
    assert!(Settings::load(&folders).0.layouts.is_empty());
}

#[test]
fn what_is_not_understood_leaves_the_usual_layout() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = Folders::within(home.path());
    let mut window = Window::open_with(Some(folders.clone()));
    window.command(Command::TimelinePanel);
    window.save_layout("good");
    drop(window);
    let good = Settings::load(&folders).0.layouts["good"].clone();
    let later: Value = serde_json::from_str(&good.to_string().replace("\"viewport\"", "\"hologram\"")).expect("JSON");
    // A container that is within itself.
    let mut round = good;
    let root = round["root"].clone();
    for tile in round["tiles"]["tiles"].as_object_mut().expect("tiles").values_mut() {
        if let Some(children) = tile.pointer_mut("/Container/Tabs/children").and_then(Value::as_array_mut) {
            children.push(root.clone());
        }
    }
    for bad in [later, round, json!({"root": 7}), json!("half of a lay"), json!(null)] {
        let kept = bad.clone();
        Settings::change(&folders, |settings| {
            settings.layout = Some(kept.clone());
            settings.layouts.insert("bad".into(), kept);
        })
        .expect("writable");
        let mut window = Window::open_with(Some(folders.clone()));
        window.settle();
        if !bad.is_null() {
            assert!(window.shows("The layout of the last time is not understood"), "{bad}");
        }
        assert!(window.has_tab("Inspector") && !window.below_the_picture(), "{bad}");
        window.command(Command::TimelinePanel);
        window.command(Command::Layouts);
        window.press("Use layout bad");
        assert!(window.shows("The layout “bad” is not understood"), "{bad}");
        assert!(!window.below_the_picture());
    }
}
