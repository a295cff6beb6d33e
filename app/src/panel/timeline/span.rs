//! Time from left to right: to the screen and back, zoom about the pointer, marks of a ruler, and what times snap to.

use crate::state::TimeSnap;
use cloudwright_core::arrange::keys::{MOST_S, to_step};
use egui::Rangef;

/// As close as it gets, and as far, seconds from left to right.
const WIDTHS_S: [f64; 2] = [0.02, 2e7];
/// Between marks with numbers, points at least.
const TICK: f32 = 58.0;
/// So near to a key or the clock, dragged times are at it, points.
const MAGNET: f32 = 6.0;
/// Of the ruler's marks, seconds.
const STEPS_S: [f64; 24] = [
    0.01,
    0.02,
    0.05,
    0.1,
    0.2,
    0.5,
    1.0,
    2.0,
    5.0,
    10.0,
    20.0,
    30.0,
    60.0,
    120.0,
    300.0,
    600.0,
    1800.0,
    3600.0,
    7200.0,
    21_600.0,
    86_400.0,
    604_800.0,
    2_592_000.0,
    2e7,
];

/// What of the time is in sight, and where.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    pub(super) x: Rangef,
    pub(super) times_s: [f64; 2],
}

impl Span {
    pub(super) fn s_per_point(&self) -> f64 {
        (self.times_s[1] - self.times_s[0]) / f64::from(self.x.span().max(1.0))
    }

    /// Where a time is; what lies far out of sight stays near enough to be drawn.
    pub(super) fn x_of(&self, time_s: f64) -> f32 {
        let points = (time_s - self.times_s[0]) / self.s_per_point();
        self.x.min + points.clamp(-1e5, 1e5) as f32
    }

    pub(super) fn time_at(&self, x: f32) -> f64 {
        self.times_s[0] + f64::from(x - self.x.min) * self.s_per_point()
    }

    /// More of the time by that factor; what is at `x` stays there.
    pub(super) fn zoomed(self, x: f32, factor: f64) -> Self {
        let width_s = self.times_s[1] - self.times_s[0];
        let factor = (width_s * factor).clamp(WIDTHS_S[0], WIDTHS_S[1]) / width_s;
        let about_s = self.time_at(x);
        self.at(self.times_s.map(|time_s| about_s + (time_s - about_s) * factor))
    }

    /// What is in sight goes along with a hand.
    pub(super) fn panned(self, points: f32) -> Self {
        let by_s = -f64::from(points) * self.s_per_point();
        self.at(self.times_s.map(|time_s| time_s + by_s))
    }

    /// The same place with other times; if they are within bounds.
    fn at(self, times_s: [f64; 2]) -> Self {
        let is_sound = times_s.iter().all(|time_s| time_s.abs() <= MOST_S * 2.0) && times_s[1] > times_s[0];
        if is_sound { Self { times_s, ..self } } else { self }
    }

    /// Times that hold all from the first to the last, with some room.
    pub(super) fn around([first_s, last_s]: [f64; 2]) -> [f64; 2] {
        let room_s = ((last_s - first_s) * 0.05).max(0.25);
        [first_s - room_s, last_s + room_s]
    }

    /// Between marks with numbers, seconds.
    pub(super) fn step_s(&self) -> f64 {
        let least_s = f64::from(TICK) * self.s_per_point();
        STEPS_S.into_iter().find(|step_s| *step_s >= least_s).unwrap_or(STEPS_S[STEPS_S.len() - 1])
    }

    /// The marks in sight, `step_s` apart.
    pub(super) fn marks(&self, step_s: f64) -> impl Iterator<Item = f64> + use<> {
        let [first, last] = self.times_s.map(|time_s| time_s / step_s);
        let count = (last.floor() - first.ceil()).clamp(-1.0, 5000.0) as i64;
        (0..=count).map(move |mark| (first.ceil() + mark as f64) * step_s)
    }

    /// Where a dragged time snaps to: to one of `others` if that is near, else to a step. `coarse`: to whole seconds.
    pub(super) fn snapped(&self, time_s: f64, snap: TimeSnap, coarse: bool, others: impl Iterator<Item = f64>) -> f64 {
        let step_s = match snap {
            _ if coarse => 1.0,
            TimeSnap::Off => return to_step(time_s),
            TimeSnap::Frames => 1.0 / 24.0,
            TimeSnap::Seconds => 1.0,
        };
        let apart = |other: f64| (other - time_s).abs();
        let near = others.min_by(|a, b| apart(*a).total_cmp(&apart(*b)));
        let near = near.filter(|other| apart(*other) <= f64::from(MAGNET) * self.s_per_point() && !coarse);
        to_step(near.unwrap_or_else(|| (time_s / step_s).round() * step_s))
    }
}

/// A time as people read it: to the millisecond, without zeros behind.
pub(super) fn seconds(time_s: f64) -> String {
    let time_s = (time_s * 1e3).round() / 1e3;
    format!("{} s", if time_s == 0.0 { 0.0 } else { time_s })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPAN: Span = Span { x: Rangef { min: 100.0, max: 300.0 }, times_s: [-10.0, 30.0] };

    #[test]
    fn zoom_and_pan_keep_what_is_under_the_pointer() {
        assert_eq!((SPAN.time_at(150.0), SPAN.x_of(0.0)), (0.0, 150.0));
        let near = SPAN.zoomed(150.0, 0.25);
        assert!((near.time_at(150.0)).abs() < 1e-9 && near.s_per_point() < SPAN.s_per_point());
        assert!((SPAN.panned(20.0).time_at(170.0)).abs() < 1e-9);
        let mut far = SPAN;
        for _ in 0..1000 {
            far = far.zoomed(170.0, 3.0).panned(f32::NAN);
        }
        assert!(far.times_s.iter().all(|time_s| time_s.is_finite()) && far.x_of(f64::INFINITY).is_finite());
        assert!(far.marks(far.step_s()).count() < 50);
    }

    #[test]
    fn times_snap_to_what_is_near() {
        let snapped = |time_s, snap, coarse| SPAN.snapped(time_s, snap, coarse, [7.3].into_iter());
        assert_eq!(snapped(8.2, TimeSnap::Seconds, false), 7.3, "another key");
        assert_eq!(snapped(9.2, TimeSnap::Seconds, false), 9.0);
        assert_eq!(snapped(9.2, TimeSnap::Frames, false), to_step(221.0 / 24.0));
        assert_eq!(snapped(9.2, TimeSnap::Off, false), 9.2);
        assert_eq!(snapped(7.4, TimeSnap::Off, true), 7.0);
        assert_eq!([seconds(2.0), seconds(0.041_666), seconds(-0.0)], ["2 s", "0.042 s", "0 s"]);
    }
}
