//! The arranging commands: what they come to, that undo brings the file back byte for byte, and that redo repeats them.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::state::Item;
use cloudwright_core::scene::Scene;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

/// Two clouds of the starter's model; its body has a sprite taken out by hand, its heads share a group.
fn two_clouds() -> Window {
    let mut window = Window::open();
    window.settle();
    let (cloud, model) = (window.scene().clouds[0].id, window.scene().models[0].clone());
    window.select([Item::Cloud(cloud)]);
    window.command(Command::Duplicate);
    window.select([Item::Sprite(model.id, model.boxes[1].id, 3)]);
    window.command(Command::Delete);
    window.select([2, 3].map(|at| Item::Box(model.id, model.boxes[at].id)));
    window.command(Command::NewGroup);
    window
}

type Choose = fn(&Scene) -> Vec<Item>;

fn first_cloud(scene: &Scene) -> Vec<Item> {
    vec![Item::Cloud(scene.clouds[0].id)]
}

fn all_clouds(scene: &Scene) -> Vec<Item> {
    scene.clouds.iter().map(|cloud| Item::Cloud(cloud.id)).collect()
}

/// Body and left head: not in the cloud's middle.
fn two_boxes(scene: &Scene) -> Vec<Item> {
    let model = &scene.models[0];
    model.boxes.as_slice()[1..3].iter().map(|each| Item::Box(model.id, each.id)).collect()
}

fn the_model(scene: &Scene) -> Vec<Item> {
    vec![Item::Model(scene.models[0].id)]
}

fn a_group(scene: &Scene) -> Vec<Item> {
    vec![Item::Group(scene.models[0].id, scene.models[0].groups[0].id)]
}

#[test]
fn each_command_and_its_way_back() {
    // Models, clouds and boxes of the first model after it.
    let cases: [(Command, Choose, [usize; 3]); 17] = [
        (Command::Duplicate, all_clouds, [1, 4, 4]),
        (Command::Duplicate, two_boxes, [1, 2, 6]),
        (Command::DuplicateOwn, first_cloud, [2, 3, 4]),
        (Command::MakeOwn, first_cloud, [2, 2, 4]),
        (Command::MirrorX, two_boxes, [1, 2, 4]),
        (Command::MirrorY, first_cloud, [1, 2, 4]),
        (Command::MirrorZ, all_clouds, [1, 2, 4]),
        (Command::Join, all_clouds, [1, 1, 8]),
        (Command::Split, two_boxes, [3, 3, 4]),
        (Command::Reroll, all_clouds, [1, 2, 4]),
        (Command::Reroll, the_model, [1, 2, 4]),
        (Command::Reroll, two_boxes, [1, 2, 4]),
        (Command::ResetSprites, two_boxes, [1, 2, 4]),
        (Command::AutoGroup, first_cloud, [1, 2, 4]),
        (Command::Delete, a_group, [1, 2, 4]),
        (Command::Delete, first_cloud, [1, 1, 4]),
        (Command::Delete, the_model, [0, 0, 0]),
    ];
    let mut window = two_clouds();
    let (start, steps) = (window.file(), window.session().document().history().len());
    for (command, choose, wanted) in cases {
        let items = choose(window.scene());
        window.select(items);
        assert!(window.harness.state().can(command), "{command:?}");
        window.command(command);
        let scene = window.scene();
        let boxes = scene.models.first().map_or(0, |model| model.boxes.len());
        assert_eq!([scene.models.len(), scene.clouds.len(), boxes], wanted, "{command:?}");
        let after = window.file();
        assert_ne!(after, start, "{command:?}");
        assert_eq!(window.session().document().history().len(), steps + 1, "{command:?} is one step");
        assert_eq!(window.undo_name().as_deref(), Some(command.row().full_label().as_str()));
        window.command(Command::Undo);
        assert_eq!(window.file(), start, "{command:?}, undone");
        window.command(Command::Redo);
        assert_eq!(window.file(), after, "{command:?}, redone");
        window.command(Command::Undo);
    }
}

#[test]
fn what_is_made_is_selected_and_what_cannot_be_is_told() {
    let mut window = two_clouds();
    let clouds = all_clouds(window.scene());
    window.select(clouds.clone());
    window.command(Command::DuplicateOwn);
    let selected = window.harness.state().selection().items().to_vec();
    assert_eq!(selected, all_clouds(window.scene())[2..]);
    let joined = [selected[0], clouds[0]];
    window.select(joined);
    window.command(Command::Join);
    assert_eq!(window.harness.state().selection().items(), [clouds[0]], "the primary stays");

    let model = window.scene().models[0].clone();
    window.select(model.boxes.iter().map(|each| Item::Box(model.id, each.id)));
    let before = window.file();
    window.command(Command::Split);
    assert_eq!(window.file(), before);
    assert!(window.shows("but not all"));
}

#[test]
fn other_dice_other_sprites() {
    let mut window = Window::open();
    window.settle();
    let positions = |window: &Window| {
        let sprites = &window.session().derived().clouds()[0].sprites;
        sprites.iter().map(|sprite| (sprite.box_id, sprite.position)).collect::<Vec<_>>()
    };
    let start = (window.file(), positions(&window));
    let choices: [Choose; 3] = [first_cloud, the_model, |scene| two_boxes(scene)[..1].to_vec()];
    for choose in choices {
        let items = choose(window.scene());
        window.select(items);
        window.press("Re-roll");
        assert_ne!(positions(&window), start.1);
        window.press("Undo");
        assert_eq!((window.file(), positions(&window)), start);
    }
    // Of several, each gets a roll of its own.
    let items = two_boxes(window.scene());
    window.select(items);
    window.press("Re-roll");
    let boxes = &window.scene().models[0].boxes;
    assert!(boxes[1].key.is_some() && boxes[2].key.is_some() && boxes[1].key != boxes[2].key);
}

#[test]
fn many_placements_show_while_they_are_chosen() {
    let mut window = Window::open();
    window.settle();
    let (start, items) = (window.file(), first_cloud(window.scene()));
    window.select(items);
    window.command(Command::PlaceMany);
    window.set("Placements", 7.0);
    window.set("Altitude spread", 300.0);
    assert_eq!(window.session().derived().clouds().len(), 8, "they are shown");
    let shown = window.scene().clouds.as_slice()[1..].to_vec();
    window.press("Re-roll the placements");
    assert_ne!(window.scene().clouds.as_slice()[1..], shown);
    window.set("Placements", 0.0);
    assert!(window.shows("outside 1 to 10000"));
    window.press("Place");
    assert_eq!((window.scene().clouds.len(), window.undo_name().as_deref()), (8, Some("Many placements")));
    assert_eq!(window.harness.state().selection().clouds().count(), 7);
    window.command(Command::Undo);
    assert_eq!((window.file(), window.undo_name()), (start.clone(), None));

    window.command(Command::PlaceMany);
    assert!(!window.shows("Turned by chance"), "nothing is selected any more");
    let items = first_cloud(window.scene());
    window.select(items);
    window.command(Command::PlaceMany);
    assert_ne!(window.file(), start);
    let shown = window.file();
    window.keys(Modifiers::COMMAND, Key::D);
    assert_eq!((window.file(), window.session().document().is_open()), (shown, true), "keys wait for the answer");
    window.keys(Modifiers::NONE, Key::Escape);
    assert_eq!((window.file(), window.undo_name()), (start.clone(), None));
    assert!(window.harness.query_by_role_and_label(Role::Button, "Place").is_none());

    // What ends the gesture otherwise has taken what is shown; nothing is placed twice.
    window.command(Command::PlaceMany);
    window.command(Command::AddCamera);
    assert!(window.harness.query_by_role_and_label(Role::Button, "Place").is_none());
    assert_eq!((window.scene().clouds.len(), window.scene().cameras.len()), (13, 2));
    for _ in 0..2 {
        window.command(Command::Undo);
    }
    assert_eq!((window.file(), window.undo_name()), (start, None));
}

#[test]
fn the_history_leads_anywhere() {
    let mut window = Window::open();
    window.settle();
    let mut states = vec![window.file()];
    let items = two_boxes(window.scene());
    window.select(items);
    for command in [Command::MirrorX, Command::Duplicate, Command::NewGroup] {
        window.command(command);
        states.push(window.file());
    }
    window.press("History 1: Mirror east–west");
    assert_eq!(window.file(), states[1]);
    window.press("History 3: New shading group");
    assert_eq!(window.file(), states[3]);
    window.press("History 0: As opened");
    assert_eq!(window.file(), states[0]);
    assert!(!window.session().document().is_modified());
    window.press("Redo");
    assert_eq!(window.file(), states[1], "what was jumped over can still be redone");
}

/// Wherever in the picture a cloud stands and from wherever it is seen, its copy is in the picture too, and beside it.
#[test]
fn a_copy_is_in_sight_wherever_the_cloud_is() {
    let mut tried = 0;
    for (z, heading_deg) in [(3200.0, 0.0), (3200.0, -16.0), (3200.0, 16.0), (-3200.0, 180.0), (-3200.0, 196.0)] {
        let mut scene = Window::open().scene().clone();
        (scene.cameras[0].position.z, scene.cameras[0].heading_deg) = (z, heading_deg);
        let (mut window, _folder) = crate::outline::with_scene(&scene);
        let start = window.scene().clouds[0].clone();
        let of_start = window.on_screen(window.middle_of(&start));
        if !window.viewport().contains(of_start) {
            continue;
        }
        tried += 1;
        let boxes = Item::Box(start.model, window.scene().models[0].boxes[1].id);
        for command in [Command::Duplicate, Command::DuplicateOwn] {
            window.select([Item::Cloud(start.id)]);
            window.command(command);
            let copy = window.scene().clouds.last().expect("a copy").clone();
            let at = window.on_screen(window.middle_of(&copy));
            assert!(window.viewport().contains(at), "{command:?} from {z} at {heading_deg}°: {at}");
            assert!(copy.position.distance(start.position) > 300.0, "{command:?}: beside it");
            window.command(Command::Undo);
        }
        window.select([boxes]);
        window.command(Command::Duplicate);
        let copy = window.primary_box();
        let at = window.on_screen(start.position + copy.center);
        assert!(window.viewport().contains(at), "a box from {z} at {heading_deg}°: {at}");
    }
    assert!(tried >= 4, "{tried}");
}
