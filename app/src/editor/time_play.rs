//! The time of day, running.
//!
//! It runs in the view alone: nothing in the scene changes, so nothing can be undone or is unsaved. When it stops, the
//! hour that it reached becomes the scene's, as one step. Esc and undo drop it; so does a hand that sets another hour.

use super::Editor;
use cloudwright_core::document::Edit;

/// Seconds that one frame may move on what runs by the clock: after a stall it goes on where it was, and doesn't jump.
pub(crate) const MAX_STEP_S: f64 = 0.25;

/// Whether time runs, and how fast.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TimePlay {
    hour: Option<f64>,
    hours_a_minute: f64,
}

impl Default for TimePlay {
    fn default() -> Self {
        Self { hour: None, hours_a_minute: 24.0 }
    }
}

impl TimePlay {
    /// The hour that it has reached, in [0, 24), while it runs.
    pub(crate) fn hour(&self) -> Option<f64> {
        self.hour
    }

    /// Hours of the scene in a minute of the artist's.
    pub(crate) fn hours_a_minute(&self) -> f64 {
        self.hours_a_minute
    }

    pub(crate) fn is_on(&self) -> bool {
        self.hour.is_some()
    }

    pub(super) fn set_speed(&mut self, hours_a_minute: f64) {
        if hours_a_minute.is_finite() {
            self.hours_a_minute = hours_a_minute;
        }
    }

    /// Stops, and the hour is forgotten.
    pub(super) fn drop_hour(&mut self) {
        self.hour = None;
    }

    fn advance(&mut self, seconds: f64) {
        if let Some(hour) = &mut self.hour {
            *hour = (*hour + seconds.clamp(0.0, MAX_STEP_S) * self.hours_a_minute / 60.0).rem_euclid(24.0);
        }
    }
}

impl Editor {
    /// Starts at the scene's hour; or stops, and the scene's hour is the one that was reached.
    pub(super) fn toggle_time(&mut self) {
        if let Some(hour) = self.time_play.hour.take() {
            let edit = Edit::TimeOfDay(hour);
            let done = self.session.edit(&edit.name(), vec![edit]);
            self.report(done);
        } else {
            self.time_play.hour = Some(self.session.scene().time_of_day_h);
        }
    }

    /// A frame's worth of time; the next frame is asked for only while it runs.
    pub(super) fn run_time(&mut self, context: &egui::Context) {
        if !self.time_play.is_on() {
            return;
        }
        if context.input(|input| input.key_pressed(egui::Key::Escape)) && !self.viewport.has_keys() {
            self.time_play.drop_hour();
            return;
        }
        self.time_play.advance(context.input(|input| f64::from(input.stable_dt)));
        context.request_repaint();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_across_midnight_and_never_jumps() {
        let mut time = TimePlay { hour: Some(23.95), hours_a_minute: 60.0 };
        time.advance(0.1);
        assert!((time.hour.expect("it runs") - 0.05).abs() < 1e-9);
        time.advance(3600.0);
        assert!((time.hour.expect("it runs") - 0.3).abs() < 1e-9, "a stall counts as one step");
        time.set_speed(f64::NAN);
        time.advance(f64::NAN);
        assert_eq!(time.hours_a_minute(), 60.0);
        time.drop_hour();
        time.advance(0.1);
        assert!(!time.is_on());
    }
}
