//! Reports into a scene: one sets its properties, several of one station become tracks.

use super::Air;
use crate::arrange::keys;
use crate::document::{Document, Edit, EditError, ListEdit};
use crate::formats::metar::Report;
use crate::property::{Address, NoSuchProperty, Target, Value};
use crate::scene::{KeyValue, Track, TrackId, TrackKey};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// How many seconds may pass between reports in one of the scene's clock.
pub const SPEEDS: RangeInclusive<f64> = 1.0..=86_400.0;

/// Reports that are no timeline.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unordered {
    /// There is none.
    #[error("there is no report")]
    None,
    /// They are of several stations.
    #[error("reports of two stations, {0} and {1}")]
    Stations(String, String),
}

/// Reports that a scene does not take.
#[derive(Debug, thiserror::Error)]
pub enum ApplyError {
    /// They are no timeline.
    #[error(transparent)]
    Unordered(#[from] Unordered),
    /// An edit was refused.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// A property has another name.
    #[error(transparent)]
    Property(#[from] NoSuchProperty),
}

/// When each report was made, seconds from the earliest, in order of time; of two of one minute the later in the list, as
/// corrections come later.
///
/// Reports tell the day of the month and no month. Days more than fifteen apart are of two months, of which the earlier
/// ends with the last day that is told of it.
///
/// # Errors
/// If there is none, or they are of several stations.
pub fn seconds(reports: &[Report]) -> Result<Vec<(f64, &Report)>, Unordered> {
    let first = reports.first().ok_or(Unordered::None)?;
    if let Some(other) = reports.iter().find(|report| report.station != first.station) {
        return Err(Unordered::Stations(first.station.clone(), other.station.clone()));
    }
    let days = || reports.iter().map(|report| report.day);
    let (least, most) = (days().min().unwrap_or(1), days().max().unwrap_or(1));
    let minute = |report: &Report| {
        let next_month = most - least > 15 && report.day <= 15;
        let day = report.day + if next_month { most } else { 0 };
        (day * 24 + report.hour) * 60 + report.minute
    };
    let in_order: BTreeMap<u32, &Report> = reports.iter().map(|report| (minute(report), report)).collect();
    let start = in_order.keys().next().copied().unwrap_or(0);
    Ok(in_order.into_iter().map(|(minute, report)| (60.0 * f64::from(minute - start), report)).collect())
}

/// Has `document`'s scene take the air of `reports` as one undo point: the first report's at once, and of several tracks
/// with smooth keys, `speed` of their seconds in one of the clock's. Tracks that the properties had go. The time of day
/// runs on past 24, as its keys may.
///
/// # Errors
/// If the reports are no timeline; the document is then as before.
pub fn apply(document: &mut Document, reports: &[Report], speed: f64) -> Result<(), ApplyError> {
    let timed = seconds(reports)?;
    document.begin("Weather from reports");
    let done = edit(document, &timed, speed.clamp(*SPEEDS.start(), *SPEEDS.end()));
    match done {
        Ok(()) => Ok(document.commit()?),
        Err(error) => {
            document.cancel();
            Err(error)
        }
    }
}

fn edit(document: &mut Document, timed: &[(f64, &Report)], speed: f64) -> Result<(), ApplyError> {
    let airs: Vec<(f64, Air)> =
        timed.iter().map(|(time_s, report)| (*time_s, Air::of(report, document.scene()))).collect();
    // Each property's keys; what a report does not know has none at its time.
    let mut keyed: Vec<(&'static str, Vec<(f64, f64)>)> = Vec::new();
    let start_h = airs.first().map_or(0.0, |(_, air)| air.time_of_day_h);
    for (time_s, air) in &airs {
        for (address, value) in air.values() {
            let value = if address == "time_of_day_h" { start_h + time_s / 3600.0 } else { value };
            match keyed.iter_mut().find(|each| each.0 == address) {
                Some((_, keys)) => keys.push((*time_s / speed, value)),
                None => keyed.push((address, vec![(*time_s / speed, value)])),
            }
        }
    }
    for (address, keys) in keyed {
        let target: Target = address.parse()?;
        for edit in keys::cleared(document.scene(), &[target]).edits {
            document.apply(edit)?;
        }
        let Some((_, first)) = keys.first() else { continue };
        let address: Address = address.parse()?;
        let set = Edit::set(document.scene(), address, &Value::Number(*first))?;
        document.apply(set)?;
        if timed.len() > 1 {
            let mut next_id = document.scene().next_id;
            let id = TrackId::new(&mut next_id);
            let keys = keys.iter().map(|(time_s, value)| TrackKey::new(*time_s, KeyValue::One(*value))).collect();
            document.apply(Edit::NextId(next_id))?;
            let track = Track::new(id, target.to_string(), keys);
            document.apply(Edit::Track(ListEdit::Insert { at: usize::MAX, value: track }))?;
        }
    }
    Ok(())
}
