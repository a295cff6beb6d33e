//! The view on board of a path: where it is at the clock's time.
//!
//! It follows the path as it is in this frame, open gestures included.

use super::navigation::Navigation;
use crate::state::Reading;
use cloudwright_core::flight::PathCurve;
use cloudwright_core::scene::{Camera, CameraPath, PathId};

/// A view on its way.
pub(super) struct OnBoard {
    pub(super) path: PathId,
    /// The view that it came from.
    pub(super) before: Navigation,
    /// The path as it was last seen.
    flown: Option<(CameraPath, PathCurve)>,
}

/// Where the view is in one frame.
pub(super) struct PathView {
    pub(super) camera: Camera,
    /// Metres a second of the clock.
    pub(super) speed_m_s: f64,
}

impl OnBoard {
    pub(super) fn new(path: PathId, before: Navigation) -> Self {
        Self { path, before, flown: None }
    }

    /// Where it is now; none if the path is gone.
    pub(super) fn path_view(&mut self, reading: &Reading<'_>) -> Option<PathView> {
        let path = reading.session.scene().path(self.path)?;
        let flown = self.flown.take().filter(|(flown, _)| flown == path);
        let (_, curve) = self.flown.insert(flown.unwrap_or_else(|| (path.clone(), PathCurve::new(path))));
        let time_s = reading.clock.time_s();
        Some(PathView { camera: curve.camera_at(time_s), speed_m_s: curve.velocity_at(time_s).length() })
    }
}
