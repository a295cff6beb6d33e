//! The time of day, running.
//!
//! It runs in the view alone: nothing in the scene changes, so nothing can be undone or is unsaved. When it stops, the
//! hour that it reached becomes the scene's, as one step. Esc and undo drop it; so does a hand that sets another hour.

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

    pub(crate) fn set_speed(&mut self, hours_a_minute: f64) {
        if hours_a_minute.is_finite() {
            self.hours_a_minute = hours_a_minute;
        }
    }

    /// Starts at `hour`, in [0, 24).
    pub(crate) fn start(&mut self, hour: f64) {
        self.hour = Some(hour);
    }

    /// Stops. The hour that it had reached, if it ran.
    pub(crate) fn stop(&mut self) -> Option<f64> {
        self.hour.take()
    }

    /// Stops, and the hour is forgotten.
    pub(crate) fn drop_hour(&mut self) {
        self.hour = None;
    }

    /// A frame's worth of the artist's seconds; a stall counts as one step.
    pub(crate) fn advance(&mut self, seconds: f64) {
        if let Some(hour) = &mut self.hour {
            *hour = (*hour + seconds.clamp(0.0, MAX_STEP_S) * self.hours_a_minute / 60.0).rem_euclid(24.0);
        }
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
