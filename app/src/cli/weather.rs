//! `cloudwright weather`: a scene with the air of real reports.

use super::arguments::report_speed;
use super::failure::{Failure, UNUSABLE_INPUT};
use super::{answer, counted, input, say};
use crate::state::starter_scene;
use crate::storage::FileId;
use crate::{opening, saving, storage};
use cloudwright_core::document::Document;
use cloudwright_core::formats::metar::{self, RefusedGroup, Report};
use cloudwright_core::reported::{self, Air, ApplyError, PlannedLayer};
use cloudwright_core::scene::Scene;
use serde::Serialize;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(
    group = clap::ArgGroup::new("reports").required(true),
    after_help = "Examples:
  cloudwright weather --metar \"EDDF 171320Z 24012KT 9999 SCT035 18/09 Q1015\" -o sky.cloudscene
  cloudwright weather --file eddf.txt sky.cloudscene -o day.cloudscene --speed 1440
  cloudwright weather --metar \"EDDF 171320Z 24012KT 9999 SCT035 18/09 Q1015\" --json

From a report come wind, temperature, dew point, haze (by the visibility) and the hour at the scene's offset from UTC;
tracks that these had go. The date stays: reports tell the day of the month alone. Clouds are planned, and are to be placed
by hand for now: the plan is told, with the kind, base, thickness and oktas of each layer.
Several reports of one station become tracks with smooth keys at their times, so that the sky steps at none. In a file
each report is a line; empty lines and those that begin with # are passed over. METAR and SPECI are read, TAF is not."
)]
pub(super) struct Arguments {
    /// Scene that takes the weather; the editor's new scene if not given
    scene: Option<PathBuf>,
    /// The report, quoted
    #[arg(long, value_name = "REPORT", group = "reports")]
    metar: Option<String>,
    /// File of reports, a line each
    #[arg(long, value_name = "REPORTS", group = "reports")]
    file: Option<PathBuf>,
    /// Scene to write
    #[arg(short, long, value_name = "SCENE", required_unless_present = "json")]
    output: Option<PathBuf>,
    /// Answer with each report and the plan of its sky as JSON; lengths in metres
    #[arg(long)]
    json: bool,
    /// How much faster than life the reports' time passes in the scene's clock, 1 to 86400
    #[arg(long, value_name = "TIMES", default_value_t = 600.0, value_parser = report_speed)]
    speed: f64,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

/// Of a file of reports, and more than a year of them.
const MOST_BYTES: usize = 4 << 20;

/// A line with its report, or why it is none.
struct Line {
    number: usize,
    read: Result<Report, RefusedGroup>,
}

#[derive(Serialize)]
struct Answer<'a> {
    line: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    report: Option<&'a Report>,
    #[serde(skip_serializing_if = "Option::is_none")]
    plan: Option<Plan>,
    #[serde(skip_serializing_if = "Option::is_none")]
    refused: Option<&'a RefusedGroup>,
}

#[derive(Serialize)]
struct Plan {
    layers: Vec<PlannedLayer>,
    air: Air,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let lines = lines(arguments)?;
    let scene = match &arguments.scene {
        Some(path) => opening::open(path)?.0,
        None => starter_scene(),
    };
    if let Some(output) = &arguments.output {
        input::check_scene_name(output)?;
        if let Some(path) = &arguments.scene {
            input::check_output(&scene, path, output)?;
        }
        if arguments.file.as_deref().and_then(FileId::of).is_some_and(|file| FileId::of(output) == Some(file)) {
            let what = format!("--output {}: those are the reports", output.display());
            return Err(Failure::argument(what, "choose another name; they would be lost"));
        }
        saving::to_copy(&scene, arguments.scene.as_deref(), output).map_err(input::save_failure)?;
    }
    let refused = lines.iter().find_map(|line| Some((line.number, line.read.as_ref().err()?)));
    if arguments.json {
        tell_json(&lines, &scene)?;
        if refused.is_some() {
            return Err(Failure::Told(UNUSABLE_INPUT));
        }
    }
    if let Some((number, refused)) = refused {
        let what = format!("{}: {refused}", place(arguments, number));
        return Err(Failure::argument(what, "correct it or leave it out; nothing is written"));
    }
    let Some(output) = &arguments.output else { return Ok(()) };
    let reports: Vec<Report> = lines.into_iter().filter_map(|line| line.read.ok()).collect();
    let mut document = Document::new(scene);
    reported::apply(&mut document, &reports, arguments.speed).map_err(|error| match error {
        ApplyError::Unordered(error) => {
            Failure::argument(format!("{}: {error}", place(arguments, 0)), "give reports of one station, a line each")
        }
        other => Failure::could_not(other.to_string(), "report this"),
    })?;
    input::save_scene(document.scene(), arguments.scene.as_deref(), output, arguments.force)?;
    match &reports[..] {
        [report] => tell_layers(&reported::layers(report)),
        _ => say(&format!("{} became tracks", counted(reports.len(), "report", "reports"))),
    }
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
    let text = match (&arguments.file, &arguments.metar) {
        (Some(file), _) => String::from_utf8(storage::read(file, MOST_BYTES)?).map_err(|_| {
            Failure::argument(format!("{}: it is no text in UTF-8", file.display()), "give reports, a line each")
        })?,
        // Pasted reports may be wrapped; there is one.
        (None, Some(metar)) => {
            return Ok(vec![Line { number: 1, read: metar::read(metar) }]);
        }
        (None, None) => String::new(),
    };
    let has_report = |line: &str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    let lines = text.lines().enumerate().filter(|(_, line)| has_report(line));
    Ok(lines.map(|(index, line)| Line { number: index + 1, read: metar::read(line) }).collect())
}

fn tell_json(lines: &[Line], scene: &Scene) -> Result<(), Failure> {
    let plan = |report: &Report| Plan { layers: reported::layers(report), air: Air::of(report, scene) };
    let answers: Vec<Answer<'_>> = lines
        .iter()
        .map(|Line { number, read }| Answer {
            line: *number,
            report: read.as_ref().ok(),
            plan: read.as_ref().ok().map(plan),
            refused: read.as_ref().err(),
        })
        .collect();
    let text = serde_json::to_string_pretty(&answers);
    answer(&(text.map_err(|error| Failure::could_not(error.to_string(), "report this"))? + "\n"))
}

fn tell_layers(layers: &[PlannedLayer]) {
    if layers.is_empty() {
        say("the report has no clouds to place");
    }
    for layer in layers {
        let genus = serde_json::to_value(layer.genus).unwrap_or_default();
        say(&format!(
            "to be placed by hand: {}, base {:.0} m above the station{}, {:.0} m thick, {} of 8 oktas",
            genus.as_str().unwrap_or_default().replace('_', " "),
            layer.base_m,
            if layer.base_assumed { " (assumed)" } else { "" },
            layer.thickness_m,
            layer.oktas
        ));
    }
}
