//! Single groups of a report. A group's form tells its kind; where a form is known but its numbers can't be, that is
//! said.

use super::{Clear, Cover, Layer, LayerKind, Visibility, Weather, Wind, WindFrom};

pub(super) enum Group {
    Wind(Option<Wind>),
    Visibility(Option<Visibility>),
    Layer(Layer),
    Clear(Clear),
    Weather(Weather),
    Temperatures(Option<f64>, Option<f64>),
    Pressure(Option<f64>),
    /// A sky has no use for it, nor for so many `more` groups that belong to it.
    PassedOver {
        more: usize,
    },
    /// There is no observation.
    Nothing,
    /// A forecast or remarks begin.
    End,
}

/// 9999.
pub(super) const TEN_KM: Visibility = Visibility { m: 10_000.0, or_more: true };

type Read = Result<Group, &'static str>;

pub(super) fn read(text: &str) -> Read {
    match text {
        "RMK" | "NOSIG" | "BECMG" | "TEMPO" => return Ok(Group::End),
        "NIL" => return Ok(Group::Nothing),
        // QFE 773/5: pressure at the aerodrome, in millimetres and otherwise. WS R23, WS ALL RWY: shear.
        "QFE" => return Ok(Group::PassedOver { more: 1 }),
        "SKC" => return Ok(Group::Clear(Clear::Skc)),
        "CLR" => return Ok(Group::Clear(Clear::Clr)),
        "NSC" => return Ok(Group::Clear(Clear::Nsc)),
        "NCD" => return Ok(Group::Clear(Clear::Ncd)),
        "CAVOK" => return Ok(Group::Clear(Clear::Cavok)),
        // Some stations write so what was not measured.
        "XX/XX" => return Ok(Group::Temperatures(None, None)),
        _ => {}
    }
    let readers: [fn(&str) -> Option<Read>; 8] =
        [passed_over, wind, visibility, layer, temperatures, pressure, weather, runway];
    let read = readers.iter().find_map(|reader| reader(text));
    read.unwrap_or(Err("it is none of a report's groups"))
}

fn passed_over(text: &str) -> Option<Read> {
    const WORDS: &[&str] = &[
        "AUTO", "COR", "RTD", "AMD", "NSW", "$", "WS", "ALL", "RWY", "BLU", "WHT", "GRN", "YLO", "YLO1", "YLO2", "AMB",
        "RED", "BLACK",
    ];
    let colour = text.strip_prefix("BLACK").unwrap_or(text).trim_end_matches('+');
    let is_correction = text.len() == 3 && text.starts_with("CC");
    let is_recent = text.strip_prefix("RE").is_some_and(|rest| is_unknown(rest) || Weather::read(rest).is_some());
    let is_variation = text.len() == 7
        && text.split_once('V').is_some_and(|(from, to)| [from, to].iter().all(|part| digits(part, 3).is_some()));
    let passed = WORDS.contains(&text)
        || WORDS.contains(&colour)
        || is_correction
        || is_recent
        || is_variation
        || is_unknown(text)
        || is_sea(text);
    passed.then_some(Ok(Group::PassedOver { more: 0 }))
}

/// W15/S4, W///H12: the sea's temperature, and its state or the waves' height.
fn is_sea(text: &str) -> bool {
    let Some((temperature, state)) = text.strip_prefix('W').and_then(|rest| rest.split_at_checked(rest.len().min(3)))
    else {
        return false;
    };
    let temperature = temperature.trim_end_matches('/');
    (temperature.is_empty() || celsius(temperature).is_some())
        && state
            .trim_start_matches('/')
            .strip_prefix(['S', 'H'])
            .is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit() || b == b'/'))
}

/// R34L/0650, R12/290150, R34L/CLRD70, R/SNOCLO: a runway's visual range or state. R23, RWY23 follow WS.
fn runway(text: &str) -> Option<Read> {
    let rest = text.strip_prefix("RWY").or(text.strip_prefix('R'))?;
    let (name, said) = rest.split_once('/').unwrap_or((rest, "/"));
    let sides = name.trim_start_matches(|c: char| c.is_ascii_digit());
    let is_name = name.is_empty() || digits(name.strip_suffix(sides)?, 2).is_some();
    let is_side = matches!(sides, "" | "L" | "C" | "R" | "LL" | "RR");
    let is_said = said.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'/');
    (is_name && is_side && is_said && !rest.is_empty()).then_some(Ok(Group::PassedOver { more: 0 }))
}

fn wind(text: &str) -> Option<Read> {
    const UNITS: [(&str, f64); 4] = [("KT", 1852.0 / 3600.0), ("MPS", 1.0), ("KMH", 1.0 / 3.6), ("KPH", 1.0 / 3.6)];
    let (body, mps) = UNITS.iter().find_map(|(unit, mps)| Some((text.strip_suffix(unit)?, *mps)))?;
    if is_unknown(body) {
        return Some(Ok(Group::Wind(None)));
    }
    let (from, rest) = body.split_at_checked(3)?;
    let (speed, gust) = rest.split_once('G').map_or((rest, None), |(speed, gust)| (speed, Some(gust)));
    if is_unknown(speed) {
        return Some(Ok(Group::Wind(None)));
    }
    let number = |text: &str| match text {
        "P99" => Some(100.0),
        _ => digits(text, 2).or_else(|| digits(text, 3)).map(f64::from),
    };
    let bad = Some(Err("a wind is a direction in tens of degrees and a speed, such as 24012G25KT"));
    let Some(speed) = number(speed) else { return bad };
    let gust = match gust {
        Some(gust) if !is_unknown(gust) => match number(gust) {
            Some(gust) => Some(gust * mps),
            None => return bad,
        },
        _ => None,
    };
    let from = match (from, digits(from, 3)) {
        ("VRB", _) => WindFrom::Variable,
        ("///", _) => WindFrom::Unknown,
        ("000", _) if speed == 0.0 => WindFrom::Calm,
        (_, Some(from)) if from <= 360 => WindFrom::Deg(f64::from(from % 360)),
        _ => return bad,
    };
    let speed_mps = speed * mps;
    // The scene's own bound: no wind measured at a station has been stronger.
    if speed_mps.max(gust.unwrap_or(0.0)) > 150.0 {
        return Some(Err("there is no such wind"));
    }
    Some(Ok(Group::Wind(Some(Wind { from, speed_mps, gust_mps: gust }))))
}

fn visibility(text: &str) -> Option<Read> {
    let told = |visibility| Some(Ok(Group::Visibility(Some(visibility))));
    if let Some(body) = text.strip_suffix("SM") {
        if is_unknown(body) {
            return Some(Ok(Group::Visibility(None)));
        }
        // P6SM: more than six. M1/4SM: less than a quarter.
        let (more, number) = body.strip_prefix('P').map_or((false, body), |rest| (true, rest));
        let number = number.strip_prefix('M').unwrap_or(number);
        let whole = (1..=3).find_map(|length| digits(number, length)).map(f64::from);
        return match whole.or_else(|| fraction(number)) {
            Some(number) => told(Visibility { or_more: more || number >= 10.0, ..miles(number) }),
            None => Some(Err("a visibility in miles is a number or a fraction, such as 10SM or 3/4SM")),
        };
    }
    if let Some(km) = text.strip_suffix("KM").and_then(|km| digits(km, 2).or_else(|| digits(km, 1))) {
        return told(Visibility { m: 1000.0 * f64::from(km), or_more: false });
    }
    let (metres, direction) = text.split_at_checked(4)?;
    let metres = digits(metres, 4)?;
    match direction {
        "" | "NDV" if metres == 9999 => told(TEN_KM),
        "" | "NDV" => told(Visibility { m: f64::from(metres), or_more: false }),
        // The least, and where; the prevailing one stands before it.
        "N" | "NE" | "E" | "SE" | "S" | "SW" | "W" | "NW" => Some(Ok(Group::PassedOver { more: 0 })),
        _ => None,
    }
}

/// So many statute miles.
pub(super) fn miles(miles: f64) -> Visibility {
    Visibility { m: miles * 1609.344, or_more: miles >= 10.0 }
}

/// 3/4: below one.
pub(super) fn fraction(text: &str) -> Option<f64> {
    let number = |text| digits(text, 1).or_else(|| digits(text, 2)).map(f64::from);
    let (above, below) = text.split_once('/')?;
    let (above, below) = (number(above)?, number(below)?);
    (above < below).then(|| above / below)
}

fn layer(text: &str) -> Option<Read> {
    let (cover, rest) = match text.split_at_checked(3)? {
        ("FEW", rest) => (Some(Cover::Few), rest),
        ("SCT", rest) => (Some(Cover::Scattered), rest),
        ("BKN", rest) => (Some(Cover::Broken), rest),
        ("OVC", rest) => (Some(Cover::Overcast), rest),
        ("///", rest) => (None, rest),
        _ => (Some(Cover::Hidden), text.strip_prefix("VV")?),
    };
    let bad = Some(Err("a layer is its cover, its base in hundreds of feet and perhaps CB or TCU, such as SCT025TCU"));
    let Some((base, kind)) = rest.split_at_checked(3) else { return bad };
    let base_m = match digits(base, 3) {
        Some(hundreds) => Some(f64::from(100 * hundreds) * 0.3048),
        None if base == "///" => None,
        None => return bad,
    };
    // No cloud that matters is above 20 km; 999 is no height.
    if base_m.is_some_and(|base| base > 20_000.0) {
        return Some(Err("clouds are not that high"));
    }
    let kind = match kind {
        "CB" => LayerKind::Cumulonimbus,
        "TCU" => LayerKind::Towering,
        _ if kind.is_empty() || is_unknown(kind) => LayerKind::Plain,
        _ => return bad,
    };
    if cover == Some(Cover::Hidden) && kind != LayerKind::Plain {
        return bad;
    }
    Some(Ok(Group::Layer(Layer { cover, base_m, kind })))
}

fn temperatures(text: &str) -> Option<Read> {
    // 12/10, M02/M05, 12///, ///10.
    let (temperature, dew_point) = match text.strip_prefix("///") {
        Some(dew_point) => ("//", dew_point),
        None => text.split_once('/')?,
    };
    let one = |text: &str| if is_unknown(text) || text.is_empty() { Some(None) } else { celsius(text).map(Some) };
    let (temperature, dew_point) = (one(temperature)?, one(dew_point)?);
    // The scene's own bounds, and the world's records.
    if [temperature, dew_point].iter().flatten().any(|t| !(-80.0..=60.0).contains(t)) {
        return Some(Err("air has no such temperature"));
    }
    Some(Ok(Group::Temperatures(temperature, dew_point)))
}

fn celsius(text: &str) -> Option<f64> {
    match text.strip_prefix('M') {
        Some(below) => Some(0.0 - f64::from(digits(below, 2)?)),
        None => Some(f64::from(digits(text, 2)?)),
    }
}

fn pressure(text: &str) -> Option<Read> {
    let (unit, number) = text.split_at_checked(1)?;
    let hpa = match unit {
        "Q" => 1.0,
        "A" => 0.338_639,
        _ => return None,
    };
    if is_unknown(number) {
        return Some(Ok(Group::Pressure(None)));
    }
    let pressure = f64::from(digits(number, 4)?) * hpa;
    // Beyond the records at sea level on either side.
    if !(850.0..=1100.0).contains(&pressure) {
        return Some(Err("air has no such pressure"));
    }
    Some(Ok(Group::Pressure(Some(pressure))))
}

fn weather(text: &str) -> Option<Read> {
    Weather::read(text).map(|weather| Ok(Group::Weather(weather)))
}

/// 171320Z.
pub(super) fn time(text: &str) -> Option<[u32; 3]> {
    let number = digits(text.strip_suffix('Z')?, 6)?;
    let [day, hour, minute] = [number / 10_000, number / 100 % 100, number % 100];
    ((1..=31).contains(&day) && hour < 24 && minute < 60).then_some([day, hour, minute])
}

/// One or more slashes.
fn is_unknown(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b == b'/')
}

/// A number of exactly so many digits, at most six.
fn digits(text: &str, count: usize) -> Option<u32> {
    (text.len() == count && text.bytes().all(|b| b.is_ascii_digit())).then(|| text.parse().ok()).flatten()
}
