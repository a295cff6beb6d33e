//! Measuring by the Chart panel, drawing by a method, and the lenses: view state, all of it off the frame.

use crate::Window;
use crate::flight_panel::with_path;
use crate::off_frame::is_idle;
use crate::tools::opened;
use cloudwright::command::Command;
use cloudwright::state::Lens;
use cloudwright_core::method::{self, Family, METHODS};
use cloudwright_core::rules::{Movement, Rasterizer};
use egui::accesskit::Role;
use egui::{Key, Modifiers, PointerButton, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use std::time::Duration;

impl Window {
    fn method(&self) -> Option<&'static str> {
        self.harness.state().view().method.map(|method| method.name)
    }

    fn has(&self, role: Role, label: &str) -> bool {
        self.harness.query_by_role_and_label(role, label).is_some()
    }

    /// Sprites a pixel, as the status bar says; of a whole picture of what is wanted now.
    fn overdraw(&mut self) -> f64 {
        self.wait("a picture", is_idle);
        self.overdraw_shown()
    }

    fn overdraw_shown(&self) -> f64 {
        let label = self.harness.get_by_label_contains("overdraw").accesskit_node().value().expect("a text");
        label.trim_start_matches("overdraw ").parse().expect("a number")
    }

    /// Presses a method's row, wherever the panel is scrolled to.
    fn row(&mut self, method: &str) {
        self.node(Role::Button, method).click_accesskit();
        self.settle();
    }

    fn wipe(&self) -> f64 {
        self.node(Role::Slider, "Wipe").accesskit_node().numeric_value().expect("a place")
    }
}

fn with_panel() -> Window {
    let mut window = opened();
    window.command(Command::ChartPanel);
    window
}

fn measured() -> Window {
    let mut window = with_panel();
    window.press("Measure");
    window.wait("times", |window| window.has(Role::Button, "Measure"));
    window.settle();
    window
}

#[test]
fn measures_off_the_frame_and_changes_nothing() {
    let mut window = with_panel();
    let start = window.file();
    window.press("Measure");
    assert!(window.has(Role::Button, "Stop") && window.has(Role::ProgressIndicator, "Progress of measuring"));
    window.wait("a first row", |window| window.has(Role::Button, "truth"));
    window.wait("the end", |window| window.has(Role::Button, "Measure"));
    window.settle();
    // All that make a difference in a still, and that need no adapter.
    let made = |method: &&method::Method| {
        let rules = &method.rules;
        rules.without_effect(Movement::default()).is_none()
            && !matches!(rules.rasterizer, Rasterizer::Gpu | Rasterizer::Plain)
            && !rules.hazes_fragments()
    };
    for method in METHODS.iter().filter(made) {
        assert!(window.has(Role::Button, method.name), "{}", method.name);
        assert!(window.shows(&format!("Point of {}", method.name)), "{}", method.name);
    }
    assert!(window.shows("cheapest: ") && window.shows("Left out: "));
    window.set("Good enough", 0.0001);
    // Only the truth is as true, and no one would choose it for that.
    assert!(window.shows("cheapest: truth"));
    assert_eq!((window.file(), window.undo_name()), (start, None));
}

#[test]
fn a_row_or_a_point_has_the_viewport_draw_by_its_method() {
    let mut window = measured();
    let whole = window.overdraw();
    window.row("quarter");
    assert_eq!(window.method(), Some("quarter"));
    // Its pictures are drawn beside the window, and come when they are done.
    window.wait("the picture by a quarter", |window| window.overdraw_shown() < 0.8 * whole);
    window.press("Drawn by quarter");
    assert_eq!(window.method(), None);
    window.wait("the picture by all", |window| window.overdraw_shown() == whole);
    window.harness.get_by_label("Point of eight-bits").click();
    window.settle();
    assert_eq!(window.method(), Some("eight-bits"));
    window.row("eight-bits");
    assert_eq!(window.method(), None, "the same row again goes back");
}

#[test]
fn measuring_can_be_stopped() {
    let mut window = with_panel();
    window.press("Measure");
    window.press("Stop");
    assert!(window.has(Role::Button, "Measure") && !window.has(Role::Button, "Stop"));
    window.wait("rest", is_idle);
    assert!(!window.shows("Point of"), "what comes too late is not shown");
}

#[test]
fn what_was_stopped_in_the_middle_is_called_so() {
    let mut window = with_panel();
    window.press("Measure");
    window.wait("a first row", |window| window.has(Role::Button, "truth"));
    // Its colour is not all that tells its family.
    let family = window.node(Role::Button, "truth").accesskit_node().description();
    assert_eq!(family.as_deref(), Some(Family::Truth.name()));
    window.press("Stop");
    assert!(window.shows("Measuring was stopped") && window.shows("cheapest: not known yet"));
    // Another scene has nothing of this one's.
    window.press("Measure");
    window.command(Command::New);
    window.press("Clear sky");
    assert!(window.has(Role::Button, "Measure") && !window.shows("Measuring was stopped"));
    assert!(!window.has(Role::Button, "truth"));
}

#[test]
fn along_a_path_flicker_is_measured_too() {
    let mut window = with_path();
    window.command(Command::ChartPanel);
    window.node(Role::ComboBox, "What is measured").click();
    window.settle();
    window.press("along “path”");
    window.press("Measure");
    window.wait("times", |window| window.has(Role::Button, "Measure"));
    window.settle();
    assert!(window.shows("flicker") && window.shows("Point of no-lock"), "a flight shows more methods than a still");
    window.node(Role::ComboBox, "What the chart shows").click();
    window.settle();
    window.press("flicker against cost");
    assert!(window.shows("Point of no-lock"));
    // The clock is nothing to a path, and its end is nothing to a chart of the view.
    window.command(Command::SecondOn);
    assert!(!window.shows("has changed since"));
    window.command(Command::Undo);
    assert!(window.shows("has changed since"), "the path lacks a key");
}

#[test]
fn the_truth_is_seen_in_a_drag_that_comes_before_it_is_whole() {
    let mut window = measured();
    window.wait("rest", is_idle);
    window.row("truth");
    let middle = window.viewport().center();
    let before = window.harness.state().picture_time();
    window.button(middle, PointerButton::Middle, true, Modifiers::NONE);
    // Each frame asks for another picture.
    let came = (0..6000_u16).any(|frame| {
        window.pointer(middle + vec2(f32::from(frame % 60) + 10.0, 0.0), None);
        std::thread::sleep(Duration::from_millis(3));
        window.harness.state().picture_time() != before
    });
    assert!(came, "no picture while the button was down");
    window.button(middle, PointerButton::Middle, false, Modifiers::NONE);
}

#[test]
fn what_was_measured_of_something_else_is_called_so() {
    let stale = "has changed since this was measured";
    let mut window = measured();
    assert!(!window.shows(stale));
    window.command(Command::Duplicate);
    assert!(!window.shows(stale), "nothing was selected");
    let middle = window.viewport().center();
    window.drag_with(PointerButton::Middle, Modifiers::NONE, middle, vec2(60.0, 0.0));
    window.settle();
    assert!(window.shows(stale));
}

#[test]
fn a_scene_without_sprites_is_refused() {
    let mut window = with_panel();
    window.command(Command::SelectAll);
    window.command(Command::Delete);
    window.press("Measure");
    assert!(window.shows("Nothing was measured: there are no sprites"));
    assert!(window.has(Role::Button, "Measure"));
}

#[test]
fn lenses_show_what_they_say_and_go_away() {
    let mut window = with_panel();
    for (lens, name, legend) in [
        (Lens::Overdraw, "Overdraw", "Sprites blended on a pixel"),
        (Lens::WrongOrder, "Wrong order", "Cost of the sprites' order"),
        (Lens::Error, "Error", "FLIP against the truth"),
    ] {
        window.press(name);
        assert_eq!(window.harness.state().view().lens, lens);
        assert!(window.shows(legend), "{name}");
        window.wait(name, |window| window.shows("mean ") && is_idle(window));
    }
    // Another view, another map: the old one is gone at once.
    let middle = window.viewport().center();
    window.button(middle, PointerButton::Middle, true, Modifiers::NONE);
    window.pointer(middle + vec2(60.0, 0.0), None);
    window.pointer(middle + vec2(80.0, 0.0), None);
    assert!(window.shows("when the view rests") && !window.shows("mean "));
    window.button(middle + vec2(80.0, 0.0), PointerButton::Middle, false, Modifiers::NONE);
    window.wait("the new map", |window| window.shows("mean "));
    window.press("Picture");
    assert!(!window.shows("FLIP against the truth"));
    window.wait("rest", is_idle);
}

#[test]
fn the_wipe_follows_hand_and_keys_and_stays_in_the_picture() {
    let mut window = with_panel();
    window.press("Wipe");
    window.wait("the truth", |window| window.harness.query_by_label("truth").is_some());
    let rect = window.viewport();
    assert_eq!(window.wipe(), 0.5);
    window.drag(rect.center(), vec2(rect.width() * 0.25, 0.0));
    assert!((window.wipe() - 0.75).abs() < 0.01, "{}", window.wipe());
    let placed = window.wipe();
    window.keys(Modifiers::NONE, Key::ArrowLeft);
    assert!((window.wipe() - placed + 0.01).abs() < 1e-6, "{} of {placed}", window.wipe());
    window.drag(rect.center() + vec2(rect.width() * (window.wipe() as f32 - 0.5), 0.0), vec2(rect.width(), 0.0));
    assert_eq!(window.wipe(), 1.0);
    assert_eq!(window.harness.state().selection().items().len(), 0, "nothing was picked by it");
}
