//! What a sky makes of weather reports: layers, the air's values, and how they go on from report to report.

use crate::reports::read;
use cloudwright_core::document::Document;
use cloudwright_core::formats::metar::Report;
use cloudwright_core::reported::{self, Air, Genus, Place, Sky, Told, Unordered, layers};
use cloudwright_core::scene::{Scene, TrackKey};
use std::collections::BTreeMap;

/// Where no station says where it is.
const HERE: Place = Place { latitude_deg: 50.0, longitude_deg: 8.0 };

fn skies(reports: &[Report]) -> Result<Vec<(f64, Sky)>, Unordered> {
    let told: Vec<Told> = reports.iter().map(|report| Told { report: report.clone(), place: None }).collect();
    reported::skies(&told, HERE, &Scene::default())
}

fn take_air(document: &mut Document, reports: &[Report], speed: f64) {
    let told: Vec<Told> = reports.iter().map(|report| Told { report: report.clone(), place: None }).collect();
    let skies = reported::skies(&told, HERE, document.scene()).expect("one station");
    document.begin("Weather from reports");
    reported::take_air(document, &skies, speed).expect("they fit");
    document.commit().expect("a sound scene");
}

/// What holds of every sky that is made of a report.
pub(crate) fn check_sky(report: &Report, scene: &Scene, line: &str) {
    let planned = layers(report);
    for (below, above) in planned.iter().zip(planned.iter().skip(1)) {
        assert!(below.base_m <= above.base_m, "{line}");
    }
    for layer in &planned {
        assert!((0.0..=20_000.0).contains(&layer.base_m) && (1.0..=11_000.0).contains(&layer.thickness_m), "{line}");
        assert!((1.5..=8.0).contains(&layer.oktas), "{line}");
    }
    take_air(&mut Document::new(scene.clone()), std::slice::from_ref(report), 1.0);
    let humidity = Air::of(report, scene).relative_humidity;
    assert!(humidity.is_none_or(|humidity| humidity > 0.0 && humidity <= 1.0), "{line}: {humidity:?}");
}

#[test]
fn layers_have_their_genus_thickness_and_cover() {
    use Genus::*;
    type Row = (&'static str, &'static [(Genus, f64, f64)]);
    let rows: &[Row] = &[
        ("9999 FEW020 18/12", &[(Cumulus, 1.5, 800.0)]),
        ("9999 SCT035 18/12", &[(Cumulus, 3.5, 800.0)]),
        ("9999 BKN035", &[(Stratocumulus, 6.0, 500.0)]),
        ("9999 OVC010", &[(Stratus, 8.0, 300.0)]),
        ("9999 OVC040", &[(Stratocumulus, 8.0, 500.0)]),
        ("4000 RA OVC012", &[(Nimbostratus, 8.0, 3000.0)]),
        ("4000 SHRA OVC030", &[(Stratocumulus, 8.0, 500.0)]),
        ("9999 SCT100", &[(Altocumulus, 3.5, 400.0)]),
        ("9999 OVC120", &[(Altostratus, 8.0, 1500.0)]),
        ("9999 FEW250", &[(Cirrus, 1.5, 800.0)]),
        ("9999 OVC250", &[(Cirrostratus, 8.0, 600.0)]),
        ("9999 SCT030TCU", &[(ToweringCumulus, 3.5, 4000.0)]),
        // To 11 km; the anvil may stand above the altocumulus, which ends nothing.
        ("9999 FEW030CB BKN100", &[(Cumulonimbus, 1.5, 11_000.0 - 914.4), (Altocumulus, 6.0, 400.0)]),
        // Two hundred feet are 60.96 m of room; heaps grow into what is above them.
        ("9999 BKN010 OVC012", &[(Stratocumulus, 6.0, 60.96), (Stratus, 8.0, 300.0)]),
        ("9999 SCT010 BKN012", &[(Cumulus, 3.5, 200.0), (Stratocumulus, 6.0, 500.0)]),
        ("0200 FG VV002", &[(Fog, 8.0, 60.96)]),
        ("0200 FG OVC001", &[(Fog, 8.0, 100.0), (Stratus, 8.0, 300.0)]),
        ("9999 MIFG NSC", &[(Fog, 8.0, 2.0)]),
        ("9999 BCFG NSC", &[(Fog, 4.0, 50.0)]),
        ("9999 VCFG NSC", &[]),
        ("0800 +SN VV005", &[(Nimbostratus, 8.0, 3000.0)]),
        ("CAVOK", &[]),
        ("9999 ///015 //////", &[]),
        ("9999 //////CB 20/10", &[(Cumulonimbus, 1.5, 9750.0)]),
    ];
    for (groups, wanted) in rows {
        let report = read(&format!("EDDF 171320Z 24012KT {groups}"));
        let planned = layers(&report);
        let got: Vec<_> = planned.iter().map(|layer| (layer.genus, layer.oktas, layer.thickness_m)).collect();
        assert_eq!(got.len(), wanted.len(), "{groups}: {got:?}");
        for (got, wanted) in got.iter().zip(*wanted) {
            assert_eq!((got.0, got.1), (wanted.0, wanted.1), "{groups}");
            assert!((got.2 - wanted.2).abs() < 1e-6, "{groups}: {got:?}");
        }
    }
}

#[test]
fn air_becomes_properties() {
    let mut scene = Scene::default();
    scene.site.utc_offset_h = 5.5;
    scene.sky.haze_length_m = 20_000.0;
    let air = |groups: &str| Air::of(&read(&format!("VIDP 172130Z {groups}")), &scene);
    let foggy = air("24010KT 0391 FG 10/10 Q1010");
    // Magnus at its own dew point, Koschmieder by hand, and 21:30 and five and a half hours.
    assert!(foggy.relative_humidity == Some(1.0) && (foggy.time_of_day_h - 3.0).abs() < 1e-12);
    assert!((foggy.haze_length_m.expect("seen") - 391.0 / 3.912).abs() < 1e-9);
    let names: Vec<_> = foggy.values().iter().map(|value| value.0).collect();
    assert_eq!(names.len(), 6, "{names:?}");
    let fair = air("00000KT 9999 NSC 20/09 Q1010");
    assert_eq!((fair.wind_from_deg, fair.wind_speed_mps, fair.haze_length_m), (None, Some(0.0), Some(20_000.0)));
    // Over water at 20 °C and 9 °C, 23.39 and 11.48 hPa (CRC Handbook): 49.1 %. The formula keeps within 0.4 %.
    assert!((fair.relative_humidity.expect("known") - 11.48 / 23.39).abs() < 0.008 * 0.491);
    assert_eq!(air("/////KT ////").values().len(), 1);
    // Rounded apart.
    assert_eq!(air("00000KT 9999 10/11").dew_point_c, Some(10.0));
}

#[test]
fn reports_of_a_station_stand_in_order_across_a_month() {
    let lines = ["EDDF 010020Z 24010KT", "EDDF 302320Z 24010KT", "EDDF 302350Z 24010KT", "EDDF 302350Z COR 25010KT"];
    let reports: Vec<Report> = lines.iter().map(|line| read(line)).collect();
    let timed = skies(&reports).expect("one station");
    let times: Vec<f64> = timed.iter().map(|(time_s, _)| *time_s).collect();
    assert_eq!(times, [0.0, 1800.0, 3600.0]);
    assert_eq!(timed[1].1.air.wind_from_deg, Some(250.0), "the correction holds");
    let strange = [reports[0].clone(), read("EDDM 010020Z")];
    assert!(skies(&strange).is_err_and(|error| error.to_string().contains("2 stations, and none says where EDDF")));
    assert_eq!(skies(&[]), Err(Unordered::None));
}

/// Values pass through every report, with one slope on either side, and leave no bound between two.
#[test]
fn the_sky_steps_at_no_report() {
    use cloudwright_core::property::Target;
    use cloudwright_core::weather::Curve;
    let lines = [
        "EDDF 172100Z 35010KT 9999 NSC 18/10 Q1010",
        "EDDF 172300Z 01020KT 5000 BR OVC010 14/13 Q1008",
        "EDDF 180100Z VRB02KT 0400 FG VV001 12/12 Q1007",
        "EDDF 180300Z 20008KT //// ////// ///// Q////",
        "EDDF 180500Z 22012KT 9999 SCT020 16/12 Q1011",
    ];
    let reports: Vec<Report> = lines.iter().map(|line| read(line)).collect();
    let mut scene = Scene::default();
    // Its midnight lies between two reports.
    scene.site.utc_offset_h = 1.0;
    let mut document = Document::new(scene);
    take_air(&mut document, &reports, 600.0);
    // Again, they take the tracks' places.
    take_air(&mut document, &reports, 600.0);
    let scene = document.scene();
    assert_eq!(scene.tracks.len(), 6);
    let count = BTreeMap::from([("weather/wind_from_deg", 4), ("sky/haze_length_m", 4), ("time_of_day_h", 5)]);
    for track in scene.tracks.iter() {
        if let Some(count) = count.get(track.property.as_str()) {
            assert_eq!(track.keys.len(), *count, "{}", track.property);
        }
        let curve = Curve::of(track, &track.property.parse::<Target>().expect("a property"));
        // A cubic that does not overshoot has slopes of three times the steepest chord at most (Fritsch and Carlson).
        let chord = |pair: &[TrackKey]| {
            let [from, to] = [&pair[0], &pair[1]].map(|key| (key.time_s, curve.at(key.time_s, 0)));
            ((to.1 - from.1) / (to.0 - from.0)).abs()
        };
        let steepest = track.keys.windows(2).map(chord).fold(0.0, f64::max);
        for key in &track.keys {
            let tiny = 1e-4;
            let jump = (curve.at(key.time_s + tiny, 0) - curve.at(key.time_s - tiny, 0)).abs();
            let most = 2.0 * tiny * 3.0 * steepest + 1e-9;
            assert!(jump <= most, "{} jumps by {jump} at {}, {most} at most", track.property, key.time_s);
        }
    }
    let hours = scene.tracks.iter().find(|track| track.property == "time_of_day_h").expect("keyed");
    let end = hours.keys.last().expect("keys");
    assert!((end.time_s - 48.0).abs() < 1e-9, "eight hours, 600 times as fast");
    assert!((end.value.parts()[0] - 30.0).abs() < 1e-9, "the hour runs on: {:?}", end.value);
}
