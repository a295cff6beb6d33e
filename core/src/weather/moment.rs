//! When a scene is looked at.

/// A moment of a scene.
///
/// The scene's clock is the only thing that runs. The time of day is one of the values that a scene has at a moment; who
/// looks at another hour overrides it, and changes nothing that is saved.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Moment {
    /// Seconds of the scene's clock, from 0 where play or flight begins.
    pub clock_s: f64,
    /// The time of day to look at, local civil hours (any number; taken modulo 24), if another than the scene's.
    pub time_h: Option<f64>,
}

impl Moment {
    /// `clock_s` seconds after play or flight began, at the scene's own time of day.
    pub fn at(clock_s: f64) -> Self {
        Self { clock_s, time_h: None }
    }

    /// The beginning, as another time of day shows it.
    pub fn at_hour(time_h: f64) -> Self {
        Self { clock_s: 0.0, time_h: Some(time_h) }
    }
}
