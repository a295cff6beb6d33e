//! Reports and the layers that were made of them, in words.

use crate::units::{self, Units};
use cloudwright_core::formats::metar::{
    Cover, Descriptor, Intensity, Layer, LayerKind, Report, Visibility, Weather, Wind, WindFrom,
};
use cloudwright_core::reported::PlannedLayer;
use serde::Serialize;

/// `EDDF on the 17th at 13:20 UTC`.
pub fn head(report: &Report) -> String {
    let Report { station, day, hour, minute, .. } = report;
    let th = match day {
        1 | 21 | 31 => "st",
        2 | 22 => "nd",
        3 | 23 => "rd",
        _ => "th",
    };
    format!("{station} on the {day}{th} at {hour:02}:{minute:02} UTC")
}

/// What stands in its groups, one after the other.
pub fn groups(report: &Report, units: Units) -> Vec<String> {
    let mut said: Vec<String> = Vec::new();
    said.extend(report.wind.as_ref().map(|it| wind(it, units)));
    said.extend(report.visibility.as_ref().map(|it| visibility(it, units)));
    said.extend(report.weather.iter().map(weather));
    said.extend(report.layers.iter().map(|it| reported_layer(it, units)));
    said.extend(report.clear.map(code));
    said.extend(report.temperature_c.map(|it| format!("{it:.0} °C")));
    said.extend(report.dew_point_c.map(|it| format!("dew point {it:.0} °C")));
    said.extend(report.pressure_hpa.map(|it| format!("{it:.0} hPa")));
    said
}

/// `cumulus, base 1070 m above the station, 800 m thick`.
pub fn layer(layer: &PlannedLayer, units: Units) -> String {
    let PlannedLayer { genus, base_m, base_assumed, thickness_m, .. } = layer;
    let assumed = if *base_assumed { " (assumed)" } else { "" };
    let [base, thick] = [base_m, thickness_m].map(|length_m| height(*length_m, units));
    format!("{}, base {base} above the station{assumed}, {thick} thick", name(genus))
}

/// A kind of thing by the name that files have for it: `towering cumulus`.
pub fn name(kind: &impl Serialize) -> String {
    code(kind).replace('_', " ")
}

fn code(kind: impl Serialize) -> String {
    serde_json::to_value(kind).ok().and_then(|value| value.as_str().map(String::from)).unwrap_or_default()
}

/// Without the thousands apart, as in what is copied elsewhere.
fn height(length_m: f64, units: Units) -> String {
    let unit = units.altitude();
    format!("{:.0} {}", unit.from_si(length_m), unit.name)
}

fn wind(wind: &Wind, units: Units) -> String {
    let speed = |speed_mps| units.speed().text(speed_mps);
    let from = match wind.from {
        WindFrom::Calm => return "no wind".into(),
        WindFrom::Unknown => "wind".into(),
        WindFrom::Variable => "variable wind".into(),
        WindFrom::Deg(degrees) => format!("wind from {}", units::heading(degrees)),
    };
    let gusts = wind.gust_mps.map(|gust| format!(", gusts {}", speed(gust))).unwrap_or_default();
    format!("{from} {}{gusts}", speed(wind.speed_mps))
}

fn visibility(visibility: &Visibility, units: Units) -> String {
    let far = match visibility.m {
        // In tenths of kilometres fog would be nothing.
        m if m < 2000.0 => format!("{m:.0} m"),
        m => units.distance(m),
    };
    format!("visibility {far}{}", if visibility.or_more { " or more" } else { "" })
}

/// `light showers of rain`, `thunderstorm with hail nearby`.
fn weather(weather: &Weather) -> String {
    let intensity = match weather.intensity {
        Intensity::Light => "light ",
        Intensity::Moderate => "",
        Intensity::Heavy => "heavy ",
    };
    let phenomena: Vec<String> = weather.phenomena.iter().map(name).collect();
    let mut said = intensity.to_owned();
    for descriptor in &weather.descriptors {
        said.push_str(&name(descriptor));
        said.push_str(match descriptor {
            _ if phenomena.is_empty() => "",
            Descriptor::Showers | Descriptor::Patches => " of ",
            Descriptor::Thunderstorm => " with ",
            _ => " ",
        });
    }
    said.push_str(&phenomena.join(" and "));
    if weather.nearby { format!("{said} nearby") } else { said }
}

fn reported_layer(layer: &Layer, units: Units) -> String {
    let at = layer.base_m.map(|base_m| format!(" at {}", height(base_m, units))).unwrap_or_default();
    let tower = if layer.kind == LayerKind::Plain { String::new() } else { format!(", {}", code(layer.kind)) };
    match layer.cover {
        Some(Cover::Hidden) => {
            let up = layer.base_m.map(|up_m| format!(", seen {} up", height(up_m, units))).unwrap_or_default();
            format!("sky hidden{up}")
        }
        Some(cover) => {
            let [fewest, most] = cover.oktas();
            let oktas = if fewest == most { most.to_string() } else { format!("{fewest} to {most}") };
            format!("{} ({oktas} oktas){at}{tower}", code(cover))
        }
        None => format!("clouds{at}{tower}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::formats::metar::read;

    #[test]
    fn groups_are_told_one_after_the_other() {
        for (text, units, wanted) in [
            (
                "EDDF 171320Z 24012G25KT 9999 -SHRA FEW035 SCT045CB 18/09 Q1015",
                Units::Aviation,
                "EDDF on the 17th at 13:20 UTC: wind from 240° 12 kt, gusts 25 kt; visibility 5.4 NM or more; light \
                 showers of rain; FEW (1 to 2 oktas) at 3500 ft; SCT (3 to 4 oktas) at 4500 ft, CB; 18 °C; dew point 9 \
                 °C; 1015 hPa",
            ),
            (
                "METAR LOWI 010650Z 00000KT 0300 FZFG VV002 M01/M02",
                Units::Metric,
                "LOWI on the 1st at 06:50 UTC: no wind; visibility 300 m; freezing fog; sky hidden, seen 61 m up; -1 \
                 °C; dew point -2 °C",
            ),
            (
                "KSFO 220656Z VRB05KT CAVOK",
                Units::Metric,
                "KSFO on the 22nd at 06:56 UTC: variable wind 9 km/h; \
             visibility 10.0 km or more; CAVOK",
            ),
            (
                "KSFO 230656Z VCTS BKN///TCU OVC100",
                Units::Metric,
                "KSFO on the 23rd at 06:56 UTC: thunderstorm nearby; \
             BKN (5 to 7 oktas), TCU; OVC (8 oktas) at 3048 m",
            ),
        ] {
            let report = read(text).expect("a report");
            assert_eq!(format!("{}: {}", head(&report), groups(&report, units).join("; ")), wanted);
        }
    }
}
