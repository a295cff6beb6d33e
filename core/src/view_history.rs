//! What one view has seen on its way: the reason why frame 4,711 of a flight is not a still.
//!
//! Steps are made in order and are 1/60 s apart ([`STEP_S`]) from where a path starts, so that a frame is the same alone
//! or in a sequence, at any frame rate. A history belongs to a view, never to the scene.

use crate::camera::View;
use crate::derived::Derived;
use crate::draw_list::{OrderMemory, Sorting};
use crate::facing::{FacingMemory, FacingRule};
use crate::shading::FormingRule;

/// Seconds between two steps (MODEL §4).
pub const STEP_S: f64 = 1.0 / 60.0;

/// The history of one view.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ViewHistory {
    /// How sprites near the eye turn and fade.
    pub facing: FacingMemory,
    /// In what order sprites are drawn.
    pub order: OrderMemory,
    /// By which rule clouds form. It remembers nothing, but belongs to what a view is drawn by.
    pub forming: FormingRule,
}

impl ViewHistory {
    /// Of nothing yet.
    pub fn new(rule: FacingRule, sorting: Sorting) -> Self {
        Self { facing: FacingMemory::new(rule), order: OrderMemory::new(sorting), forming: FormingRule::default() }
    }

    /// Goes on to `view`.
    pub fn step(&mut self, derived: &Derived, view: &View) {
        let (clouds, version) = (derived.clouds(), derived.version());
        self.facing.step(clouds, version, view.eye, view.up);
        self.order.step(clouds, version, view);
    }
}
