//! The window's panels, one file each. They read the scene and return actions; none changes anything itself.
//!
//! A new panel is a file here, a variant with its row in [`Panel::show`], and a command that brings it up.

mod aircraft;
mod bars;
mod camera;
mod chart;
mod checkerboard;
mod cloud;
mod cloud_box;
pub(crate) mod color_levels;
mod fields;
mod flight;
pub(crate) mod handle;
mod history;
mod inspector;
mod kept;
mod model;
mod outline;
mod palette;
mod path;
mod place_many;
mod preset_gallery;
mod problems;
mod progress;
mod shading_groups;
mod sky;
mod status;
mod thinning;

pub(crate) use bars::{CommandState, menu_bar, toolbar};
pub(crate) use fields::{name_it, number_field};
pub(crate) use palette::Palette;
pub(crate) use place_many::{ask_place_many, default_places};
pub use preset_gallery::{category_gallery, preset_gallery};
pub(crate) use status::status;
pub(crate) use thinning::{THINNING_TOLERANCE, ThinAnswer, ask_thinning};

use crate::editor::{Action, Charting, Clock, Session, TimePlay, ViewState};
use crate::theme::icon;
use crate::thumbnail::Thumbnails;
use crate::units::Units;
use cloudwright_core::scene::ColorLevels;
use egui::Ui;
use serde::{Deserialize, Serialize};
use std::cell::RefCell;

/// A panel that can be docked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Panel {
    /// The picture and the hands on it.
    Viewport,
    /// Models, clouds and cameras as a tree.
    Outline,
    /// The values of what is selected.
    Inspector,
    /// The five colour levels.
    ColorLevels,
    /// Which sprites take the sun as one lump.
    ShadingGroups,
    /// Light, time and place.
    Sky,
    /// Camera paths, aircraft and the scene's clock.
    Flight,
    /// What each method costs and gets wrong.
    Chart,
    /// All changes.
    History,
    /// What is wrong with the scene.
    Problems,
}

/// What panels read.
#[derive(Clone, Copy)]
pub(crate) struct Reading<'a> {
    /// The open document.
    pub(crate) session: &'a Session,
    /// How it is looked at.
    pub(crate) view: &'a ViewState,
    /// Pictures of categories, drawn when they are asked for.
    pub(crate) thumbnails: &'a RefCell<Thumbnails>,
    /// The time of day, if it runs.
    pub(crate) time_play: &'a TimePlay,
    /// The scene's clock, and what is flown by it.
    pub(crate) clock: &'a Clock,
    /// What was measured of the scene.
    pub(crate) charting: &'a Charting,
    /// Colour levels to paste.
    pub(crate) copied_levels: Option<&'a ColorLevels>,
    /// Clockwise from north: where the viewport looks.
    pub(crate) view_heading_deg: f64,
    /// Whether what draws the viewport draws aircraft.
    pub(crate) draws_aircraft: bool,
    /// Whether the panel of colour levels is on the screen.
    pub(crate) levels_shown: bool,
    /// Whether flights by hand are recorded.
    pub(crate) is_recording: bool,
    /// Whether the panel of flights is on the screen.
    pub(crate) flight_shown: bool,
    /// What altitudes and speeds are shown in.
    pub(crate) units: Units,
}

impl Reading<'_> {
    /// The hour that is shown: the running one, or the scene's.
    pub(crate) fn hour(&self) -> f64 {
        self.time_play.hour().unwrap_or(self.session.scene().time_of_day_h)
    }
}

impl Panel {
    /// On its tab.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Viewport => "Viewport",
            Self::Outline => "Outline",
            Self::Inspector => "Inspector",
            // Short, so that four tabs stand side by side in a window of 1280 points.
            Self::ColorLevels => "Levels",
            Self::ShadingGroups => "Groups",
            Self::Sky => "Sky",
            Self::Flight => "Flight",
            Self::Chart => "Chart",
            Self::History => "History",
            Self::Problems => "Problems",
        }
    }

    /// Before its name.
    pub(crate) fn icon(self) -> &'static str {
        match self {
            Self::Viewport => icon::CAMERA,
            Self::Outline => icon::TREE_STRUCTURE,
            Self::Inspector => icon::SLIDERS_HORIZONTAL,
            Self::ColorLevels => icon::GRADIENT,
            Self::ShadingGroups => icon::STACK,
            Self::Sky => icon::SUN,
            Self::Flight => icon::AIRPLANE_TILT,
            Self::Chart => icon::CHART_SCATTER,
            Self::History => icon::CLOCK_COUNTER_CLOCKWISE,
            Self::Problems => icon::WARNING,
        }
    }

    /// Shows it. The viewport shows itself.
    pub(crate) fn show(self, ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
        match self {
            Self::Viewport => {}
            Self::Outline => outline::show(ui, reading, actions),
            Self::Inspector => inspector::show(ui, reading, actions),
            Self::ColorLevels => color_levels::show(ui, reading, actions),
            Self::ShadingGroups => shading_groups::show(ui, reading, actions),
            Self::Sky => sky::show(ui, reading, actions),
            Self::Flight => flight::show(ui, reading, actions),
            Self::Chart => chart::show(ui, reading, actions),
            Self::History => history::show(ui, reading, actions),
            Self::Problems => problems::show(ui, reading, actions),
        }
    }
}
