//! Light fitted from the window: off the frame, one undo point that tells how near it came, and nothing if it is stopped.

use crate::Window;
use cloudwright::command::Command;
use egui::accesskit::Role;
use egui::{Key, Modifiers};

#[test]
fn fits_tells_and_can_be_undone() {
    let mut window = Window::open();
    window.settle();
    let start = window.file();
    window.command(Command::FitLight);
    window.node(Role::RadioButton, "By the sun of the scene's hour").click();
    window.settle();
    window.press("Fit");
    assert_eq!(window.file(), start, "it is worked out off the frame");
    window.wait("light to be fitted", |window| window.undo_name().as_deref() == Some("Fit light"));
    window.wait("what came of it", |window| window.shows(" before, "));
    window.press("OK");
    window.command(Command::Undo);
    assert_eq!((window.file(), window.undo_name()), (start, None));
}

#[test]
fn is_stopped_and_closed() {
    let mut window = Window::open();
    window.settle();
    let start = window.file();
    window.command(Command::FitLight);
    window.press("Fit");
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(window.shows("as it gets to a path tracer's"), "Esc has stopped the work; it can be asked again");
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(!window.shows("as it gets to a path tracer's"), "and closed the question");
    assert_eq!((window.file(), window.undo_name()), (start, None));
}
