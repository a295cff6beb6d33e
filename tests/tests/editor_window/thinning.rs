//! Thinning from the window: off the frame, one undo point, and nothing if it is stopped or refused.

use crate::Window;
use cloudwright::command::Command;
use egui::{Key, Modifiers};

fn sprites(window: &Window) -> usize {
    window.session().derived().clouds().iter().map(|cloud| cloud.sprites.len()).sum()
}

#[test]
fn drops_sprites_within_the_tolerance_and_can_be_undone() {
    let mut window = Window::open();
    window.settle();
    let (start, before) = (window.file(), sprites(&window));
    window.command(Command::ThinOut);
    window.set("Tolerance", 0.05);
    window.press("Thin out");
    assert_eq!(window.file(), start, "it is worked out off the frame");
    window.wait("sprites to go", |window| window.undo_name().as_deref() == Some("Thin out"));
    window.settle();
    assert!(sprites(&window) < before, "{} of {before}", sprites(&window));
    assert!(window.shows(&format!("of {before} sprites are left")));
    window.command(Command::Undo);
    assert_eq!((window.file(), window.undo_name()), (start, None));
}

#[test]
fn is_refused_stopped_and_closed() {
    let mut window = Window::open();
    window.settle();
    let start = window.file();
    window.command(Command::ThinOut);
    window.set("Tolerance", 0.0005);
    window.press("Thin out");
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(window.shows("Drops the sprites"), "Esc has stopped the work; it can be asked again");
    window.keys(Modifiers::COMMAND, Key::D);
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(!window.shows("Drops the sprites"), "and closed the question");
    assert_eq!((window.file(), window.undo_name()), (start, None));
}
