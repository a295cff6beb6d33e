//! The window's panels, one file each. They read the scene and return actions; none changes anything itself.
//!
//! A new panel is a file here, a variant with its row in [`Panel::show`], and a command that brings it up.

mod bars;
mod camera;
mod chart;
mod cloud;
mod cloud_box;
mod color_levels;
mod corner;
mod exchange;
mod film;
mod fit_light;
mod flight;
mod history;
mod inspector;
mod manual;
mod menu_keys;
mod model;
mod models;
mod outline;
mod palette;
mod picture;
mod place_many;
mod plugin;
mod problems;
mod progress;
mod refusals;
mod script;
mod shading_groups;
mod sky;
mod start_page;
mod status;
mod thinning;
mod timeline;
mod tour;
mod weather_report;

pub(crate) use bars::{menu_bar, toolbar};
pub(crate) use corner::Answer;
pub(crate) use exchange::{ArrivingForm, ExchangeAnswer, LeavingChosen, LeavingForm, Stage, ask_arriving, ask_leaving};
pub(crate) use film::{FilmChosen, FilmForm, ask_film, film_eyes};
pub(crate) use fit_light::{FitLightChosen, ask_fit_light};
pub(crate) use manual::Manual;
pub(crate) use menu_keys::wanted_menu;
pub(crate) use palette::Palette;
pub(crate) use picture::{PictureForm, ask_picture};
pub(crate) use place_many::{ask_place_many, default_places};
pub(crate) use plugin::{PluginForm, Said, ask_plugin, show_last_run};
pub(crate) use start_page::{StartChoice, StartPage, start_page};
pub(crate) use status::{Drawn, status};
pub(crate) use thinning::{ThinAnswer, USUAL_TOLERANCE, ask_thinning};
pub(crate) use tour::{STEPS, TourAnswer, tour};
pub(crate) use weather_report::{WeatherChosen, WeatherForm, ask_weather};

use crate::state::{Action, Reading};
use crate::theme::icon;
use egui::Ui;
use serde::{Deserialize, Serialize};

/// A panel that can be docked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Panel {
    /// The picture, and what is done in it.
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
    /// Keys over the scene's clock.
    Timeline,
    /// Where plugins are written.
    Script,
    /// What each method costs and gets wrong.
    Chart,
    /// All changes.
    History,
    /// What is wrong with the scene.
    Problems,
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
            Self::Timeline => "Timeline",
            Self::Script => "Script",
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
            Self::Timeline => icon::DIAMOND,
            Self::Script => icon::MAGIC_WAND,
            Self::Chart => icon::CHART_SCATTER,
            Self::History => icon::CLOCK_COUNTER_CLOCKWISE,
            Self::Problems => icon::WARNING,
        }
    }

    /// Where it is narrower than a dock, it is scrolled sideways and so many points wide. The picture has any size.
    pub(crate) fn least_width(self) -> Option<f32> {
        Some(match self {
            Self::Viewport => return None,
            Self::Outline | Self::History | Self::Problems => 190.0,
            Self::Inspector => 370.0,
            Self::ColorLevels | Self::ShadingGroups | Self::Flight => 370.0,
            Self::Sky | Self::Chart => 380.0,
            Self::Script => 400.0,
            Self::Timeline => 460.0,
        })
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
            Self::Timeline => timeline::show(ui, reading, actions),
            Self::Script => script::show(ui, reading, actions),
            Self::Chart => chart::show(ui, reading, actions),
            Self::History => history::show(ui, reading, actions),
            Self::Problems => problems::show(ui, reading, actions),
        }
    }
}
