//! The view on board of a path: where it is at the clock's time, and what it has seen on its way there ([`Playback`]).
//!
//! It follows the path as it is in this frame, open gestures included. After a change it is seen anew from the start.

use super::navigation::Navigation;
use crate::panel::Reading;
use cloudwright_core::draw_list::Sorting;
use cloudwright_core::facing::FacingRule;
use cloudwright_core::flight::{PathCurve, Playback};
use cloudwright_core::scene::{Camera, CameraPath, PathId};
use cloudwright_core::view_history::ViewHistory;

/// A view on its way.
pub(super) struct Ride {
    pub(super) path: PathId,
    /// The view that it came from.
    pub(super) before: Navigation,
    flown: Option<Flown>,
    history: ViewHistory,
}

/// The path as it was last seen.
struct Flown {
    path: CameraPath,
    sorting: Sorting,
    curve: PathCurve,
    playback: Playback,
}

/// Where the view is in one frame.
pub(super) struct Seat {
    pub(super) camera: Camera,
    pub(super) history: ViewHistory,
    /// Metres a second of the clock.
    pub(super) speed_m_s: f64,
}

impl Ride {
    pub(super) fn new(path: PathId, before: Navigation) -> Self {
        Self { path, before, flown: None, history: ViewHistory::default() }
    }

    /// Where it is now; none if the path is gone.
    pub(super) fn seat(&mut self, reading: &Reading<'_>) -> Option<Seat> {
        let path = reading.session.scene().path(self.path)?;
        let sorting = reading.view.sorting;
        let flown = match self.flown.take() {
            Some(flown) if flown.path == *path && flown.sorting == sorting => flown,
            _ => Flown {
                path: path.clone(),
                sorting,
                curve: PathCurve::new(path),
                playback: Playback::new(path, FacingRule::default(), sorting),
            },
        };
        let flown = self.flown.insert(flown);
        let time_s = reading.clock.time_s();
        // Seeing all anew from the start is too slow for a drag: until it ends, the view remembers what it saw before.
        if !reading.session.document().is_open() {
            self.history = flown.playback.seek(reading.session.derived(), time_s).1.clone();
        }
        Some(Seat {
            camera: flown.curve.camera_at(time_s),
            history: self.history.clone(),
            speed_m_s: flown.curve.velocity_at(time_s).length(),
        })
    }
}
