//! The sun's way over one day, sampled: when it rises and sets, and the arc that it draws.

use cloudwright_core::scene::{Site, Sun};
use cloudwright_core::weather::sun_direction;
use egui::{Context, Id};
use glam::Vec3;
use std::sync::Arc;

/// Samples an hour.
const AN_HOUR: usize = 4;
/// Halvings of the span in which the sun passes the horizon: to a second.
const HALVINGS: usize = 10;

/// Of one place and day.
pub(super) struct SunPath {
    sun: Sun,
    place: Site,
    /// Towards the sun, every quarter of an hour, midnight at both ends.
    pub(super) directions: Vec<Vec3>,
    /// Local hours; none on a day on which it doesn't, or with a sun set by hand.
    pub(super) sunrise_h: Option<f64>,
    /// As [`SunPath::sunrise_h`].
    pub(super) sunset_h: Option<f64>,
}

impl SunPath {
    /// The window's last one, if it still holds.
    pub(super) fn of(context: &Context, sun: Sun, place: &Site) -> Arc<Self> {
        let id = Id::unique("sun path");
        let kept: Option<Arc<Self>> = context.data(|data| data.get_temp(id));
        kept.filter(|path| path.sun == sun && path.place == *place).unwrap_or_else(|| {
            let path = Arc::new(Self::new(sun, place));
            context.data_mut(|data| data.insert_temp(id, Arc::clone(&path)));
            path
        })
    }

    /// Degrees above the horizon, at a local hour.
    pub(super) fn elevation_deg(&self, hour: f64) -> f64 {
        let height = sun_direction(self.sun, &self.place, hour).y;
        f64::from(height).clamp(-1.0, 1.0).asin().to_degrees()
    }

    fn new(sun: Sun, place: &Site) -> Self {
        let height = |hour: f64| sun_direction(sun, place, hour).y;
        let hours: Vec<f64> = (0..=24 * AN_HOUR).map(|i| i as f64 / AN_HOUR as f64).collect();
        let directions: Vec<Vec3> = hours.iter().map(|hour| sun_direction(sun, place, *hour)).collect();
        let passes = |up: bool| {
            let at = directions.windows(2).position(|pair| (pair[0].y <= 0.0) == up && (pair[1].y > 0.0) == up)?;
            let (mut before, mut after) = (hours[at], hours[at + 1]);
            for _ in 0..HALVINGS {
                let middle = (before + after) * 0.5;
                *(if (height(middle) > 0.0) == up { &mut after } else { &mut before }) = middle;
            }
            Some((before + after) * 0.5)
        };
        Self { sun, place: place.clone(), sunrise_h: passes(true), sunset_h: passes(false), directions }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn midsummer_in_seattle_and_at_the_pole() {
        // NOAA's calculator, with refraction: 5:11 and 21:11.
        let path = SunPath::new(Sun::ByPlace, &Site::default());
        let (rise, set) = (path.sunrise_h.expect("it rises"), path.sunset_h.expect("it sets"));
        assert!((rise - 5.2).abs() < 0.15 && (set - 21.15).abs() < 0.15, "{rise} and {set}");
        let pole = Site { latitude_deg: 89.0, ..Site::default() };
        let path = SunPath::new(Sun::ByPlace, &pole);
        assert_eq!((path.sunrise_h, path.sunset_h), (None, None));
    }
}
