//! A random walk of 2,000 commands over three scenes: the document stays sound at every step, what is derived follows
//! it, and undoing everything brings the start back byte for byte, the counter of ids included.

use crate::Window;
use cloudwright::command::{Command, Menu, TABLE};
use cloudwright::state::{Item, Selection};
use cloudwright_core::derived::Derived;
use cloudwright_core::formats::scene_file;
use cloudwright_core::problem::{self, Severity};
use cloudwright_core::random::draw;
use cloudwright_core::scene::Scene;
use cloudwright_tests::root;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;

/// Of all three scenes together.
const STEPS: u32 = 2_000;
const SCENES: [&str; 3] = ["single_cumulus", "altocumulus", "overcast"];
/// Beyond this, only what makes the scene smaller is done, or the walk would drown in sprites.
const MOST_SPRITES: usize = 60_000;

/// A walker with dice.
struct Walk {
    window: Window,
    seed: u64,
    rolls: u32,
}

impl Walk {
    /// A number below `below`.
    fn roll(&mut self, below: usize) -> usize {
        self.rolls += 1;
        let [bits, ..] = draw(self.seed, 0, self.rolls, 0);
        ((u64::from(bits) * below as u64) >> 32) as usize
    }

    fn pick<T: Copy>(&mut self, of: &[T]) -> Option<T> {
        let at = self.roll(of.len().max(1));
        of.get(at).copied()
    }

    /// Selects none to three random things.
    fn select(&mut self) {
        let items = everything(self.window.scene());
        let chosen: Vec<Item> = (0..self.roll(4)).filter_map(|_| self.pick(&items)).collect();
        self.window.harness.state_mut().select(Selection::of(chosen));
    }

    /// A command of the table that needs no answer.
    fn command(&mut self) -> Command {
        let asks = [
            Command::AddPreset,
            Command::PlaceMany,
            Command::WeatherReport,
            Command::Rename,
            Command::Palette,
            Command::Preferences,
            Command::PlayTime,
            Command::SwitchTheme,
        ];
        let able: Vec<Command> = TABLE
            .iter()
            .filter(|row| ![Menu::File, Menu::Window, Menu::Help].contains(&row.menu) && !asks.contains(&row.command))
            .map(|row| row.command)
            .filter(|command| self.window.harness.state().can(*command))
            .collect();
        if self.window.sprites() > MOST_SPRITES {
            return Command::Delete;
        }
        self.pick(&able).unwrap_or(Command::SelectAll)
    }

    /// A number typed into one of the fields that are shown.
    fn type_a_number(&mut self) {
        self.window.settle();
        let count = self.window.harness.query_all_by_role(Role::SpinButton).count();
        let at = self.roll(count.max(1));
        let value = [0.0, 1.0, 0.3, -20.0, 77.0, 1e9][self.roll(6)];
        if let Some(field) = self.window.harness.query_all_by_role(Role::SpinButton).nth(at) {
            field.set_value_accesskit(value);
        }
        self.window.settle();
    }
}

fn everything(scene: &Scene) -> Vec<Item> {
    let mut items: Vec<Item> = scene.clouds.iter().map(|cloud| Item::Cloud(cloud.id)).collect();
    for model in &scene.models {
        items.push(Item::Model(model.id));
        items.extend(model.groups.iter().map(|group| Item::Group(model.id, group.id)));
        for each in &model.boxes {
            items.push(Item::Box(model.id, each.id));
            items.extend((0..each.sprite_count.min(2)).map(|index| Item::Sprite(model.id, each.id, index)));
        }
    }
    items.extend(scene.cameras.iter().map(|camera| Item::Camera(camera.id)));
    items.extend(scene.paths.iter().map(|path| Item::Path(path.id)));
    items.extend(scene.aircraft.iter().map(|aircraft| Item::Aircraft(aircraft.id)));
    items.extend(scene.props.iter().map(|prop| Item::Prop(prop.id)));
    items
}

fn assert_sound(scene: &Scene, after: &str) {
    let errors: Vec<_> = problem::check(scene).into_iter().filter(|p| p.severity == Severity::Error).collect();
    assert!(errors.is_empty(), "after {after}: {errors:#?}");
}

fn assert_derived(walk: &Walk, after: &str) {
    let fresh = Derived::new(walk.window.scene());
    let clouds = walk.window.session().derived().clouds();
    assert!(fresh.clouds() == clouds, "after {after}: the clouds shown are not the scene's");
}

fn bytes(scene: &Scene) -> String {
    scene_file::write(scene).expect("a scene that can be saved")
}

#[test]
fn two_thousand_commands_and_all_the_way_back() {
    for (seed, name) in (1..).zip(SCENES) {
        let mut window = Window::open();
        window.harness.state_mut().open_path(&root().join(format!("assets/scenes/{name}.cloudscene")));
        window.settle();
        let start = bytes(window.scene());
        let mut walk = Walk { window, seed, rolls: 0 };
        let context = walk.window.harness.ctx.clone();
        for step in 0..STEPS / SCENES.len() as u32 + 1 {
            walk.select();
            let command = walk.command();
            let after = format!("{name}, step {step}: {}", command.row().name);
            walk.window.harness.state_mut().perform(command, &context);
            if step % 40 == 17 {
                walk.type_a_number();
            }
            assert_sound(walk.window.scene(), &after);
            if step % 100 == 99 {
                walk.window.wait("the clouds", |window| window.session().pending().is_none());
                assert_derived(&walk, &after);
            }
        }
        let end = bytes(walk.window.scene());
        assert_ne!(start, end, "{name}: the walk got somewhere");
        let mut undone = 0;
        while walk.window.undo_name().is_some() {
            walk.window.harness.state_mut().perform(Command::Undo, &context);
            undone += 1;
        }
        assert!(bytes(walk.window.scene()) == start, "{name}: {undone} steps back is not the start");
        for _ in 0..undone {
            walk.window.harness.state_mut().perform(Command::Redo, &context);
        }
        assert!(bytes(walk.window.scene()) == end, "{name}: {undone} steps forward is not the end");
        walk.window.wait("the clouds", |window| window.session().pending().is_none());
        assert_derived(&walk, "redoing all");
    }
}
