//! One dialog has all that a user prefers, and what it sets is what commands set.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::renderer::RendererChoice;
use cloudwright::storage::{Folders, Settings, ThemeChoice};
use cloudwright::units::Units;
use egui::accesskit::Role;
use egui::{Key, Modifiers};

#[test]
fn each_preference_holds_at_once_and_at_the_next_start() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = Folders::within(home.path());
    let mut window = Window::open_with(Some(folders.clone()));
    window.settle();
    window.keys(Modifiers::COMMAND, Key::Comma);
    window.choose("Look", "Light");
    assert!(!window.harness.ctx.global_style().visuals.dark_mode);
    window.choose("Units", "Feet and knots, as in aviation");
    window.choose("Keys", "Blender's, where it has the command");
    window.choose("Unsaved work is kept", "Every 30 s");
    window.choose("Memory for undo", "64 MB");
    window.choose("Drawn by", "The CPU");
    window.node(Role::CheckBox, "Show the start page at the start").click();
    window.settle();
    window.choose("Size of the interface", "125 %");
    assert_eq!(window.harness.ctx.zoom_factor(), 1.25);
    window.press("Done");
    let (settings, notice) = Settings::load(&folders);
    assert_eq!(notice, None);
    assert_eq!(
        (settings.theme, settings.units, settings.renderer),
        (ThemeChoice::Light, Units::Aviation, RendererChoice::Cpu)
    );
    assert_eq!((settings.scale(), settings.keep_work_every_s(), settings.start_page), (1.25, 30, false));
    assert_eq!(settings.undo_mb, 64);
    window.command(Command::SwitchUnits);
    assert_eq!(Settings::load(&folders).0.units, Units::Metric, "the command sets the same");
    drop(window);
    let mut window = Window::open_with(Some(folders));
    window.settle();
    assert_eq!(window.harness.ctx.zoom_factor(), 1.25);
    window.command(Command::Preferences);
    assert!(window.node(Role::ComboBox, "Drawn by").value().is_some_and(|value| value == "The CPU"));
}

#[test]
fn values_from_elsewhere_are_brought_within_what_can_be() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = Folders::within(home.path());
    std::fs::create_dir_all(&folders.config).expect("writable");
    for (text, scale, seconds) in [
        ("{\"scale\": 1e30, \"keep_work_every_s\": 4000000000}", 3.0, 600),
        ("{\"scale\": -1.0, \"folded\": [\"no such part\"]}", 0.5, 0),
        ("{\"scale\": 1.0, \"from_the_future\": {}}", 1.0, 0),
        ("{\"scale\": 1.0, \"theme\": \"da", 1.0, 0),
    ] {
        std::fs::write(folders.config.join("settings.json"), text).expect("writable");
        let settings = Settings::load(&folders).0;
        assert_eq!((settings.scale(), settings.keep_work_every_s()), (scale, seconds), "{text}");
        let mut window = Window::open_with(Some(folders.clone()));
        window.settle();
        assert_eq!(window.shows("the settings start anew"), text.ends_with("da"), "{text}");
    }
}
