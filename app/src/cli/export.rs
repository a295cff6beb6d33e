//! `cloudwright export`: a scene for other tools, in the format that the file's name says.

use super::exchange::{Answer, choice_failure, set_options, tell_notes};
use super::failure::Failure;
use super::progress::Progress;
use super::{answer, arguments, info, input};
use crate::exchange::{LeaveError, Left, Order, Subject, leave};
use crate::opening::{self, Beside};
use crate::saving::SaveError;
use crate::storage::Over;
use crate::units::time_of_day;
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Change;
use cloudwright_core::exchange::{Corners, ExportError, Format, Part};
use cloudwright_core::scene::Scene;
use cloudwright_core::sprites::PlacedCloud;
use cloudwright_core::weather::Moment;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright export fair_weather.cloudscene -o sprites.json
  cloudwright export fair_weather.cloudscene -o sprites.csv
  cloudwright export summer_day.cloudscene -o evening.json --at 45
  cloudwright export fair_weather.cloudscene -o lit.json --shaded --time 18:30 --camera main
  cloudwright export fair_weather.cloudscene -o clouds.cld --cloud \"big one\"
  cloudwright export front.cloudscene -o front.glb --at 45 --set plain=yes
  cloudwright export summer_day.cloudscene -o index.html --at 45 --camera sunset
  cloudwright export summer_day.cloudscene -o day.WPR --set each_key=yes

The file's ending chooses the format, or else --format does; `cloudwright formats` lists them, with what each carries and
what can be set of it. What of the scene a format does not carry is said on stderr. A format may need several files; they
appear together, or none does.")]
pub(super) struct Arguments {
    /// Scene to export
    scene: PathBuf,
    /// File to write; its ending chooses the format
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// The format, where the ending does not choose it
    #[arg(long, value_name = "NAME")]
    format: Option<String>,
    /// What an option of the format is to be, as often as needed
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Only the clouds of that name, as often as needed
    #[arg(long, value_name = "NAME")]
    cloud: Vec<String>,
    /// Add each sprite's four corners with their light
    #[arg(long)]
    shaded: bool,
    /// Time of day of the light; the scene's if not given
    #[arg(long, value_name = "HH:MM", value_parser = time_of_day)]
    time: Option<f64>,
    /// Seconds of the scene's clock: where clouds are then, and how far they have formed
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = arguments::seconds)]
    at: f64,
    /// Camera that the sprites face; the scene's first if not given
    #[arg(long, value_name = "NAME")]
    camera: Option<String>,
    /// Answer with the files that were written, and what they do not carry, as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let name = arguments.output.file_name().unwrap_or_default().to_string_lossy();
    let format = Format::to_write(arguments.format.as_deref(), &name)
        .map_err(|error| choice_failure(&error, &format!("--output {}", arguments.output.display()), true))?;
    let mut options = format.usual_for_writing();
    set_options(&mut options, &arguments.set, format.write_options)?;
    let has_corners = has_corners(arguments, format)?;
    let (scene, beside) = if format.carries.contains(&Part::Atlas) {
        opening::open(&arguments.scene)?
    } else {
        (opening::open_scene(&arguments.scene)?, Beside::default())
    };
    let camera = if has_corners {
        let camera = input::camera(&scene, &arguments.scene, arguments.camera.as_deref())?;
        // Corners depend on where the eye is and which way is up, not on the picture's size.
        Some(camera.clone())
    } else {
        None
    };
    check_clouds(arguments, &scene)?;
    input::check_output(&scene, &arguments.scene, &arguments.output)?;
    let progress = Progress::start_stoppable("placing sprites");
    let nothing = Derived::default();
    let plan = nothing.plan(&scene, &Change::everything());
    let derived = plan.carry_out(progress.watch()).ok_or_else(Failure::stopped)?;
    drop(progress);
    let progress = Progress::start_stoppable("exporting");
    let chosen = |cloud: &&PlacedCloud| arguments.cloud.contains(&cloud.name);
    let order = Order {
        format,
        options,
        clouds: (!arguments.cloud.is_empty())
            .then(|| derived.clouds().iter().filter(chosen).map(|cloud| cloud.id).collect()),
        camera: camera.map(|camera| derived.timeline().camera_at(&camera, arguments.at)),
        moment: Moment { clock_s: arguments.at, time_h: arguments.time },
        over: Over::Anything,
    };
    let subject = Subject { scene: &scene, derived: &derived, atlas: beside.sheet(), file: Some(&arguments.scene) };
    let left = leave(subject, &order, &arguments.output, progress.watch());
    drop(progress);
    let Left { files, notes } = left.map_err(|error| failure(arguments, error))?;
    if arguments.json {
        let files = files.iter().map(|path| path.display().to_string()).collect();
        return answer(&info::json_text(&Answer { format: format.name, files, notes: &notes })?);
    }
    tell_notes(&notes);
    Ok(())
}

fn failure(arguments: &Arguments, error: LeaveError) -> Failure {
    let scene = arguments.scene.display();
    match error {
        LeaveError::Save(SaveError::InUse { path, what }) => {
            let what = format!("--output: {} would be written, and that is {what}", path.display());
            Failure::argument(what, "choose another name; it would be lost")
        }
        LeaveError::Save(error) => error.into(),
        LeaveError::Export(ExportError::Cancelled) => Failure::stopped(),
        LeaveError::Export(error @ ExportError::Nothing(_)) => {
            Failure::argument(format!("{scene}: {error}"), "there is nothing to export")
        }
        LeaveError::Export(error @ ExportError::TooMuch { .. }) => {
            Failure::argument(format!("{scene}: {error}"), "export fewer clouds: --cloud NAME")
        }
        LeaveError::Export(error) => Failure::could_not(error.to_string(), "report this"),
    }
}

/// Whether corners are to be lit: as the format always has them, or as it is asked to.
fn has_corners(arguments: &Arguments, format: &Format) -> Result<bool, Failure> {
    let has_corners = format.corners == Corners::Always || arguments.shaded;
    if arguments.shaded && format.corners == Corners::None {
        let what = format!("--shaded: {} has no corners", format.title);
        return Err(Failure::argument(what, "leave it out, or export as .json or .csv"));
    }
    let needless = [("--time", arguments.time.is_some()), ("--camera", arguments.camera.is_some())];
    match needless.into_iter().find(|(_, given)| *given && !has_corners) {
        Some((flag, _)) if format.corners == Corners::Asked => {
            Err(Failure::argument(format!("{flag}: no corners are to be lit"), "add --shaded"))
        }
        Some((flag, _)) => Err(Failure::argument(format!("{flag}: {} has no light", format.title), "leave it out")),
        None => Ok(has_corners),
    }
}

/// That the clouds that are asked for are there.
fn check_clouds(arguments: &Arguments, scene: &Scene) -> Result<(), Failure> {
    let names: Vec<&str> = scene.clouds.iter().map(|cloud| cloud.name.as_str()).collect();
    let Some(missing) = arguments.cloud.iter().find(|name| !names.contains(&name.as_str())) else { return Ok(()) };
    let what = format!("{}: clouds: there is no cloud “{missing}”", arguments.scene.display());
    Err(Failure::argument(
        what,
        format!("{}the clouds are {}", arguments::did_you_mean(missing, &names), names.join(", ")),
    ))
}
