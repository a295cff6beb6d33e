//! The editor by its labels, without a window and without a GPU: the real app in egui's test harness.
//!
//! Widgets are found as a screen reader finds them; what comes of a click is read from the document.

#![allow(clippy::panic, reason = "a failing test says what it found")]

mod appending;
mod arranging;
mod by_keyboard;
mod chart_panel;
mod clipboard;
mod clock;
mod colors;
mod crowd;
mod drawing_boxes;
mod editing;
mod exchange;
mod files;
mod filming;
mod fit_light;
mod flight_panel;
mod flying;
mod folders;
mod grabbing;
mod groups;
mod help;
mod layouts;
mod many_tracks;
mod off_frame;
mod on_disk;
mod outline;
mod paths_in_view;
mod picture_choice;
mod picturing;
mod plugin_fields;
mod plugins;
mod preferences;
mod recovery;
mod remembering;
mod renaming;
mod script_panel;
mod sections;
mod seeing;
mod several;
mod start_page;
mod thinning;
mod timeline;
mod tools;
mod viewing;
mod walk;
mod weather_report;
mod window_sizes;

use cloudwright::command::Command;
use cloudwright::editor::{Ask, Editor, FileDialogs, Reply, Start};
use cloudwright::renderer::RendererChoice;
use cloudwright::scripting::{self, Host};
use cloudwright::state::{Item, Selection, Session};
use cloudwright::storage::Folders;
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::Scene;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Pos2};
use egui_kittest::kittest::Queryable;
use egui_kittest::{Harness, Node};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;
use std::sync::mpsc::Sender;
use std::time::Duration;

/// Answers to file dialogs, first one first; and what was asked.
#[derive(Default, Clone)]
struct Script {
    answers: Rc<RefCell<VecDeque<Reply>>>,
    asked: Rc<RefCell<Vec<Ask>>>,
}

impl FileDialogs for Script {
    fn ask(&mut self, ask: &Ask, answer: Sender<Reply>, wake: Box<dyn FnOnce() + Send>) {
        self.asked.borrow_mut().push(ask.clone());
        let reply = self.answers.borrow_mut().pop_front().unwrap_or(Reply::Cancelled);
        answer.send(reply).expect("the editor waits");
        wake();
    }
}

fn start(dialogs: Script, folders: Option<Folders>) -> Start {
    // This program has no such subcommand.
    scripting::use_host(Host::at(env!("CARGO_BIN_EXE_script_host")));
    Start {
        scene: None,
        start_page: false,
        renderer: RendererChoice::Cpu,
        device: None,
        file_dialogs: Box::new(dialogs),
        folders,
    }
}

/// An editor under test.
struct Window {
    harness: Harness<'static, Editor>,
    script: Script,
}

impl Window {
    fn open() -> Self {
        Self::open_with(None)
    }

    /// An editor of a user with these folders.
    fn open_with(folders: Option<Folders>) -> Self {
        Self::open_sized(folders, [1280.0, 1200.0])
    }

    /// In a window of that size, points.
    fn open_sized(folders: Option<Folders>, size: [f32; 2]) -> Self {
        let script = Script::default();
        let dialogs = script.clone();
        let harness = Harness::builder()
            .with_size(size)
            .build_eframe(move |creation| Editor::new(&creation.egui_ctx, start(dialogs, folders)));
        Self { harness, script }
    }

    fn answer(&self, reply: Reply) {
        self.script.answers.borrow_mut().push_back(reply);
    }

    /// A few frames. The picture arrives when it likes, so there is no waiting until all is quiet.
    fn settle(&mut self) {
        self.harness.run_steps(4);
        // Files are written by a thread of their own.
        while self.harness.state().is_busy() {
            std::thread::yield_now();
            self.harness.step();
        }
        self.harness.run_steps(2);
    }

    /// A frame now and then until `done`. What has just come to show may still move what stands below it: a press waits
    /// for that.
    fn wait(&mut self, what: &str, done: impl Fn(&Self) -> bool) {
        for _ in 0..12_000 {
            if done(self) {
                return self.harness.run_steps(2);
            }
            std::thread::sleep(Duration::from_millis(5));
            self.harness.step();
        }
        panic!("{what}: in vain");
    }

    /// Whether a script was stopped: by the clock, or on a quick machine by the count of its steps.
    fn shows_an_end(&self) -> bool {
        self.shows("takes too long") || self.shows("more than a script may")
    }

    fn session(&self) -> &Session {
        self.harness.state().session()
    }

    fn scene(&self) -> &Scene {
        self.session().scene()
    }

    fn sprites(&self) -> usize {
        self.session().derived().clouds().iter().map(|cloud| cloud.sprites.len()).sum()
    }

    /// The last undo point has a name that tells what was done and begins so.
    fn was_told(&self, words: &str) {
        let name = self.undo_name();
        assert!(name.as_ref().is_some_and(|name| name.starts_with(words)), "{name:?}, not {words}");
    }

    fn undo_name(&self) -> Option<String> {
        self.session().document().undo_name().map(Into::into)
    }

    fn node<'a>(&'a self, role: Role, label: &'a str) -> Node<'a> {
        self.harness.get_by_role_and_label(role, label)
    }

    fn press(&mut self, button: &str) {
        self.node(Role::Button, button).click();
        self.settle();
    }

    /// A command of the table, as from the palette.
    fn command(&mut self, command: Command) {
        let context = self.harness.ctx.clone();
        self.harness.state_mut().perform(command, &context);
        self.settle();
    }

    /// A number's field.
    fn set(&mut self, label: &str, value: f64) {
        self.node(Role::SpinButton, label).set_value_accesskit(value);
        self.settle();
    }

    fn select(&mut self, items: impl IntoIterator<Item = Item>) {
        self.harness.state_mut().select(Selection::of(items));
        self.settle();
    }

    /// The scene as its file.
    fn file(&self) -> String {
        scene_file::write(self.scene()).expect("it can be written")
    }

    /// Types into a field.
    fn type_into(&mut self, role: Role, label: &str, text: &str) {
        self.node(role, label).focus();
        self.settle();
        self.node(role, label).type_text(text);
        self.settle();
    }

    fn keys(&mut self, modifiers: Modifiers, key: Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.settle();
    }

    fn shows(&self, label: &str) -> bool {
        self.harness.query_all_by_label_contains(label).next().is_some()
    }

    fn pointer(&mut self, to: Pos2, pressed: Option<bool>) {
        self.harness.event(Event::PointerMoved(to));
        if let Some(pressed) = pressed {
            let button = PointerButton::Primary;
            self.harness.event(Event::PointerButton { pos: to, button, pressed, modifiers: Modifiers::NONE });
        }
        self.harness.step();
    }
}
