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
fn a_report_sets_the_air() {
    let place = Place::new();
    let ran = place.run_words(&["weather", "--metar", FAIR, "good.cloudscene", "-o", "out.cloudscene"]);
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{}", ran.stderr);
    for wanted in ["cumulus, base 1067 m", "3.5 of 8 oktas", "altocumulus, base 3658 m", "by hand"] {
        assert!(ran.stderr.contains(wanted), "no “{wanted}” in: {}", ran.stderr);
    }
    let weather = &json(&place.read("out.cloudscene"))["scene"]["weather"];
    assert_eq!(
        ["wind_from_deg", "temperature_c", "dew_point_c"].map(|name| weather[name].as_f64()),
        [Some(240.0), Some(18.0), Some(9.0)]
    );
    assert!((weather["wind_speed_mps"].as_f64().expect("set") - 12.0 * 1852.0 / 3600.0).abs() < 1e-9);
    assert_eq!(place.run("check out.cloudscene").code, 0);
    // Without a scene, into a new one.
    assert_eq!(place.run_words(&["weather", "--metar", FAIR, "-o", "new.cloudscene"]).code, 0);
    assert_eq!(place.run("check new.cloudscene").code, 0);
}

#[test]
fn reports_become_tracks() {
    let place = Place::new();
    place.put("day.txt", DAY.as_bytes());
    let ran = place.run("weather --file day.txt good.cloudscene -o out.cloudscene --speed 3600");
    assert_eq!((ran.code, ran.stderr.as_str()), (0, "3 reports became tracks\n"));
    let scene = json(&place.read("out.cloudscene"));
    let tracks = scene["scene"]["tracks"].as_array().expect("tracks");
    assert_eq!(tracks.len(), 6);
    for track in tracks {
        let times: Vec<_> = track["keys"].as_array().expect("keys").iter().map(|key| key["time_s"].as_f64()).collect();
        assert_eq!(times, [Some(0.0), Some(6.0), Some(14.0)], "{}", track["property"]);
    }
    assert_eq!(place.run("check out.cloudscene").code, 0);
}

#[test]
fn json_has_the_report_and_the_plan() {
    let place = Place::new();
    place.put("day.txt", format!("{DAY}EDDF 172020Z 3002KT\n").as_bytes());
    let ran = place.run("weather --file day.txt --json");
    assert_eq!((ran.code, ran.stderr.as_str()), (2, ""));
    let answer = json(ran.stdout.as_bytes());
    assert_eq!(answer.as_array().map(Vec::len), Some(4));
    assert_eq!(answer[0]["plan"]["layers"][0]["genus"], "fog");
    assert_eq!(answer[2]["report"]["layers"][0]["kind"], "CB");
    assert_eq!(answer[2]["plan"]["layers"][0]["genus"], "cumulonimbus");
    assert_eq!(answer[3]["refused"]["group"], "3002KT");
    assert_eq!(answer[3]["refused"]["column"], 14);
    assert_eq!(place.run_words(&["weather", "--json", "--metar", FAIR]).code, 0);
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
        (&format!("weather --file two.txt {out}"), &["EDDF and EDDM", "one station"]),
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
