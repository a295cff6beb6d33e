//! Everything by keyboard, and by ear: menus by their letters, a name on every control, a focus that Tab moves through all of it.

use crate::Window;
use cloudwright::command::{Command, Menu};
use cloudwright::state::Item;
use cloudwright_tests::root;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use std::collections::BTreeSet;

/// What is pressed, set, chosen or typed into.
const CONTROLS: [Role; 16] = [
    Role::Button,
    Role::SpinButton,
    Role::Slider,
    Role::ComboBox,
    Role::CheckBox,
    Role::RadioButton,
    Role::TextInput,
    Role::MultilineTextInput,
    Role::ColorWell,
    Role::Link,
    Role::Tab,
    Role::ProgressIndicator,
    Role::Switch,
    Role::ListItem,
    Role::MenuItem,
    Role::DisclosureTriangle,
];

impl Window {
    /// Controls without a name, as they are told to a screen reader.
    fn nameless(&self) -> Vec<String> {
        let mut found = Vec::new();
        for role in CONTROLS {
            for node in self.harness.query_all_by_role(role) {
                let it = node.accesskit_node();
                let name = it.label().unwrap_or_default();
                // A glyph of the icon font is no name.
                // The numbers beside a script's lines are a text to look at.
                let value = it.value().unwrap_or_default();
                let is_numbers = !value.is_empty() && value.lines().all(|line| line.trim().parse::<u32>().is_ok());
                if role == Role::MultilineTextInput && is_numbers {
                    continue;
                }
                if !name.chars().any(|letter| letter.is_alphanumeric() || letter == '?') {
                    found.push(format!("{role:?} {name:?} {:?} at {:?}", it.value(), node.rect()));
                }
            }
        }
        found
    }

    fn all_have_names(&self, what: &str) {
        let nameless = self.nameless();
        assert!(nameless.is_empty(), "{what}: {nameless:#?}");
    }
}

#[test]
fn every_control_has_a_name() {
    let mut window = Window::open();
    window.harness.state_mut().open_path(&root().join("assets/scenes/fair_weather.cloudscene"));
    window.settle();
    let scene = window.scene();
    let (model, of) = (scene.models[0].id, scene.models[0].boxes[0].id);
    let items = [
        Item::Cloud(scene.clouds[0].id),
        Item::Model(model),
        Item::Box(model, of),
        Item::Sprite(model, of, 0),
        Item::Camera(scene.cameras[0].id),
        Item::Path(scene.paths[0].id),
    ];
    let panels = [
        Command::OutlinePanel,
        Command::InspectorPanel,
        Command::LevelsPanel,
        Command::GroupsPanel,
        Command::SkyPanel,
        Command::FlightPanel,
        Command::TimelinePanel,
        Command::ScriptPanel,
        Command::ChartPanel,
        Command::HistoryPanel,
        Command::ProblemsPanel,
    ];
    window.all_have_names("nothing selected");
    for item in items {
        window.select([item]);
        for panel in panels {
            window.command(panel);
            window.all_have_names(&format!("{} with {item:?}", panel.row().name));
        }
    }
    window.command(Command::AddKeys);
    window.command(Command::CurveView);
    window.all_have_names("curves");
    for tool in [Command::MoveTool, Command::RotateTool, Command::ScaleTool, Command::BoxTool] {
        window.command(tool);
        window.all_have_names(tool.row().name);
    }
}

#[test]
fn every_dialog_and_menu_has_names() {
    let mut window = Window::open();
    let cloud = window.scene().clouds[0].id;
    window.select([Item::Cloud(cloud)]);
    for command in [
        Command::AddPreset,
        Command::PlaceMany,
        Command::FitLight,
        Command::ThinOut,
        Command::WeatherReport,
        Command::Export,
        Command::RenderPicture,
        Command::Palette,
        Command::Preferences,
        Command::SaveLayout,
        Command::ReportProblem,
        Command::About,
        Command::StartPage,
        Command::Manual,
        Command::Tour,
    ] {
        window.command(command);
        window.all_have_names(command.row().name);
        window.keys(Modifiers::NONE, Key::Escape);
    }
    for menu in Menu::ALL {
        window.press(menu.name());
        window.all_have_names(menu.name());
        window.keys(Modifiers::NONE, Key::Escape);
    }
}

#[test]
fn alt_and_a_letter_open_a_menu_and_arrows_go_through_it() {
    let mut window = Window::open();
    window.settle();
    for menu in Menu::ALL {
        window.keys(Modifiers::ALT, menu.key());
        let first = cloudwright::command::TABLE.iter().filter(|row| row.menu == menu).nth(1).expect("rows");
        assert!(window.shows(first.name), "{}", menu.name());
        window.keys(Modifiers::NONE, Key::Escape);
    }
    let cameras = window.scene().cameras.len();
    window.keys(Modifiers::ALT, Key::D);
    window.settle();
    // The first entry has the focus; the third of those that can be chosen is a camera.
    for _ in 0..2 {
        window.keys(Modifiers::NONE, Key::ArrowDown);
    }
    window.keys(Modifiers::NONE, Key::Enter);
    assert_eq!(window.scene().cameras.len(), cameras + 1);
    window.keys(Modifiers::NONE, Key::F10);
    assert!(window.shows("Open recent…"));
    window.keys(Modifiers::NONE, Key::ArrowRight);
    assert!(!window.shows("Open recent…") && window.shows("Select nothing"), "its neighbour");
    window.keys(Modifiers::NONE, Key::ArrowLeft);
    window.keys(Modifiers::NONE, Key::ArrowLeft);
    assert!(window.shows("About Cloudwright"), "and round about");
}

#[test]
fn blenders_keys_go_before_a_menus_letter() {
    let mut window = Window::open();
    window.command(Command::SwitchKeymap);
    window.command(Command::SelectAll);
    let clouds = window.scene().clouds.len();
    window.keys(Modifiers::ALT, Key::D);
    assert_eq!(window.scene().clouds.len(), clouds + 1, "Alt+D duplicates there");
    window.keys(Modifiers::ALT, Key::F);
    assert!(window.shows("Open recent…"));
}

/// Tab visits what there is, and comes round.
#[test]
fn tab_goes_through_all_of_the_window() {
    let mut window = Window::open();
    let cloud = window.scene().clouds[0].id;
    window.select([Item::Cloud(cloud)]);
    let mut visited = BTreeSet::new();
    for _ in 0..400 {
        window.harness.key_press(Key::Tab);
        window.harness.step();
        let focused = window.harness.query_all(egui_kittest::kittest::By::new().predicate(|node| node.is_focused()));
        visited.extend(focused.filter_map(|node| node.accesskit_node().label()));
    }
    for name in
        ["File", "New", "Viewport", "Name", "Opacity", "Look and wind", "Presets of colour levels", "Level 3 height"]
    {
        assert!(visited.iter().any(|label| label.contains(name)), "{name} in {visited:#?}");
    }
}

/// Frames may take longer than a hand takes to type into three fields.
#[test]
fn what_is_typed_across_fields_in_one_frame_comes_to_each() {
    let mut window = Window::open();
    window.settle();
    window.press("body");
    window.node(Role::SpinButton, "Size x").focus();
    window.settle();
    let (key, modifiers) = (Key::Tab, Modifiers::NONE);
    let tab = Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers };
    for figures in ["400", "60", "300"] {
        let typed = figures.chars().map(|figure| Event::Text(figure.into()));
        window.harness.input_mut().events.extend(typed.chain([tab.clone()]));
    }
    window.settle();
    assert_eq!(window.primary_box().size.to_array(), [400.0, 60.0, 300.0]);
}
