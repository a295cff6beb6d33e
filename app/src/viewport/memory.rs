//! What the view remembers of its way ([`ViewHistory`]), by the rules of one method: along a path, or moved by hand.
//!
//! Along a path the way is the path's, up to the clock's time ([`Playback`]), as it is in this frame, open gestures
//! included; after a change it is gone anew from the start. A hand has no clock, so the way since the last frame is taken
//! in steps of a few metres, and goes on from where a flight was left. A view that is put elsewhere has come no way.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::flight::Playback;
use cloudwright_core::scene::{Camera, CameraPath};
use cloudwright_core::version::Version;
use cloudwright_core::view_history::ViewHistory;
use glam::DVec3;

/// Length of a step by hand, metres: sprites are tens of metres wide.
const STEP_M: f64 = 2.0;
/// Of one frame's way; more would be a jump.
const MOST_STEPS: u32 = 64;

/// One method's memory.
#[derive(Default)]
pub(super) struct Memory {
    /// The rules: a history of nothing yet.
    fresh: ViewHistory,
    history: ViewHistory,
    /// Where the history was made, through which clouds.
    last: Option<(DVec3, Version)>,
    flight: Option<(CameraPath, Playback)>,
}

impl Memory {
    /// The view is put elsewhere.
    pub(super) fn begin_anew(&mut self) {
        *self = Self { history: self.fresh.clone(), fresh: std::mem::take(&mut self.fresh), last: None, flight: None };
    }

    /// From now on by the rules of `fresh`, a history of nothing yet.
    pub(super) fn go_by(&mut self, fresh: ViewHistory) {
        if fresh != self.fresh {
            self.fresh = fresh;
            self.begin_anew();
        }
    }

    /// A hand has moved the view to `camera`. What it remembers there.
    pub(super) fn follow(&mut self, camera: &Camera, derived: &Derived) -> &ViewHistory {
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

    /// The view has come along `path` for `time_s` seconds. What it remembers there. While a gesture `is_open`, it is
    /// what it was before, since going all the way anew is too slow for a drag.
    pub(super) fn fly(&mut self, path: &CameraPath, time_s: f64, derived: &Derived, is_open: bool) -> &ViewHistory {
        if !is_open {
            let flight = self.flight.take().filter(|(flown, _)| flown == path);
            let (_, playback) = self
                .flight
                .insert(flight.unwrap_or_else(|| (path.clone(), Playback::with_history(path, self.fresh.clone()))));
            let (camera, history) = playback.seek(derived, time_s);
            self.last = Some((camera.position, derived.version()));
            self.history = history.clone();
        }
        &self.history
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::starter_scene;
    use cloudwright_core::method::named;
    use cloudwright_core::scene::{PathId, PathKey};

    /// From before the starter's cloud to its middle.
    fn into_the_cloud() -> (Derived, CameraPath) {
        let mut scene = starter_scene();
        let key = |time_s: f64, z: f64| {
            let position = DVec3::new(0.0, 1190.0, z);
            PathKey { time_s, position, heading_deg: 0.0, pitch_deg: 0.0, roll_deg: 0.0 }
        };
        let path = CameraPath::new(PathId::new(&mut scene.next_id), "in", vec![key(0.0, 800.0), key(8.0, 0.0)]);
        (Derived::new(&scene), path)
    }

    #[test]
    fn a_flight_that_is_left_is_gone_on_from() {
        let (derived, path) = into_the_cloud();
        let mut memory = Memory::default();
        let flown = memory.fly(&path, 8.0, &derived, false).clone();
        let (camera, alone) = {
            let mut playback = Playback::with_history(&path, ViewHistory::default());
            let (camera, history) = playback.seek(&derived, 8.0);
            (camera, history.clone())
        };
        assert!(flown == alone, "what the path's own playback remembers");
        assert!(flown != ViewHistory::default(), "sprites near the eye are remembered");
        assert!(*memory.follow(&camera, &derived) == flown, "the hand is where the flight was");
        // A gesture holds the memory; its end may bring another path.
        assert!(*memory.fly(&path, 0.0, &derived, true) == flown);
        assert!(*memory.fly(&path, 0.0, &derived, false) != flown);
    }

    #[test]
    fn other_rules_begin_anew() {
        let (derived, path) = into_the_cloud();
        let mut memory = Memory::default();
        let by_ours = memory.fly(&path, 8.0, &derived, false).clone();
        let rules = named("no-lock").expect("in the table").settings.history();
        memory.go_by(rules.clone());
        assert!(memory.history == rules, "nothing of the old rules is left");
        memory.fly(&path, 8.0, &derived, false);
        memory.go_by(rules);
        memory.go_by(ViewHistory::default());
        assert!(*memory.fly(&path, 8.0, &derived, false) == by_ours, "the same way by the same rules");
    }
}
