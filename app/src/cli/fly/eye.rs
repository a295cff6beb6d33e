//! Who looks: along a path, or from one camera that stands still, or goes as its tracks say.

use crate::cli::failure::Failure;
use cloudwright_core::derived::Derived;
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{Camera, CameraPath, Scene, Thing};
use cloudwright_core::view_history::{Playback, ViewHistory};
use std::path::Path;
use std::sync::Arc;

/// Who looks, and for how long.
pub(super) enum Eye<'a> {
    /// Each frame has seen what lay on the way.
    Path(&'a CameraPath, Box<Playback>),
    /// Each frame is a still: what `render --at` draws.
    Still(&'a Camera, f64),
}

impl<'a> Eye<'a> {
    pub(super) fn along(path: &'a CameraPath, rules: Rules) -> Self {
        Self::Path(path, Box::new(Playback::new(path, rules)))
    }

    /// From `camera`, for so many `seconds`; if none are given, up to the last key of all tracks, or where there is none,
    /// as long as the frames that are `asked` for take.
    pub(super) fn still(
        camera: &'a Camera,
        (seconds, asked): (Option<f64>, Option<f64>),
        (scene, file): (&Scene, &Path),
    ) -> Result<Self, Failure> {
        let last_keys = scene.tracks.iter().filter_map(|track| Some(track.keys.last()?.time_s));
        let last_s = last_keys.fold(0.0, f64::max);
        match seconds.or((last_s > 0.0).then_some(last_s)).or(asked) {
            Some(seconds) => Ok(Self::Still(camera, seconds)),
            None => {
                let what = format!("{}: tracks: none has a key after second 0", file.display());
                Err(Failure::argument(what, "say how long to film: --seconds 20"))
            }
        }
    }

    pub(super) fn duration_s(&self) -> f64 {
        match self {
            Self::Path(_, playback) => playback.duration_s(),
            Self::Still(_, seconds) => *seconds,
        }
    }

    /// What its frames are named after.
    pub(super) fn thing(&self) -> Thing {
        match self {
            Self::Path(path, _) => Thing::Path(path.id),
            Self::Still(camera, _) => Thing::Camera(camera.id),
        }
    }

    /// What its path or camera is called.
    pub(super) fn name(&self) -> &str {
        match self {
            Self::Path(path, _) => &path.name,
            Self::Still(camera, _) => &camera.name,
        }
    }

    /// Where it is at `clock_s`.
    pub(super) fn camera_at(&self, derived: &Derived, clock_s: f64) -> Camera {
        match self {
            Self::Path(_, playback) => playback.camera_at(clock_s),
            Self::Still(camera, _) => derived.timeline().camera_at(camera, clock_s),
        }
    }

    /// Where it is at `clock_s`, and what it has seen.
    pub(super) fn at(&mut self, derived: &Derived, clock_s: f64) -> (Camera, Arc<ViewHistory>) {
        match self {
            Self::Path(_, playback) => {
                let (camera, history) = playback.seek(derived, clock_s);
                (camera, Arc::clone(history))
            }
            Self::Still(..) => (self.camera_at(derived, clock_s), Arc::default()),
        }
    }
}
