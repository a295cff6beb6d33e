//! Light, sky, haze and ground as rows of numbers: over the day, and over the scene's clock.

use super::super::Leaving;
use crate::exchange::sampled::sampled;
use crate::frame::background;
use crate::weather::{Moment, SceneNow, WeatherRules};
use glam::DVec3;

/// How many numbers each row has of what, in order.
pub(super) const FIELDS: [(&str, usize); 15] = [
    ("hour", 1),
    ("sun_direction", 3),
    ("ambient", 4),
    ("directional", 3),
    ("dome_parameters", 27),
    ("dome_scale", 3),
    ("sun_disc", 3),
    ("glow_direction", 3),
    ("haze_length_m", 1),
    ("exposure", 1),
    ("inside_density", 1),
    ("ground_dark", 3),
    ("ground_bright", 3),
    ("ground_without_sun", 3),
    ("shadow_share", 1),
];
const NUMBERS: usize = {
    let (mut sum, mut i) = (0, 0);
    while i < FIELDS.len() {
        sum += FIELDS[i].1;
        i += 1;
    }
    sum
};
/// Rows of an hour.
pub(super) const ROWS_AN_HOUR: usize = 10;
/// Where the clock moves the sky: so many times a day is told once more.
const DAYS: usize = 8;
/// How far a straight line between two rows of the clock may be from the truth, as a share of the number; of what is
/// less than a hundredth, in ten-thousandths.
const TOLERANCE: f32 = 0.01;

pub(super) type Row = [f32; NUMBERS];

/// The seconds of the clock at which there is a day of rows: evenly over it, if it moves the sky itself and not just the
/// hour; else the moment's.
pub(super) fn days_s(leaving: &Leaving<'_>, times_s: &[f64]) -> Vec<f64> {
    let noon = |clock_s: f64| row(leaving, Moment { clock_s, time_h: Some(12.0) });
    let (Some(first_s), Some(last_s)) = (times_s.first(), times_s.last()) else { return vec![leaving.moment.clock_s] };
    if times_s.iter().all(|time_s| noon(*time_s) == noon(*first_s)) {
        return vec![leaving.moment.clock_s];
    }
    (0..=DAYS).map(|day| first_s + (last_s - first_s) * day as f64 / DAYS as f64).collect()
}

/// From midnight to midnight, each six minutes, one day after the other.
pub(super) fn by_hour(leaving: &Leaving<'_>, days_s: &[f64]) -> Vec<Row> {
    let hour = |row: usize| row as f64 / ROWS_AN_HOUR as f64;
    let row = |clock_s: f64, at: usize| {
        // Midnight's end is not its beginning to whoever interpolates.
        let mut row = row(leaving, Moment { clock_s, time_h: Some(hour(at)) });
        row[0] = hour(at) as f32;
        row
    };
    days_s.iter().flat_map(|clock_s| (0..=24 * ROWS_AN_HOUR).map(move |at| row(*clock_s, at))).collect()
}

/// At the scene's own hour, each behind its second of the clock; one row if the clock moves none of it.
pub(super) fn by_clock(leaving: &Leaving<'_>, times_s: &[f64]) -> Vec<[f32; NUMBERS + 1]> {
    let near = |a: Row, b: Row| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= TOLERANCE * a.abs().max(0.01));
    let at = |clock_s: f64| row(leaving, Moment::at(clock_s));
    let between = |a: Row, b: Row, share: f64| std::array::from_fn(|i| a[i] + (b[i] - a[i]) * share as f32);
    let mut rows = sampled(times_s, at, between, near);
    if rows.iter().all(|(_, row)| *row == rows[0].1) {
        rows.truncate(1);
    }
    let timed = |(clock_s, row): (f64, Row)| {
        let mut timed = [clock_s as f32; NUMBERS + 1];
        timed[1..].copy_from_slice(&row);
        timed
    };
    rows.into_iter().map(timed).collect()
}

fn row(leaving: &Leaving<'_>, moment: Moment) -> Row {
    let Leaving { scene, derived, .. } = *leaving;
    let now = SceneNow::new(scene, (&[], derived.timeline()), moment, WeatherRules::default());
    // From above the ground, whose colours are the same from everywhere there.
    let altitude_m = now.ground.as_ref().map_or(0.0, |ground| ground.altitude_m);
    let behind = background(&now, DVec3::Y * (altitude_m + 1.0));
    let (light, dome) = (&now.light, &behind.dome);
    let mut row = Vec::with_capacity(NUMBERS);
    row.push(light.time_h.rem_euclid(24.0) as f32);
    row.extend(light.direction.to_array());
    row.extend(light.ambient_max.to_array());
    row.extend(light.directional_max.to_array());
    row.extend((0..9).flat_map(|i| dome.parameters.map(|channel| channel[i])));
    row.extend(dome.scale.to_array());
    row.extend(dome.sun_disc.to_array());
    row.extend(dome.glow_direction.to_array());
    row.extend([behind.haze_length_m, now.exposure, now.inside_density]);
    row.extend(behind.ground.as_ref().map_or([0.0; 3], |ground| ground.dark.to_array()));
    row.extend(behind.ground.as_ref().map_or([0.0; 3], |ground| ground.bright.to_array()));
    row.extend(behind.ground.as_ref().map_or([1.0; 3], |ground| ground.without_sun.to_array()));
    row.push(now.shadows.map_or(0.0, |shadows| shadows.share));
    let mut whole = [0.0; NUMBERS];
    whole.iter_mut().zip(row).for_each(|(slot, number)| *slot = number);
    whole
}
