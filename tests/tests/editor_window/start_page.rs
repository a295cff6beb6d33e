//! The start page: what was open, skies to begin with, left at once; and the tour.

use crate::{Script, Window, start};
use cloudwright::command::Command;
use cloudwright::editor::{Editor, Start};
use cloudwright::storage::{Folders, Settings};
use cloudwright_tests::root;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use std::path::Path;

impl Window {
    /// As a user without a scene sees it.
    fn at_the_start(folders: Option<Folders>) -> Self {
        let script = Script::default();
        let start = Start { start_page: true, ..start(script.clone(), folders) };
        let harness = Harness::builder()
            .with_size([1280.0, 900.0])
            .build_eframe(move |creation| Editor::new(&creation.egui_ctx, start));
        let mut window = Self { harness, script };
        window.settle();
        window
    }

    fn shows_start_page(&self) -> bool {
        self.shows("Begin with")
    }
}

#[test]
fn it_is_left_at_once_and_comes_again() {
    let mut window = Window::at_the_start(None);
    assert!(window.shows_start_page());
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(!window.shows_start_page());
    window.press("Window");
    window.press("Start page");
    assert!(window.shows_start_page());
    window.press("To the editor");
    assert!(!window.shows_start_page());
}

#[test]
fn a_sky_to_begin_with_is_a_scene_without_a_file() {
    for (label, clouds) in
        [("Clear sky", 0..1), ("Fair weather", 20..40), ("Overcast", 1..2000), ("Storm at dusk", 1..200)]
    {
        let mut window = Window::at_the_start(None);
        window.press(label);
        window.settle();
        assert!(clouds.contains(&window.scene().clouds.len()), "{label}: {}", window.scene().clouds.len());
        assert_eq!((window.session().path(), window.session().document().is_modified()), (None, false));
        assert!(!window.shows_start_page());
        window.command(Command::AddCamera);
        window.command(Command::StartPage);
        window.press("Clear sky");
        assert!(window.shows("Save the changes?"), "what was changed is not lost");
    }
    let mut window = Window::at_the_start(None);
    window.press("Weather from a report");
    assert!(window.harness.query_by_role_and_label(Role::MultilineTextInput, "Reports").is_some());
}

#[test]
fn new_in_the_file_menu_begins_with_a_clear_sky_or_another() {
    let mut window = Window::open();
    window.settle();
    window.press("File");
    window.press("New…");
    let top = |label| window.node(Role::Button, label).rect().left_top();
    for later in ["One small cloud", "Fair weather", "A front passes"] {
        let (first, later) = (top("Clear sky"), top(later));
        assert!((first.y, first.x) < (later.y, later.x), "{first} and {later}");
    }
    window.keys(Modifiers::NONE, Key::Enter);
    assert!(window.scene().clouds.is_empty() && window.scene().models.is_empty(), "the first has the focus");
    assert!(!window.shows("New scene") && !window.session().document().is_modified());
    window.keys(Modifiers::COMMAND, Key::N);
    window.press("Storm at dusk");
    assert!(!window.scene().clouds.is_empty());
    let scene = window.scene().clone();
    window.keys(Modifiers::COMMAND, Key::N);
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(!window.shows("New scene") && window.scene() == &scene);
}

#[test]
fn recent_scenes_are_there_with_pictures_and_open() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = Folders::within(home.path());
    let kept = home.path().join("kept sky.cloudscene");
    std::fs::copy(root().join("assets/scenes/overcast.cloudscene"), &kept).expect("copied");
    let broken = home.path().join("broken.cloudscene");
    std::fs::write(&broken, "{ half of a sc").expect("writable");
    Settings::change(&folders, |settings| {
        settings.remember_scene(&broken);
        settings.remember_scene(Path::new("/gone.cloudscene"));
        settings.remember_scene(&kept);
    })
    .expect("writable");
    let mut window = Window::at_the_start(Some(folders));
    window.wait("recent scenes", |window| window.shows("kept sky"));
    assert!(window.shows("broken") && !window.shows("gone"));
    window.press("kept sky");
    assert_eq!(window.session().path(), Some(kept.as_path()));
    window.command(Command::StartPage);
    window.wait("recent scenes", |window| window.shows("broken"));
    window.press("broken");
    assert!(window.shows("Problems in"));
    window.press("OK");
    assert_eq!(window.session().path(), Some(kept.as_path()), "nothing else has changed");
}

#[test]
fn who_does_not_want_it_is_not_asked_again() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = Folders::within(home.path());
    let mut window = Window::at_the_start(Some(folders.clone()));
    window.node(Role::CheckBox, "Show this at the start").click();
    window.settle();
    assert!(window.shows_start_page(), "it stays for now");
    assert!(!Settings::load(&folders).0.start_page);
}

#[test]
fn the_tour_has_seven_steps_and_is_left_at_any() {
    for leave_at in 1..=7 {
        let mut window = Window::at_the_start(None);
        window.press("Take the tour");
        for step in 1..leave_at {
            assert!(window.shows(&format!("{step} of 7")));
            window.press("Next");
        }
        assert!(window.shows(&format!("{leave_at} of 7")));
        if leave_at == 2 {
            window.press("Back");
            assert!(window.shows("1 of 7"));
        }
        match leave_at {
            7 => window.press("Done"),
            3 => window.keys(Modifiers::NONE, Key::Escape),
            _ => window.press("Leave the tour"),
        }
        assert!(!window.shows(" of 7"));
    }
    let mut window = Window::open();
    window.command(Command::Tour);
    window.press("Next");
    window.press("Add camera");
    assert!(window.shows("2 of 7"), "the editor is used meanwhile");
    assert_eq!(window.scene().cameras.len(), 2);
}
