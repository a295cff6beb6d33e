//! Weather presets of Microsoft Flight Simulator: five real ones, and what our scenes become.

use super::{arrived, left, left_at};
use cloudwright_core::derived::Derived;
use cloudwright_core::exchange::Content;
use cloudwright_core::formats::wpr::{CloudLayer, Gust, NOWHERE_M, Preset, WindLayer, Wpr};
use cloudwright_core::formats::xml::{self, Element, Node};
use cloudwright_core::measure::{Observer, sky_cover};
use cloudwright_core::reported::{Genus, Sky};
use cloudwright_core::scene::{KeyValue, Scene, Track, TrackId, TrackKey};
use cloudwright_tests::root;
use cloudwright_tests::small_scenes::{crowd, heap};

/// The five, with their names.
pub(super) fn real() -> Vec<(String, Vec<u8>)> {
    let folder = root().join("tests/wpr");
    let names = ["Fog", "Soaring-Ridge", "Thunderstorms", "Windy", "X-Hurricane-KMIA"];
    let read = |name: &str| std::fs::read(folder.join(format!("{name}.WPR"))).expect("a preset");
    names.iter().map(|name| ((*name).into(), read(name))).collect()
}

/// All names, values, texts and comments of a file, in their order.
fn values(bytes: &[u8]) -> Vec<String> {
    fn walk(element: &Element, found: &mut Vec<String>) {
        found.push(element.name.clone());
        found.extend(element.attributes.iter().map(|(name, value)| format!("{name}={value}")));
        for node in &element.children {
            match node {
                Node::Element(child) => walk(child, found),
                Node::Text(text) => found.push(text.clone()),
                Node::Comment(words) => found.push(format!("# {words}")),
            }
        }
        found.push("end".into());
    }
    let mut found = Vec::new();
    walk(&xml::read(bytes).expect("XML"), &mut found);
    found
}

#[test]
fn real_presets_keep_all_their_values() {
    for (name, bytes) in real() {
        let wpr = Wpr::read(&bytes).expect("sound");
        let written = wpr.write();
        assert_eq!(values(&written), values(&bytes), "{name}");
        assert!(written.starts_with("\u{feff}<?xml".as_bytes()) && written.windows(4).any(|four| four == b"\r\n\r\n"));
        let (was, is) = (wpr.preset(), Wpr::read(&written).and_then(|wpr| wpr.preset()));
        assert_eq!(was, is, "{name}");
    }
}

#[test]
fn a_preset_is_understood() {
    let storm = Wpr::read(&real()[2].1).and_then(|wpr| wpr.preset()).expect("sound");
    assert_eq!((storm.name.as_str(), storm.image.as_str()), ("DNBOF - Thunderstorms", "storm"));
    assert_eq!((storm.pressure_pa, storm.thunderstorm, storm.above_ground), (Some(101_325.0), Some(0.85), true));
    assert_eq!((storm.clouds.len(), storm.winds.len(), storm.unknown.len()), (3, 2, 0));
    let first = CloudLayer { coverage: 0.28, density: 1.0, scattering: 0.0, bottom_m: 1000.0, top_m: NOWHERE_M };
    assert_eq!(storm.clouds[0], first);
    let gust = Gust { from_deg: 245.0, speed_kt: 35.0, interval_s: 30.0, duration_s: 2.0 };
    let wind = WindLayer { altitude_m: 0.0, from_deg: 225.0, speed_kt: 20.0, gust: Some(gust) };
    assert_eq!(storm.winds[0], wind);
    assert_eq!(Wpr::of(&storm).preset(), Ok(storm));
    let hurricane = Wpr::read(&real()[4].1).and_then(|wpr| wpr.preset()).expect("sound");
    assert_eq!(hurricane.unknown, ["Hurricane"]);
}

#[test]
fn presets_become_skies_by_the_table_of_reports() {
    let scene = Scene::default();
    for ((name, bytes), wanted) in real().iter().zip([
        &[(Genus::Fog, 0.0, 8.0)][..],
        &[(Genus::Cumulus, 1524.0, 3.2)],
        &[(Genus::Cumulonimbus, 1000.0, 2.24), (Genus::Cirrus, 8200.0, 1.84), (Genus::Cirrostratus, 10_600.0, 4.8)],
        &[],
        &[],
    ]) {
        let preset = Wpr::read(bytes).and_then(|wpr| wpr.preset()).expect("sound");
        let sky = Sky::of_preset(&preset, &scene);
        let made: Vec<(Genus, f64, f64)> = sky.layers.iter().map(|l| (l.genus, l.base_m, l.oktas)).collect();
        assert_eq!(made.len(), wanted.len(), "{name}: {made:?}");
        for (made, wanted) in made.iter().zip(wanted) {
            assert!(
                made.0 == wanted.0 && (made.1 - wanted.1).abs() < 1e-9 && (made.2 - wanted.2).abs() < 1e-9,
                "{name}: {made:?}"
            );
        }
        let speed = preset.winds[0].speed_kt * 1852.0 / 3600.0;
        assert!(sky.air.wind_speed_mps.is_some_and(|mps| (mps - speed).abs() < 1e-9), "{name}");
        assert_eq!(sky.air.time_of_day_h, scene.time_of_day_h, "{name}");
    }
    let Ok(hurricane) = arrived(&real()[4].1, "a.WPR", &[]) else { panic!("refused") };
    let said: Vec<String> = hurricane.notes.iter().map(ToString::to_string).collect();
    assert!(said.iter().any(|note| note.contains("Hurricane")), "{said:?}");
    assert!(said.iter().any(|note| note.contains("gusts, winds above the lowest")), "{said:?}");
}

fn preset_of(bytes: &[u8]) -> Preset {
    Wpr::read(bytes).and_then(|wpr| wpr.preset()).expect("sound")
}

#[test]
fn a_scene_becomes_what_is_measured_of_it() {
    let mut scene = crowd(400);
    scene.weather.wind_from_deg = -90.0;
    scene.weather.wind_speed_mps = 10.0;
    let preset = preset_of(&left(&scene, "sky.WPR", &[]));
    let derived = Derived::new(&scene);
    let covered = sky_cover(&scene, &derived, &Observer::default(), |_| true).covered;
    let [layer, none, nor] = preset.clouds[..] else { panic!("{:?}", preset.clouds) };
    assert!((layer.coverage - covered).abs() < 6e-4, "{layer:?}, {covered}");
    assert!(covered > 0.01, "there is something to measure: {covered}");
    assert!(layer.bottom_m < 1200.0 && layer.top_m > 1200.0 && layer.top_m - layer.bottom_m < 500.0, "{layer:?}");
    assert_eq!((none.coverage, none.bottom_m, nor), (0.0, NOWHERE_M, none));
    let wind = &preset.winds[0];
    assert!((wind.from_deg - 270.0).abs() < 1e-9 && (wind.speed_kt - 19.438).abs() < 1e-9, "{wind:?}");
    assert!(preset.temperature_k.is_some_and(|kelvin| (kelvin - 288.15).abs() < 1e-9));
    assert_eq!((preset.name.as_str(), preset.above_ground), ("crowd", false));
}

#[test]
fn bases_that_lie_apart_are_layers() {
    let mut scene = crowd(60);
    for (index, y) in (0..60).zip([800.0, 900.0, 3000.0, 6000.0, 6100.0].into_iter().cycle()) {
        scene.clouds.get_mut(index).expect("there").position.y = y;
    }
    let preset = preset_of(&left(&scene, "sky.WPR", &[]));
    let bases: Vec<bool> =
        preset.clouds.iter().zip([850.0, 3000.0, 6050.0]).map(|(l, y)| (l.bottom_m - y).abs() < 200.0).collect();
    assert_eq!(bases, [true; 3], "{:?}", preset.clouds);
}

#[test]
fn each_key_has_a_preset_and_what_is_too_much_is_cut() {
    let mut scene = heap(30);
    let id = TrackId::new(&mut scene.next_id);
    let keys = [(0.0, 5.0), (30.0, 200.0)].map(|(time_s, mps)| TrackKey::new(time_s, KeyValue::One(mps)));
    scene.tracks.push(Track::new(id, "weather/wind_speed_mps", keys.to_vec()));
    let (files, notes) = left_at(&scene, "day.WPR", &[("each_key", "yes")], 0.0).expect("they leave");
    let speeds: Vec<f64> = files.iter().map(|(_, bytes)| preset_of(bytes).winds[0].speed_kt).collect();
    assert_eq!(files.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["day.WPR", "day_2.WPR"]);
    assert!((speeds[0] - 9.719).abs() < 1e-9 && (speeds[1] - 150.0).abs() < 1e-9, "{speeds:?}");
    assert!(notes.iter().any(|note| note.to_string().ends_with("kt is cut to 150, the simulator's most")), "{notes:?}");
    let at_end = left_at(&scene, "day.WPR", &[], 15.0).expect("it leaves");
    let speed = preset_of(&at_end.0[0].1).winds[0].speed_kt;
    assert!(speed > 10.0 && speed <= 150.0, "{speed}");
}

#[test]
fn what_is_broken_is_told_with_its_line() {
    let sound = String::from_utf8(real()[0].1.clone()).expect("text");
    for (from, to, wanted) in [
        ("101325.000", "NaN", "line 12: MSLPressure: “NaN” is no number"),
        ("Unit=\"pa\"", "Unit=\"hPa\"", "line 12: MSLPressure: its unit is “hPa”; the simulator's is pa"),
        ("Value=\"288.150\"", "", "line 13: MSLTemperature: it has no Value"),
        ("SimBase.Document", "Sim", "line 3: Sim: it is no weather preset"),
        ("<Order>", "<Order", "line "),
        ("</WeatherPreset.Preset>", "", "line "),
    ] {
        let broken = sound.replace(from, to);
        let error = arrived(broken.as_bytes(), "a.WPR", &[]).expect_err(from).to_string();
        assert!(error.contains(wanted), "“{error}”, not “{wanted}”");
    }
    let Ok(sound) = arrived(sound.as_bytes(), "a.WPR", &[]) else { panic!("refused") };
    assert!(matches!(sound.content, Content::Weather(_)));
}
