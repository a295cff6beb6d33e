//! The article's fading, as a state that each frame adds to (W, Listing 1), for charts against the closed form.
//!
//! As printed it subtracts how far a vertex is from the *edge*, so that the core fades first, the reverse of its own
//! text, and it leaves alpha unset when the fade is off. Mended in both, it still adds time steps to a state: what it
//! reaches depends on the frame rate, and it overshoots.

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
}
