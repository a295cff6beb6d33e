//! `cloudwright weather`: a scene with the sky of real reports.

use super::arguments::report_speed;
use super::failure::{Failure, UNUSABLE_INPUT};
use super::progress::Progress;
use super::run::failure as plugin_failure;
use super::{answer, input, say};
use crate::reports::{self, Line, MOST_TIME, MadeLayer, MakeError, Making, make, reading, words};
use crate::starter::empty_sky;
use crate::storage::FileId;
use crate::units::{Units, counted};
use crate::{opening, saving, storage};
use cloudwright_core::document::Document;
use cloudwright_core::formats::metar::{RefusedGroup, Report};
use cloudwright_core::reported::{Place, Sky};
use cloudwright_core::scene::Scene;
use cloudwright_scripts::Patience;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;
use std::time::Instant;

#[derive(Debug, clap::Args)]
#[command(
    group = clap::ArgGroup::new("reports").required(true),
    after_help = "Examples:
  cloudwright weather --metar \"EDDF 171320Z 24012KT 9999 SCT035 18/09 Q1015\" -o sky.cloudscene
  cloudwright weather --file eddf.txt sky.cloudscene -o day.cloudscene --speed 1440
  cloudwright weather --file three.json -o between.cloudscene --place EDDF=50.03,8.57
  cloudwright weather --metar \"EDDF 171320Z 24012KT 9999 SCT035 18/09 Q1015\" --json

From a report come wind, temperature, dew point, haze (by the visibility), the hour at the scene's offset from UTC, and
clouds: each layer by a plugin that ships, as many as cover the sky as the report says, measured from below. They take the
place of the clouds that are there.
Several reports become tracks with smooth keys at their times, so that the sky steps at none; clouds form and dissipate
between them. A TAF becomes the hours ahead; what comes and goes within the hour or perhaps (TEMPO, PROB) is left out.
Reports of several stations weigh by their distance from the scene's place, for which each needs its own: by --place, or
out of the file. In a file each report is a line, and what is indented goes on with it; empty lines and those that begin
with # are passed over. Or it is JSON with rawOb or rawTAF, lat and lon, as aviationweather.gov answers."
)]
pub(super) struct Arguments {
    /// Scene that takes the weather; an empty one if not given, at the station's place: roughly, where that is not told
    scene: Option<PathBuf>,
    /// The report or forecast, quoted
    #[arg(long, value_name = "REPORT", group = "reports")]
    metar: Option<String>,
    /// File of reports, a line each, or a weather service's JSON
    #[arg(long, value_name = "REPORTS", group = "reports")]
    file: Option<PathBuf>,
    /// Scene to write
    #[arg(short, long, value_name = "SCENE", required_unless_present = "json")]
    output: Option<PathBuf>,
    /// Answer with each report, and the layers of its sky with what they were to cover and do, as JSON; lengths in metres
    #[arg(long)]
    json: bool,
    /// How much faster than life the reports' time passes in the scene's clock, 1 to 86400
    #[arg(long, value_name = "TIMES", default_value_t = 600.0, value_parser = report_speed)]
    speed: f64,
    /// Where a station is, degrees north and east, as often as needed
    #[arg(long, value_name = "STATION=LATITUDE,LONGITUDE", value_parser = place_of_station)]
    place: Vec<(String, Place)>,
    /// Keep the clouds that are there
    #[arg(long)]
    keep_clouds: bool,
    /// Another sky of the same reports
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

/// Of a file of reports, and more than a year of them.
const MOST_BYTES: usize = 4 << 20;
#[derive(Serialize, JsonSchema)]
pub(super) struct Answer<'a> {
    reports: Vec<AnswerLine<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    skies: Option<Vec<AnswerSky<'a>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    layers: Option<&'a [MadeLayer]>,
}

/// A report; of a forecast its states, one after the other.
#[derive(Serialize, JsonSchema)]
struct AnswerLine<'a> {
    line: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    reports: Option<&'a [Report]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    refused: Option<&'a RefusedGroup>,
}

#[derive(Serialize, JsonSchema)]
struct AnswerSky<'a> {
    /// Of the scene's clock.
    time_s: f64,
    #[serde(flatten)]
    sky: &'a Sky,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let lines = lines(arguments)?;
    let scene = match &arguments.scene {
        Some(path) => opening::open(path)?.0,
        None => empty_sky(),
    };
    if let Some(output) = &arguments.output {
        check_output(arguments, &scene, output)?;
    }
    let told = match reading::told(&lines) {
        Ok(told) => told,
        Err((number, refused)) => {
            if arguments.json {
                tell_json(&lines, None)?;
                return Err(Failure::Told(UNUSABLE_INPUT));
            }
            let what = format!("{}: {refused}", place(arguments, number));
            return Err(Failure::argument(what, "correct it or leave it out; nothing is written"));
        }
    };
    let several = told.iter().any(|each| each.report.station != told[0].report.station);
    let making = Making {
        speed: arguments.speed,
        seed: arguments.seed,
        keeps_clouds: arguments.keep_clouds,
        moves_site: arguments.scene.is_none() || lines.iter().any(|line| line.place.is_some()) && !several,
        date: lines.iter().find_map(|line| line.date),
    };
    let mut document = Document::new(scene);
    let progress = Progress::start_stoppable("making the sky");
    let patience = Patience { cancelled: progress.watch().cancelled(), until: Some(Instant::now() + MOST_TIME) };
    let made = make(&mut document, &told, &making, &patience).map_err(|error| failure(arguments, error));
    drop(progress);
    let made = made?;
    if arguments.json {
        tell_json(&lines, Some(&made))?;
    }
    let Some(output) = &arguments.output else { return Ok(()) };
    input::save_scene(document.scene(), arguments.scene.as_deref(), output, arguments.force)?;
    if made.skies.len() > 1 {
        say(&format!("{} became tracks", counted(made.skies.len(), "time", "times")));
    }
    made.layers.iter().for_each(|layer| say(&layer_line(layer)));
    if made.layers.is_empty() {
        say("the report has no clouds");
    }
    Ok(())
}

fn failure(arguments: &Arguments, error: MakeError) -> Failure {
    match error {
        MakeError::Unordered(error) => Failure::argument(
            format!("{}: {error}", place(arguments, 0)),
            "give reports of one station, or say where each is: --place EDDF=50.03,8.57",
        ),
        MakeError::Plugin { plugin, error } => plugin_failure(plugin, &error),
        broken @ MakeError::Broken(_) => Failure::could_not(broken.to_string(), "report this"),
    }
}

fn check_output(arguments: &Arguments, scene: &Scene, output: &std::path::Path) -> Result<(), Failure> {
    input::check_scene_name(output)?;
    if let Some(path) = &arguments.scene {
        input::check_output(scene, path, output)?;
    }
    if arguments.file.as_deref().and_then(FileId::of).is_some_and(|file| FileId::of(output) == Some(file)) {
        let what = format!("--output {}: those are the reports", output.display());
        return Err(Failure::argument(what, "choose another name; they would be lost"));
    }
    saving::to_copy(scene, arguments.scene.as_deref(), output)?;
    Ok(())
}

/// Where a line is from, for people; 0 stands for all.
fn place(arguments: &Arguments, number: usize) -> String {
    match &arguments.file {
        Some(file) if number > 0 => format!("{}:{number}", file.display()),
        Some(file) => file.display().to_string(),
        None => "--metar".into(),
    }
}

fn lines(arguments: &Arguments) -> Result<Vec<Line>, Failure> {
    let mut lines = match (&arguments.file, &arguments.metar) {
        (Some(file), _) => {
            let bad = |what: &str| {
                Failure::argument(format!("{}: {what}", file.display()), "give reports, a line each, or as JSON")
            };
            let text =
                String::from_utf8(storage::read(file, MOST_BYTES)?).map_err(|_| bad("it is no text in UTF-8"))?;
            reports::lines(&text).map_err(|error| bad(&error.to_string()))?
        }
        // Pasted reports may be wrapped; there is one.
        (None, Some(metar)) => vec![reading::one(metar)],
        (None, None) => Vec::new(),
    };
    let given = |station: &str| arguments.place.iter().find(|(name, _)| name == station).map(|(_, place)| *place);
    reading::put_stations(&mut lines, given);
    Ok(lines)
}

/// EDDF=50.03,8.57
fn place_of_station(text: &str) -> Result<(String, Place), String> {
    let read = || {
        let (station, place) = text.split_once('=')?;
        Some((station.trim().to_ascii_uppercase(), reading::place_of(place)?))
    };
    read().ok_or_else(|| "write it as EDDF=50.03,8.57: degrees north, and degrees east".into())
}

fn tell_json<'a>(lines: &'a [Line], made: Option<&'a reports::Made>) -> Result<(), Failure> {
    let line = |line: &'a Line| AnswerLine {
        line: line.number,
        reports: line.read.as_deref().ok(),
        refused: line.read.as_ref().err(),
    };
    let skies =
        |made: &'a reports::Made| made.skies.iter().map(|(time_s, sky)| AnswerSky { time_s: *time_s, sky }).collect();
    let answered = Answer {
        reports: lines.iter().map(line).collect(),
        skies: made.map(skies),
        layers: made.map(|made| made.layers.as_slice()),
    };
    answer(&super::info::json_text(&answered)?)
}

/// `BKN cumulus, base 1070 m, 800 m thick: 14 clouds, 5.8 oktas where 6 are asked for`.
pub(super) fn layer_line(made: &MadeLayer) -> String {
    let MadeLayer { layer, clouds, .. } = made;
    let what = words::layer(layer, Units::Metric);
    match made.fullest() {
        Some(cover) => format!(
            "{what}: {}, {:.1} oktas where {} are asked for",
            counted(clouds.len(), "cloud", "clouds"),
            cover.measured_oktas,
            cover.asked_oktas
        ),
        None => format!("{what}: no clouds; the haze is as the visibility has it"),
    }
}
