//! Work that a crash would lose. A crash is an editor that is dropped without leaving: its locks go, its files stay.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::editor::Reply;
use cloudwright::state::Item;
use cloudwright::storage::{Folders, Over};
use cloudwright::{opening, saving};
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::Scene;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use std::path::Path;
use std::time::{Duration, Instant};

fn kept_count(home: &Path) -> usize {
    let folder = home.join("state/recovery");
    std::fs::read_dir(folder).map_or(0, |entries| {
        entries
            .filter(|entry| entry.as_ref().is_ok_and(|e| e.path().extension().is_some_and(|x| x == "rescue")))
            .count()
    })
}

/// What a crash would leave of the scene at this moment.
fn kept(home: &Path) -> Option<Scene> {
    let entries = std::fs::read_dir(home.join("state/recovery")).ok()?;
    let mut paths = entries.map(|entry| entry.expect("readable").path());
    let bytes = std::fs::read(paths.find(|path| path.extension().is_some_and(|ending| ending == "rescue"))?).ok()?;
    let rescue: serde_json::Value = serde_json::from_slice(&bytes).expect("whole");
    Some(scene_file::read(rescue["scene"].as_str().expect("text").as_bytes()).expect("sound"))
}

#[test]
fn work_is_kept_while_it_goes_on() {
    // A second, and what a busy machine may add.
    let at_the_latest = Duration::from_secs(3);

    let home = tempfile::tempdir().expect("a folder");
    let mut window = Window::open_with(Some(Folders::within(home.path())));
    window.settle();
    window.press("body");
    let body = |scene: &Scene| scene.models[0].boxes.iter().find(|each| each.name == "body").cloned();
    let sprites = |scene: &Scene| body(scene).expect("it stays").sprite_count;
    let first = sprites(window.scene()) + 1;
    let mut changed_at = Vec::new();
    let begin = Instant::now();
    while begin.elapsed() < at_the_latest + Duration::from_secs(1) {
        std::thread::sleep(Duration::from_millis(100));
        let next = first + changed_at.len() as u32;
        window.node(Role::SpinButton, "Sprites").set_value_accesskit(next.into());
        window.harness.run_steps(2);
        assert_eq!(sprites(window.scene()), next);
        changed_at.push(Instant::now());
        let kept_count = kept(home.path()).map_or(0, |scene| (sprites(&scene) + 1 - first) as usize);
        let waiting = changed_at.get(kept_count).map_or(Duration::ZERO, Instant::elapsed);
        assert!(waiting < at_the_latest, "{kept_count} of {} changes are kept", changed_at.len());
    }
}

#[test]
fn a_gesture_that_goes_on_puts_off_nothing_that_came_before() {
    let home = tempfile::tempdir().expect("a folder");
    let mut window = Window::open_with(Some(Folders::within(home.path())));
    window.settle();
    window.press("body");
    window.node(Role::SpinButton, "Sprites").set_value_accesskit(77.0);
    window.harness.run_steps(2);
    let before = window.scene().clone();
    window.command(Command::PlaceMany);
    assert!(window.session().document().is_open() && window.scene().clouds.len() > before.clouds.len());
    window.wait("what was done before, and nothing of the gesture", |_| kept(home.path()).as_ref() == Some(&before));
    assert!(window.session().document().is_open());
}

/// While a hand has changed what a track moves, the track does not show; it is there all the same.
#[test]
fn tracks_that_do_not_show_are_kept() {
    let home = tempfile::tempdir().expect("a folder");
    let mut window = Window::open_with(Some(Folders::within(home.path())));
    window.settle();
    window.select([Item::Cloud(window.scene().clouds[0].id)]);
    window.ask("Key Position");
    window.set("Position x", 123.0);
    let now = window.scene().clone();
    assert_eq!((now.tracks.len(), now.clouds[0].position.x), (1, 123.0));
    window.wait("what was done", |_| kept(home.path()).as_ref() == Some(&now));
}

#[test]
fn unsaved_work_comes_back_after_a_crash_with_its_history() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = || Some(Folders::within(home.path()));
    let path = home.path().join("sky.cloudscene");
    let mut window = Window::open_with(folders());
    window.settle();
    window.answer(Reply::Path(path.clone()));
    window.press("Save");
    let saved = window.scene().clone();
    window.press("body");
    window.set("Sprites", 70.0);
    let between = window.scene().clone();
    window.set("Sprites", 77.0);
    assert_eq!(kept_count(home.path()), 1);
    let lost = window.scene().clone();
    let mut beside = Window::open_with(folders());
    beside.settle();
    assert!(!beside.shows("Recover unsaved work?"), "that editor still runs");
    drop(window);
    let mut again = Window::open_with(folders());
    again.settle();
    assert!(again.shows("Recover unsaved work?"));
    again.press("Recover sky.cloudscene");
    assert_eq!((again.scene(), again.session().path()), (&lost, Some(path.as_path())));
    assert!(again.session().document().is_modified());
    assert_eq!(opening::open_scene(&path).expect("a sound scene"), saved, "the file is as it was");
    again.keys(Modifiers::COMMAND, Key::Z);
    assert_eq!(again.scene(), &between);
    again.keys(Modifiers::COMMAND, Key::Z);
    assert_eq!(again.scene().models, saved.models);
    assert!(again.session().document().is_modified(), "whether the file is so is not known");
    again.command(Command::Redo);
    again.command(Command::Redo);
    assert_eq!(again.scene(), &lost);
    drop(again);
    let mut again = Window::open_with(folders());
    again.settle();
    again.press("Recover sky.cloudscene");
    again.keys(Modifiers::COMMAND, Key::S);
    assert_eq!(opening::open_scene(&path).expect("a sound scene"), lost);
    assert_eq!(kept_count(home.path()), 0, "saved is saved");
}

#[test]
fn a_file_that_changed_before_the_crash_is_not_overwritten_after_it() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = || Some(Folders::within(home.path()));
    let path = home.path().join("sky.cloudscene");
    let mut window = Window::open_with(folders());
    window.settle();
    window.answer(Reply::Path(path.clone()));
    window.press("Save");
    // Without the focus the window doesn't look at it.
    window.harness.input_mut().focused = false;
    let theirs = Scene { name: "theirs".into(), ..window.scene().clone() };
    saving::save(&theirs, None, &path, Over::Anything).expect("writable");
    std::thread::sleep(Duration::from_millis(10));
    window.press("Add camera");
    drop(window);
    let mut again = Window::open_with(folders());
    again.harness.input_mut().focused = false;
    again.settle();
    again.press("Recover sky.cloudscene");
    again.keys(Modifiers::COMMAND, Key::S);
    assert!(again.shows("another program changed it"));
    assert_eq!(opening::open_scene(&path).expect("a sound scene"), theirs);
}

#[test]
fn recovery_can_wait_or_be_refused() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = || Some(Folders::within(home.path()));
    for _ in 0..2 {
        let mut window = Window::open_with(folders());
        window.settle();
        if window.shows("Recover unsaved work?") {
            window.press("Later");
        }
        window.press("Add camera");
    }
    assert_eq!(kept_count(home.path()), 2);
    let mut window = Window::open_with(folders());
    window.settle();
    let start = window.scene().clone();
    window.discard_first();
    window.discard_first();
    assert!(!window.shows("Recover unsaved work?"));
    assert_eq!((window.scene(), kept_count(home.path())), (&start, 0));
}

impl Window {
    fn discard_first(&mut self) {
        let all: Vec<_> = self.harness.get_all_by_role_and_label(Role::Button, "Discard New scene").collect();
        all.first().expect("one is offered").click();
        self.settle();
    }
}

#[test]
fn an_end_on_purpose_leaves_nothing() {
    let home = tempfile::tempdir().expect("a folder");
    let mut window = Window::open_with(Some(Folders::within(home.path())));
    window.settle();
    window.press("Add camera");
    assert_eq!(kept_count(home.path()), 1);
    window.keys(Modifiers::COMMAND, Key::Z);
    assert_eq!(kept_count(home.path()), 0, "undone, there is nothing to lose");
    window.press("Add camera");
    window.keys(Modifiers::COMMAND, Key::Q);
    window.press("Don't save");
    window.harness.state_mut().leave();
    drop(window);
    let left = std::fs::read_dir(home.path().join("state/recovery")).expect("there").count();
    assert_eq!(left, 0);
}

#[test]
fn broken_leftovers_are_told_about() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = || Some(Folders::within(home.path()));
    let folder = home.path().join("state/recovery");
    std::fs::create_dir_all(&folder).expect("writable");
    let head = "{\"format\":\"cloudwright-rescue\",\"version\":1,\"path\":null,\"saved_at_ms\":1";
    for (rescue, button) in
        [(format!("{head},\"scene\":\"{{}}\"}}"), "Recover New scene"), ("{".into(), "Recover Unreadable work")]
    {
        std::fs::write(folder.join("1-1.lock"), "").expect("writable");
        std::fs::write(folder.join("1-1.rescue"), rescue).expect("writable");
        let mut window = Window::open_with(folders());
        window.settle();
        let start = window.scene().clone();
        window.press(button);
        assert!(window.shows("error at recovery"));
        window.press("OK");
        assert_eq!(window.scene(), &start);
        assert_eq!(kept_count(home.path()), 1, "what can't be read is not thrown away");
    }
}

#[test]
fn where_nothing_can_be_kept_it_is_said_and_work_goes_on() {
    let home = tempfile::NamedTempFile::new().expect("a file where a folder should be");
    let mut window = Window::open_with(Some(Folders::within(home.path())));
    window.settle();
    window.press("Add camera");
    assert!(window.shows("can't be kept"));
    window.press("Add camera");
    assert_eq!(window.scene().cameras.len(), 3);
}
