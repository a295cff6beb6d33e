//! In small windows and in large ones, all that can be used is in the window, or comes into it when it is scrolled to.

use crate::Window;
use cloudwright::command::{Command, Menu, TABLE};
use cloudwright::state::Item;
use cloudwright_tests::root;
use egui::accesskit::Role;
use egui::{Key, Modifiers, Rect, vec2};
use egui_kittest::Node;
use egui_kittest::kittest::{NodeT, Queryable};
use std::collections::BTreeSet;

const SIZES: [[f32; 2]; 2] = [[800.0, 600.0], [3840.0, 2160.0]];

/// Everything of the kinds that are pressed, set or typed into.
const CONTROLS: [Role; 7] =
    [Role::Button, Role::SpinButton, Role::Slider, Role::ComboBox, Role::CheckBox, Role::TextInput, Role::ColorWell];

fn open(size: [f32; 2]) -> Window {
    let mut window = Window::open_sized(None, size);
    window.harness.state_mut().open_path(&root().join("assets/scenes/fair_weather.cloudscene"));
    window.settle();
    window
}

impl Window {
    fn size(&self) -> Rect {
        self.harness.ctx.content_rect()
    }

    /// The names of all controls, by role. Lists lay out only what is in sight, so no node can be kept.
    fn controls(&self) -> BTreeSet<(usize, String)> {
        let named =
            |(at, role)| self.nodes(role).map(move |node| (at, node.accesskit_node().label().unwrap_or_default()));
        CONTROLS.into_iter().enumerate().flat_map(named).collect()
    }

    fn nodes(&self, role: Role) -> impl Iterator<Item = Node<'_>> {
        self.harness.query_all_by_role(role).filter(|node| node.rect().width() >= 1.0)
    }

    /// Scrolls to each control in turn, `but` those, and sees that it has come into the window.
    fn all_can_be_reached(&mut self, what: &str, but: &BTreeSet<(usize, String)>) {
        let inside = self.size().expand(1.0);
        for (role, name) in self.controls().difference(but).cloned().collect::<Vec<_>>() {
            let role = CONTROLS[role];
            let all = |window: &Self| -> Vec<Rect> {
                let named = window.nodes(role).filter(|node| node.accesskit_node().label().unwrap_or_default() == name);
                named.map(|node| node.rect()).collect()
            };
            // What is larger than its place shows in part.
            let in_part = |rect: &Rect| {
                let (seen, least) = (rect.intersect(inside).size(), rect.size().min(vec2(8.0, 8.0)));
                seen.x >= least.x && seen.y >= least.y
            };
            let shows = |window: &Self| all(window).iter().any(in_part);
            if !all(self).iter().all(|rect| inside.contains_rect(*rect)) {
                let named = |node: &Node<'_>| node.accesskit_node().label().unwrap_or_default() == name;
                self.nodes(role).filter(named).for_each(|node| node.scroll_to_me());
                self.harness.run_steps(2);
                // What has the focus is in sight sideways too.
                if !shows(self) {
                    self.nodes(role).filter(named).take(1).for_each(|node| node.focus());
                    self.harness.run_steps(4);
                }
                assert!(shows(self), "{what} in {:?}: {role:?} {name:?} at {:?}", self.size().size(), all(self));
            }
        }
    }
}

/// Not the flight panel: its list of keys scrolls within what scrolls, and of a request only the inner one hears.
const PANELS: [Command; 10] = [
    Command::OutlinePanel,
    Command::InspectorPanel,
    Command::LevelsPanel,
    Command::GroupsPanel,
    Command::SkyPanel,
    Command::TimelinePanel,
    Command::ScriptPanel,
    Command::ChartPanel,
    Command::HistoryPanel,
    Command::ProblemsPanel,
];

#[test]
fn all_of_each_panel_can_be_reached() {
    for size in SIZES {
        let mut window = open(size);
        let scene = window.scene();
        let (cloud, model, path) = (scene.clouds[0].id, scene.models[0].id, scene.paths[0].id);
        let of = scene.models[0].boxes[0].id;
        let items = [Item::Box(model, of), Item::Cloud(cloud), Item::Model(model), Item::Path(path)];
        for item in items.into_iter().take(if size == SIZES[0] { 4 } else { 1 }) {
            window.select([item]);
            // Only the inspector is another one for another thing, and large windows cut off nothing: one of each is enough.
            let panels = PANELS.into_iter().filter(|panel| {
                let is_first = item == items[0] && size == SIZES[0];
                is_first || *panel == Command::InspectorPanel
            });
            for panel in panels {
                window.command(panel);
                window.all_can_be_reached(&format!("{} with {item:?}", panel.row().name), &BTreeSet::new());
            }
        }
    }
}

#[test]
fn all_of_each_menu_can_be_reached() {
    for size in SIZES {
        let mut window = open(size);
        for menu in Menu::ALL {
            window.press(menu.name());
            let rows: Vec<_> = TABLE.iter().filter(|row| row.menu == menu).collect();
            // Where the last row shows without a scroll, all do.
            let first = if size == SIZES[0] { 0 } else { rows.len() - 1 };
            for row in &rows[first..] {
                let role = Role::Button;
                let find = |window: &Window| {
                    let all = window.harness.query_all_by_role_and_label(role, row.name);
                    all.map(|node| node.rect()).rfind(|rect| rect.top() > 20.0 || menu == Menu::File)
                };
                if let Some(node) = window.harness.query_all_by_role_and_label(role, row.name).last() {
                    node.scroll_to_me();
                }
                window.harness.run_steps(2);
                let rect = find(&window).expect("it is in the menu");
                assert!(window.size().contains_rect(rect), "{} in {:?}: {rect:?}", row.name, window.size().size());
            }
            window.keys(Modifiers::NONE, Key::Escape);
        }
    }
}

/// A command that asks, and a button of its answer.
const DIALOGS: [(Command, &str); 16] = [
    (Command::New, "Cancel"),
    (Command::AddPreset, "Cancel"),
    (Command::PlaceMany, "Cancel"),
    (Command::FitLight, "Cancel"),
    (Command::ThinOut, "Cancel"),
    (Command::WeatherReport, "Cancel"),
    (Command::Export, "Cancel"),
    (Command::RenderPicture, "Cancel"),
    (Command::RenderFlight, "Cancel"),
    (Command::Palette, "File: New…"),
    (Command::Preferences, "Done"),
    (Command::SaveLayout, "Cancel"),
    (Command::ReportProblem, "Cancel"),
    (Command::About, "OK"),
    (Command::StartPage, "To the editor"),
    (Command::Tour, "Leave the tour"),
];

#[test]
fn all_of_each_dialog_can_be_reached() {
    for size in SIZES {
        let mut window = open(size);
        let cloud = window.scene().clouds[0].id;
        window.select([Item::Cloud(cloud)]);
        for (command, answer) in DIALOGS {
            // What stands behind a question is not reached meanwhile.
            let behind = window.controls();
            window.command(command);
            assert!(window.harness.query_by_role_and_label(Role::Button, answer).is_some(), "{}", command.row().name);
            window.all_can_be_reached(command.row().name, &behind);
            // The first may end the typing in a field.
            window.keys(Modifiers::NONE, Key::Escape);
            window.keys(Modifiers::NONE, Key::Escape);
        }
        assert!(!window.shows("Cancel"));
    }
}

#[test]
fn messages_cover_no_field() {
    for size in SIZES {
        let window = open(size);
        let picture = window.harness.get_by_label("Viewport").rect();
        let message = window.harness.get_by_label_contains("Opened ").rect();
        assert!(picture.contains_rect(message), "{message:?} in {picture:?}");
    }
}
