//! An hour that is tried out in the view, running or not.
//!
//! Nothing in the scene changes by it, so nothing is unsaved and there is nothing to undo. It begins at the scene's hour and
//! runs; stopped, it stays where it is until it is kept in the scene, or left for the scene's own. Whatever changes the
//! scene's hour meanwhile ends it.

/// Seconds that one frame may move on what runs by the clock: after a stall it goes on where it was, and doesn't jump.
pub(crate) const MAX_STEP_S: f64 = 0.25;

/// The hour that is tried out, if one is, and how fast it runs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TimePlay {
    tried: Option<Tried>,
    hours_a_minute: f64,
}

#[derive(Debug, Clone, Copy)]
struct Tried {
    /// In [0, 24).
    hour: f64,
    /// The scene's, where it began.
    scene_hour: f64,
    runs: bool,
}

impl Default for TimePlay {
    fn default() -> Self {
        Self { tried: None, hours_a_minute: 24.0 }
    }
}

impl TimePlay {
    /// The hour that is tried out, in [0, 24); none if the scene's is shown.
    pub(crate) fn time_h(&self) -> Option<f64> {
        self.tried.map(|tried| tried.hour)
    }

    /// Whether it runs.
    pub(crate) fn runs(&self) -> bool {
        self.tried.is_some_and(|tried| tried.runs)
    }

    /// Hours of the scene in a minute of the artist's.
    pub(crate) fn hours_a_minute(&self) -> f64 {
        self.hours_a_minute
    }

    pub(crate) fn set_speed(&mut self, hours_a_minute: f64) {
        if hours_a_minute.is_finite() {
            self.hours_a_minute = hours_a_minute;
        }
    }

    /// Runs on from where it stopped, or from the scene's hour; or stops.
    pub(crate) fn run_or_stop(&mut self, scene_hour: f64) {
        let tried = self.tried.get_or_insert(Tried { hour: scene_hour, scene_hour, runs: false });
        tried.runs = !tried.runs;
    }

    /// The scene's hour is shown again. The one that was tried out, if there was one.
    pub(crate) fn leave(&mut self) -> Option<f64> {
        self.tried.take().map(|tried| tried.hour)
    }

    /// A frame's worth of the artist's seconds, of a scene with that hour.
    pub(crate) fn advance(&mut self, seconds: f64, scene_hour: f64) {
        self.tried = self.tried.filter(|tried| tried.scene_hour == scene_hour);
        if let Some(tried) = self.tried.as_mut().filter(|tried| tried.runs) {
            tried.hour = (tried.hour + seconds.clamp(0.0, MAX_STEP_S) * self.hours_a_minute / 60.0).rem_euclid(24.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_across_midnight_and_never_jumps() {
        let mut time = TimePlay::default();
        time.set_speed(60.0);
        time.run_or_stop(23.95);
        time.advance(0.1, 23.95);
        assert!((time.time_h().expect("it runs") - 0.05).abs() < 1e-9);
        time.advance(3600.0, 23.95);
        assert!((time.time_h().expect("it runs") - 0.3).abs() < 1e-9, "a stall counts as one step");
        time.set_speed(f64::NAN);
        time.advance(f64::NAN, 23.95);
        assert_eq!(time.hours_a_minute(), 60.0);
        assert!(time.leave().is_some() && time.time_h().is_none());
        time.advance(0.1, 23.95);
        assert!(!time.runs());
    }

    #[test]
    fn stays_where_it_stopped_until_the_scene_has_another_hour() {
        let mut time = TimePlay::default();
        time.run_or_stop(12.0);
        time.advance(0.25, 12.0);
        time.run_or_stop(12.0);
        time.advance(0.25, 12.0);
        assert_eq!((time.time_h(), time.runs()), (Some(12.1), false));
        time.run_or_stop(12.0);
        time.advance(0.25, 12.0);
        assert_eq!((time.time_h(), time.runs()), (Some(12.2), true));
        time.advance(0.25, 9.0);
        assert_eq!(time.time_h(), None);
    }
}
