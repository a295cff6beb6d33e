//! `cloudwright export`: all sprites for other tools, as JSON or as a table, written as they come.

use super::failure::Failure;
use super::progress::Progress;
use super::{arguments, input};
use crate::units::time_of_day;
use crate::{opening, storage};
use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Change;
use cloudwright_core::formats::{sprites_csv, sprites_json};
use cloudwright_core::posed_sprite::Still;
use cloudwright_core::weather::{Moment, SceneNow, WeatherRules};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright export fair_weather.cloudscene -o sprites.json
  cloudwright export fair_weather.cloudscene -o sprites.csv
  cloudwright export summer_day.cloudscene -o evening.json --at 45
  cloudwright export fair_weather.cloudscene -o lit.json --shaded --time 18:30 --camera main")]
pub(super) struct Arguments {
    /// Scene to export
    scene: PathBuf,
    /// File to write; .json or .csv decides the format
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Add each sprite's four corners with their light
    #[arg(long)]
    shaded: bool,
    /// Time of day of the light; the scene's if not given
    #[arg(long, value_name = "HH:MM", requires = "shaded", value_parser = time_of_day)]
    time: Option<f64>,
    /// Seconds of the scene's clock: where clouds are then, and how far they have formed
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = arguments::seconds)]
    at: f64,
    /// Camera that the sprites face; the scene's first if not given
    #[arg(long, value_name = "NAME", requires = "shaded")]
    camera: Option<String>,
}

enum Format {
    Json,
    Csv,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let format = format_of(&arguments.output)?;
    let scene = opening::open_scene(&arguments.scene)?;
    let camera = if arguments.shaded {
        let camera = input::camera(&scene, &arguments.scene, arguments.camera.as_deref())?;
        // Corners depend on where the eye is and which way is up, not on the picture's size.
        Some(camera.clone())
    } else {
        None
    };
    input::check_output(&scene, &arguments.scene, &arguments.output)?;
    let progress = Progress::start_stoppable("placing sprites");
    let nothing = Derived::default();
    let plan = nothing.plan(&scene, &Change::everything());
    let derived = plan.carry_out(progress.watch()).ok_or_else(Failure::stopped)?;
    drop(progress);
    let progress = Progress::start_stoppable("exporting");
    let moment = Moment { clock_s: arguments.at, time_h: arguments.time };
    let now = SceneNow::new(&scene, (derived.clouds(), derived.timeline()), moment, WeatherRules::default());
    let view = camera.map(|camera| {
        let camera = derived.timeline().camera_at(&camera, arguments.at);
        View::new(&camera, 1, 1)
    });
    let shaded = view.as_ref().map(|view| Still { view, light: &now.light });
    let watch = progress.watch();
    let written = storage::write_streamed(&arguments.output, |out| {
        match format {
            Format::Json => sprites_json::write(out, &now.clouds, shaded, watch),
            Format::Csv => sprites_csv::write(out, &now.clouds, shaded, watch),
        }?;
        if watch.is_cancelled() { Err(ErrorKind::Interrupted.into()) } else { Ok(()) }
    });
    match written {
        Err(_) if watch.is_cancelled() => Err(Failure::stopped()),
        written => Ok(written?),
    }
}

fn format_of(path: &Path) -> Result<Format, Failure> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("json") => Ok(Format::Json),
        Some("csv") => Ok(Format::Csv),
        _ => Err(Failure::argument(
            format!("--output {}: the ending names no format", path.display()),
            "end its name in .json or .csv",
        )),
    }
}
