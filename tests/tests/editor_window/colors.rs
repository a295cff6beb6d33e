//! Colour levels and the sky: handles, fields, presets, keys over the day, time that runs.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::state::{Item, Selection};
use cloudwright_core::scene::{ColorLevels, DailyTable};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Pos2, Vec2, pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};

/// A window with the starter's cloud selected.
fn with_cloud() -> Window {
    let mut window = Window::open();
    window.settle();
    let cloud = window.scene().clouds[0].id;
    window.harness.state_mut().select(Selection::of([Item::Cloud(cloud)]));
    window.settle();
    window
}

/// A window with the sky's panel up.
fn with_sky() -> Window {
    let mut window = Window::open();
    let context = window.harness.ctx.clone();
    window.harness.state_mut().perform(Command::SkyPanel, &context);
    window.settle();
    window
}

fn levels(window: &Window, model: usize) -> ColorLevels {
    window.scene().models[model].color_levels
}

fn hours<T>(table: &DailyTable<T>) -> Vec<f64> {
    table.keys.iter().map(|key| key.hour).collect()
}

/// Drags a handle in four moves, and leaves the button down. Where the pointer is then.
fn drag(window: &mut Window, handle: &str, way: Vec2) -> Pos2 {
    let from = window.node(Role::Slider, handle).rect().center();
    window.pointer(from, Some(true));
    for step in 1..=4_u8 {
        window.pointer(from + way * (f32::from(step) / 4.0), None);
    }
    from + way
}

fn let_go(window: &mut Window, at: Pos2) {
    window.pointer(at, Some(false));
    window.settle();
}

#[test]
fn a_level_is_dragged_in_the_panel_and_on_the_cloud() {
    for handle in ["Level 3", "Level 3 on the cloud"] {
        let mut window = with_cloud();
        let scene = window.scene().clone();
        let before = levels(&window, 0);
        let at = drag(&mut window, handle, vec2(0.0, -20.0));
        assert!(window.session().document().is_open(), "{handle}");
        let dragged = levels(&window, 0)[2].height;
        assert!(dragged > before[2].height + 0.01 && dragged < before[3].height, "{handle}: {dragged}");
        let work = window.session().derived().work_done();
        assert_eq!(work.models_populated, 1, "{handle}: no sprite is strewn again");
        let_go(&mut window, at);
        window.was_told("Height of level ");
        window.press("Undo");
        assert_eq!((window.scene(), window.undo_name()), (&scene, None), "{handle}: one step");

        let at = drag(&mut window, handle, vec2(0.0, -900.0));
        let (levels, next) = (levels(&window, 0), before[3].height);
        assert_eq!((levels[2].height, levels[3].height), (next, next), "{handle}: it stops at its neighbour");
        window.harness.key_press(Key::Escape);
        window.harness.step();
        assert_eq!(window.scene(), &scene, "{handle}: Esc drops it");
        let_go(&mut window, at);
        assert_eq!((window.scene(), window.undo_name()), (&scene, None), "{handle}");
    }
}

#[test]
fn a_level_is_moved_by_keys() {
    let mut window = with_cloud();
    window.node(Role::Slider, "Level 2").focus();
    window.settle();
    let before = levels(&window, 0)[1].height;
    window.keys(Modifiers::NONE, Key::ArrowUp);
    assert!((levels(&window, 0)[1].height - before - 0.01).abs() < 1e-9);
    window.keys(Modifiers::SHIFT, Key::ArrowUp);
    assert!((levels(&window, 0)[1].height - before - 0.11).abs() < 1e-9);
    window.keys(Modifiers::NONE, Key::ArrowDown);
    assert!((levels(&window, 0)[1].height - before - 0.10).abs() < 1e-9);
    for _ in 0..3 {
        window.press("Undo");
    }
    assert_eq!(window.undo_name(), None, "each press is a step");
}

#[test]
fn a_level_is_set_by_its_fields() {
    let mut window = with_cloud();
    window.set("Level 1 height", 0.05);
    window.set("Level 1 opacity", 0.5);
    window.set("Level 5 colour brightness", 2.0);
    let after = levels(&window, 0);
    assert_eq!((after[0].height, after[0].color.a), (0.05, 0.5));
    let [r, g, b] = after[4].color.rgb.to_array();
    assert!((r.max(g).max(b) - 1.52).abs() < 1e-5, "twice {:?}", after[4].color);
    let scene = window.scene().clone();
    for bad in [f64::NAN, -1.0, 7.0] {
        window.set("Level 1 opacity", bad);
    }
    window.set("Level 1 height", f64::NAN);
    assert_eq!(levels(&window, 0)[0].height, scene.models[0].color_levels[0].height);
}

#[test]
fn a_colour_is_picked() {
    let mut window = with_cloud();
    let before = levels(&window, 0);
    window.harness.get_by_label("Level 4 colour").click();
    window.settle();
    let field = window.harness.get_by_label("Level 4 colour picker").rect();
    for (x, pressed) in [(0.5, Some(true)), (0.7, None), (0.9, None), (0.9, Some(false))] {
        window.pointer(field.lerp_inside(vec2(x, 0.3)), pressed);
    }
    window.settle();
    let after = levels(&window, 0);
    assert_ne!(after[3].color.rgb, before[3].color.rgb);
    assert_eq!((after[2], after[4], after[3].color.a), (before[2], before[4], before[3].color.a));
    let [r, _, b] = after[3].color.rgb.to_array();
    assert!(b > 4.0 * r, "far to the right it is saturated: {:?}", after[3].color);
    window.set("Level 4 colour red", 255.0);
    assert_eq!(levels(&window, 0)[3].color.rgb.r, 1.0);
    window.keys(Modifiers::NONE, Key::Escape);
    window.press("Undo");
    window.press("Undo");
    assert_eq!((levels(&window, 0), window.undo_name()), (before, None), "the drag was one step");
}

/// The scene shows what a preset would do while the pointer is over it, and is as before when the pointer has gone.
#[test]
fn presets_show_what_they_would_do() {
    let mut window = with_cloud();
    let (before, name) = (levels(&window, 0), window.undo_name());
    let file = window.file();
    window.press("Presets of colour levels");
    let over = |window: &mut Window, label: &str| {
        let at = window.harness.get_by_label(label).rect().center();
        window.harness.event(Event::PointerMoved(at));
        window.harness.run_steps(3);
        levels(window, 0)
    };
    let rain = over(&mut window, "Rain");
    assert_ne!(rain, before);
    let veil = over(&mut window, "Thin veil");
    assert!(veil != before && veil != rain);
    window.harness.event(Event::PointerMoved(pos2(5.0, 790.0)));
    window.harness.run_steps(3);
    assert_eq!((levels(&window, 0), window.undo_name(), window.file()), (before, name.clone(), file));
    assert_eq!(over(&mut window, "Rain"), rain);
    window.press("Rain");
    assert_eq!((levels(&window, 0), window.undo_name().as_deref()), (rain, Some("Preset of colour levels")));
    window.press("Undo");
    assert_eq!((levels(&window, 0), window.undo_name()), (before, name), "one step");
    window.press("Presets of colour levels");
    over(&mut window, "Rain");
    window.keys(Modifiers::NONE, Key::Escape);
    assert_eq!(levels(&window, 0), before, "the list was left");
}

#[test]
fn levels_are_copied_pasted_and_set_from_presets() {
    let mut window = with_cloud();
    let first = levels(&window, 0);
    window.press("Add cloud");
    window.press("Presets of colour levels");
    window.press("Rain");
    assert_eq!(window.undo_name().as_deref(), Some("Preset of colour levels"));
    let rain = levels(&window, 1);
    assert_ne!(rain, first);
    assert_eq!(levels(&window, 0), first);
    window.press("Copy");
    let both: Vec<Item> = window.scene().models.iter().map(|model| Item::Model(model.id)).collect();
    window.press("Presets of colour levels");
    window.press("Thin veil");
    window.harness.state_mut().select(Selection::of(both));
    window.settle();
    let scene = window.scene().clone();
    window.press("Paste");
    assert_eq!((levels(&window, 0), levels(&window, 1)), (rain, rain));
    assert_eq!(window.undo_name().as_deref(), Some("Paste colour levels"));
    // Both follow what is changed in one.
    window.set("Level 5 opacity", 0.75);
    assert_eq!((levels(&window, 0)[4].color.a, levels(&window, 1)[4].color.a), (0.75, 0.75));
    window.press("Undo");
    window.press("Undo");
    assert_eq!(window.scene(), &scene);
    window.press("Arrange colour levels");
    window.press("Space evenly");
    assert_eq!(levels(&window, 0).map(|level| level.height), [0.0, 0.25, 0.5, 0.75, 1.0]);
}

#[test]
fn a_key_of_the_sky_is_added_moved_and_removed() {
    let mut window = with_sky();
    let cloud = window.scene().clouds[0].id;
    window.harness.state_mut().select(Selection::of([Item::Cloud(cloud)]));
    window.settle();
    let scene = window.scene().clone();
    let before = hours(&scene.sky.ambient);
    window.press("Add ambient key");
    let added = hours(&window.scene().sky.ambient);
    assert_eq!((added.len(), added[9]), (before.len() + 1, 12.0));
    assert_eq!(window.undo_name().as_deref(), Some("Ambient light"));

    // Past the key at 8:50 and back to between it and 7:20.
    let band = window.harness.get_by_label("Ambient over the day").rect();
    let at = drag(&mut window, "Ambient key 10", vec2(-band.width() * 4.5 / 24.0, 0.0));
    let moved = hours(&window.scene().sky.ambient);
    assert!((moved[8] - 7.5).abs() < 0.1 && moved[9] == before[8], "{moved:?}");
    let_go(&mut window, at);
    window.set("Ambient key opacity", 0.5);
    assert_eq!(window.scene().sky.ambient.keys[8].value.a, 0.5, "the one in hand is the chosen one");
    for _ in 0..2 {
        window.press("Undo");
    }
    assert_eq!(hours(&window.scene().sky.ambient), added, "a drag is one step");

    window.node(Role::Slider, "Ambient key 10").focus();
    window.settle();
    window.keys(Modifiers::NONE, Key::ArrowRight);
    assert!((window.scene().sky.ambient.keys[9].hour - 12.1).abs() < 1e-9);
    window.keys(Modifiers::NONE, Key::Delete);
    assert_eq!(window.scene().sky, scene.sky);
    assert_eq!(window.scene().clouds, scene.clouds, "Delete is the key's, not the selected cloud's");
    assert!(!window.scene().clouds.is_empty());
}

#[test]
fn keys_never_share_an_hour_and_one_stays() {
    let mut window = with_sky();
    let width = window.harness.get_by_label("Directional over the day").rect().width();
    let at = drag(&mut window, "Directional key 5", vec2(width * 4.0 / 24.0, 0.0));
    let_go(&mut window, at);
    let hours_now = hours(&window.scene().sky.directional);
    assert!(hours_now.windows(2).all(|pair| pair[0] < pair[1]), "{hours_now:?}");
    assert_eq!(window.undo_name().as_deref(), Some("Directional light"), "and it is no problem");
    for _ in 0..20 {
        if window.node(Role::Button, "Remove directional key").accesskit_node().is_disabled() {
            break;
        }
        window.press("Remove directional key");
    }
    assert_eq!(window.scene().sky.directional.keys.len(), 1);
}

#[test]
fn time_runs_in_the_view_alone() {
    let mut window = with_sky();
    let scene = window.scene().clone();
    let shown = |window: &Window| {
        let value = window.node(Role::Slider, "Time of day").accesskit_node().numeric_value();
        value.expect("a slider has a value")
    };
    window.press("Play");
    window.harness.run_steps(10);
    assert!(shown(&window) > 12.01, "{}", shown(&window));
    assert_eq!(window.scene(), &scene);
    assert!(!window.session().document().is_modified());
    window.press("Stop");
    let stopped = shown(&window);
    window.harness.run_steps(4);
    assert_eq!(shown(&window), stopped, "it stays where it stopped");
    assert!(stopped > 12.01 && window.shows("Preview: the scene's hour is 12:00"));
    assert_eq!((window.scene(), window.undo_name()), (&scene, None), "the scene has its own hour");
    window.press("Back to the scene's hour");
    assert_eq!(shown(&window), 12.0);
    assert!(!window.shows("Preview"));

    // Kept, it is one step; undone, the scene has its hour again, and so has the view.
    window.press("Play");
    window.harness.run_steps(10);
    window.press("Stop");
    let tried = shown(&window);
    window.press("Keep this hour");
    assert_eq!((window.scene().time_of_day_h, shown(&window)), (tried, tried));
    assert_eq!(window.undo_name().as_deref(), Some("Keep this hour"));
    assert!(!window.shows("Preview"));
    window.press("Undo");
    assert_eq!((window.scene(), window.undo_name(), shown(&window)), (&scene, None, 12.0));

    // Esc leaves what runs, and so does another hour of the scene's.
    window.keys(Modifiers::NONE, Key::P);
    window.harness.run_steps(10);
    assert!(shown(&window) > 12.01);
    window.keys(Modifiers::NONE, Key::Escape);
    assert_eq!((shown(&window), window.scene(), window.undo_name()), (12.0, &scene, None));
    window.keys(Modifiers::NONE, Key::P);
    window.harness.run_steps(10);
    window.node(Role::Slider, "Time of day").set_value_accesskit(9.0);
    window.settle();
    assert_eq!((shown(&window), window.scene().time_of_day_h), (9.0, 9.0));
    assert!(window.harness.query_by_role_and_label(Role::Button, "Play").is_some(), "it no longer runs");
    window.keys(Modifiers::NONE, Key::P);
    window.harness.run_steps(10);
    window.keys(Modifiers::COMMAND, Key::Z);
    assert_eq!((shown(&window), window.scene()), (12.0, &scene));
}

#[test]
fn the_hours_slider_fills_the_panel() {
    for width in [1280.0, 1600.0] {
        let mut window = Window::open_sized(None, [width, 1000.0]);
        window.settle();
        window.command(Command::SkyPanel);
        let slider = window.node(Role::Slider, "Time of day").rect();
        let panel = window.node(Role::DisclosureTriangle, "Sun").rect();
        assert!(slider.width() > 230.0, "{slider} in a window {width} wide");
        assert!(slider.right() < width && slider.left() - panel.left() < 40.0, "{slider}");
    }
}
