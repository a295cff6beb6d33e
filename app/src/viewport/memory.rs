//! How the view sees the scene, with what it remembers of its way ([`ViewHistory`]) by one set of rules: along a path, or
//! moved by hand.
//!
//! Along a path the way is the path's, up to the clock's time ([`Playback`]), as it is in this frame, open gestures
//! included; after a change of the path or of the clouds' shapes it is gone anew from the start. A hand has no clock, so
//! the way since the last frame is taken in steps of a few metres, and goes on from where a flight was left. A view that
//! is put elsewhere has come no way.

use super::parallel;
use crate::state::Reading;
use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{Camera, CameraPath};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Shapes;
use cloudwright_core::view_history::{Playback, ViewHistory};
use cloudwright_core::weather::Moment;
use glam::DVec3;
use std::sync::Arc;

/// Length of a step by hand, metres: sprites are tens of metres wide.
const STEP_M: f64 = 2.0;
/// Of one frame's way; more would be a jump.
const MOST_STEPS: u32 = 64;

/// Where the view is in one frame.
pub(super) struct ViewAt<'a> {
    pub(super) camera: Camera,
    /// Whether that is the far eye of an orthographic view.
    pub(super) is_orthographic: bool,
    /// On board of which path.
    pub(super) path: Option<&'a CameraPath>,
    /// Of the picture, pixels.
    pub(super) size: [u32; 2],
}

/// What is remembered by one set of rules.
pub(super) struct Memory {
    rules: Rules,
    history: Arc<ViewHistory>,
    /// Where the history was made, through which clouds.
    last: Option<(DVec3, Shapes)>,
    flight: Option<(CameraPath, Playback)>,
}

impl Memory {
    /// Of nothing yet.
    pub(super) fn new(rules: Rules) -> Self {
        Self { rules, history: Arc::default(), last: None, flight: None }
    }

    /// What is to be drawn by `rules`.
    pub(super) fn sight(&mut self, rules: &Rules, place: &ViewAt<'_>, reading: &Reading<'_>) -> Sight {
        let session = reading.session;
        self.go_by(rules);
        let mut hidden = reading.view.hidden_in(session.scene());
        if place.is_orthographic {
            self.begin_anew();
            parallel::hide(&place.camera, &mut hidden);
        }
        let history = match place.path {
            _ if place.is_orthographic => &self.history,
            Some(path) => {
                let is_open = session.document().is_open();
                self.fly(path, reading.clock.time_s(), session.derived(), is_open)
            }
            None => self.follow(&place.camera, reading.clock.time_s(), session.derived()),
        };
        Sight {
            camera: place.camera.clone(),
            moment: Moment { clock_s: reading.clock.time_s(), time_h: reading.time_play.time_h() },
            size: place.size,
            hidden,
            meshes: session.beside().meshes().clone(),
            history: Arc::clone(history),
            rules: *rules,
            facet: None,
        }
    }

    /// The view is put elsewhere.
    pub(super) fn begin_anew(&mut self) {
        *self = Self::new(self.rules);
    }

    /// From now on by `rules`.
    fn go_by(&mut self, rules: &Rules) {
        if !rules.remember_as(&self.rules) {
            *self = Self::new(*rules);
        }
    }

    /// A hand has moved the view to `camera`. What it remembers there.
    fn follow(&mut self, camera: &Camera, clock_s: f64, derived: &Derived) -> &Arc<ViewHistory> {
        let here = (camera.position, derived.shapes().clone());
        if self.last.as_ref() != Some(&here) {
            let from = self.last.as_ref().map_or(camera.position, |(eye, _)| *eye);
            let steps = ((from.distance(camera.position) / STEP_M).ceil() as u32).clamp(1, MOST_STEPS);
            for step in 1..=steps {
                let position = from.lerp(camera.position, f64::from(step) / f64::from(steps));
                let view = View::new(&Camera { position, ..camera.clone() }, 1, 1);
                Arc::make_mut(&mut self.history).step(&self.rules, derived, clock_s, &view);
            }
            self.last = Some(here);
        }
        &self.history
    }

    /// The view has come along `path` for `time_s` seconds. What it remembers there. While a gesture `is_open`, it is
    /// what it was before, since going all the way anew is too slow for a drag.
    fn fly(&mut self, path: &CameraPath, time_s: f64, derived: &Derived, is_open: bool) -> &Arc<ViewHistory> {
        if !is_open {
            let flight = self.flight.take().filter(|(flown, _)| flown.goes_as(path));
            let begun = || (path.clone(), Playback::new(path, self.rules));
            let (_, playback) = self.flight.insert(flight.unwrap_or_else(begun));
            let (camera, history) = playback.seek(derived, time_s);
            self.last = Some((camera.position, derived.shapes().clone()));
            self.history = Arc::clone(history);
        }
        &self.history
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::starter::starter_scene;
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
        let mut memory = Memory::new(Rules::SHIPPED);
        let flown = memory.fly(&path, 8.0, &derived, false).clone();
        let (camera, alone) = {
            let mut playback = Playback::new(&path, Rules::SHIPPED);
            let (camera, history) = playback.seek(&derived, 8.0);
            (camera, history.clone())
        };
        assert!(flown == alone, "what the path's own playback remembers");
        assert!(*flown != ViewHistory::default(), "sprites near the eye are remembered");
        assert!(*memory.follow(&camera, 8.0, &derived) == flown, "the hand is where the flight was");
        // A gesture holds the memory; its end may bring another path.
        assert!(*memory.fly(&path, 0.0, &derived, true) == flown);
        assert!(*memory.fly(&path, 0.0, &derived, false) != flown);
    }

    #[test]
    fn other_rules_begin_anew() {
        let (derived, path) = into_the_cloud();
        let mut memory = Memory::new(Rules::SHIPPED);
        let by_ours = memory.fly(&path, 8.0, &derived, false).clone();
        let rules = named("no-lock").expect("in the table").rules;
        memory.go_by(&rules);
        assert!(*memory.history == ViewHistory::default(), "nothing of the old rules is left");
        memory.fly(&path, 8.0, &derived, false);
        memory.go_by(&rules);
        memory.go_by(&Rules::SHIPPED);
        assert!(*memory.fly(&path, 8.0, &derived, false) == by_ours, "the same way by the same rules");
    }
}
