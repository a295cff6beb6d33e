//! What panels and viewport read in a frame.

use super::{Charting, Clock, Offered, Script, Session, TimePlay, ViewState};
use crate::plugins::Library;
use crate::thumbnail::Thumbnails;
use crate::units::Units;
use cloudwright_core::scene::ColorLevels;
use cloudwright_core::weather::{CloudNow, WeatherRules};
use std::cell::RefCell;

/// What panels read.
#[derive(Clone, Copy)]
pub(crate) struct Reading<'a> {
    /// The open document.
    pub(crate) session: &'a Session,
    /// How it is looked at.
    pub(crate) view: &'a ViewState,
    /// Pictures of categories, drawn when they are asked for.
    pub(crate) thumbnails: &'a RefCell<Thumbnails>,
    /// The hour that is tried out, if one is.
    pub(crate) time_play: &'a TimePlay,
    /// The scene's clock, and what is flown by it.
    pub(crate) clock: &'a Clock,
    /// What was measured of the scene.
    pub(crate) charting: &'a Charting,
    /// Colour levels to paste.
    pub(crate) copied_levels: Option<&'a ColorLevels>,
    /// Clockwise from north: where the viewport looks.
    pub(crate) view_heading_deg: f64,
    /// Whether the panel of colour levels is on the screen.
    pub(crate) levels_shown: bool,
    /// Whether flights by hand are recorded.
    pub(crate) is_recording: bool,
    /// Whether the panel of flights is on the screen.
    pub(crate) flight_shown: bool,
    /// The script that is being written.
    pub(crate) script: &'a Script,
    /// The plugins that there are.
    pub(crate) library: &'a Library,
    /// Of pictures that are drawn into files, pixels.
    pub(crate) picture_size: [u32; 2],
    /// What menus at things offer.
    pub(crate) offered: &'a Offered,
    /// What altitudes and speeds are shown in.
    pub(crate) units: Units,
}

impl<'a> Reading<'a> {
    /// The hour that is shown: the one that is tried out, or the scene's at the clock's time.
    pub(crate) fn time_h(&self) -> f64 {
        let (session, clock_s) = (self.session, self.clock.time_s());
        self.time_play.time_h().unwrap_or_else(|| session.derived().timeline().time_of_day_h(session.scene(), clock_s))
    }

    /// The clouds at the clock's time, in their order.
    pub(crate) fn clouds_now(&self) -> Vec<CloudNow<'a>> {
        self.session.derived().clouds_at(self.clock.time_s(), WeatherRules::default())
    }
}
