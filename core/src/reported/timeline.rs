//! Skies into a scene: one sets its properties, several become tracks.

use super::Sky;
use crate::arrange::keys;
use crate::document::{Document, Edit, EditError, ListEdit};
use crate::formats::metar::Report;
use crate::property::{Address, NoSuchProperty, Target, Value};
use crate::scene::{KeyValue, Track, TrackId, TrackKey};
use std::ops::RangeInclusive;

/// How many seconds may pass between reports in one of the scene's clock.
pub const SPEEDS: RangeInclusive<f64> = 1.0..=86_400.0;

/// Reports that a scene does not take.
#[derive(Debug, thiserror::Error)]
pub enum ApplyError {
    /// An edit was refused.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// A property has another name.
    #[error(transparent)]
    Property(#[from] NoSuchProperty),
}

/// When each report was made, minutes from the beginning of the earliest one's month; none of none.
///
/// Reports tell the day of the month and no month. Days more than fifteen apart are of two months, of which the earlier
/// ends with the last day that is told of it.
pub(super) fn minutes_apart<'a>(reports: impl Iterator<Item = &'a Report> + Clone) -> Option<Vec<u32>> {
    let days = || reports.clone().map(|report| report.day);
    let (least, most) = (days().min()?, days().max()?);
    let minute = |report: &Report| {
        let next_month = most - least > 15 && report.day <= 15;
        let day = report.day + if next_month { most } else { 0 };
        (day * 24 + report.hour) * 60 + report.minute
    };
    Some(reports.map(minute).collect())
}

/// Has `document`'s scene take the air of `skies`, each with its second, within the transaction that is open: the first
/// one's at once, and of several tracks with smooth keys, `speed` of their seconds in one of the clock's. Tracks that the
/// properties had go. The time of day runs on past 24, as its keys may.
///
/// # Errors
/// If an edit is refused.
pub fn take_air(document: &mut Document, skies: &[(f64, Sky)], speed: f64) -> Result<(), ApplyError> {
    // Each property's keys; what a report does not know has none at its time.
    let mut keyed: Vec<(&'static str, Vec<(f64, f64)>)> = Vec::new();
    let start_h = skies.first().map_or(0.0, |(_, sky)| sky.air.time_of_day_h);
    for (time_s, sky) in skies {
        for (address, value) in sky.air.values() {
            let value = if address == "time_of_day_h" { start_h + time_s / 3600.0 } else { value };
            match keyed.iter_mut().find(|each| each.0 == address) {
                Some((_, keys)) => keys.push((*time_s / speed, value)),
                None => keyed.push((address, vec![(*time_s / speed, value)])),
            }
        }
    }
    for (address, keys) in keyed {
        let target: Target = address.parse()?;
        let Some((_, first)) = keys.first() else { continue };
        let address: Address = address.parse()?;
        let set = Edit::set(document.scene(), address, &Value::Number(*first))?;
        document.apply(set)?;
        let keys = if skies.len() > 1 { keys } else { Vec::new() };
        let keys = keys.into_iter().map(|(time_s, value)| TrackKey::new(time_s, KeyValue::One(value))).collect();
        take_track(document, target, keys)?;
    }
    Ok(())
}

/// Has a property have a track of those keys in place of what it had, or none without keys; within the transaction that
/// is open.
///
/// # Errors
/// If an edit is refused.
pub fn take_track(document: &mut Document, target: Target, keys: Vec<TrackKey>) -> Result<(), EditError> {
    for edit in keys::cleared(document.scene(), &[target]).edits {
        document.apply(edit)?;
    }
    if keys.is_empty() {
        return Ok(());
    }
    let mut next_id = document.scene().next_id;
    let id = TrackId::new(&mut next_id);
    document.apply(Edit::NextId(next_id))?;
    let track = Track::new(id, target.to_string(), keys);
    document.apply(Edit::Track(ListEdit::Insert { at: usize::MAX, value: track }))?;
    Ok(())
}
