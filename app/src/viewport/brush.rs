//! A method at work in this view: the sprites that it draws, and what it remembers of the view's way.

use super::memory::Memory;
use super::picture::{Clouds, Shot};
use crate::panel::Reading;
use cloudwright_core::method::Settings;
use cloudwright_core::scene::{Camera, CameraPath};
use cloudwright_core::version::Version;
use std::borrow::Cow;
use std::sync::Arc;

/// One method's.
#[derive(Default)]
pub(super) struct Brush {
    memory: Memory,
    /// The clouds of that revision with that share of their sprites.
    thinned: Option<(Version, f32, Clouds)>,
}

/// Where the view is in one frame.
pub(super) struct Place<'a> {
    pub(super) camera: &'a Camera,
    /// On board of which path.
    pub(super) path: Option<&'a CameraPath>,
    /// Of the picture, pixels.
    pub(super) size: [u32; 2],
}

impl Brush {
    /// The view is put elsewhere.
    pub(super) fn begin_anew(&mut self) {
        self.memory.begin_anew();
    }

    /// What is to be drawn by `settings`.
    pub(super) fn shot(&mut self, settings: &Settings, place: &Place<'_>, reading: &Reading<'_>) -> Shot {
        let session = reading.session;
        let clouds = self.clouds(settings, reading);
        let derived = clouds.as_ref().map_or(session.derived(), |clouds| &clouds.0);
        self.memory.go_by(settings.history());
        let history = match place.path {
            Some(path) => {
                let is_open = session.document().is_open();
                self.memory.fly(path, reading.clock.time_s(), derived, is_open)
            }
            None => self.memory.follow(place.camera, derived),
        };
        Shot {
            settings: *settings,
            camera: place.camera.clone(),
            hour: reading.hour(),
            clock_s: reading.clock.time_s(),
            size: place.size,
            hidden: reading.view.hidden_in(session.scene()),
            history: history.clone(),
            clouds,
        }
    }

    /// None for all sprites. Dropping them takes a millisecond or so for ten thousand, and is done when the scene changes.
    fn clouds(&mut self, settings: &Settings, reading: &Reading<'_>) -> Option<Clouds> {
        if settings.kept >= 1.0 {
            self.thinned = None;
            return None;
        }
        let key = (reading.session.revision(), settings.kept);
        if self.thinned.as_ref().is_none_or(|(revision, kept, _)| (*revision, *kept) != key) {
            let (_, derived, beside) = reading.session.to_draw();
            self.thinned = match settings.clouds(&derived, beside.sheet()) {
                Cow::Owned(thinned) => Some((key.0, key.1, Clouds(Arc::new(thinned)))),
                Cow::Borrowed(_) => None,
            };
        }
        self.thinned.as_ref().map(|(.., clouds)| clouds.clone())
    }
}
