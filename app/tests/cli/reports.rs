//! `cloudwright weather`: reports into scenes.

use crate::Place;
use serde_json::Value;

const FAIR: &str = "EDDF 171320Z 24012KT 9999 SCT035 BKN120 18/09 Q1015";
const DAY: &str = "# a day
EDDF 170600Z 20004KT 0400 FG VV001 08/08 Q1018

EDDF 171200Z 24012KT 9999 SCT035 18/09 Q1015
EDDF 172000Z 30020G35KT 6000 SHRA FEW020CB BKN035 13/11 Q1011
";

fn json(bytes: &[u8]) -> Value {
    serde_json::from_slice(bytes).expect("JSON")
}

#[test]
fn a_report_sets_the_air_and_places_its_clouds() {
    let place = Place::new();
    let ran = place.run_words(&["weather", "--metar", FAIR, "good.cloudscene", "-o", "out.cloudscene"]);
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{}", ran.stderr);
    for wanted in ["cumulus, base 1067 m", "where 3.5 are asked for", "altocumulus, base 3658 m", "where 6 are"] {
        assert!(ran.stderr.contains(wanted), "no “{wanted}” in: {}", ran.stderr);
    }
    let written = json(&place.read("out.cloudscene"));
    let weather = &written["scene"]["weather"];
    assert_eq!(
        ["wind_from_deg", "temperature_c", "dew_point_c"].map(|name| weather[name].as_f64()),
        [Some(240.0), Some(18.0), Some(9.0)]
    );
    assert!((weather["wind_speed_mps"].as_f64().expect("set") - 12.0 * 1852.0 / 3600.0).abs() < 1e-9);
    assert_eq!(place.run("check out.cloudscene").code, 0);
    // The clouds that were there have gone, or stay.
    let before: Value = serde_json::from_str(&crate::scenes::good()).expect("JSON");
    let name = before["scene"]["clouds"][0]["name"].as_str().expect("a name").to_owned();
    let has = |scene: &Value| scene["scene"]["clouds"].as_array().expect("clouds").iter().any(|c| c["name"] == name);
    assert!(!has(&written));
    let words = ["weather", "--metar", FAIR, "good.cloudscene", "-o", "kept.cloudscene", "--keep-clouds"];
    assert_eq!(place.run_words(&words).code, 0);
    assert!(has(&json(&place.read("kept.cloudscene"))));
}

/// Without a scene, a new one at the station's place, by its name roughly: Sydney's noon is no midnight.
#[test]
fn a_new_scene_is_where_the_station_is() {
    let place = Place::new();
    let metar = "YSSY 170200Z 24012KT 9999 FEW035 18/09 Q1015";
    for (more, site, hour) in
        [(&[][..], [-26.0, 135.0, 9.0], 11.0), (&["--place", "yssy=-33.95,151.18"], [-33.95, 151.18, 10.0], 12.0)]
    {
        let words = [&["weather", "--metar", metar, "-o", "new.cloudscene", "--force"][..], more].concat();
        let ran = place.run_words(&words);
        assert_eq!(ran.code, 0, "{}", ran.stderr);
        let scene = &json(&place.read("new.cloudscene"))["scene"];
        let told = ["latitude_deg", "longitude_deg", "utc_offset_h"].map(|name| scene["place"][name].as_f64());
        assert_eq!(told, site.map(Some));
        assert_eq!(scene["time_of_day_h"].as_f64(), Some(hour));
        assert_eq!(place.run("check new.cloudscene").code, 0);
    }
}

#[test]
fn reports_become_tracks() {
    let place = Place::new();
    place.put("day.txt", DAY.as_bytes());
    let ran = place.run("weather --file day.txt good.cloudscene -o out.cloudscene --speed 3600");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(ran.stderr.contains("3 times became tracks"), "{}", ran.stderr);
    let scene = json(&place.read("out.cloudscene"));
    let tracks = scene["scene"]["tracks"].as_array().expect("tracks");
    let (clouds, air): (Vec<_>, Vec<_>) =
        tracks.iter().partition(|track| track["property"].as_str().is_some_and(|name| name.starts_with("cloud/")));
    assert_eq!(air.len(), 6);
    let times = |track: &Value| -> Vec<f64> {
        let keys = track["keys"].as_array().expect("keys").iter();
        keys.map(|key| key["time_s"].as_f64().expect("a time")).collect()
    };
    for track in &air {
        assert_eq!(times(track), [0.0, 6.0, 14.0], "{}", track["property"]);
    }
    // Heaps come at noon and go, the tower and the deck come in the evening; nothing steps.
    let shares = |track: &Value| -> Vec<f64> {
        let keys = track["keys"].as_array().expect("keys").iter();
        keys.filter_map(|key| key["value"].as_f64()).collect()
    };
    let formed: Vec<_> = clouds.iter().filter(|track| track["property"].to_string().contains("formed/core")).collect();
    assert!(formed.iter().all(|track| times(track) == [0.0, 6.0, 14.0]));
    for wanted in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        assert!(formed.iter().any(|track| shares(track) == wanted), "none is there at {wanted:?}");
    }
    assert_eq!(place.run("check out.cloudscene").code, 0);
}

/// As measured from below, each layer alone, within half an okta of its group.
#[test]
fn layers_cover_what_their_groups_say() {
    let place = Place::new();
    for (groups, wanted) in [
        ("9999 FEW040", &[[1.0, 2.0]][..]),
        ("9999 SCT035 BKN120", &[[3.0, 4.0], [5.0, 7.0]]),
        ("9999 OVC020", &[[8.0, 8.0]]),
        ("6000 TSRA FEW030CB BKN060", &[[1.0, 2.0], [5.0, 7.0]]),
        ("9999 FEW012 SCT250", &[[1.0, 2.0], [3.0, 4.0]]),
    ] {
        let metar = format!("EDDF 171320Z 24012KT {groups} 18/09 Q1015");
        let ran = place.run_words(&["weather", "--json", "--metar", &metar]);
        assert_eq!((ran.code, ran.stderr.as_str()), (0, ""), "{groups}");
        let answer = json(ran.stdout.as_bytes());
        let layers = answer["layers"].as_array().expect("layers");
        assert_eq!(layers.len(), wanted.len(), "{groups}");
        for (layer, [fewest, most]) in layers.iter().zip(wanted) {
            let measured = layer["covers"][0]["measured_oktas"].as_f64().expect("measured");
            let near = fewest - 0.5..=most + 0.5;
            assert!(near.contains(&measured), "{groups}: {measured} oktas of {}", layer["genus"]);
            assert!(!layer["clouds"].as_array().expect("ids").is_empty());
        }
    }
}

#[test]
fn json_has_each_report_or_the_group_that_could_not_be_read() {
    let place = Place::new();
    place.put("day.txt", format!("{DAY}EDDF 172020Z 3002KT\n").as_bytes());
    let ran = place.run("weather --file day.txt --json");
    assert_eq!((ran.code, ran.stderr.as_str()), (2, ""));
    let answer = json(ran.stdout.as_bytes());
    let reports = answer["reports"].as_array().expect("reports");
    assert_eq!(reports.len(), 4);
    assert_eq!(reports[2]["reports"][0]["layers"][0]["kind"], "CB");
    assert_eq!(reports[3]["refused"]["group"], "3002KT");
    assert_eq!((&reports[3]["refused"]["column"], &reports[3]["line"]), (&14.into(), &6.into()));
    assert!(answer.get("layers").is_none(), "no sky is made of a part");
    place.put("day.txt", DAY.as_bytes());
    let ran = place.run("weather --file day.txt --json --speed 3600");
    let answer = json(ran.stdout.as_bytes());
    assert_eq!(answer["skies"][0]["layers"][0]["genus"], "fog");
    assert_eq!(answer["skies"][2]["layers"][0]["genus"], "cumulonimbus");
    assert_eq!(answer["skies"][2]["time_s"], 14.0);
}

/// A forecast over several lines, and a service's JSON with two stations' places.
#[test]
fn forecasts_and_a_services_answer_are_read() {
    let place = Place::new();
    place.put("taf.txt", b"TAF EDDF 171100Z 1712/1718 24012KT 9999 FEW035\n  BECMG 1714/1716 BKN030\n");
    let ran = place.run("weather --file taf.txt -o taf.cloudscene");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(ran.stderr.contains("4 times became tracks"), "{}", ran.stderr);
    let service = r#"[
        {"rawOb": "EDDF 171220Z 24012KT 9999 NSC 18/09", "lat": 50.03, "lon": 8.57,
         "reportTime": "2026-05-17T12:20:00.000Z"},
        {"rawOb": "EDFM 171220Z 24012KT 9999 NSC 14/09", "lat": 49.47, "lon": 8.51}
    ]"#;
    place.put("two.json", service.as_bytes());
    let ran = place.run("weather --file two.json -o two.cloudscene");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    let scene = &json(&place.read("two.cloudscene"))["scene"];
    // Half way between two stations both weigh the same.
    assert!((scene["weather"]["temperature_c"].as_f64().expect("set") - 16.0).abs() < 0.01);
    assert!((scene["place"]["latitude_deg"].as_f64().expect("set") - 49.75).abs() < 1e-9);
    assert_eq!(scene["place"]["date"], "2026-05-17");
    for (text, wanted) in [
        ("[{\"raw\": 1}]", "neither rawOb nor rawTAF"),
        ("[{", "no JSON"),
        ("[{\"rawOb\": \"EDDF 171220Z 2402KT\"}]", "2402KT"),
    ] {
        place.put("bad.json", text.as_bytes());
        place.refuses("weather --file bad.json -o out.cloudscene", 2, &["bad.json", wanted]);
    }
}

#[test]
fn refusals_leave_nothing() {
    let place = Place::new();
    place.put("day.txt", DAY.as_bytes());
    place.put("day.cloudscene", DAY.as_bytes());
    place.put("bad.txt", format!("{DAY}EDDF 172020Z 3002KT\n").as_bytes());
    place.put("two.txt", b"EDDF 171200Z 24012KT\nEDDM 171220Z 24012KT\n");
    place.put("empty.txt", b"# nothing\n\n");
    place.put("bytes.txt", b"EDDF \xff\xfe");
    let out = "-o out.cloudscene";
    let rows: &[(&str, &[&str])] = &[
        (&format!("weather --file bad.txt {out}"), &["bad.txt:6", "column 14", "“3002KT”", "24012G25KT"]),
        (&format!("weather --file two.txt {out}"), &["2 stations", "EDDF", "--place"]),
        (&format!("weather --file two.txt {out} --place EDDF"), &["EDDF=50.03,8.57"]),
        (&format!("weather --file empty.txt {out}"), &["there is no report"]),
        (&format!("weather --file bytes.txt {out}"), &["UTF-8"]),
        (&format!("weather --file none.txt {out}"), &["none.txt"]),
        (&format!("weather --metar EDDF {out}"), &["--metar: column 5", "ends before"]),
        (&format!("weather --file day.txt {out} --speed 0"), &["1 to 86400"]),
        (&format!("weather --file day.txt {out} --speed NaN"), &["1 to 86400"]),
        (&format!("weather --file day.txt --metar EDDF {out}"), &["cannot be used with"]),
        (&format!("weather {out}"), &["--metar"]),
        ("weather --file day.txt", &["--output"]),
        ("weather --file day.txt -o out.json", &[".cloudscene"]),
        ("weather --file day.txt none.cloudscene -o out.cloudscene", &["none.cloudscene"]),
        ("weather --file day.txt good.cloudscene -o good.cloudscene --force", &["that is the scene itself"]),
        ("weather --file day.cloudscene -o day.cloudscene --force", &["those are the reports"]),
        ("weather --file day.txt -o good.cloudscene", &["good.cloudscene", "already", "--force"]),
    ];
    for (words, wanted) in rows {
        place.refuses(words, 2, wanted);
    }
}
