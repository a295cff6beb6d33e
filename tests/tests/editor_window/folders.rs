//! Folders of clouds in the outline: made of the selection, filled and emptied by dragging, hidden, locked, soloed and
//! deleted, each as one step.

use crate::Window;
use crate::outline::with_scene;
use cloudwright::command::Command;
use cloudwright::state::Item;
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::{Folder, FolderId, Scene};
use cloudwright_tests::small_scenes::crowd;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Pos2, vec2};
use egui_kittest::kittest::Queryable;

/// So many clouds, each of another name; those of that number are in a folder "Anvils".
fn with_anvils(count: u32, within: &[usize]) -> Scene {
    let mut scene = crowd(count);
    for index in 0..scene.clouds.len() {
        scene.clouds[index].name = format!("cloud {index:03}");
    }
    if !within.is_empty() {
        let id = FolderId::new(&mut scene.next_id);
        scene.folders.push(Folder::new(id, "Anvils"));
        within.iter().for_each(|at| scene.clouds[*at].folder = Some(id));
    }
    scene
}

impl Window {
    /// The names of the clouds in each folder, by its name; those in none come last.
    fn folders(&self) -> Vec<(String, Vec<String>)> {
        let scene = self.scene();
        let of = |folder: Option<FolderId>| {
            let clouds = scene.clouds.iter().filter(|cloud| cloud.folder == folder);
            clouds.map(|cloud| cloud.name.clone()).collect::<Vec<_>>()
        };
        let folders = scene.folders.iter().map(|folder| (folder.name.clone(), of(Some(folder.id))));
        folders.chain([(String::new(), of(None))]).collect()
    }

    fn middle_of_row(&self, name: &str) -> Pos2 {
        self.node(Role::Button, name).rect().center()
    }

    fn is_listed(&self, name: &str) -> bool {
        self.harness.query_by_role_and_label(Role::Button, name).is_some()
    }

    fn drag_row(&mut self, from: &str, to: Pos2) {
        let at = self.middle_of_row(from);
        self.drag(at, to - at);
    }

    fn drawn(&self) -> usize {
        self.session().derived().clouds().len()
    }
}

fn words(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

#[test]
fn a_folder_is_made_of_the_selection_and_named_at_once() {
    let (mut window, _folder) = with_scene(&with_anvils(5, &[]));
    let start = window.file();
    assert!(!window.harness.state().can(Command::NewFolder) && !window.harness.state().can(Command::MoveToFolder));
    let ids: Vec<_> = window.scene().clouds.iter().map(|cloud| cloud.id).collect();
    window.select([1, 3].map(|at| Item::Cloud(ids[at])));
    window.command(Command::NewFolder);
    assert_eq!(window.undo_name().as_deref(), Some("New folder from selection"));
    window.harness.event(Event::Text("Anvils".into()));
    window.keys(Modifiers::NONE, Key::Enter);
    let others = words(&["cloud 000", "cloud 002", "cloud 004"]);
    assert_eq!(window.folders(), [("Anvils".into(), words(&["cloud 001", "cloud 003"])), (String::new(), others)]);
    assert!(window.shows("2 clouds"));
    // Below it, deeper; the others follow.
    let (top, left) =
        (|name: &str| window.middle_of_row(name).y, |name: &str| window.node(Role::Button, name).rect().left());
    assert!(top("Anvils") < top("cloud 001") && top("cloud 003") < top("cloud 000"));
    assert!(left("Anvils") + 8.0 < left("cloud 001") && (left("Anvils") - left("cloud 000")).abs() < 0.5);
    window.press("Fold Anvils");
    assert!(!window.is_listed("cloud 001") && window.is_listed("cloud 000"));
    window.select([Item::Cloud(ids[3])]);
    assert!(window.is_listed("cloud 001"), "it is unfolded for what is picked");
    // What is saved is what is opened.
    let text = window.file();
    let again = scene_file::read(text.as_bytes()).expect("sound");
    assert_eq!((&again, scene_file::write(&again).ok()), (window.scene(), Some(text)));
    window.command(Command::Undo);
    window.command(Command::Undo);
    assert_eq!(window.file(), start, "the name and the folder");
}

#[test]
fn rows_are_dragged_into_a_folder_and_out_of_it() {
    let (mut window, _folder) = with_scene(&with_anvils(5, &[1, 3]));
    let start = window.file();
    let ids: Vec<_> = window.scene().clouds.iter().map(|cloud| cloud.id).collect();
    // Onto the folder's row.
    window.drag_row("cloud 004", window.middle_of_row("Anvils"));
    assert_eq!(window.folders()[0].1, words(&["cloud 001", "cloud 003", "cloud 004"]));
    assert_eq!(window.undo_name().as_deref(), Some("Cloud into folder Anvils"));
    window.command(Command::Undo);
    assert_eq!(window.file(), start);
    // Several, between two of its clouds.
    window.select([0, 2].map(|at| Item::Cloud(ids[at])));
    window.drag_row("cloud 002", window.middle_of_row("cloud 003") - vec2(0.0, 6.0));
    assert_eq!(window.folders()[0].1, words(&["cloud 001", "cloud 000", "cloud 002", "cloud 003"]));
    assert_eq!(window.undo_name().as_deref(), Some("Clouds into folder Anvils"));
    window.command(Command::Undo);
    // Among those in none, and onto the heading.
    window.select([]);
    window.drag_row("cloud 001", window.middle_of_row("cloud 002") + vec2(0.0, 6.0));
    assert_eq!(window.folders()[1].1, words(&["cloud 000", "cloud 002", "cloud 001", "cloud 004"]));
    assert_eq!(window.undo_name().as_deref(), Some("Cloud out of the folder"));
    window.command(Command::Undo);
    window.drag_row("cloud 003", window.middle_of_row("Clouds (5)"));
    assert_eq!(window.folders()[0].1, words(&["cloud 001"]));
    window.command(Command::Undo);
    // Within the folder it is the order that changes.
    window.drag_row("cloud 003", window.middle_of_row("cloud 001") - vec2(0.0, 6.0));
    assert_eq!(window.folders()[0].1, words(&["cloud 003", "cloud 001"]));
    assert_eq!(window.undo_name().as_deref(), Some("Change the order"));
    window.command(Command::Undo);
    // A model takes no cloud.
    window.drag_row("cloud 001", window.middle_of_row("low"));
    assert_eq!(window.file(), start);
}

#[test]
fn commands_move_select_and_take_out() {
    let (mut window, _folder) = with_scene(&with_anvils(4, &[1]));
    let start = window.file();
    let ids: Vec<_> = window.scene().clouds.iter().map(|cloud| cloud.id).collect();
    window.select([0, 2].map(|at| Item::Cloud(ids[at])));
    assert!(!window.harness.state().can(Command::LeaveFolder) && !window.harness.state().can(Command::SelectFolder));
    window.command(Command::MoveToFolder);
    assert!(window.shows("Where 2 clouds go:"));
    window.press("Into Anvils");
    assert_eq!(window.folders()[0].1.len(), 3);
    assert_eq!(window.undo_name().as_deref(), Some("Clouds into folder Anvils"));
    window.select([Item::Cloud(ids[1])]);
    window.command(Command::SelectFolder);
    assert_eq!(window.harness.state().selection().items(), [0, 1, 2].map(|at| Item::Cloud(ids[at])));
    window.command(Command::LeaveFolder);
    assert_eq!(window.folders()[0].1.len(), 0);
    assert_eq!(window.undo_name().as_deref(), Some("Clouds out of the folder"));
    let id = window.scene().folders[0].id;
    window.select([Item::Folder(id)]);
    window.command(Command::SelectFolder);
    assert!(window.shows("The folder is empty"));
    window.command(Command::Undo);
    window.command(Command::Undo);
    // Deleted, it leaves its cloud.
    window.select([Item::Folder(id)]);
    window.command(Command::Delete);
    assert_eq!((window.scene().folders.len(), window.scene().clouds.len()), (0, 4));
    assert!(window.shows("Its cloud stays, in no folder"));
    window.command(Command::Undo);
    assert_eq!(window.file(), start);
    // A copy of it has copies of them.
    window.select([Item::Folder(id)]);
    window.command(Command::Duplicate);
    assert_eq!(window.folders()[1], ("Anvils 2".into(), words(&["cloud"])));
}

#[test]
fn hidden_locked_and_solo() {
    let (mut window, _folder) = with_scene(&with_anvils(6, &[1, 3]));
    let start = window.file();
    let scene = window.scene().clone();
    let (id, cloud) = (scene.folders[0].id, &scene.clouds[1]);
    let shows = |window: &Window| window.harness.state().view().shows(window.scene(), &window.scene().clouds[1]);
    let picks = |window: &Window| window.harness.state().view().can_pick(window.scene(), &window.scene().clouds[1]);
    assert!(window.drawn() == 6 && shows(&window) && picks(&window));
    // By its row, and by the command.
    window.press("Hide Anvils");
    assert_eq!((window.drawn(), shows(&window)), (4, false));
    assert_eq!(window.undo_name().as_deref(), Some("Hidden of Anvils from off to on"));
    assert!(scene_file::read(window.file().as_bytes()).expect("sound").folders[0].hidden, "it is saved");
    window.press("Show Anvils");
    assert_eq!(window.drawn(), 6);
    window.select([Item::Folder(id)]);
    window.command(Command::Hide);
    assert_eq!(window.drawn(), 4);
    window.command(Command::Undo);
    window.command(Command::Undo);
    window.command(Command::Undo);
    assert_eq!(window.file(), start);
    window.press("Lock Anvils");
    assert!(shows(&window) && !picks(&window));
    window.select([]);
    window.command(Command::SelectAll);
    let items = window.harness.state().selection().items().to_vec();
    assert!(items.len() == 4 && !items.contains(&Item::Cloud(cloud.id)));
    window.select([Item::Folder(id)]);
    window.command(Command::Lock);
    assert!(picks(&window));
    // Alone in sight, until Esc.
    let seen = |window: &Window| {
        let view = window.harness.state().view();
        window.scene().clouds.iter().filter(|cloud| view.shows(window.scene(), cloud)).count()
    };
    for leave in [0, 1] {
        window.command(Command::Solo);
        assert_eq!((seen(&window), window.drawn()), (2, 6), "in this view");
        if leave == 0 {
            window.command(Command::Solo);
        } else {
            window.keys(Modifiers::NONE, Key::Escape);
        }
        assert_eq!(seen(&window), 6);
    }
    assert_eq!(window.scene().folders, scene.folders);
}

#[test]
fn folders_are_searched_and_only_rows_in_sight_are_laid_out() {
    let within: Vec<usize> = (0..400).step_by(2).collect();
    let (mut window, _folder) = with_scene(&with_anvils(400, &within));
    let rows = |window: &Window| (0..400).filter(|at| window.is_listed(&format!("cloud {at:03}"))).count();
    assert!((10..100).contains(&rows(&window)), "{}", rows(&window));
    window.press("Fold Anvils");
    assert!(window.is_listed("cloud 001") && window.is_listed("Clouds (400)"));
    window.type_into(Role::TextInput, "Find in the outline", "cloud 01");
    assert!(window.is_listed("Clouds (10 of 400)") && window.is_listed("Anvils") && window.is_listed("cloud 010"));
    for _ in 0.."cloud 01".len() {
        window.keys(Modifiers::NONE, Key::Backspace);
    }
    window.type_into(Role::TextInput, "Find in the outline", "anv");
    assert!(window.is_listed("Anvils") && window.is_listed("Clouds (0 of 400)"));
}

#[test]
fn boxes_are_dragged_into_another_model() {
    let mut scene = with_anvils(3, &[]);
    for index in 0..scene.models.len() {
        let name = format!("body of {}", scene.models[index].name);
        scene.models[index].boxes[0].name = name;
    }
    let (mut window, _folder) = with_scene(&scene);
    let start = window.file();
    window.drag_row("body of low", window.middle_of_row("flat"));
    let counts = |window: &Window| window.scene().models.iter().map(|model| model.boxes.len()).collect::<Vec<_>>();
    let flat = scene.models.iter().position(|model| model.name == "flat").expect("there");
    let low = scene.models.iter().position(|model| model.name == "low").expect("there");
    assert_eq!(counts(&window)[flat], scene.models[flat].boxes.len() + 1);
    assert_eq!(counts(&window)[low], scene.models[low].boxes.len() - 1);
    assert_eq!(window.undo_name().as_deref(), Some("Box into model flat"));
    let model = &window.scene().models[flat];
    let new = model.boxes.last().expect("one");
    assert_eq!(window.harness.state().selection().items(), [Item::Box(model.id, new.id)]);
    window.command(Command::Undo);
    assert_eq!(window.file(), start);
}

#[test]
fn a_folders_colour_is_picked() {
    let (mut window, _folder) = with_scene(&with_anvils(3, &[1]));
    let folder = window.scene().folders[0].clone();
    window.select([Item::Folder(folder.id)]);
    assert!(window.harness.query_by_role_and_label(Role::SpinButton, "Colour r").is_none());
    window.node(Role::ColorWell, "Colour").click();
    window.settle();
    window.set("Colour red", 255.0);
    window.set("Colour blue", 0.0);
    let color = window.scene().folders[0].color.to_array();
    assert!(color[0] == 1.0 && color[2] == 0.0, "{color:?}");
    window.was_told("Colour b of Anvils");
}
