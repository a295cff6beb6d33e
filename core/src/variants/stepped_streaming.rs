//! Following the wind by explicit steps, as most engines do: right for short frames, and beyond two lags it blows up.

use crate::weather::{Lean, SteppedStreaming, Wind};

/// Steps of a film's frame.
pub const STEPPED_24: SteppedStreaming = stepped("explicit steps", 1.0 / 24.0);

/// Steps of a tenth of a second, as when a machine is slow.
pub const STEPPED_10: SteppedStreaming = stepped("explicit steps", 0.1);

/// More steps than this are not gone, so that any clock has an answer.
const MOST_STEPS: f64 = 1e6;

const fn stepped(name: &'static str, frame_s: f64) -> SteppedStreaming {
    SteppedStreaming { name, frame_s, lean }
}

/// d += Δt (u − d)/τ from second 0 on.
fn lean(wind: &Wind, clock_s: f64, frame_s: f64, lag_s: f64) -> Lean {
    let tracks = wind.tracks();
    let mut lean = tracks.striven_for(0.0);
    let steps = (clock_s / frame_s).clamp(0.0, MOST_STEPS) as u32;
    for step in 0..steps {
        let towards = tracks.striven_for(f64::from(step) * frame_s);
        let share = frame_s / lag_s.max(1e-9);
        lean.middle += (towards.middle - lean.middle) * share;
        lean.shear += (towards.shear - lean.shear) * share;
    }
    lean
}
