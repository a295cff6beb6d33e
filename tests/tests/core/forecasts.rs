//! Forecasts: their states, one after the other; and skies between stations.

use cloudwright_core::formats::metar::forecast::{self, ExpectedKind};
use cloudwright_core::formats::metar::{self, Report};
use cloudwright_core::reported::{self, Genus, Place, Sky, Told, expected};
use cloudwright_core::scene::Scene;

/// A forecast over several lines, with all kinds of changes.
const TAF: &str = "TAF AMD EDDF 171100Z 1712/1818 24012KT 9999 SCT035 TX18/1714Z TNM02/1806Z
  TEMPO 1713/1716 26018G30KT 4000 SHRA BKN020CB
  BECMG 1718/1720 VRB02KT 3000 BR NSW OVC008
  PROB30 TEMPO 1800/1806 0300 FG VV001
  FM180700 30010KT CAVOK
  BECMG 1816/1818 NSC=";

/// When, from where the wind blows, how far one sees, and what the layers are.
fn told(report: &Report) -> String {
    let wind = report.wind.map_or("?".into(), |wind| format!("{:?} {:.0}", wind.from, wind.speed_mps));
    let seen = report.visibility.map_or(0.0, |visibility| visibility.m);
    let layers: Vec<String> =
        report.layers.iter().map(|layer| format!("{:?}@{:.0}", layer.cover, layer.base_m.unwrap_or(-1.0))).collect();
    format!(
        "{}/{:02}:{:02} {wind}, {seen:.0} m, {}{} weather {}",
        report.day,
        report.hour,
        report.minute,
        layers.join(" "),
        report.clear.map_or(String::new(), |clear| format!("{clear:?}")),
        report.weather.len()
    )
}

#[test]
fn a_forecast_is_read_and_becomes_states() {
    let forecast = forecast::read(TAF).expect("a forecast");
    use ExpectedKind::{At, Becoming, Passing, Perhaps};
    let kinds: Vec<ExpectedKind> = forecast.changes.iter().map(|change| change.kind).collect();
    assert_eq!(kinds, [Passing, Becoming, Perhaps, At, Becoming]);
    let states: Vec<String> = expected(&forecast).iter().map(told).collect();
    let fair = "Deg(240.0) 6, 10000 m, Some(Scattered)@1067 weather 0";
    let dull = "Variable 1, 3000 m, Some(Overcast)@244 weather 1";
    let clear = "Deg(300.0) 5, 10000 m, Cavok weather 0";
    assert_eq!(
        states,
        [
            format!("17/12:00 {fair}"),
            format!("17/18:00 {fair}"),
            format!("17/20:00 {dull}"),
            format!("18/06:30 {dull}"),
            format!("18/07:00 {clear}"),
            format!("18/16:00 {clear}"),
            format!("18/18:00 {}", clear.replace("Cavok", "Nsc")),
            format!("18/18:00 {}", clear.replace("Cavok", "Nsc")),
        ]
    );
}

#[test]
fn a_forecast_that_is_none_is_refused_at_its_group() {
    for (text, group, column) in [
        ("TAF", "", 4),
        ("TAF EDDF", "", 9),
        ("TAF EDDF 171100Z", "", 17),
        ("TAF EDDF 171100Z 1712/17", "1712/17", 18),
        ("TAF EDDF 171100Z 1718/1712 24012KT", "1718/1712", 18),
        ("TAF EDDF 171100Z 1712/1818 24012KT FM1812 CAVOK", "FM1812", 36),
        ("TAF EDDF 171100Z 1712/1818 24012KT BECMG", "", 41),
        ("TAF EDDF 171100Z 1712/1818 24012KT BECMG 1713 CAVOK", "1713", 42),
        ("TAF EDDF 171100Z 1712/1818 24012KT SCT03", "SCT03", 36),
        ("TAF EDDF 171100Z 1712/1818 CNL", "CNL", 28),
        ("TAF EDDF 171100Z NIL", "NIL", 18),
    ] {
        let refused = forecast::read(text).expect_err(text);
        assert_eq!((refused.group.as_str(), refused.column), (group, column), "{text}: {refused}");
    }
    // Over the end of a month, and with hour 24.
    assert!(forecast::read("TAF EDDF 302300Z 3100/0124 24012KT 9999 FEW030").is_ok());
    // A change at the first minute of a month has no half hour before it.
    let first = forecast::read("TAF EDDF 312300Z 3100/0124 24012KT FM010000 30012KT").expect("a forecast");
    let times: Vec<_> = expected(&first).iter().map(|report| (report.day, report.hour)).collect();
    assert_eq!(times, [(31, 0), (1, 0), (1, 0), (1, 24)]);
}

fn sky(groups: &str) -> Sky {
    Sky::of(&metar::read(&format!("EDDF 171320Z {groups}")).expect("a report"), &Scene::default())
}

#[test]
fn between_skies_all_is_a_mean_by_weight() {
    let [west, east] = [sky("35010KT 4000 SCT020 BKN100 20/10"), sky("01030KT 8000 OVC030 10/08")];
    let between = Sky::between(&[(3.0, west), (1.0, east.clone())]).expect("two skies");
    let near = |got: Option<f64>, wanted: f64| assert!((got.expect("known") - wanted).abs() < 1e-9, "{got:?} {wanted}");
    near(between.air.temperature_c, 17.5);
    near(between.air.dew_point_c, 9.5);
    near(between.air.wind_speed_mps, 15.0 * 1852.0 / 3600.0);
    // 10 kt weigh as much three times as 30 kt do once: half way between, through north.
    let from_deg = between.air.wind_from_deg.expect("it blows");
    assert!(from_deg.min(360.0 - from_deg) < 1e-9, "{from_deg}");
    // Heaps are the west's alone, at three quarters of their cover; the closed sheet is the east's alone.
    let layers: Vec<_> = between.layers.iter().map(|layer| (layer.genus, layer.oktas, layer.base_m.round())).collect();
    let wanted = [
        (Genus::Cumulus, 0.75 * 3.5, 610.0),
        (Genus::Stratocumulus, 0.25 * 8.0, 914.0),
        (Genus::Altocumulus, 0.75 * 6.0, 3048.0),
    ];
    assert_eq!(layers, wanted);
    assert_eq!(Sky::between(&[(0.2, east.clone())]), Some(east));
    assert_eq!(Sky::between(&[]), None);
}

#[test]
fn stations_weigh_by_their_distance() {
    // A degree of longitude on the equator is 111.2 km of the Earth's mean circumference.
    let place = |longitude_deg: f64| Place { latitude_deg: 0.0, longitude_deg };
    assert!((place(179.5).km_to(place(-179.5)) - 6371.009_f64.to_radians()).abs() < 1e-6);
    let told = |station: &str, time: &str, celsius: u32, east_deg: f64| Told {
        report: metar::read(&format!("{station} 17{time}Z 24012KT {celsius}/05")).expect("a report"),
        place: Some(place(east_deg)),
    };
    let list = [told("AAAA", "1200", 10, 0.1), told("BBBB", "1230", 20, -0.2), told("AAAA", "1300", 30, 0.1)];
    let skies = reported::skies(&list, place(0.0), &Scene::default()).expect("all have places");
    let warmth: Vec<(f64, f64)> =
        skies.iter().map(|(time_s, sky)| (*time_s, sky.air.temperature_c.expect("told"))).collect();
    // At twice the distance a station weighs a quarter: a fifth of all. Before its first report it says that one.
    for ((time_s, celsius), wanted) in warmth.iter().zip([(0.0, 12.0), (1800.0, 12.0), (3600.0, 28.0)]) {
        assert!(*time_s == wanted.0 && (celsius - wanted.1).abs() < 1e-9, "{warmth:?}");
    }
    let unplaced = Told { place: None, ..list[1].clone() };
    let error = reported::skies(&[list[0].clone(), unplaced], place(0.0), &Scene::default()).expect_err("no place");
    assert!(error.to_string().contains("BBBB"), "{error}");
    // The ninth station does not count, however warm it is there.
    let mut nine: Vec<Told> = (0..8).map(|i| told(&format!("C{i}CC"), "1200", 10, 0.1 + 0.01 * f64::from(i))).collect();
    nine.push(told("DDDD", "1200", 50, 1.0));
    let skies = reported::skies(&nine, place(0.0), &Scene::default()).expect("all have places");
    assert!((skies[0].1.air.temperature_c.expect("told") - 10.0).abs() < 1e-9);
}
