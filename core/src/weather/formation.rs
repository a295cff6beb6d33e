//! Forming and dissipating in closed form: how much of a cloud there is at any time, in any order (W, MODEL §5).
//!
//! The core comes first: its opacity a rises from 0 to 1. When it reaches the threshold θ, the edges begin to follow: k
//! rises from 0 to 1. At ρ, the distance to the cloud's centre in its radii, opacity is a − 2θ(1 − k)ρ, clamped. Beyond
//! half the radius all is exactly clear until the edges begin, so nothing pops. Dissipating is the same backwards. The
//! article's listings, which step a state instead, are among the ways that fail.

use crate::scene::{Formation, FormationChange, HowFarFormed};

/// By which rule clouds form.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum FormingRule {
    /// The closed form ([`Formed::at`]).
    #[default]
    ClosedForm,
    /// A state that each frame adds to: it fails, and is kept for charts and tests.
    Stepped(Stepped),
}

/// A rule whose outcome depends on how often frames come.
#[derive(Debug, Clone, Copy)]
pub struct Stepped {
    /// In words; no two rules have the same, and they are told apart by it.
    pub name: &'static str,
    /// Frames a second, at least 1.
    pub frames_a_second: u32,
    /// How far a cloud has formed at a number of seconds of the scene's clock, with so many frames a second.
    pub formed: fn(&Formation, f64, u32) -> Formed,
}

impl PartialEq for Stepped {
    fn eq(&self, other: &Self) -> bool {
        (self.name, self.frames_a_second) == (other.name, other.frames_a_second)
    }
}

impl FormingRule {
    /// How far a cloud has formed at `clock_s`, seconds of the scene's clock; as [`Formed::at`].
    pub fn formed(self, formation: Option<&Formation>, clock_s: f64) -> Formed {
        match (self, formation) {
            (Self::Stepped(stepped), Some(formation)) => {
                (stepped.formed)(formation, clock_s, stepped.frames_a_second.max(1))
            }
            _ => Formed::at(formation, clock_s),
        }
    }

    /// What it is, for charts.
    pub fn in_words(self) -> String {
        match self {
            Self::ClosedForm => "closed form".into(),
            Self::Stepped(Stepped { name, frames_a_second, .. }) => format!("{name}, {frames_a_second} a second"),
        }
    }
}

/// How far a cloud has formed, at one moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Formed {
    /// a: opacity at the centre, 0 to 1.
    pub core: f32,
    /// 2θ(1 − k): how much less it is at the radius.
    pub falloff: f32,
}

impl Formed {
    /// All of it.
    pub const WHOLE: Self = Self { core: 1.0, falloff: 0.0 };

    /// At `clock_s`, seconds of the scene's clock. A cloud without a formation is whole. A duration of zero is a step: at
    /// its instant it has been taken.
    pub fn at(formation: Option<&Formation>, clock_s: f64) -> Self {
        let Some(formation) = formation else { return Self::WHOLE };
        let Formation { change, start_s, core_s, edges_s, threshold } = *formation;
        let edges_begin_s = threshold * core_s;
        let since_s = clock_s - start_s;
        let run_s = match change {
            FormationChange::Forming => since_s,
            FormationChange::Dissipating => core_s.max(edges_begin_s + edges_s) - since_s,
        };
        let core = share(run_s, core_s, change);
        let edges = share(run_s - edges_begin_s, edges_s, change);
        Self { core: core as f32, falloff: (2.0 * threshold * (1.0 - edges)) as f32 }
    }

    /// As far as numbers set by hand say; the core's opacity from which on edges show is the formation's, if there is one.
    pub fn by_hand(formed: &HowFarFormed, formation: Option<&Formation>) -> Self {
        let threshold = formation.copied().unwrap_or_default().threshold;
        Self { core: formed.core as f32, falloff: (2.0 * threshold * (1.0 - formed.edges)) as f32 }
    }

    /// So far, 0 to 1: the core first, and the edges from where it is half opaque.
    pub fn of_progress(progress: f32) -> Self {
        const THRESHOLD: f32 = 0.5;
        let run = progress * (1.0 + THRESHOLD);
        Self { core: run.min(1.0), falloff: 2.0 * THRESHOLD * (1.0 - (run - THRESHOLD).clamp(0.0, 1.0)) }
    }

    /// No further than either.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self { core: self.core.min(other.core), falloff: self.falloff.max(other.falloff) }
    }

    /// Opacity at a distance from the cloud's centre, in its radii.
    pub fn opacity(&self, radii: f32) -> f32 {
        (self.core - self.falloff * radii).clamp(0.0, 1.0)
    }

    /// Whether there is anything of it.
    pub fn shows(&self) -> bool {
        self.core > 0.0 || self.falloff < 0.0
    }
}

/// How much of a duration is over, 0 to 1. With none, all at its instant: when the cloud comes that instant has it,
/// when it goes it no longer does.
fn share(run_s: f64, duration_s: f64, change: FormationChange) -> f64 {
    if duration_s > 0.0 {
        return (run_s / duration_s).clamp(0.0, 1.0);
    }
    let over = match change {
        FormationChange::Forming => run_s >= 0.0,
        FormationChange::Dissipating => run_s > 0.0,
    };
    f64::from(u8::from(over))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formation(change: FormationChange) -> Formation {
        Formation { change, start_s: 10.0, core_s: 20.0, edges_s: 30.0, threshold: 0.4 }
    }

    #[test]
    fn the_core_comes_first_and_goes_last() {
        use FormationChange::{Dissipating, Forming};
        // Seconds, and opacity at the centre, at a quarter, at half and at the whole of the radius.
        for (change, clock_s, want) in [
            (Forming, 0.0, [0.0, 0.0, 0.0, 0.0]),
            (Forming, 14.0, [0.2, 0.0, 0.0, 0.0]),
            (Forming, 18.0, [0.4, 0.2, 0.0, 0.0]),
            // k = 1/2, a = 1.
            (Forming, 33.0, [1.0, 0.9, 0.8, 0.6]),
            (Forming, 48.0, [1.0; 4]),
            (Forming, 1e9, [1.0; 4]),
            (Dissipating, 10.0, [1.0; 4]),
            (Dissipating, 25.0, [1.0, 0.9, 0.8, 0.6]),
            (Dissipating, 40.0, [0.4, 0.2, 0.0, 0.0]),
            (Dissipating, 48.0, [0.0; 4]),
        ] {
            let formed = Formed::at(Some(&formation(change)), clock_s);
            for (radii, want) in [0.0, 0.25, 0.5, 1.0].into_iter().zip(want) {
                let got = formed.opacity(radii);
                assert!((got - want).abs() < 1e-6, "{change:?} at {clock_s} s, {radii} radii: {got}, want {want}");
            }
        }
    }

    #[test]
    fn durations_of_zero_are_steps() {
        for change in [FormationChange::Forming, FormationChange::Dissipating] {
            let at_once = Formation { core_s: 0.0, edges_s: 0.0, ..formation(change) };
            let comes = change == FormationChange::Forming;
            for (clock_s, before) in [(9.99, true), (10.0, false), (10.01, false)] {
                let shows = Formed::at(Some(&at_once), clock_s).opacity(1.0) == 1.0;
                assert_eq!(shows, comes != before, "{change:?} at {clock_s}");
            }
        }
    }
}
