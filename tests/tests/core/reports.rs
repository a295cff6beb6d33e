//! Weather reports: what they say, and what is refused and where.
//!
//! The lines are written for the tests, in the ways that stations write. The twin is crate metar-taf-parser, where it
//! does not panic.

use crate::skies::check_sky;
use cloudwright_core::formats::metar::{self, LayerKind, Report, WindFrom};
use cloudwright_core::random::draw;
use cloudwright_core::scene::Scene;
use std::fmt::Write;

pub(crate) fn read(line: &str) -> Report {
    metar::read(line).unwrap_or_else(|refused| panic!("{line}\n{refused}"))
}

/// What a sky needs of it, in a line.
fn digest(report: &Report) -> String {
    let mut text = format!("{} {}/{}:{:02}", report.station, report.day, report.hour, report.minute);
    if let Some(wind) = report.wind {
        let from = match wind.from {
            WindFrom::Deg(deg) => deg.to_string(),
            other => format!("{other:?}").to_lowercase(),
        };
        let _ = write!(text, " wind {from} {:.1}", wind.speed_mps);
        if let Some(gust) = wind.gust_mps {
            let _ = write!(text, "-{gust:.1}");
        }
    }
    if let Some(visibility) = report.visibility {
        let _ = write!(text, " sees {:.0}{}", visibility.m, if visibility.or_more { "+" } else { "" });
    }
    for layer in &report.layers {
        let cover = layer.cover.map_or("?".into(), |cover| format!("{}-{}", cover.oktas()[0], cover.oktas()[1]));
        let base = layer.base_m.map_or("?".into(), |base| format!("{base:.0}"));
        let kind = match layer.kind {
            LayerKind::Plain => "",
            LayerKind::Cumulonimbus => "CB",
            LayerKind::Towering => "TCU",
        };
        let _ = write!(text, " {cover}@{base}{kind}");
    }
    if let Some(clear) = report.clear {
        let _ = write!(text, " {clear:?}");
    }
    for weather in &report.weather {
        let _ = write!(text, " {:?}", weather.intensity);
        text.extend(weather.descriptors.iter().map(|each| format!("/{each:?}")));
        text.extend(weather.phenomena.iter().map(|each| format!("/{each:?}")));
        text += if weather.nearby { "/near" } else { "" };
    }
    for (name, value) in [("T", report.temperature_c), ("D", report.dew_point_c), ("p", report.pressure_hpa)] {
        if let Some(value) = value {
            let _ = write!(text, " {name} {value:.0}");
        }
    }
    text
}

/// Lines as stations write them, and what they say.
const READ: &[(&str, &str)] = &[
    ("EDDF 171320Z 24012KT 9999 SCT035 18/09 Q1015", "EDDF 17/13:20 wind 240 6.2 sees 10000+ 3-4@1067 T 18 D 9 p 1015"),
    (
        "METAR COR LOWI 010000Z AUTO 00000KT 0400 R26/0600N FG VV001 M01/M02 Q1031 NOSIG=",
        "LOWI 1/0:00 wind calm 0.0 sees 400 8-8@30 Moderate/Fog T -1 D -2 p 1031",
    ),
    (
        "SPECI KMIA 042153Z VRB03G15KT 1 1/2SM +TSRA FEW010 BKN025CB OVC050 24/23 A2992 RMK AO2 SLP133 $",
        "KMIA 4/21:53 wind variable 1.5-7.7 sees 2414 1-2@305 5-7@762CB 8-8@1524 Heavy/Thunderstorm/Rain T 24 D 23 p 1013",
    ),
    (
        "UUEE 311200Z 36005G10MPS CAVOK M12/M20 Q1040 R06C/190055 NOSIG",
        "UUEE 31/12:00 wind 0 5.0-10.0 sees 10000+ Cavok T -12 D -20 p 1040",
    ),
    (
        "LFPG 151030Z 35010KT 320V020 3000 1500NE -RADZ BR BKN004 OVC010 08/07 Q0998 TEMPO 1500 OVC002",
        "LFPG 15/10:30 wind 350 5.1 sees 3000 5-7@122 8-8@305 Light/Rain/Drizzle Moderate/Mist T 8 D 7 p 998",
    ),
    ("EGPD 312350Z AUTO /////KT //// // ////// ///// Q////", "EGPD 31/23:50"),
    (
        "ESSB 312350Z AUTO ///05KT 9999NDV ///012/// //////CB OVC040/// 05/// Q1001",
        "ESSB 31/23:50 wind unknown 2.6 sees 10000+ ?@366 ?@?CB 8-8@1219 T 5 p 1001",
    ),
    (
        "SBGR 121100Z 20003KT 9999 SCT030TCU FEW035CB 27/20 Q1016",
        "SBGR 12/11:00 wind 200 1.5 sees 10000+ 3-4@914TCU 1-2@1067CB T 27 D 20 p 1016",
    ),
    (
        "CYYZ 121100Z 27025G40KT P6SM SKC 10/M03 A3001",
        "CYYZ 12/11:00 wind 270 12.9-20.6 sees 9656+ Skc T 10 D -3 p 1016",
    ),
    (
        "KSFO 121156Z AUTO 28008KT M1/4SM R28R/1200V2400FT FG VV002 11/11 A3005 RMK AO2",
        "KSFO 12/11:56 wind 280 4.1 sees 402 8-8@61 Moderate/Fog T 11 D 11 p 1018",
    ),
    ("KDEN 121156Z 28008KT 10SM CLR 11/M08 A3005", "KDEN 12/11:56 wind 280 4.1 sees 16093+ Clr T 11 D -8 p 1018"),
    (
        "RJTT 010030Z 18015KT 9999 -SHRA FEW015 BKN200 22/18 Q1009 A2980",
        "RJTT 1/0:30 wind 180 7.7 sees 10000+ 1-2@457 5-7@6096 Light/Showers/Rain T 22 D 18 p 1009",
    ),
    (
        "EGVN 010050Z 18015KT 9999 VCSH FEW015 12/10 Q1009 BLU NOSIG",
        "EGVN 1/0:50 wind 180 7.7 sees 10000+ 1-2@457 Moderate/Showers/near T 12 D 10 p 1009",
    ),
    (
        "EGQL 010050Z 18015KT 5000 HZ BKN012 12/10 Q1009 BLACKWHT",
        "EGQL 1/0:50 wind 180 7.7 sees 5000 5-7@366 Moderate/Haze T 12 D 10 p 1009",
    ),
    (
        "OMDB 010050Z 31020KT 0800 BLDU DS NSC 38/05 Q0999 WS R12 RESQ",
        "OMDB 1/0:50 wind 310 10.3 sees 800 Nsc Moderate/Blowing/Dust Moderate/Duststorm T 38 D 5 p 999",
    ),
    (
        "ENGM 010050Z 01002KT 350V080 9999 MIFG BCFG NSC M05/M05 Q1022 R01L/CLRD62",
        "ENGM 1/0:50 wind 10 1.0 sees 10000+ Nsc Moderate/Shallow/Fog Moderate/Patches/Fog T -5 D -5 p 1022",
    ),
    ("NZSP 010050Z 020P99KT 9999 NCD M60/M70 Q//// RE//", "NZSP 1/0:50 wind 20 51.4 sees 10000+ Ncd T -60 D -70"),
    (
        "ENXX 010050Z AUTO 20030KT 9999 NCD 05/03 Q1012 W///S5 W12/H34",
        "ENXX 1/0:50 wind 200 15.4 sees 10000+ Ncd T 5 D 3 p 1012",
    ),
    ("MGQZ 020000Z 00000KT 9999 BKN020 16/12 QFE 773/5", "MGQZ 2/0:00 wind calm 0.0 sees 10000+ 5-7@610 T 16 D 12"),
    ("SVXX 020000Z /////KT 9999 BKN050 XX/XX Q////", "SVXX 2/0:00 sees 10000+ 5-7@1524"),
    (
        "ZBAA 020000Z 36004MPS 330V030 2000 -SN OVC033 M03/M05 Q1031 BECMG FM0100 4000",
        "ZBAA 2/0:00 wind 0 4.0 sees 2000 8-8@1006 Light/Snow T -3 D -5 p 1031",
    ),
    (
        "metar eddm 020020z 25008kt 9999 few040 bkn120 21/12 q1018=",
        "EDDM 2/0:20 wind 250 4.1 sees 10000+ 1-2@1219 5-7@3658 T 21 D 12 p 1018",
    ),
    (
        "PAFA 020020Z 25008KT 3/4SM FZFG UP VV/// M12/M13 A2950",
        "PAFA 2/0:20 wind 250 4.1 sees 1207 8-8@? Moderate/Freezing/Fog Moderate/Unknown T -12 D -13 p 999",
    ),
];

/// Lines that are refused, with the group and its column.
const REFUSED: &[(&str, &str, usize)] = &[
    ("", "", 1),
    ("   ", "", 4),
    ("EDDF", "", 5),
    ("METAR", "", 6),
    ("TAF EDDF 171100Z 1712/1818 24012KT", "TAF", 1),
    ("ED 171320Z", "ED", 1),
    ("EDDF 1713Z 24012KT", "1713Z", 6),
    ("EDDF 321320Z 24012KT", "321320Z", 6),
    ("EDDF 172420Z 24012KT", "172420Z", 6),
    ("EDDF 171360Z 24012KT", "171360Z", 6),
    ("EDDF 171320Z NIL", "NIL", 14),
    ("EDDF 171320Z 37012KT 9999", "37012KT", 14),
    ("EDDF 171320Z 24KT 9999", "24KT", 14),
    ("EDDF 171320Z 240300KT 9999", "240300KT", 14),
    ("EDDF 171320Z 24012GKT 9999", "24012GKT", 14),
    ("EDDF 171320Z 24012KT 99999 FEW010", "99999", 22),
    ("EDDF 171320Z 24012KT 4/3SM", "4/3SM", 22),
    ("EDDF 171320Z 24012KT 1/0SM", "1/0SM", 22),
    ("EDDF 171320Z 24012KT 5000 9999 FEW010", "9999", 27),
    ("EDDF 171320Z 24012KT 9999 FEW", "FEW", 27),
    ("EDDF 171320Z 24012KT 9999 FEW999 18/12", "FEW999", 27),
    ("EDDF 171320Z 24012KT 9999 FEW03O 18/12", "FEW03O", 27),
    ("EDDF 171320Z 24012KT 9999 FEW030XX", "FEW030XX", 27),
    ("EDDF 171320Z 24012KT 9999 VV001CB", "VV001CB", 27),
    ("EDDF 171320Z 24012KT CAVOK FEW030", "FEW030", 28),
    ("EDDF 171320Z 24012KT 9999 FEW030 SKC", "SKC", 34),
    ("EDDF 171320Z 24012KT 9999 99/12", "99/12", 27),
    ("EDDF 171320Z 24012KT 9999 18/12 19/12", "19/12", 33),
    ("EDDF 171320Z 24012KT 9999 Q0315", "Q0315", 27),
    ("EDDF 171320Z 24012KT 9999 A9999", "A9999", 27),
    ("EDDF 171320Z 24012KT 9999 R€/12", "R€/12", 27),
    ("EDDF 171320Z 24012KT 9999 -€a", "-€A", 27),
    ("EDDF 171320Z 24012KT 9999 VV€", "VV€", 27),
    ("EDDF 171320Z 24012KT 9999 RARASNSNDZ", "RARASNSNDZ", 27),
    ("ÖDDF 171320Z 24012KT", "ÖDDF", 1),
    ("EDDF 171320Z 24012KT 9999 CB TO OBS S 20/20", "CB", 27),
    ("EDDF 171320Z 24012KT 9999 AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA", "AAAAAAAAAAAAAAAAAAAAAAAA", 27),
    ("EDDF 171320Z 24012KT 9999 \u{0}\u{7f}", "\u{0}\u{7f}", 27),
];

#[test]
fn reports_are_read() {
    for (line, wanted) in READ {
        assert_eq!(digest(&read(line)), *wanted, "{line}");
    }
}

#[test]
fn what_cannot_be_read_is_named_with_its_place() {
    for (line, group, column) in REFUSED {
        match metar::read(line) {
            Ok(report) => panic!("{line}\nis read as {}", digest(&report)),
            Err(refused) => {
                assert_eq!((refused.group.as_str(), refused.column), (*group, *column), "{line}: {refused}");
            }
        }
    }
}

/// By their definitions: no more than the rounding of a product and a quotient away, 2⁻⁵² of the value each.
#[test]
fn units_are_exact() {
    let near = |got: f64, wanted: f64| assert!((got - wanted).abs() <= wanted * 2.0 * f64::EPSILON, "{got} {wanted}");
    let report = read("KABC 010000Z 09060G99KT 2 1/4SM FEW001 SCT123 18/12 A2992");
    let wind = report.wind.expect("measured");
    near(wind.speed_mps, 60.0 * 1852.0 / 3600.0);
    near(wind.gust_mps.expect("told"), 99.0 * 1852.0 / 3600.0);
    near(report.visibility.expect("measured").m, 2.25 * 1609.344);
    near(report.layers[0].base_m.expect("measured"), 30.48);
    near(report.layers[1].base_m.expect("measured"), 3749.04);
    // The standard pressure is 1013.25 hPa or 29.9213 inches; two decimals of an inch are 0.17 hPa off at most.
    assert!((report.pressure_hpa.expect("measured") - 1013.25).abs() < 0.17);
}

/// A few thousand lines with letters lost, doubled, swapped or replaced: an answer to each, and a sky for what is read.
#[test]
fn no_line_panics() {
    const OTHERS: [char; 14] = ['/', '9', '0', 'M', 'G', 'V', 'B', ' ', '€', 'é', '\u{0}', '=', '-', 'P'];
    let scene = Scene::default();
    let mut refused = 0;
    for (index, (line, _)) in READ.iter().enumerate() {
        for round in 0..300 {
            let mut letters: Vec<char> = line.chars().collect();
            let [times, ..] = draw(1, index as u64, round, 0);
            for block in 0..1 + times % 4 {
                let [way, at, other, to] = draw(2, index as u64, round, block);
                let place = |n: u32| n as usize % letters.len();
                let (at, to, other) = (place(at), place(to), OTHERS[other as usize % OTHERS.len()]);
                match way % 4 {
                    0 if letters.len() > 1 => drop(letters.remove(at)),
                    1 => letters.insert(at, letters[at]),
                    2 => letters.swap(at, to),
                    _ => letters[at] = other,
                }
            }
            let text: String = letters.into_iter().collect();
            match metar::read(&text) {
                Ok(report) => check_sky(&report, &scene, &text),
                Err(error) => {
                    refused += 1;
                    assert!((1..=text.chars().count() + 1).contains(&error.column), "{text}: {error}");
                }
            }
        }
    }
    assert!(refused > 1000, "the lines are hardly changed: {refused} are refused");
}

/// The twin reads the same numbers from what both read.
#[test]
fn the_twin_agrees() {
    use metar_taf_parser::metar::models::pressure::Pressure;
    use metar_taf_parser::metar::models::visibility::Visibility;
    for (line, _) in READ.iter().filter(|(line, _)| !line.starts_with("metar")) {
        check_twin(line, |parsed, report| {
            if let (Some(theirs), Some(ours)) = (&parsed.temperature, report.temperature_c) {
                assert_eq!(f64::from(theirs.temperature), ours, "{line}");
                assert_eq!(Some(f64::from(theirs.dew_point)), report.dew_point_c, "{line}");
            }
            if let Some(Visibility::Single { prevailing, .. }) = parsed.visibility
                && prevailing != 9999
            {
                let ours = report.visibility.expect("both read it").m;
                assert!((f64::from(prevailing) - ours).abs() <= 0.5, "{line}: {prevailing} {ours}");
            }
            if let (Some(Pressure::QnhHpa(theirs)), Some(ours)) = (&parsed.pressure, report.pressure_hpa) {
                assert!((f64::from(*theirs) - ours).abs() < 1.0, "{line}");
            }
            let heights = |bases: Vec<Option<f64>>| bases.into_iter().flatten().map(|m| m.round() as i64).collect();
            let ours: Vec<i64> =
                heights(report.layers.iter().filter(|l| l.cover.is_some()).map(|l| l.base_m).collect());
            let theirs: Vec<i64> =
                heights(parsed.clouds.iter().map(|c| c.altitude_ft.map(|ft| f64::from(ft) * 0.3048)).collect());
            assert_eq!(ours, theirs, "{line}");
        });
    }
}

fn check_twin(line: &str, check: impl Fn(&metar_taf_parser::metar::models::Metar, &Report)) {
    let parsed = metar_taf_parser::parse_metar(line.trim_end_matches('=')).expect("the twin reads it");
    check(&parsed, &read(line));
}

/// Each is read, or refused with the group that no one reads; what is made of them tells `okta_table`.
#[test]
fn real_reports_are_read_or_refused_with_their_group() {
    let text = include_str!("../../reports/metars.txt");
    let (mut count, mut refused) = (0, Vec::new());
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        count += 1;
        match metar::read(line) {
            Ok(report) => check_sky(&report, &Scene::default(), line),
            Err(error) => refused.push(error.group),
        }
    }
    assert_eq!(count, 700);
    assert_eq!(refused, ["FEW", "CB", "11028T", "2AC070"]);
}
