//! Who looks: along a path, or from one camera that stands still, or goes as its tracks say.

use cloudwright_core::derived::Derived;
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{Camera, CameraPath, Scene, Thing};
use cloudwright_core::view_history::{Playback, ViewHistory};
use std::sync::Arc;

/// When the last key of all tracks is, in seconds of the clock; None where none moves anything after second 0.
pub(crate) fn last_key_s(scene: &Scene) -> Option<f64> {
    let last_keys = scene.tracks.iter().filter_map(|track| Some(track.keys.last()?.time_s));
    Some(last_keys.fold(0.0, f64::max)).filter(|last_s| *last_s > 0.0)
}

/// Who looks, and for how long.
pub(crate) enum Eye<'a> {
    /// Each frame has seen what lay on the way.
    Path(&'a CameraPath, Box<Playback>),
    /// Each frame is a still, for so many seconds: what `render --at` draws.
    Still(&'a Camera, f64),
}

impl<'a> Eye<'a> {
    pub(crate) fn along(path: &'a CameraPath, rules: Rules) -> Self {
        Self::Path(path, Box::new(Playback::new(path, rules)))
    }

    pub(crate) fn duration_s(&self) -> f64 {
        match self {
            Self::Path(_, playback) => playback.duration_s(),
            Self::Still(_, seconds) => *seconds,
        }
    }

    /// What its frames are named after.
    pub(crate) fn thing(&self) -> Thing {
        match self {
            Self::Path(path, _) => Thing::Path(path.id),
            Self::Still(camera, _) => Thing::Camera(camera.id),
        }
    }

    /// What its path or camera is called.
    pub(crate) fn name(&self) -> &str {
        match self {
            Self::Path(path, _) => &path.name,
            Self::Still(camera, _) => &camera.name,
        }
    }

    /// Where it is at `clock_s`.
    pub(crate) fn camera_at(&self, derived: &Derived, clock_s: f64) -> Camera {
        match self {
            Self::Path(_, playback) => playback.camera_at(clock_s),
            Self::Still(camera, _) => derived.timeline().camera_at(camera, clock_s),
        }
    }

    /// Where it is at `clock_s`, and what it has seen.
    pub(crate) fn at(&mut self, derived: &Derived, clock_s: f64) -> (Camera, Arc<ViewHistory>) {
        match self {
            Self::Path(_, playback) => {
                let (camera, history) = playback.seek(derived, clock_s);
                (camera, Arc::clone(history))
            }
            Self::Still(..) => (self.camera_at(derived, clock_s), Arc::default()),
        }
    }
}
