//! Reports out of a text: METAR, SPECI and TAF, a line each, or as a weather service's JSON.

use cloudwright_core::formats::metar::{self, RefusedGroup, Report, forecast};
use cloudwright_core::reported::{Place, Told, expected};
use cloudwright_core::scene::Date;
use serde_json::Value;

/// A report's text, and what stands in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Which line of the text it begins in, from 1; of JSON, which of its reports.
    pub number: usize,
    /// The report, of a forecast one for each of its states; or why it can't be read.
    pub read: Result<Vec<Report>, RefusedGroup>,
    /// Where the station is, where that is told.
    pub place: Option<Place>,
    /// The day of the report, where that is told.
    pub date: Option<Date>,
}

impl Line {
    /// The station's letters, if it could be read.
    pub fn station(&self) -> Option<&str> {
        Some(&self.read.as_ref().ok()?.first()?.station)
    }
}

/// The text is JSON, but holds no reports.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct NoReports(String);

/// All reports of `text`.
///
/// In a text each is a line; what is indented goes on with the one before, as forecasts do, and empty lines and those that
/// begin with # are passed over. JSON is a list of objects with `rawOb` or `rawTAF`, and perhaps `lat`, `lon` and
/// `reportTime`, as aviationweather.gov answers.
///
/// # Errors
/// If the text is JSON without such a list.
pub fn lines(text: &str) -> Result<Vec<Line>, NoReports> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim_start().starts_with(['[', '{']) {
        return of_json(text);
    }
    let mut reports: Vec<(usize, String)> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let passed_over = line.trim().is_empty() || line.trim_start().starts_with('#');
        let goes_on = line.starts_with(char::is_whitespace);
        match reports.last_mut() {
            _ if passed_over => {}
            // The line's end counts as one character, as it does in the text.
            Some((_, report)) if goes_on => *report = format!("{report}\n{line}"),
            _ => reports.push((index + 1, line.to_owned())),
        }
    }
    let line = |(number, text): (usize, String)| Line { number, read: read(&text), place: None, date: None };
    Ok(reports.into_iter().map(line).collect())
}

/// One report or forecast, over any number of lines.
pub fn one(text: &str) -> Line {
    Line { number: 1, read: read(text), place: None, date: None }
}

/// What was read of all lines, for [`super::make`]; or the first line that could not be read.
///
/// # Errors
/// With that line and its group.
pub fn told(lines: &[Line]) -> Result<Vec<Told>, (usize, &RefusedGroup)> {
    let mut told = Vec::new();
    for Line { number, read, place, .. } in lines {
        let reports = read.as_ref().map_err(|refused| (*number, refused))?;
        told.extend(reports.iter().map(|report| Told { report: report.clone(), place: *place }));
    }
    Ok(told)
}

/// A place as people write it: degrees north and degrees east, `50.03, 8.57`. None if it is none.
pub fn place_of(text: &str) -> Option<Place> {
    let (latitude, longitude) = text.split_once(',')?;
    let degrees = |text: &str, most: f64| text.trim().parse::<f64>().ok().filter(|deg| deg.abs() <= most);
    Some(Place { latitude_deg: degrees(latitude, 90.0)?, longitude_deg: degrees(longitude, 180.0)? })
}

/// Has stations be where `told` knows them, by their letters.
pub fn put_stations(lines: &mut [Line], told: impl Fn(&str) -> Option<Place>) {
    for line in lines {
        line.place = line.station().and_then(&told).or(line.place);
    }
}

fn read(text: &str) -> Result<Vec<Report>, RefusedGroup> {
    let mut words = text.split_whitespace();
    if words.next().is_some_and(|word| word.eq_ignore_ascii_case("TAF")) {
        forecast::read(text).map(|forecast| expected(&forecast))
    } else {
        metar::read(text).map(|report| vec![report])
    }
}

fn of_json(text: &str) -> Result<Vec<Line>, NoReports> {
    let refuse = |what: &str| NoReports(what.to_owned());
    let json: Value = serde_json::from_str(text).map_err(|error| NoReports(format!("it is no JSON: {error}")))?;
    let list = match &json {
        Value::Array(list) => list.as_slice(),
        one => std::slice::from_ref(one),
    };
    let line = |(index, report): (usize, &Value)| {
        let raw = ["rawOb", "rawTAF"].iter().find_map(|name| report.get(name)?.as_str());
        let raw = raw.ok_or_else(|| refuse("a report has neither rawOb nor rawTAF, a text"))?;
        let degrees = |name: &str, most: f64| report.get(name)?.as_f64().filter(|deg| deg.abs() <= most);
        let place = degrees("lat", 90.0).zip(degrees("lon", 180.0));
        let time = ["reportTime", "issueTime"].iter().find_map(|name| report.get(name)?.as_str());
        let date = time.and_then(|time| time.get(..10)?.parse().ok());
        // A forecast of the service's begins with its word, or not.
        let text = match report.get("rawOb") {
            None if !raw.trim_start().starts_with("TAF") => format!("TAF {raw}"),
            _ => raw.to_owned(),
        };
        Ok(Line {
            number: index + 1,
            read: read(&text),
            place: place.map(|(latitude_deg, longitude_deg)| Place { latitude_deg, longitude_deg }),
            date,
        })
    };
    list.iter().enumerate().map(line).collect()
}
