//! A sky from weather reports: where they are pasted, what was understood of them while they are typed, and what the
//! clouds that were made cover.

mod covers;
mod understood;

use super::corner::{self, Answer};
use super::plugin::{Said, said};
use crate::reports::{Line, Made, reading};
use crate::theme;
use crate::units::Units;
use crate::widget::{lines_field, number_field, seed_field, text_field};
use cloudwright_core::property::Number;
use cloudwright_core::reported::{SPEEDS, roughly};
use egui::{Context, Grid, Id, ScrollArea, Ui};
use std::collections::BTreeMap;

const SPEED: Number = Number {
    label: "Speed",
    unit: "×",
    min: *SPEEDS.start(),
    max: *SPEEDS.end(),
    doc: "How much faster than life the reports' time passes in the scene's clock.",
};
/// Before another one is chosen: an hour in six seconds.
const USUAL_SPEED: f64 = 600.0;
/// Rows of text that are shown.
const ROWS: usize = 5;
/// So many stations can be placed by hand.
const STATIONS: usize = 8;

/// What is chosen.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WeatherChosen {
    /// The reports, as they were pasted.
    pub(crate) text: String,
    /// Whether the clouds that are there stay.
    pub(crate) keeps_clouds: bool,
    /// Whether the scene moves to the reports' place.
    pub(crate) moves_site: bool,
    /// How much faster than life.
    pub(crate) speed: f64,
    /// Another one is another sky.
    pub(crate) seed: u64,
    /// Where stations are, as it was typed.
    pub(crate) places: BTreeMap<String, String>,
}

impl Default for WeatherChosen {
    fn default() -> Self {
        Self {
            text: String::new(),
            keeps_clouds: false,
            moves_site: true,
            speed: USUAL_SPEED,
            seed: 1,
            places: BTreeMap::new(),
        }
    }
}

/// What is shown of it.
#[derive(Clone, Copy)]
pub(crate) struct WeatherForm<'a> {
    /// What was read; or why that is none.
    pub(crate) lines: Result<&'a [Line], &'a str>,
    /// Whether it is shown for the first time.
    pub(crate) is_new: bool,
    /// What the scene shows of it.
    pub(crate) made: Option<&'a Made>,
    pub(crate) said: Said<'a>,
    /// Whether all of it could be read, and there is something.
    pub(crate) can_do: bool,
    pub(crate) units: Units,
}

/// Asks in a corner, so that the sky can be seen.
pub(crate) fn ask_weather(context: &Context, form: &WeatherForm<'_>, chosen: &mut WeatherChosen) -> Option<Answer> {
    corner::ask(context, Id::unique("weather report"), theme::WIDE_DIALOG_WIDTH, |ui| {
        ui.heading("Weather from a report");
        ui.weak("METARs and TAFs become air, clouds and, if they are several, tracks with keys at their times.");
        ui.add_space(theme::GAP);
        let height = ui.ctx().content_rect().height() * theme::WIDE_FORM_SHARE;
        ScrollArea::vertical().id_salt("form").max_height(height).show(ui, |ui| {
            ui.set_width(ui.available_width());
            if let Some(text) = lines_field(ui, "Reports", [HINT, HELP], ROWS, form.is_new, &chosen.text) {
                chosen.text = text;
            }
            ui.add_space(theme::GAP);
            options(ui, form, chosen);
            ui.add_space(theme::GAP);
            understood::show(ui, form.lines, form.units);
            if let Some(made) = form.made {
                ui.add_space(theme::GAP);
                covers::show(ui, made, form.units);
            }
        });
        ui.add_space(theme::GAP);
        said(ui, &form.said);
        corner::buttons(ui, "OK", form.can_do && form.said.error.is_none())
    })
}

const HINT: &str = "EDDF 171320Z 24012KT 9999 SCT035 18/09 Q1015";
const HELP: &str = "Each report is a line; what is indented goes on with the one before. Or a weather service's JSON.";

fn options(ui: &mut Ui, form: &WeatherForm<'_>, chosen: &mut WeatherChosen) {
    ui.checkbox(&mut chosen.keeps_clouds, "Keep the clouds that stand")
        .on_hover_text("Else the reports' clouds take their place.");
    ui.checkbox(&mut chosen.moves_site, "Put the scene where the reports are from")
        .on_hover_text("Then the sun stands as it does there at that hour.");
    let lines = form.lines.unwrap_or_default();
    let stations = unplaced(lines);
    Grid::new("weather options").num_columns(2).min_col_width(theme::NAME_WIDTH).show(ui, |ui| {
        ui.label("Seed").on_hover_text(SEED_HELP);
        ui.horizontal(|ui| seed_field(ui, "Seed", "Re-roll Seed", SEED_HELP, &mut chosen.seed));
        ui.end_row();
        let has_times = lines.len() > 1 || lines.iter().any(|line| line.read.as_ref().is_ok_and(|it| it.len() > 1));
        if has_times {
            ui.label(SPEED.label).on_hover_text(SPEED.doc);
            ui.horizontal(|ui| number_field(ui, SPEED.label, &SPEED, &mut chosen.speed, true));
            ui.end_row();
        }
        for station in stations.iter().take(STATIONS) {
            place(ui, station, &mut chosen.places);
        }
    });
    if stations.len() > STATIONS {
        ui.weak(format!("and {} more stations", stations.len() - STATIONS));
    }
}

const SEED_HELP: &str = "Another one is another sky of the same reports.";

/// Stations that the text itself does not place, each once.
fn unplaced(lines: &[Line]) -> Vec<&str> {
    let mut stations = Vec::new();
    for station in lines.iter().filter(|line| line.place.is_none()).filter_map(Line::station) {
        if !stations.contains(&station) {
            stations.push(station);
        }
    }
    stations
}

/// Where a station is, to be typed.
fn place(ui: &mut Ui, station: &str, places: &mut BTreeMap<String, String>) {
    let label = format!("{station} is at");
    ui.label(&label);
    let typed = places.get(station).cloned().unwrap_or_default();
    let hint = match roughly(station) {
        Some(place) => format!("roughly {:.0}, {:.0}", place.latitude_deg, place.longitude_deg),
        None => "50.03, 8.57".into(),
    };
    ui.horizontal(|ui| {
        if !typed.is_empty() && reading::place_of(&typed).is_none() {
            ui.colored_label(theme::error(ui), "write 50.03, 8.57");
        }
        if let Some(text) = text_field(ui, &label, &hint, "Degrees north, and degrees east.", &typed) {
            places.insert(station.to_owned(), text);
        }
    });
    ui.end_row();
}
