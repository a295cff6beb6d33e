//! By which rules the clock moves clouds: how they form, and how loose edges follow the wind.

use super::{FormingRule, Lean, Wind};

/// By which rules the clock moves clouds; by default in closed form.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WeatherRules {
    /// How clouds form.
    pub forming: FormingRule,
    /// How loose edges follow the wind.
    pub streaming: StreamingRule,
}

/// By which rule edges follow the wind.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum StreamingRule {
    /// The closed form ([`Wind::lean`]).
    #[default]
    ClosedForm,
    /// A state that each frame adds to: it fails, and is kept for charts and tests.
    Stepped(SteppedStreaming),
}

/// A rule whose outcome depends on how often frames come.
#[derive(Debug, Clone, Copy)]
pub struct SteppedStreaming {
    /// In words; no two rules have the same, and they are told apart by it.
    pub name: &'static str,
    /// Seconds from frame to frame.
    pub frame_s: f64,
    /// How far edges lean at a number of seconds of the scene's clock, with such frames and the lag, in seconds.
    pub lean: fn(&Wind, clock_s: f64, frame_s: f64, lag_s: f64) -> Lean,
}

impl PartialEq for SteppedStreaming {
    fn eq(&self, other: &Self) -> bool {
        (self.name, self.frame_s) == (other.name, other.frame_s)
    }
}

impl StreamingRule {
    /// How far edges lean at `clock_s` of the scene's clock, where they follow the wind with that lag, seconds.
    pub fn lean(self, wind: &Wind, clock_s: f64, lag_s: f64) -> Lean {
        match self {
            Self::ClosedForm => wind.lean(clock_s),
            Self::Stepped(SteppedStreaming { frame_s, lean, .. }) => lean(wind, clock_s, frame_s, lag_s),
        }
    }

    /// What it is, for charts.
    pub fn in_words(self) -> String {
        match self {
            Self::ClosedForm => "closed form".into(),
            Self::Stepped(SteppedStreaming { name, frame_s, .. }) => format!("{name}, each {frame_s} s"),
        }
    }
}
