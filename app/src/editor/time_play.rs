//! The time of day, running.
//!
//! It runs in the view alone: nothing in the scene changes, so nothing can be undone or is unsaved. When it stops, the
//! hour that it reached becomes the scene's, as one step.

/// Whether time runs, and how fast.
#[derive(Debug, Clone, Copy)]
pub(super) struct TimePlay {
    /// The hour that it has reached, while it runs.
    pub(super) hour: Option<f64>,
    /// Hours of the scene in a minute of the artist's.
    pub(super) hours_a_minute: f64,
    started: bool,
}

impl Default for TimePlay {
    fn default() -> Self {
        Self { hour: None, hours_a_minute: 24.0, started: false }
    }
}

impl TimePlay {
    pub(super) fn is_on(&self) -> bool {
        self.started
    }

    pub(super) fn toggle(&mut self) {
        self.started ^= true;
    }
}
