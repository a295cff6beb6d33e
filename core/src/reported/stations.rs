//! Reports in order of time, and between stations.

use super::{Sky, minutes_apart};
use crate::formats::metar::Report;
use crate::scene::Scene;
use schemars::JsonSchema;
use serde::Serialize;

/// A report, and where it was made if that is known.
#[derive(Debug, Clone, PartialEq)]
pub struct Told {
    /// What it says.
    pub report: Report,
    /// Of its station.
    pub place: Option<Place>,
}

/// A place on the Earth.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Place {
    /// North is positive.
    pub latitude_deg: f64,
    /// East is positive.
    pub longitude_deg: f64,
}

/// Reports that are no timeline.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unordered {
    /// There is none.
    #[error("there is no report")]
    None,
    /// They are of several stations, and of one it is not known where it is.
    #[error("reports of {stations} stations, and none says where {unplaced} is")]
    Unplaced {
        /// How many there are.
        stations: usize,
        /// One of them.
        unplaced: String,
    },
}

/// As many stations count at a place, the nearest ones.
const NEAREST: usize = 8;
/// Stations that are nearer weigh no more, kilometres.
const NEAR_KM: f64 = 1.0;
/// Mean radius of the Earth (IUGG).
const EARTH_KM: f64 = 6371.009;

impl Place {
    /// Along a great circle, by the haversine, kilometres.
    pub fn km_to(self, other: Self) -> f64 {
        let half_sine = |degrees: f64| libm::sin(0.5 * degrees.to_radians());
        let (north, east) =
            (half_sine(self.latitude_deg - other.latitude_deg), half_sine(self.longitude_deg - other.longitude_deg));
        let cosines = libm::cos(self.latitude_deg.to_radians()) * libm::cos(other.latitude_deg.to_radians());
        2.0 * EARTH_KM * libm::asin((north * north + cosines * east * east).clamp(0.0, 1.0).sqrt())
    }
}

/// The skies that `told` ask for over `here`, each with its seconds from the first: one for every time at which a station
/// reported. Of several stations the nearest eight count, by their latest report or else their first, and weigh by the
/// inverse square of their distance. Of two reports of one station and minute the later in the list holds, as corrections
/// come later.
///
/// # Errors
/// If there is none, or several stations of which one has no place.
pub fn skies(told: &[Told], here: Place, scene: &Scene) -> Result<Vec<(f64, Sky)>, Unordered> {
    let minutes = minutes_apart(told.iter().map(|told| &told.report)).ok_or(Unordered::None)?;
    let mut names: Vec<&str> = told.iter().map(|told| told.report.station.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let mut stations: Vec<(f64, Vec<(u32, &Report)>)> = Vec::with_capacity(names.len());
    for name in &names {
        let own = || told.iter().zip(&minutes).filter(|(told, _)| told.report.station == *name);
        let place = own().find_map(|(told, _)| told.place);
        if place.is_none() && names.len() > 1 {
            return Err(Unordered::Unplaced { stations: names.len(), unplaced: (*name).to_owned() });
        }
        let km = place.map_or(NEAR_KM, |place| place.km_to(here)).max(NEAR_KM);
        // What comes later in the list stands behind, and is found first from there.
        let mut reports: Vec<(u32, &Report)> = own().map(|(told, minute)| (*minute, &told.report)).collect();
        reports.sort_by_key(|(minute, _)| *minute);
        stations.push((km, reports));
    }
    stations.sort_by(|a, b| a.0.total_cmp(&b.0));
    stations.truncate(NEAREST);
    let mut times: Vec<u32> =
        stations.iter().flat_map(|(_, reports)| reports.iter().map(|(minute, _)| *minute)).collect();
    times.sort_unstable();
    times.dedup();
    let start = times.first().copied().unwrap_or_default();
    let at = |minute: u32| {
        let weighed: Vec<(f64, Sky)> = stations
            .iter()
            .filter_map(|(km, reports)| {
                let latest = reports.iter().rfind(|(made, _)| *made <= minute).or(reports.first());
                Some((1.0 / (km * km), Sky::of(latest?.1, scene)))
            })
            .collect();
        Some((60.0 * f64::from(minute - start), Sky::between(&weighed)?))
    };
    Ok(times.into_iter().filter_map(at).collect())
}
