//! A flight along a path, seen from the cockpit: the camera at any time, and what the view has seen on its way there.
//!
//! The history is made in steps of 1/60 s from the path's start, whatever is asked for: frame 4,711 is the same whether it
//! is drawn alone or in a sequence, at any frame rate (MODEL §4). Going on costs the steps between; going back starts
//! from the nearest earlier state kept, one for every ten seconds flown.

use super::{STEP_S, ViewHistory};
use crate::camera::View;
use crate::derived::Derived;
use crate::flight::PathCurve;
use crate::rules::Rules;
use crate::scene::{Camera, CameraPath};
use crate::sprites::Shapes;
use crate::weather::Timeline;
use std::sync::Arc;

/// Steps between two states that are kept: ten seconds.
const KEPT_EVERY: usize = 600;

/// A view's way along a path.
#[derive(Debug, Clone)]
pub struct Playback {
    curve: PathCurve,
    rules: Rules,
    /// Of the clouds that it flies through.
    shapes: Option<Shapes>,
    /// What moves those.
    timeline: Option<Arc<Timeline>>,
    /// The history after `steps` steps; the first is at the path's start.
    history: Arc<ViewHistory>,
    steps: usize,
    taken: u64,
    /// After 1, 601, 1201, … steps.
    kept: Vec<Arc<ViewHistory>>,
}

impl Playback {
    /// At the start of `path`, by `rules`.
    pub fn new(path: &CameraPath, rules: Rules) -> Self {
        let history = Arc::default();
        Self {
            curve: PathCurve::new(path),
            rules,
            shapes: None,
            timeline: None,
            history,
            steps: 0,
            taken: 0,
            kept: Vec::new(),
        }
    }

    /// How many steps were gone since this was made, those that were gone again included.
    pub fn steps_taken(&self) -> u64 {
        self.taken
    }

    /// From the path's first key to its last, seconds.
    pub fn duration_s(&self) -> f64 {
        self.curve.duration_s()
    }

    /// The camera `t_s` seconds from the start; beyond the path's ends that at the end.
    pub fn camera_at(&self, t_s: f64) -> Camera {
        self.curve.camera_at(if t_s.is_finite() { t_s.clamp(0.0, self.duration_s()) } else { 0.0 })
    }

    /// The camera `t_s` seconds from the start, and the history as of the last step not after that. Times beyond the
    /// path's ends are its ends. The way is gone anew where the clouds' sprites or places, or what moves them, are not those of the last time;
    /// their colours, light and names are not its affair.
    pub fn seek(&mut self, derived: &Derived, t_s: f64) -> (Camera, &Arc<ViewHistory>) {
        let t_s = if t_s.is_finite() { t_s.clamp(0.0, self.duration_s()) } else { 0.0 };
        // A frame's time in f64 may lie a rounding before the step that it stands for.
        let wanted = libm::floor(t_s / STEP_S + 1e-6) as usize + 1;
        let same_timeline = self.timeline.as_ref().is_some_and(|old| Arc::ptr_eq(old, derived.timeline()));
        if self.shapes.as_ref() != Some(derived.shapes()) || !same_timeline {
            self.timeline = Some(Arc::clone(derived.timeline()));
            (self.shapes, self.steps, self.history) = (Some(derived.shapes().clone()), 0, Arc::default());
            self.kept.clear();
        }
        let nearest = ((wanted - 1) / KEPT_EVERY).min(self.kept.len().saturating_sub(1));
        let from_kept = nearest * KEPT_EVERY + 1;
        if self.steps > wanted || (self.steps < from_kept && nearest < self.kept.len()) {
            (self.steps, self.history) = match self.kept.get(nearest) {
                Some(kept) => (from_kept, Arc::clone(kept)),
                None => (0, Arc::default()),
            };
        }
        while self.steps < wanted {
            let clock_s = self.steps as f64 * STEP_S;
            let view = View::new(&self.curve.camera_at(clock_s), 1, 1);
            Arc::make_mut(&mut self.history).step(&self.rules, derived, clock_s, &view);
            if self.steps.is_multiple_of(KEPT_EVERY) && self.kept.len() == self.steps / KEPT_EVERY {
                self.kept.push(Arc::clone(&self.history));
            }
            self.steps += 1;
            self.taken += 1;
        }
        (self.camera_at(t_s), &self.history)
    }
}
