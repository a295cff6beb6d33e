//! What all methods of a chart draw: a scene from a camera, or along a path.

use super::report::Viewpoint;
use cloudwright_core::derived::Derived;
use cloudwright_core::flight::PathCurve;
use cloudwright_core::rules::Movement;
use cloudwright_core::scene::{CameraPath, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;

/// From one frame of a flight to the next, seconds: 30 a second, as flights are drawn.
pub const FRAME_S: f64 = 1.0 / 30.0;
/// Places along a path. At each two frames are drawn by the truth, which takes most of a chart's time.
const STOPS: usize = 5;

/// A scene, and how it is looked at.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its clouds.
    pub derived: &'a Derived,
    /// Its atlas.
    pub atlas: &'a Atlas,
    /// How it is looked at, but for the rules, which are each method's; along a path the camera is the path's, and the
    /// clock begins with the flight.
    pub sight: &'a Sight,
    /// The flight; none for a still.
    pub path: Option<&'a CameraPath>,
}

impl Subject<'_> {
    /// The moments to draw at each stop, seconds of the clock: a frame and the next one; one alone for a still, or for
    /// a flight that has no second frame.
    pub fn stops(&self) -> Vec<Vec<f64>> {
        let Some(path) = self.path else { return vec![vec![self.sight.moment.clock_s]] };
        // Roundings don't cost a path its last frame.
        let steps = (PathCurve::new(path).duration_s() / FRAME_S + 1e-6).floor();
        if steps < 1.0 {
            return vec![vec![0.0]];
        }
        let count = STOPS.min(steps as usize);
        let first = |stop: usize| ((stop as f64 + 0.5) / count as f64 * steps).floor().min(steps - 1.0);
        (0..count).map(|stop| [0.0, 1.0].map(|next| (first(stop) + next) * FRAME_S).to_vec()).collect()
    }

    /// Whether the eye moves.
    pub fn flies(&self) -> bool {
        self.path.is_some()
    }

    /// As the report says it.
    pub fn view(&self) -> Viewpoint {
        match self.path {
            Some(path) => Viewpoint::Path(path.name.clone()),
            None => Viewpoint::Camera(self.sight.camera.name.clone()),
        }
    }

    /// What moves in it.
    pub fn moves(&self) -> Movement {
        let blows = self.derived.timeline().wind().is_some();
        Movement { flies: self.flies(), forms: self.derived.forms(), blows }
    }
}
