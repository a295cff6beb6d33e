//! Keys: set by the diamonds beside fields, dragged, copied and deleted in the timeline.

use crate::Window;
use crate::tools::opened;
use cloudwright::command::Command;
use cloudwright::state::Item;
use cloudwright_core::property::Target;
use cloudwright_core::scene::{Beyond, KeyValue, Leaves, Track};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};

pub(crate) const RULER: &str = "Clock in the timeline";

impl Window {
    pub(crate) fn put_timeline(&mut self, time_s: f64) {
        self.node(Role::Slider, RULER).set_value_accesskit(time_s);
        self.settle();
    }

    pub(crate) fn timeline_s(&self) -> f64 {
        self.node(Role::Slider, RULER).accesskit_node().numeric_value().expect("a time")
    }

    /// A button that may lie out of sight.
    pub(crate) fn ask(&mut self, button: &str) {
        self.node(Role::Button, button).click_accesskit();
        self.settle();
    }

    /// What a diamond says.
    fn diamond(&self, name: &str) -> String {
        self.node(Role::Button, name).accesskit_node().value().expect("words")
    }

    fn number(&self, label: &str) -> f64 {
        self.node(Role::SpinButton, label).accesskit_node().numeric_value().expect("a number")
    }

    fn track(&self, property: &str) -> &Track {
        self.scene().tracks.iter().find(|track| track.property == property).expect("a track")
    }

    pub(crate) fn times(&self, property: &str) -> Vec<f64> {
        self.track(property).keys.iter().map(|key| key.time_s).collect()
    }

    pub(crate) fn key_named(&self, name: &str) -> Pos2 {
        self.node(Role::Button, name).rect().center()
    }

    fn has_key_named(&self, name: &str) -> bool {
        self.harness.query_by_role_and_label(Role::Button, name).is_some()
    }

    /// Turns the wheel away from the hand, over a place.
    fn wheel_over(&mut self, at: Pos2, modifiers: Modifiers) {
        self.pointer(at, None);
        self.harness.event(Event::MouseWheel {
            unit: egui::MouseWheelUnit::Point,
            delta: vec2(0.0, 100.0),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Unknown,
            modifiers,
        });
        self.settle();
    }

    /// Points of the timeline that a second takes.
    fn second(&self) -> f32 {
        let [a, b] = ["key of Exposure at 10 s", "key of Exposure at 20 s"].map(|name| self.key_named(name).x);
        (b - a) / 10.0
    }
}

/// A window with the timeline and keys of the exposure at 10, 20 and 30 s, of 1, 2 and 3 EV.
pub(crate) fn with_exposure() -> Window {
    let mut window = opened();
    window.command(Command::SkyPanel);
    window.command(Command::TimelinePanel);
    for step in 1..=3_u8 {
        window.put_timeline(10.0 * f64::from(step));
        if step == 1 {
            window.set("Exposure", 1.0);
            window.ask("Key Exposure");
            window.command(Command::AutoKey);
        } else {
            window.set("Exposure", f64::from(step));
        }
    }
    window
}

#[test]
fn a_place_and_the_exposure_are_keyed_by_their_diamonds() {
    let mut window = opened();
    let start = window.file();
    let cloud = window.scene().clouds[0].clone();
    window.select([Item::Cloud(cloud.id)]);
    window.command(Command::TimelinePanel);
    assert!(window.shows("Nothing is keyed yet"));
    window.ask("Key Position");
    assert_eq!(window.undo_name().as_deref(), Some("Key position"));
    window.put_timeline(10.0);
    // Beside its track until it is keyed: the clock's moving on would show the track again.
    window.set("Position x", cloud.position.x + 800.0);
    let property = format!("cloud/{}/position", cloud.id);
    assert_eq!((window.times(&property), window.number("Position x")), (vec![0.0], cloud.position.x + 800.0));
    assert_eq!(window.diamond("Key Position"), "changed since");
    let shown = window.session().derived().timeline().cloud_at(&window.scene().clouds[0], 10.0);
    assert_eq!(shown, None, "the picture shows the scene's own place");
    window.ask("Key Position");
    assert_eq!(window.times(&property), [0.0, 10.0]);
    assert_eq!(window.diamond("Key Position"), "keyed here");
    let moved = KeyValue::Three([cloud.position.x + 800.0, cloud.position.y, cloud.position.z]);
    assert_eq!(window.track(&property).keys[1].value, moved);
    window.put_timeline(5.0);
    assert_eq!(window.diamond("Key Position"), "keyed elsewhere");
    assert!((window.number("Position x") - cloud.position.x - 400.0).abs() < 1e-6, "half way");
    let now = window.session().derived().timeline().cloud_at(&window.scene().clouds[0], 5.0).expect("it moves");
    assert!((now.position.x - cloud.position.x - 400.0).abs() < 1e-6);

    window.command(Command::SkyPanel);
    window.ask("Key Exposure");
    window.put_timeline(0.0);
    let before = window.number("Exposure");
    window.set("Exposure", before - 2.0);
    window.ask("Key Exposure");
    window.put_timeline(2.5);
    assert!((window.number("Exposure") - before + 1.0).abs() < 1e-6);
    assert!(window.has_key_named("key of Exposure at 5 s") && window.has_key_named("key of Position at 10 s"));
    window.put_timeline(5.0);
    window.ask("Key Exposure");
    assert_eq!(window.times("sky/exposure_ev"), [0.0], "a click on a full diamond takes the key out");
    while window.undo_name().is_some() {
        window.command(Command::Undo);
    }
    assert_eq!(window.file(), start);
}

#[test]
fn auto_key_keys_what_hands_change() {
    let mut window = with_exposure();
    assert_eq!(window.times("sky/exposure_ev"), [10.0, 20.0, 30.0]);
    assert_eq!(window.scene().sky.exposure_ev, 1.0, "the scene's own value stays");
    assert_eq!(window.undo_name().as_deref(), Some("Key exposure"));
    // A cloud that is moved by hand, by an arrow of the gizmo.
    let cloud = window.scene().clouds[0].clone();
    window.select([Item::Cloud(cloud.id)]);
    window.ask("Key Position");
    window.put_timeline(40.0);
    window.press("Move");
    let pivot = window.on_screen(window.middle_of(&cloud));
    window.drag(pivot + vec2(52.0, 0.0), vec2(80.0, 0.0));
    let property = format!("cloud/{}/position", cloud.id);
    assert_eq!(window.times(&property), [30.0, 40.0]);
    let KeyValue::Three([x, ..]) = window.track(&property).keys[1].value else { panic!("a place") };
    assert!(x > cloud.position.x + 50.0 && window.scene().clouds[0].position == cloud.position);
    assert_eq!(window.undo_name().as_deref(), Some("Move"));
}

#[test]
fn keys_are_dragged_as_one_step() {
    let mut window = with_exposure();
    let before = window.file();
    let second = window.second();
    let at = window.key_named("key of Exposure at 20 s");
    window.drag(at, vec2(3.0 * second, 0.0));
    assert_eq!(window.times("sky/exposure_ev"), [10.0, 23.0, 30.0], "on a frame");
    assert_eq!(window.undo_name().as_deref(), Some("Move keys"));
    window.command(Command::Undo);
    assert_eq!(window.file(), before);
    // Over another key and back: what was passed comes back.
    window.button(at, PointerButton::Primary, true, Modifiers::NONE);
    window.pointer(at + vec2(5.0 * second, 0.0), None);
    window.pointer(at + vec2(10.0 * second, 0.0), None);
    assert_eq!(window.times("sky/exposure_ev"), [10.0, 30.0]);
    window.pointer(at + vec2(15.0 * second, 0.0), None);
    assert_eq!(window.times("sky/exposure_ev"), [10.0, 30.0, 35.0]);
    window.harness.key_press(Key::Escape);
    window.harness.step();
    window.pointer(at + vec2(17.0 * second, 0.0), Some(false));
    window.settle();
    assert_eq!(window.file(), before, "Esc takes it back");
    // All of them, from a box; then twice as far from the clock.
    let from = window.key_named("key of Exposure at 10 s") - vec2(12.0, 8.0);
    window.drag(from, vec2(25.0 * second, 16.0));
    window.command(Command::SlowKeys);
    assert_eq!(window.times("sky/exposure_ev"), [-10.0, 10.0, 30.0], "about the clock at 30 s");
    window.command(Command::MirrorKeys);
    assert_eq!(window.times("sky/exposure_ev"), [30.0, 50.0, 70.0]);
}

#[test]
fn keys_are_chosen_copied_and_deleted() {
    let mut window = with_exposure();
    let at = window.key_named("key of Exposure at 20 s");
    window.click(at, Modifiers::NONE);
    window.click(window.key_named("key of Exposure at 30 s"), Modifiers::SHIFT);
    let copied = window.clipped(Event::Copy);
    window.put_timeline(40.0);
    window.paste(&copied);
    assert_eq!(window.times("sky/exposure_ev"), [10.0, 20.0, 30.0, 40.0, 50.0]);
    // The pointer is over the timeline: Delete is about the keys that were pasted, and not about a cloud.
    let cloud = Item::Cloud(window.scene().clouds[0].id);
    window.select([cloud]);
    window.pointer(at + vec2(0.0, 40.0), None);
    window.keys(Modifiers::NONE, Key::Delete);
    assert_eq!((window.times("sky/exposure_ev"), window.scene().clouds.len()), (vec![10.0, 20.0, 30.0], 1));
    window.put_timeline(20.0);
    window.command(Command::SelectKeysAfter);
    window.command(Command::DeleteKeys);
    assert_eq!(window.times("sky/exposure_ev"), [10.0]);
    window.command(Command::SelectAllKeys);
    window.command(Command::DeleteKeys);
    assert!(window.scene().tracks.is_empty() && window.shows("Nothing is keyed yet"));
}

#[test]
fn exact_numbers_and_ways_on() {
    let mut window = with_exposure();
    window.click(window.key_named("key of Exposure at 20 s"), Modifiers::NONE);
    window.set("Key time", 21.25);
    window.set("Key value", -1.5);
    let key = &window.track("sky/exposure_ev").keys[1];
    assert_eq!((key.time_s, key.value, key.leaves), (21.25, KeyValue::One(-1.5), Leaves::Smooth));
    window.command(Command::KeysLinear);
    assert_eq!(window.track("sky/exposure_ev").keys[1].leaves, Leaves::Linear);
    window.put_timeline(0.0);
    let mut times = Vec::new();
    for _ in 0..3 {
        window.command(Command::NextKey);
        times.push(window.timeline_s());
    }
    window.command(Command::PreviousKey);
    assert_eq!((times, window.timeline_s()), (vec![10.0, 21.25, 30.0], 21.25));
    window.press("Before and after the keys");
    window.press("After: swings");
    assert_eq!(window.track("sky/exposure_ev").after, Beyond::Swing);
}

#[test]
fn tracks_are_found_folded_and_shown_as_curves() {
    let mut window = with_exposure();
    window.ask("Key Sky gain");
    assert!(window.has_key_named("key of Sky gain at 30 s") && window.has_key_named("keys of Sky at 30 s"));
    window.node(Role::TextInput, "Find tracks").focus();
    window.settle();
    window.node(Role::TextInput, "Find tracks").type_text("expo");
    window.settle();
    assert!(!window.has_key_named("key of Sky gain at 30 s") && window.has_key_named("key of Exposure at 30 s"));
    window.press("Fold Sky");
    assert!(!window.has_key_named("key of Exposure at 30 s") && window.has_key_named("keys of Sky at 30 s"));
    window.press("Unfold Sky");
    window.press("Exposure of Sky");
    window.command(Command::CurveView);
    let at = window.key_named("key of Exposure at 20 s");
    let second = window.second();
    window.drag_with(PointerButton::Primary, Modifiers::SHIFT, at, vec2(2.0, -20.0));
    let key = window.track("sky/exposure_ev").keys[1].clone();
    assert!(key.time_s == 20.0 && key.value.parts()[0] > 2.05, "Shift keeps to one axis: {key:?}");
    window.command(Command::KeysFree);
    let handle = window.key_named("handle after 20 s");
    window.drag(handle, vec2(second, 80.0));
    let pulled = window.track("sky/exposure_ev").keys[1].handles.clone().expect("handles");
    assert!(pulled.leaves.parts()[0] < 0.0 && pulled.arrives == pulled.leaves, "{pulled:?}");
    assert_eq!(window.undo_name().as_deref(), Some("Pull handle"));
}

#[test]
fn a_double_click_adds_a_key_and_the_wheel_zooms() {
    let mut window = with_exposure();
    let [at, next] = ["key of Exposure at 10 s", "key of Exposure at 20 s"].map(|name| window.key_named(name));
    let between = at + (next - at) * 0.5;
    // A frame here takes longer than a double click may.
    for pressed in [true, false, true, false] {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        let events = &mut window.harness.input_mut().events;
        events
            .extend([Event::PointerMoved(between), Event::PointerButton { pos: between, button, pressed, modifiers }]);
    }
    window.settle();
    let track = window.track("sky/exposure_ev");
    assert_eq!((track.keys.len(), window.undo_name().as_deref()), (4, Some("Add key")));
    assert!((track.keys[1].time_s - 15.0).abs() < 0.2 && (track.keys[1].value.parts()[0] - 1.4).abs() < 0.1);
    let before = window.second();
    window.wheel_over(at, Modifiers::NONE);
    assert!(window.second() > before * 1.2);
    assert!((window.key_named("key of Exposure at 10 s").x - at.x).abs() < 1.0, "about the pointer");
    window.keys(Modifiers::NONE, Key::F);
    assert!(window.second() > 0.0);
}

#[test]
fn a_deleted_cloud_takes_its_tracks_along_and_a_copy_has_its_own() {
    let mut window = opened();
    let cloud = window.scene().clouds[0].id;
    window.select([Item::Cloud(cloud)]);
    window.ask("Key Opacity");
    window.command(Command::Duplicate);
    assert_eq!(window.scene().tracks.len(), 2);
    let targets: Vec<Target> =
        window.scene().tracks.iter().map(|track| track.property.parse().expect("a property")).collect();
    assert!(targets.iter().all(|target| target.owner.is_in(window.scene())) && targets[0] != targets[1]);
    window.command(Command::Delete);
    window.select([Item::Cloud(cloud)]);
    window.command(Command::Delete);
    assert!(window.scene().tracks.is_empty() && window.scene().clouds.is_empty());
    window.command(Command::Undo);
    assert_eq!((window.scene().tracks.len(), window.scene().clouds.len()), (1, 1), "one step");
}

#[test]
fn a_place_and_the_exposure_are_keyed_and_moved_and_all_is_undone() {
    let mut window = opened();
    let start = window.file();
    let cloud = window.scene().clouds[0].clone();
    let place = format!("cloud/{}/position", cloud.id);
    window.select([Item::Cloud(cloud.id)]);
    window.command(Command::SkyPanel);
    window.command(Command::TimelinePanel);
    window.ask("Key Position");
    window.ask("Key Exposure");
    window.press("Auto-key");
    window.put_timeline(30.0);
    window.set("Position x", cloud.position.x + 900.0);
    window.set("Exposure", -3.0);
    assert_eq!([window.times(&place), window.times("sky/exposure_ev")], [[0.0, 30.0], [0.0, 30.0]]);
    // Three pictures of the way, as numbers: where the cloud is, and how bright the sky.
    let film = |window: &mut Window| {
        [0.0, 15.0, 30.0].map(|time_s| {
            window.put_timeline(time_s);
            let timeline = window.session().derived().timeline();
            let now = timeline.cloud_at(&window.scene().clouds[0], time_s).expect("it moves");
            assert!((window.number("Position x") - now.position.x).abs() < 0.1, "the field shows what is seen");
            [now.position.x - cloud.position.x, timeline.scene_at(window.scene(), time_s).sky.exposure_ev]
        })
    };
    let bright = cloudwright_core::scene::Scene::default().sky.exposure_ev;
    let before = film(&mut window);
    assert_eq!([before[0], before[2]], [[0.0, bright], [900.0, -3.0]]);
    assert!((before[1][0] - 450.0).abs() < 1e-6 && (before[1][1] - (bright - 3.0) / 2.0).abs() < 1e-6, "{before:?}");

    // Both last keys, in a box, twenty seconds earlier: at half of the time all has come.
    let [a, b] = ["key of Position at 30 s", "key of Exposure at 30 s"].map(|name| window.key_named(name));
    let [low, high] = [a.min(b), a.max(b)];
    window.drag(low - vec2(8.0, 9.0), high - low + vec2(16.0, 18.0));
    let second = (a.x - window.key_named("key of Position at 0 s").x) / 30.0;
    window.drag(a, vec2(-20.0 * second, 0.0));
    assert_eq!([window.times(&place), window.times("sky/exposure_ev")], [[0.0, 10.0], [0.0, 10.0]]);
    assert_eq!(window.undo_name().as_deref(), Some("Move keys"));
    assert_eq!(film(&mut window)[1], [900.0, -3.0]);
    window.command(Command::Undo);
    assert_eq!(film(&mut window), before, "one step");
    while window.undo_name().is_some() {
        window.command(Command::Undo);
    }
    assert_eq!(window.file(), start);
}

#[test]
fn with_ripple_later_keys_come_along() {
    let mut window = with_exposure();
    window.ask("Ripple in the timeline");
    let (second, at) = (window.second(), window.key_named("key of Exposure at 20 s"));
    window.drag(at, vec2(5.0 * second, 0.0));
    assert_eq!(window.times("sky/exposure_ev"), [10.0, 25.0, 35.0]);
    assert_eq!(window.undo_name().as_deref(), Some("Move keys and later ones"));
    // The field of the time does the same, and no key that stays is passed.
    window.set("Key time", 5.0);
    assert_eq!(window.times("sky/exposure_ev"), [10.0, 10.001, 20.001]);
    window.command(Command::Undo);
    window.command(Command::Undo);
    window.command(Command::RippleKeys);
    window.drag(at, vec2(5.0 * second, 0.0));
    assert_eq!(window.times("sky/exposure_ev"), [10.0, 25.0, 30.0]);
}

#[test]
fn values_of_the_curves_are_zoomed_and_panned() {
    let mut window = with_exposure();
    window.press("Exposure of Sky");
    window.command(Command::CurveView);
    let names = ["key of Exposure at 10 s", "key of Exposure at 20 s", "key of Exposure at 30 s"];
    let places = |window: &Window| names.map(|name| window.key_named(name));
    let before = places(&window);
    let room = |places: [Pos2; 3]| [places[2].x - places[0].x, places[0].y - places[2].y];
    window.wheel_over(before[1], Modifiers::COMMAND);
    let near = places(&window);
    assert!(room(near)[1] > room(before)[1] * 1.2 && (room(near)[0] - room(before)[0]).abs() < 0.5, "values alone");
    assert!(near[1].distance(before[1]) < 1.0, "about the pointer");
    // Over the numbers, without Ctrl.
    let keys = window.harness.get_by_label("Keys over time").rect();
    window.wheel_over(Pos2::new(keys.left() + 12.0, before[1].y), Modifiers::NONE);
    let nearer = places(&window);
    assert!(room(nearer)[1] > room(near)[1] * 1.2 && (room(nearer)[0] - room(near)[0]).abs() < 0.5);
    window.drag_with(PointerButton::Middle, Modifiers::NONE, before[1], vec2(30.0, 20.0));
    let panned = places(&window);
    assert!((panned[1] - nearer[1] - vec2(30.0, 20.0)).length() < 2.0, "{:?} from {:?}", panned[1], nearer[1]);
    window.command(Command::FitTimeline);
    assert!((room(places(&window))[1] - room(before)[1]).abs() < 0.5);
}

#[test]
fn ends_and_snapping_by_command_and_a_thing_stops_moving() {
    let mut window = with_exposure();
    for ends in [Beyond::Repeat, Beyond::Swing, Beyond::Hold] {
        window.command(Command::EndsAfter);
        assert_eq!(window.track("sky/exposure_ev").after, ends);
    }
    window.command(Command::EndsBefore);
    assert_eq!(window.track("sky/exposure_ev").before, Beyond::Repeat);
    window.command(Command::SnapKeys);
    let (second, at) = (window.second(), window.key_named("key of Exposure at 20 s"));
    window.drag(at, vec2(3.3 * second, 0.0));
    assert_eq!(window.times("sky/exposure_ev"), [10.0, 23.0, 30.0], "to whole seconds");
    let cloud = Item::Cloud(window.scene().clouds[0].id);
    window.select([cloud]);
    window.ask("Key Opacity");
    window.ask("Key Position");
    assert_eq!(window.scene().tracks.len(), 3);
    window.command(Command::ClearKeys);
    assert_eq!(window.scene().tracks.len(), 1);
    assert_eq!(window.undo_name().as_deref(), Some("Clear all keys"));
}

#[test]
fn a_search_that_finds_no_track_says_so() {
    let mut window = with_exposure();
    window.type_into(Role::TextInput, "Find tracks", "zzz");
    assert!(window.shows("No track matches “zzz”"));
}
