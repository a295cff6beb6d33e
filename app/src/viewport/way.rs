//! The way that the hand-moved view has come: what sprites near its eye must know ([`ViewHistory`]).
//!
//! A hand has no clock, so the way since the last frame is taken in steps of a few metres. A view that is put elsewhere
//! has come no way.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::Sorting;
use cloudwright_core::facing::FacingRule;
use cloudwright_core::scene::Camera;
use cloudwright_core::version::Version;
use cloudwright_core::view_history::ViewHistory;
use glam::DVec3;

/// Length of a step, metres: sprites are tens of metres wide.
const STEP_M: f64 = 2.0;
/// Of one frame's way; more would be a jump.
const MOST_STEPS: u32 = 64;

/// Where the view was and what it remembers.
#[derive(Default)]
pub(super) struct Way {
    history: ViewHistory,
    sorting: Sorting,
    last: Option<(DVec3, Version)>,
}

impl Way {
    /// The view is put elsewhere.
    pub(super) fn begin_anew(&mut self) {
        let history = ViewHistory::new(FacingRule::default(), self.sorting);
        *self = Self { history, last: None, ..*self };
    }

    /// The view was carried to `camera`, and has seen this on the way.
    pub(super) fn go_on_from(&mut self, camera: &Camera, history: ViewHistory, derived: &Derived) {
        self.history = history;
        self.last = Some((camera.position, derived.version()));
    }

    /// Goes on to `camera`, and gives what is remembered there.
    pub(super) fn follow(&mut self, camera: &Camera, derived: &Derived, sorting: Sorting) -> &ViewHistory {
        if sorting != self.sorting {
            self.sorting = sorting;
            self.begin_anew();
        }
        let here = (camera.position, derived.version());
        if self.last != Some(here) {
            let from = self.last.map_or(camera.position, |(eye, _)| eye);
            let steps = ((from.distance(camera.position) / STEP_M).ceil() as u32).clamp(1, MOST_STEPS);
            for step in 1..=steps {
                let position = from.lerp(camera.position, f64::from(step) / f64::from(steps));
                self.history.step(derived, &View::new(&Camera { position, ..camera.clone() }, 1, 1));
            }
            self.last = Some(here);
        }
        &self.history
    }
}
