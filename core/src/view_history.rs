//! What one view has seen on its way: the reason why frame 4,711 of a flight is not a still.
//!
//! Steps are made in order and are 1/60 s apart ([`STEP_S`]) from where a path starts, so that a frame is the same alone
//! or in a sequence, at any frame rate. A history belongs to a view, never to the scene, and to the rules that its steps
//! were made by: a view that goes by other ones begins anew.

mod playback;

pub use playback::Playback;

use crate::camera::View;
use crate::derived::Derived;
use crate::draw_list::OrderMemory;
use crate::facing::FacingMemory;
use crate::rules::Rules;

/// Seconds between two steps (MODEL §4).
pub const STEP_S: f64 = 1.0 / 60.0;

/// The history of one view; by default of nothing yet.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ViewHistory {
    /// How sprites near the eye turn and fade.
    pub facing: FacingMemory,
    /// In what order sprites are drawn.
    pub order: OrderMemory,
}

impl ViewHistory {
    /// Goes on to `view` by `rules`, through the clouds as they are at `clock_s`, seconds of the scene's clock.
    pub fn step(&mut self, rules: &Rules, derived: &Derived, clock_s: f64, view: &View) {
        let clouds = &derived.clouds_at(clock_s, rules.of_weather());
        let shapes = derived.shapes();
        self.facing.step(&rules.facing, clouds, shapes, view.eye, view.up);
        self.order.step(&rules.sorting, clouds, shapes, view);
    }
}
