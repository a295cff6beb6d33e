//! TAF forecasts: what is expected at one aerodrome over a day or so, as a state and what changes it.
//!
//! The codes are those of ICAO Annex 3 (appendix 5) and WMO No. 306 (FM 51); single groups are a report's. What a sky has
//! no use for (extreme temperatures, pressure, icing, turbulence, shear) is passed over.

use super::{Groups, RefusedGroup, Report, Token, blank, is_station, take};
use serde::Serialize;

/// A forecast.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Forecast {
    /// The station's four letters.
    pub station: String,
    /// When it begins to hold.
    pub from: DayTime,
    /// When it ends.
    pub until: DayTime,
    /// What holds at first.
    pub first: Report,
    /// What changes, in order.
    pub changes: Vec<Expected>,
}

/// A time in a month, UTC.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct DayTime {
    /// 1 to 31.
    pub day: u32,
    /// 0 to 24: a day may end at 24.
    pub hour: u32,
    /// 0 to 59.
    pub minute: u32,
}

/// One change that is expected.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Expected {
    /// How it comes.
    pub kind: ExpectedKind,
    /// When it begins.
    pub from: DayTime,
    /// When it is over; of [`ExpectedKind::At`] when it begins.
    pub until: DayTime,
    /// What is said of it, at its beginning; the rest is as before, but for [`ExpectedKind::At`].
    pub report: Report,
    /// Whether what fell before ends (NSW).
    pub ends_weather: bool,
}

/// How a change comes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ExpectedKind {
    /// FM: quickly, and nothing of before holds on.
    At,
    /// BECMG: slowly, to stay.
    Becoming,
    /// TEMPO: for less than an hour at a time, and for less than half of the time.
    Passing,
    /// PROB30, PROB40, alone or with TEMPO: perhaps.
    Perhaps,
}

/// Reads one forecast, over any number of lines.
///
/// # Errors
/// With the first group that could not be read.
pub fn read(text: &str) -> Result<Forecast, RefusedGroup> {
    let mut groups = Groups::new(text);
    let ends = "the text ends before the station and the hours of the forecast";
    while groups.peek().is_some_and(|token| matches!(&*token.text, "TAF" | "AMD" | "COR")) {
        groups.next();
    }
    let station = groups.next().ok_or_else(|| groups.end(ends))?;
    if !is_station(&station.text) {
        return Err(station.refused("a station has four letters, such as EDDF"));
    }
    let mut hours = groups.next().ok_or_else(|| groups.end(ends))?;
    if super::group::time(&hours.text).is_some() {
        hours = groups.next().ok_or_else(|| groups.end(ends))?;
    }
    let (from, until) = span(&hours)?;
    let mut forecast =
        Forecast { first: at(&station.text, from), station: station.text, from, until, changes: Vec::new() };
    while let Some(token) = groups.next() {
        match change(&token, &mut groups, &forecast.station)? {
            Some(change) => forecast.changes.push(change),
            None if matches!(&*token.text, "RMK") => break,
            None if matches!(&*token.text, "CNL" | "NIL") => {
                return Err(token.refused("the forecast is cancelled or missing"));
            }
            None if is_passed_over(&token.text) => {}
            None => {
                let (report, ends_weather) = match forecast.changes.last_mut() {
                    Some(change) => (&mut change.report, Some(&mut change.ends_weather)),
                    None => (&mut forecast.first, None),
                };
                match (&*token.text, ends_weather) {
                    ("NSW", Some(ends_weather)) => *ends_weather = true,
                    _ => _ = take(report, &token, &mut groups)?,
                }
            }
        }
    }
    Ok(forecast)
}

/// The head of a change, if `token` begins one.
fn change(token: &Token, groups: &mut Groups<'_>, station: &str) -> Result<Option<Expected>, RefusedGroup> {
    let bad = "a change is FM and a day and time, or BECMG, TEMPO, PROB30 or PROB40 and from when to when";
    if let Some(time) = token.text.strip_prefix("FM").filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit())) {
        let [day, hour, minute] = super::group::time(&format!("{time}Z")).ok_or_else(|| token.refused(bad))?;
        let from = DayTime { day, hour, minute };
        let (kind, report) = (ExpectedKind::At, at(station, from));
        return Ok(Some(Expected { kind, from, until: from, report, ends_weather: false }));
    }
    let kind = match &*token.text {
        "BECMG" => ExpectedKind::Becoming,
        "TEMPO" | "INTER" => ExpectedKind::Passing,
        "PROB30" | "PROB40" => ExpectedKind::Perhaps,
        _ => return Ok(None),
    };
    if kind == ExpectedKind::Perhaps && groups.peek().is_some_and(|next| next.text == "TEMPO") {
        groups.next();
    }
    let hours = groups.next().ok_or_else(|| groups.end(bad))?;
    let (from, until) = span(&hours)?;
    Ok(Some(Expected { kind, from, until, report: at(station, from), ends_weather: false }))
}

/// 1712/1818: day and hour, twice.
fn span(token: &Token) -> Result<(DayTime, DayTime), RefusedGroup> {
    let one = |text: &str| {
        let number: u32 =
            (text.len() == 4 && text.bytes().all(|b| b.is_ascii_digit())).then(|| text.parse().ok())??;
        let (day, hour) = (number / 100, number % 100);
        ((1..=31).contains(&day) && hour <= 24).then_some(DayTime { day, hour, minute: 0 })
    };
    let both = token.text.split_once('/').and_then(|(from, until)| one(from).zip(one(until)));
    let refused = || token.refused("from when to when is a day and an hour, twice, such as 1712/1818");
    let (from, until) = both.ok_or_else(refused)?;
    // A forecast that ends on a smaller day runs into the next month.
    let goes_on = from < until || from.day > until.day + 15;
    if goes_on { Ok((from, until)) } else { Err(token.refused("it ends before it begins")) }
}

/// TX25/1213Z, TNM02/1304Z, QNH2992INS, WS020/24045KT, 620304, 540009: temperatures, pressure, shear, icing, turbulence.
fn is_passed_over(text: &str) -> bool {
    let is_temperature = ["TX", "TN"].iter().any(|word| text.strip_prefix(word).is_some_and(|rest| rest.contains('/')));
    let is_six = text.len() == 6 && text.starts_with(['5', '6']) && text.bytes().all(|b| b.is_ascii_digit());
    let is_shear = text.strip_prefix("WS").is_some_and(|rest| rest.contains('/'));
    is_temperature || is_six || is_shear || text.starts_with("QNH")
}

fn at(station: &str, time: DayTime) -> Report {
    blank(station.to_owned(), [time.day, time.hour, time.minute])
}
