//! METAR and SPECI weather reports: one line of text to a typed [`Report`], or the group that could not be read; TAF
//! forecasts in [`forecast`].
//!
//! The codes are those of ICAO Annex 3 (appendix 3) and WMO No. 306 (FM 15, FM 16; tables 4678 for weather), with the
//! American and military habits that stand in real reports: statute miles, inches of mercury, CLR, colour codes. What
//! a sky has no use for (runways, sea state, recent weather) is passed over; a trend or the remarks end the
//! observation. Slashes stand for what was not measured: unknown, no error. Units become metric by their definitions:
//! a foot is 0.3048 m, a statute mile 1,609.344 m, a knot 1,852 m an hour, an inch of mercury 33.8639 hPa; but for that
//! last one, exact within the rounding of f64.
//!
//! Own code, against crate metar-taf-parser as its twin in the tests: that one panics at heights above 65,500 feet and
//! at some letters beyond ASCII, and passes over what it does not know without saying where.

pub mod forecast;
mod group;
mod phenomenon;

pub use phenomenon::{Descriptor, Intensity, Phenomenon, Weather};

use group::Group;
use schemars::JsonSchema;
use serde::Serialize;

/// What one report says of the sky over its station.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Report {
    /// The station's four letters.
    pub station: String,
    /// Day of the month, UTC, 1 to 31.
    pub day: u32,
    /// Hour, UTC.
    pub hour: u32,
    /// Minute, UTC.
    pub minute: u32,
    /// None if it was not measured.
    pub wind: Option<Wind>,
    /// None if it was not measured.
    pub visibility: Option<Visibility>,
    /// As they stand in the report, mostly lowest first.
    pub layers: Vec<Layer>,
    /// What it says in place of layers, if anything.
    pub clear: Option<Clear>,
    /// Weather at the station and near it, now.
    pub weather: Vec<Weather>,
    /// Of the air, in whole degrees Celsius; none if it was not measured.
    pub temperature_c: Option<f64>,
    /// Of the air, in whole degrees Celsius; none if it was not measured.
    pub dew_point_c: Option<f64>,
    /// Reduced to sea level; none if it was not measured.
    pub pressure_hpa: Option<f64>,
}

/// Mean wind of the last ten minutes (two in the United States).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Wind {
    /// Where it comes from, if anywhere.
    pub from: WindFrom,
    /// Metres a second. “More than 99” counts as 100.
    pub speed_mps: f64,
    /// Its gusts, metres a second, where it has any.
    pub gust_mps: Option<f64>,
}

/// Where wind comes from.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WindFrom {
    /// Degrees clockwise from true north, 0 to below 360.
    Deg(f64),
    /// From all over.
    Variable,
    /// There is no wind.
    Calm,
    /// It was not measured.
    Unknown,
}

/// How far one sees along the ground.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Visibility {
    /// Metres.
    pub m: f64,
    /// Whether one sees as far at least: 9999, CAVOK, P6SM, and 10SM and above, where sensors end.
    pub or_more: bool,
}

/// Clouds of one height.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Layer {
    /// How much of the sky they cover; none if it was not measured.
    pub cover: Option<Cover>,
    /// Their base above the station (for [`Cover::Hidden`]: how far one sees up); none if it was not measured.
    pub base_m: Option<f64>,
    /// What towers, if they do.
    pub kind: LayerKind,
}

/// How much of the sky a layer covers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub enum Cover {
    /// 1 to 2 oktas.
    #[serde(rename = "FEW")]
    Few,
    /// 3 to 4 oktas.
    #[serde(rename = "SCT")]
    Scattered,
    /// 5 to 7 oktas.
    #[serde(rename = "BKN")]
    Broken,
    /// 8 oktas.
    #[serde(rename = "OVC")]
    Overcast,
    /// The sky can't be seen for fog, snow or dust; a vertical visibility is told in place of a base.
    #[serde(rename = "VV")]
    Hidden,
}

impl Cover {
    /// From the fewest eighths of the sky to the most.
    pub fn oktas(self) -> [u32; 2] {
        match self {
            Self::Few => [1, 2],
            Self::Scattered => [3, 4],
            Self::Broken => [5, 7],
            Self::Overcast | Self::Hidden => [8, 8],
        }
    }
}

/// Whether clouds tower.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub enum LayerKind {
    /// Nothing is said of it.
    #[serde(rename = "plain")]
    Plain,
    /// Cumulonimbus.
    #[serde(rename = "CB")]
    Cumulonimbus,
    /// Towering cumulus: congestus of great vertical extent.
    #[serde(rename = "TCU")]
    Towering,
}

/// What a report says in place of layers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "UPPERCASE")]
pub enum Clear {
    /// No clouds, says a person.
    Skc,
    /// None below 12,000 feet, says an American sensor.
    Clr,
    /// None of significance: none below 5,000 feet (or higher ground's safe height), no CB, no TCU. Others there may be.
    Nsc,
    /// None detected, says a sensor.
    Ncd,
    /// As NSC, with 10 km or more to see and no weather.
    Cavok,
}

/// Why a report is refused.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema, thiserror::Error)]
#[error("column {column}: “{group}” can't be read: {reason}")]
pub struct RefusedGroup {
    /// The group as it stands there, its beginning if it is long; empty if the text ends too early.
    pub group: String,
    /// Where it begins, in characters from 1.
    pub column: usize,
    /// What is wrong.
    pub reason: &'static str,
}

/// Reads one report.
///
/// # Errors
/// With the first group that could not be read.
pub fn read(text: &str) -> Result<Report, RefusedGroup> {
    let mut groups = Groups::new(text);
    let mut report = header(&mut groups)?;
    while let Some(token) = groups.next() {
        if take(&mut report, &token, &mut groups)? == Taken::End {
            break;
        }
    }
    Ok(report)
}

#[derive(PartialEq)]
enum Taken {
    Group,
    End,
}

/// Adds what `token` says, and the groups after it that belong to it, to the report.
fn take(report: &mut Report, token: &Token, groups: &mut Groups<'_>) -> Result<Taken, RefusedGroup> {
    let refuse = |reason| token.refused(reason);
    // A number of miles and a fraction are one group.
    let fraction = groups.peek().filter(|next| next.text.contains('/') && next.text.ends_with("SM"));
    if let (1, Some(fraction)) = (token.text.len(), fraction)
        && let Some(miles) = token.text.parse::<u32>().ok().zip(group::fraction(fraction.text.trim_end_matches("SM")))
    {
        groups.next();
        set(&mut report.visibility, Some(group::miles(f64::from(miles.0) + miles.1)), || refuse(TWICE))?;
        return Ok(Taken::Group);
    }
    match group::read(&token.text).map_err(refuse)? {
        Group::Wind(wind) => set(&mut report.wind, wind, || refuse(TWICE))?,
        // The least that one sees, where no sensor knows in which direction; the prevailing one stands before it.
        Group::Visibility(Some(least)) if report.visibility.is_some_and(|before| least.m <= before.m) => {}
        Group::Visibility(visibility) => set(&mut report.visibility, visibility, || refuse(TWICE))?,
        Group::Layer(_) if report.clear.is_some_and(|clear| clear != Clear::Ncd) => {
            return Err(refuse("the report has said before that the sky is clear"));
        }
        Group::Layer(layer) => report.layers.push(layer),
        Group::Clear(clear) if clear != Clear::Ncd && !report.layers.is_empty() => {
            return Err(refuse("the report has told of clouds before"));
        }
        Group::Clear(clear) => {
            set(&mut report.clear, Some(clear), || refuse(TWICE))?;
            if clear == Clear::Cavok {
                set(&mut report.visibility, Some(group::TEN_KM), || refuse(TWICE))?;
            }
        }
        Group::Weather(weather) => report.weather.push(weather),
        Group::Temperatures(temperature, dew_point) => {
            set(&mut report.temperature_c, temperature, || refuse(TWICE))?;
            set(&mut report.dew_point_c, dew_point, || refuse(TWICE))?;
        }
        // Some stations tell it in both units; both are the same.
        Group::Pressure(pressure) => report.pressure_hpa = report.pressure_hpa.or(pressure),
        Group::PassedOver { more } => {
            for _ in 0..more {
                groups.next();
            }
        }
        Group::Nothing => return Err(refuse("the station has sent no observation")),
        Group::End => return Ok(Taken::End),
    }
    Ok(Taken::Group)
}

const TWICE: &str = "the report has another one before it, which says otherwise";

fn set<T: PartialEq>(
    value: &mut Option<T>,
    new: Option<T>,
    refuse: impl FnOnce() -> RefusedGroup,
) -> Result<(), RefusedGroup> {
    match new {
        Some(new) if value.as_ref().is_some_and(|old| *old != new) => return Err(refuse()),
        Some(new) => *value = Some(new),
        None => {}
    }
    Ok(())
}

/// The kind of report, its station and its time.
fn header(groups: &mut Groups<'_>) -> Result<Report, RefusedGroup> {
    while groups.peek().is_some_and(|token| matches!(&*token.text, "METAR" | "SPECI" | "COR")) {
        groups.next();
    }
    let ends = "the text ends before the station and the time";
    let station = groups.next().ok_or_else(|| groups.end(ends))?;
    if station.text == "TAF" {
        return Err(station.refused("that is a forecast; a METAR or SPECI is wanted here"));
    }
    if !is_station(&station.text) {
        return Err(station.refused("a station has four letters, such as EDDF"));
    }
    let time = groups.next().ok_or_else(|| groups.end(ends))?;
    let [day, hour, minute] = group::time(&time.text)
        .ok_or_else(|| time.refused("a report's time is its day, hour and minute with a Z, such as 171320Z"))?;
    Ok(blank(station.text, [day, hour, minute]))
}

fn is_station(text: &str) -> bool {
    text.len() == 4
        && text.starts_with(|c: char| c.is_ascii_uppercase())
        && text.bytes().all(|b| b.is_ascii_alphanumeric())
}

/// A report that says nothing but where and when.
fn blank(station: String, [day, hour, minute]: [u32; 3]) -> Report {
    Report {
        station,
        day,
        hour,
        minute,
        wind: None,
        visibility: None,
        layers: Vec::new(),
        clear: None,
        weather: Vec::new(),
        temperature_c: None,
        dew_point_c: None,
        pressure_hpa: None,
    }
}

/// A group of a report, in capitals.
struct Token {
    text: String,
    column: usize,
}

impl Token {
    fn refused(&self, reason: &'static str) -> RefusedGroup {
        RefusedGroup { group: self.text.chars().take(24).collect(), column: self.column, reason }
    }
}

/// The groups of a text, one after the other; a sign of equality ends a report.
struct Groups<'a> {
    rest: std::iter::Peekable<std::vec::IntoIter<Token>>,
    text: &'a str,
}

impl<'a> Groups<'a> {
    fn new(text: &'a str) -> Self {
        let mut tokens = Vec::new();
        let mut open = false;
        for (i, c) in text.chars().take_while(|c| *c != '=').enumerate() {
            if c.is_whitespace() {
                open = false;
                continue;
            }
            if !std::mem::replace(&mut open, true) {
                tokens.push(Token { text: String::new(), column: i + 1 });
            }
            if let Some(token) = tokens.last_mut() {
                token.text.push(c.to_ascii_uppercase());
            }
        }
        Self { rest: tokens.into_iter().peekable(), text }
    }

    fn next(&mut self) -> Option<Token> {
        self.rest.next()
    }

    fn peek(&mut self) -> Option<&Token> {
        self.rest.peek()
    }

    /// The end of the text, which comes too early.
    fn end(&self, reason: &'static str) -> RefusedGroup {
        RefusedGroup { group: String::new(), column: self.text.chars().count() + 1, reason }
    }
}
