//! A method at work in this view: the sprites that it draws, and what it remembers of the view's way.

use super::memory::Memory;
use super::picture::{Clouds, Shot};
use crate::opening::Beside;
use crate::state::Reading;
use cloudwright_core::derived::Derived;
use cloudwright_core::method::Settings;
use cloudwright_core::scene::{Camera, CameraPath};
use std::sync::Arc;

/// One method's.
#[derive(Default)]
pub(super) struct Brush {
    memory: Memory,
    thinned: Option<Thinned>,
}

/// Clouds with a share of their sprites.
struct Thinned {
    of: Arc<Derived>,
    /// Its sheet tells how much sprites cover.
    beside: Beside,
    kept: f32,
    clouds: Clouds,
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

    /// None for all sprites. Dropping them takes a millisecond or so for ten thousand, and is done when they change.
    fn clouds(&mut self, settings: &Settings, reading: &Reading<'_>) -> Option<Clouds> {
        if settings.kept >= 1.0 {
            self.thinned = None;
            return None;
        }
        let kept = settings.kept;
        let (_, of, beside) = reading.session.to_draw();
        let is_of = |thinned: &&Thinned| {
            let same_sheet = std::ptr::eq(thinned.beside.sheet(), beside.sheet());
            Arc::ptr_eq(&thinned.of, &of) && same_sheet && thinned.kept == kept
        };
        if let Some(thinned) = self.thinned.as_ref().filter(is_of) {
            return Some(thinned.clouds.clone());
        }
        let clouds = Clouds(Arc::new(settings.clouds(&of, beside.sheet()).into_owned()));
        self.thinned = Some(Thinned { of, beside, kept, clouds: clouds.clone() });
        Some(clouds)
    }
}
