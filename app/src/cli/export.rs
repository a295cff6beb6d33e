//! `cloudwright export`: a scene for other tools, in the format that the file's name says.

use super::exchange::{Answer, choice_failure, set_options, tell_notes};
use super::failure::Failure;
use super::progress::Progress;
use super::{answer, arguments, info, input};
use crate::opening::{self, Beside};
use crate::saving;
use crate::storage::Together;
use crate::units::time_of_day;
use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Change;
use cloudwright_core::exchange::{Corners, ExportError, Files, Format, Leaving, Note, Part};
use cloudwright_core::scene::Scene;
use cloudwright_core::weather::{CloudNow, Moment, SceneNow, WeatherRules};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright export fair_weather.cloudscene -o sprites.json
  cloudwright export fair_weather.cloudscene -o sprites.csv
  cloudwright export summer_day.cloudscene -o evening.json --at 45
  cloudwright export fair_weather.cloudscene -o lit.json --shaded --time 18:30 --camera main
  cloudwright export fair_weather.cloudscene -o clouds.cld --cloud \"big one\"
  cloudwright export front.cloudscene -o front.glb --at 45 --set plain=yes
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
    let name = file_name(&arguments.output);
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
    let moment = Moment { clock_s: arguments.at, time_h: arguments.time };
    let mut now = SceneNow::new(&scene, (derived.clouds(), derived.timeline()), moment, WeatherRules::default());
    let is_meant = |cloud: &CloudNow<'_>| arguments.cloud.is_empty() || arguments.cloud.contains(&cloud.placed.name);
    now.clouds.retain(is_meant);
    let view = camera.map(|camera| {
        let camera = derived.timeline().camera_at(&camera, arguments.at);
        View::new(&camera, 1, 1)
    });
    let leaving = Leaving {
        scene: &scene,
        derived: &derived,
        moment,
        now: &now,
        atlas: beside.sheet(),
        view: view.as_ref(),
        name: &name,
        options: &options,
        watch: progress.watch(),
    };
    let mut files = Written { scene: &scene, arguments, together: Together::default(), failed: None };
    let written = format.write(&leaving, &mut files);
    let notes = files.notes(written)?;
    let written = files.together.take_names()?;
    drop(progress);
    if arguments.json {
        let files = written.iter().map(|path| path.display().to_string()).collect();
        return answer(&info::json_text(&Answer { format: format.name, files, notes: &notes })?);
    }
    tell_notes(&notes);
    Ok(())
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

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
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

/// The files of one export, beside the one that was asked for.
struct Written<'a> {
    scene: &'a Scene,
    arguments: &'a Arguments,
    together: Together,
    /// Why a file could not be written.
    failed: Option<Failure>,
}

impl Written<'_> {
    fn notes(&mut self, written: Result<Vec<Note>, ExportError>) -> Result<Vec<Note>, Failure> {
        let Arguments { scene, .. } = self.arguments;
        written.map_err(|error| match (error, self.failed.take()) {
            (ExportError::Cancelled, _) => Failure::stopped(),
            (_, Some(failure)) => failure,
            (error @ ExportError::Nothing(_), _) => {
                Failure::argument(format!("{}: {error}", scene.display()), "there is nothing to export")
            }
            (error @ ExportError::TooMuch { .. }, _) => {
                Failure::argument(format!("{}: {error}", scene.display()), "export fewer clouds: --cloud NAME")
            }
            (error, _) => Failure::could_not(error.to_string(), "report this"),
        })
    }

    fn write(&mut self, path: &Path, fill: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
        if let Some(what) = saving::in_use(self.scene, &self.arguments.scene, path) {
            let what = format!("--output: {} would be written, and that is {what}", path.display());
            return Err(Failure::argument(what, "choose another name; it would be lost"));
        }
        Ok(self.together.add(path, |sink| fill(sink))?)
    }
}

impl Files for Written<'_> {
    fn add(&mut self, name: &str, fill: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        let asked = &self.arguments.output;
        let path = if name == file_name(asked) { asked.clone() } else { asked.with_file_name(name) };
        self.write(&path, fill).map_err(|failure| {
            self.failed = Some(failure);
            ErrorKind::Other.into()
        })
    }
}
