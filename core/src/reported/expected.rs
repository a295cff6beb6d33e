//! A forecast as reports of the hours ahead: the states that follow one another, where each is reached and left.

use crate::formats::metar::Report;
use crate::formats::metar::forecast::{DayTime, Expected, ExpectedKind, Forecast};

/// How long before a change that comes quickly (FM) all is still as before, minutes.
const QUICK_MIN: u32 = 30;

/// What `forecast` expects, as reports in order of time: between two of them all changes smoothly. What comes and goes
/// within the hour (TEMPO), or perhaps (PROB), is left out: the prevailing sky is made.
pub fn expected(forecast: &Forecast) -> Vec<Report> {
    let mut hours: Vec<Report> = Vec::new();
    let mut reach = |state: &Report, time: DayTime| hours.push(at(state, time));
    let mut state = forecast.first.clone();
    reach(&state, forecast.from);
    for change in &forecast.changes {
        match change.kind {
            ExpectedKind::Passing | ExpectedKind::Perhaps => continue,
            ExpectedKind::At => reach(&state, shortly_before(change.from)),
            ExpectedKind::Becoming => reach(&state, change.from),
        }
        state = changed(&state, change);
        reach(&state, change.until);
    }
    reach(&state, forecast.until);
    hours
}

fn at(state: &Report, time: DayTime) -> Report {
    Report { day: time.day, hour: time.hour, minute: time.minute, ..state.clone() }
}

/// The last day of the month before is not known; there, the change begins at its own time.
fn shortly_before(time: DayTime) -> DayTime {
    let minutes = (time.day * 24 + time.hour) * 60 + time.minute - QUICK_MIN;
    let (day, hour, minute) = (minutes / 1440, minutes / 60 % 24, minutes % 60);
    if day == 0 { time } else { DayTime { day, hour, minute } }
}

/// What `change` does not speak of stays, unless it begins anew.
fn changed(before: &Report, change: &Expected) -> Report {
    let said = &change.report;
    if change.kind == ExpectedKind::At {
        return said.clone();
    }
    let sky = !said.layers.is_empty() || said.clear.is_some();
    let weather = !said.weather.is_empty() || change.ends_weather;
    let of = |speaks: bool| if speaks { said } else { before };
    Report {
        wind: said.wind.or(before.wind),
        visibility: said.visibility.or(before.visibility),
        layers: of(sky).layers.clone(),
        clear: of(sky).clear,
        weather: of(weather).weather.clone(),
        ..before.clone()
    }
}
