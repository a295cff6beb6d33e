//! Weather from a report, pasted: what is understood while it is typed, a sky that is only shown, one undo point or nothing.

use crate::Window;
use cloudwright::command::Command;
use cloudwright::reports::{MOST_TIME, Making, make, reading};
use cloudwright_core::document::Document;
use cloudwright_core::scene::Scene;
use cloudwright_scripts::Patience;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;
use std::time::{Duration, Instant};

const NAME: &str = "Weather from a report";
const NOON: &str = "EDDF 171220Z 24012KT 9999 FEW040 18/09 Q1015";
const LATER: &str = "EDDF 171320Z 25014KT 9999 SCT045 20/08 Q1014";

impl Window {
    /// Opens the question as its menu does, and pastes `text` in place of what stands there.
    fn paste_reports(&mut self, text: &str) {
        if self.harness.query_by_role_and_label(Role::MultilineTextInput, "Reports").is_none() {
            self.command(Command::WeatherReport);
        }
        if !self.node(Role::MultilineTextInput, "Reports").is_focused() {
            self.node(Role::MultilineTextInput, "Reports").focus();
            self.settle();
        }
        self.keys(Modifiers::COMMAND, Key::A);
        self.harness.event(Event::Paste(text.into()));
        self.settle();
    }

    fn shows_any(&self, words: &str) -> bool {
        self.harness.query_all_by_label_contains(words).next().is_some()
    }

    fn wait_for_sky(&mut self) {
        self.wait("a sky", |window| window.shows("Measured"));
    }
}

/// The scene with the sky of `text`, made without a window.
fn made_of(scene: &Scene, text: &str) -> Scene {
    let told = reading::told(&reading::lines(text).expect("reports")).expect("all can be read");
    let making = Making { speed: 600.0, seed: 1, keeps_clouds: false, moves_site: true, date: None };
    let mut document = Document::new(scene.clone());
    let until = Some(Instant::now() + MOST_TIME);
    make(&mut document, &told, &making, &Patience { until, ..Patience::usual() }).expect("a sky");
    document.scene().clone()
}

#[test]
fn a_pasted_report_becomes_a_sky_in_one_undo_point() {
    let mut window = Window::open();
    window.settle();
    let (start, scene) = (window.file(), window.scene().clone());
    window.press("Plugins");
    window.press("Weather from a report…");
    assert!(window.node(Role::MultilineTextInput, "Reports").is_focused(), "to be typed in at once");
    window.paste_reports(NOON);
    assert!(window.shows("EDDF on the 17th at 12:20 UTC"));
    assert!(window.shows("wind from 240° 22 km/h · visibility 10.0 km or more · FEW (1 to 2 oktas) at 1219 m"));
    let mut frames = 0;
    while !window.shows("Measured") {
        window.harness.step();
        frames += 1;
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(frames > 3, "{frames} frames went on while it was made");
    assert_eq!(window.undo_name(), None, "it is only shown");
    assert!(window.shows("cumulus at 1\u{202F}219 m") && window.shows_any("1.5 oktas"), "with what it covers");
    window.press("OK");
    assert_eq!(window.undo_name().as_deref(), Some(NAME));
    assert!(window.shows("The sky as reported: cumulus 1.") && !window.shows("Measured"));
    assert_eq!(window.scene(), &made_of(&scene, NOON), "the same as without a window");
    assert!(!window.scene().clouds.is_empty() && window.scene().weather.wind_speed_mps > 6.0);
    assert_ne!(window.scene().site, scene.site, "it has moved there");
    window.command(Command::Undo);
    assert_eq!((window.file(), window.undo_name()), (start, None));
}

#[test]
fn what_is_no_report_makes_nothing_and_says_which_group() {
    let mut window = Window::open();
    window.settle();
    let start = window.file();
    window.paste_reports(NOON);
    window.wait_for_sky();
    assert_ne!(window.file(), start);
    for (text, said) in [
        ("EDDF 171220Z 24012KT 9999 FEW040 XYZ\n", "column 34: “XYZ” can't be read"),
        (&format!("{NOON}\nEDDF 171320Z 99999KT"), "report in line 2, column 14: “99999KT” can't be read"),
        ("[{\"name\": 7}]", "a report has neither rawOb nor rawTAF"),
        ("{", "it is no JSON"),
        ("the weather is fine", "column 1: “THE” can't be read"),
    ] {
        window.paste_reports(text);
        assert!(window.shows(said), "{text}: {said}");
        assert_eq!(window.file(), start, "{text}: the sky is gone");
        window.press("OK");
        assert!(window.shows(said), "{text}: there is nothing to be done");
    }
    // A line to be passed over.
    window.paste_reports("# later");
    assert!(!window.shows("can't be read"));
    window.press("Cancel");
    assert_eq!((window.file(), window.undo_name()), (start, None));
}

#[test]
fn reports_of_several_times_become_keys() {
    let mut window = Window::open();
    window.settle();
    window.paste_reports(&format!("{NOON}\n{LATER}"));
    window.wait_for_sky();
    window.set("Speed", 1200.0);
    window.press("OK");
    window.wait("it is done", |window| window.undo_name().as_deref() == Some(NAME));
    let tracks = &window.scene().tracks;
    let wind = tracks.iter().find(|track| track.property.contains("wind_speed")).expect("the wind is keyed");
    let times: Vec<f64> = wind.keys.iter().map(|key| key.time_s).collect();
    assert_eq!(times, [0.0, 3.0], "an hour at that speed");
    assert!(tracks.iter().any(|track| track.property.contains("/formed/")), "more clouds form");
    // What was chosen is there again.
    window.command(Command::WeatherReport);
    assert!(window.shows("EDDF on the 17th at 13:20 UTC"));
    assert_eq!(window.node(Role::SpinButton, "Speed").value().as_deref(), Some("1200 ×"));
}

#[test]
fn several_stations_have_to_be_somewhere() {
    let mut window = Window::open();
    window.settle();
    window.paste_reports(&format!("{NOON}\nEDDK 171220Z 20005KT 9999 FEW030 18/09 Q1015"));
    window.wait("the fault", |window| window.shows("reports of 2 stations, and none says where EDDF is"));
    for (station, place) in [("EDDF", "50.03, 8.57"), ("EDDK", "50.87")] {
        let field = format!("{station} is at");
        window.node(Role::TextInput, &field).focus();
        window.settle();
        window.node(Role::TextInput, &field).type_text(place);
        window.keys(Modifiers::NONE, Key::Enter);
    }
    assert!(window.shows("write 50.03, 8.57"), "a place has two numbers");
    window.node(Role::TextInput, "EDDK is at").focus();
    window.settle();
    window.node(Role::TextInput, "EDDK is at").type_text(", 7.14");
    window.keys(Modifiers::NONE, Key::Enter);
    window.wait_for_sky();
    window.press("OK");
    let site = &window.scene().site;
    assert!((site.latitude_deg - 50.45).abs() < 1e-9 && (site.longitude_deg - 7.855).abs() < 1e-9, "{site:?}");
}

#[test]
fn clouds_may_stay_and_another_seed_is_another_sky() {
    let mut window = Window::open();
    window.settle();
    let clouds = window.scene().clouds.len();
    let first = window.scene().clouds[0].id;
    window.paste_reports(NOON);
    window.wait_for_sky();
    assert!(window.scene().clouds.iter().all(|cloud| cloud.id != first));
    window.node(Role::CheckBox, "Keep the clouds that stand").click();
    window.wait("they stand", |window| window.scene().clouds.iter().any(|cloud| cloud.id == first));
    assert!(window.scene().clouds.len() > clouds);
    let before = window.file();
    window.press("Re-roll Seed");
    window.wait("another sky", |window| window.session().document().is_open() && window.file() != before);
    assert!(window.scene().clouds.iter().any(|cloud| cloud.id == first));
}

#[test]
fn escape_ends_the_typing_and_then_the_question() {
    let mut window = Window::open();
    window.settle();
    let start = window.file();
    window.paste_reports(NOON);
    window.wait_for_sky();
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(window.shows("Measured"));
    window.keys(Modifiers::NONE, Key::Escape);
    assert!(!window.shows("Measured"));
    assert_eq!((window.file(), window.undo_name()), (start, None));
}

#[test]
fn what_is_changed_meanwhile_stays() {
    let mut window = Window::open();
    window.settle();
    let cameras = window.scene().cameras.len();
    // Before a sky is shown, it is made for what there is then.
    window.paste_reports(NOON);
    window.command(Command::AddCamera);
    window.wait_for_sky();
    assert_eq!(window.scene().cameras.len(), cameras + 1);
    // What is shown when something else is changed was meant.
    window.command(Command::AddCamera);
    assert!(!window.shows("Measured"));
    assert_eq!(window.scene().cameras.len(), cameras + 2);
    window.command(Command::Undo);
    assert_eq!(window.undo_name().as_deref(), Some(NAME));
    window.command(Command::Undo);
    assert_eq!(window.scene().cameras.len(), cameras + 1);
}
