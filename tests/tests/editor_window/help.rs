//! What there is to read in the window itself, and what is told of a problem.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::editor::{Ask, Reply};
use egui::accesskit::Role;

#[test]
fn about_tells_version_and_renderer() {
    let mut window = Window::open();
    window.settle();
    window.press("Help");
    window.press("About Cloudwright");
    for words in [env!("CARGO_PKG_VERSION"), "CPU", std::env::consts::ARCH] {
        assert!(window.shows(words), "{words}");
    }
    window.press("OK");
    assert!(!window.shows("Drawn by"));
}

#[test]
fn a_report_holds_what_is_needed_and_the_scene_only_if_asked() {
    let home = tempfile::tempdir().expect("a folder");
    for with_scene in [false, true] {
        let path = home.path().join(format!("report-{with_scene}"));
        let mut window = Window::open();
        window.settle();
        window.press("Add camera");
        window.command(Command::ReportProblem);
        window.type_into(Role::MultilineTextInput, "What happened", "It rained.");
        if with_scene {
            window.node(Role::CheckBox, "With the scene").click();
            window.settle();
        }
        window.answer(Reply::Path(path.clone()));
        window.press("Save…");
        assert!(matches!(window.script.asked.borrow().last(), Some(Ask::Report(_))));
        let text = std::fs::read_to_string(path.with_extension("txt")).expect("written");
        for words in ["It rained.", env!("CARGO_PKG_VERSION"), "Drawn by: CPU", "- Add camera", "\"theme\""] {
            assert!(text.contains(words), "{words} in {text}");
        }
        assert_eq!(text.contains("\"cameras\""), with_scene);
        assert!(window.shows("The report is in"));
        // A file that is there is not written over unasked.
        window.command(Command::ReportProblem);
        window.answer(Reply::Path(path.clone()));
        window.press("Save…");
        let again = std::fs::read_to_string(path.with_extension("txt")).expect("still there");
        assert_eq!(again, text);
    }
}

#[test]
fn each_panel_opens_its_page() {
    let mut window = Window::open();
    window.settle();
    for (panel, name, words) in [
        (Command::OutlinePanel, "Outline", "All that the scene holds"),
        (Command::InspectorPanel, "Inspector", "The values of what is chosen"),
        (Command::LevelsPanel, "Levels", "The five colour levels"),
        (Command::GroupsPanel, "Groups", "which sprites take the sun"),
        (Command::SkyPanel, "Sky", "The hour, the light over the day"),
        (Command::FlightPanel, "Flight", "Camera paths, the clock"),
        (Command::TimelinePanel, "Timeline", "All keys of all values"),
        (Command::ScriptPanel, "Script", "Where plugins are written"),
        (Command::ChartPanel, "Chart", "What each way to draw costs"),
        (Command::HistoryPanel, "History", "All changes since"),
        (Command::ProblemsPanel, "Problems", "What is wrong with the scene"),
    ] {
        window.command(panel);
        window.press(&format!("Help on {name}"));
        assert!(window.shows(words), "{name}");
        window.press("Close the manual");
    }
    window.press("Help on Viewport");
    assert!(window.shows("The picture, and all that is done in it"));
}

#[test]
fn the_manual_is_searched() {
    let mut window = Window::open();
    window.settle();
    window.keys(egui::Modifiers::NONE, egui::Key::F1);
    assert!(window.shows("Page First cloud") && window.shows("Page Timeline"));
    window.type_into(Role::TextInput, "Search the manual", "xyzzy");
    assert!(!window.shows("Page First cloud"), "no page has these words");
    window.keys(egui::Modifiers::NONE, egui::Key::Escape);
    assert!(window.shows("Page First cloud"));
    window.type_into(Role::TextInput, "Search the manual", "ripple");
    assert!(window.shows("Page Timeline") && !window.shows("Page Outline"));
    window.press("Page Timeline");
    assert!(window.shows("All keys of all values"));
}
