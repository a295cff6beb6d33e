//! The article's fading, as a state that each frame adds to (W, Listing 1), for charts against the closed form.
//!
//! As printed it subtracts how far a vertex is from the *edge*, so that the core fades first, the reverse of its own
//! text, and it leaves alpha unset when the fade is off. Mended in both, it still adds time steps to a state: what it
//! reaches depends on the frame rate, and it overshoots.

use crate::scene::{Formation, FormationChange};
use crate::weather::{Formed, Stepped};

/// Which of the two.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Listing {
    /// As in the article.
    AsPrinted,
    /// From the centre, and never unset.
    Mended,
}

/// A cloud that forms, frame by frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteppedFade {
    listing: Listing,
    /// Of 255, as the article counts.
    alpha: f32,
    is_on: bool,
}

impl SteppedFade {
    /// A cloud that begins to form.
    pub fn new(listing: Listing) -> Self {
        Self { listing, alpha: 0.0, is_on: true }
    }

    /// A frame of `delta_s` seconds; forming takes `duration_s`.
    pub fn step(&mut self, delta_s: f32, duration_s: f32) {
        if self.is_on {
            self.alpha += 255.0 * delta_s / duration_s;
            self.is_on = self.alpha < 255.0;
        }
    }

    /// Opacity at a distance from the centre, in radii; above 1 after an overshoot, none where it is left unset.
    pub fn opacity(&self, radii: f32) -> Option<f32> {
        match self.listing {
            Listing::AsPrinted if !self.is_on => None,
            Listing::AsPrinted => Some(((self.alpha - 255.0 * (1.0 - radii)) / 255.0).max(0.0)),
            Listing::Mended if !self.is_on => Some(self.alpha / 255.0),
            Listing::Mended => Some(((self.alpha - 255.0 * radii) / 255.0).max(0.0)),
        }
    }

    /// The same as what renderers draw, who clamp it; where it is left unset, nothing.
    fn formed(&self) -> Formed {
        let core = self.alpha / 255.0;
        match (self.listing, self.is_on) {
            (Listing::AsPrinted, false) => Formed { core: 0.0, falloff: 0.0 },
            (Listing::AsPrinted, true) => Formed { core: core - 1.0, falloff: -1.0 },
            (Listing::Mended, false) => Formed { core, falloff: 0.0 },
            (Listing::Mended, true) => Formed { core, falloff: 1.0 },
        }
    }
}

/// As printed, at the 30 frames a second that flights are drawn at.
pub const STEPPED_AS_PRINTED: Stepped = Stepped {
    name: "steps, as printed",
    frames_a_second: 30,
    formed: |formation, clock_s, rate| stepped(Listing::AsPrinted, formation, clock_s, rate),
};

/// Mended, at the same rate.
pub const STEPPED_MENDED: Stepped = Stepped {
    name: "steps, mended",
    frames_a_second: 30,
    formed: |formation, clock_s, rate| stepped(Listing::Mended, formation, clock_s, rate),
};

/// At `clock_s`, stepped from when the cloud began, `frames_a_second` times a second (at least once). The article has one
/// duration: from the first sprites to the last. Dissipating it only names; here it is whole until it begins, and then
/// steps back from what forming reaches.
fn stepped(listing: Listing, formation: &Formation, clock_s: f64, frames_a_second: u32) -> Formed {
    let Formation { change, start_s, core_s, edges_s, threshold } = *formation;
    let duration_s = core_s.max(threshold * core_s + edges_s);
    let since_s = clock_s - start_s;
    let run_s = match change {
        FormationChange::Forming => since_s,
        FormationChange::Dissipating if since_s < 0.0 => return Formed::WHOLE,
        FormationChange::Dissipating => duration_s - since_s,
    };
    let mut fade = SteppedFade::new(listing);
    let rate = f64::from(frames_a_second.max(1));
    let mut steps = libm::floor(run_s * rate + 1e-6).max(0.0);
    let delta_s = (1.0 / rate) as f32;
    // A duration of zero is over after a step.
    while steps > 0.0 && fade.is_on {
        fade.step(delta_s, (duration_s as f32).max(f32::MIN_POSITIVE));
        steps -= 1.0;
    }
    fade.formed()
}
