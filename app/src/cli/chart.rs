//! `cloudwright chart`: what each way to draw costs and gets wrong, for one scene.
//!
//! Writes `chart.html` and `chart.json` into a folder. The JSON grows while it measures; a run that was broken off
//! goes on where it stopped, if scene and options are the same.

mod known;

use super::failure::Failure;
use super::progress::Progress;
use super::{answer, arguments, input, say};
use crate::chart::charted::Charted;
use crate::chart::report::Report;
use crate::chart::run::Run;
use crate::chart::subject::Subject;
use crate::chart::{choice, front, html, report, text};
use crate::rendering::check_memory;
use crate::storage::{self, Folder};
use crate::units::time_of_day;
use crate::{opening, visible};
use cloudwright_core::derived::Derived;
use cloudwright_core::flight::PathCurve;
use cloudwright_core::method::{self, METHODS, Method};
use cloudwright_core::scene::{Camera, CameraPath, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::weather::Moment;
use cloudwright_render::AdapterChoice;
use std::fmt::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// What is done is kept so often.
const KEPT_EVERY: Duration = Duration::from_secs(1);

#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Arguments {
    /// Scene to draw
    scene: PathBuf,
    /// Folder to write chart.html and chart.json to
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Draw a still from the camera of this name
    #[arg(long, value_name = "NAME", conflicts_with = "path")]
    camera: Option<String>,
    /// Fly along the path of this name; without --camera, --path and --at the scene's first path, or its first camera
    #[arg(long, value_name = "NAME")]
    path: Option<String>,
    /// Methods by name, with commas between; all that make a difference if not given
    #[arg(long, value_name = "A,B,…", value_delimiter = ',', value_parser = arguments::method)]
    methods: Vec<&'static Method>,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "640x360", value_parser = arguments::picture_size)]
    size: [u32; 2],
    /// Time of day; the scene's if not given
    #[arg(long, value_name = "HH:MM", value_parser = time_of_day)]
    time: Option<f64>,
    /// Seconds of the scene's clock at which the camera looks, 0 if not given; along a path the clock is the flight's
    #[arg(long, value_name = "SECONDS", conflicts_with = "path", value_parser = arguments::seconds)]
    at: Option<f64>,
    /// How often each method is timed, 1 to 100; the median counts
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
    repeat: u32,
    /// Mean FLIP that is good enough, 0 to 1: the cheapest method within it is named
    #[arg(long, value_name = "X", default_value_t = html::DEFAULT_TOLERANCE, value_parser = arguments::share)]
    tolerance: f64,
    /// Answer with what is in chart.json
    #[arg(long)]
    json: bool,
}

fn help() -> String {
    let mut help = "Examples:
  cloudwright chart fair_weather.cloudscene -o chart
  cloudwright chart overcast.cloudscene -o chart --camera within --size 960x540
  cloudwright chart summer_day.cloudscene -o chart --camera main --at 45
  cloudwright chart overcast.cloudscene -o chart --methods truth,fast,half,quarter --tolerance 0.01

Along a path, errors are measured at five places spread over it, and at each the change to the next of 30 frames a
second. A run that was broken off goes on when it is started again with the same scene and options.

Methods:\n"
        .to_owned();
    for method in METHODS {
        let _ = writeln!(help, "  {:<19} {}", method.name, method.about);
    }
    help
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    check_memory(arguments.size, 2, 1)?;
    let (scene, beside) = opening::open(&arguments.scene)?;
    let (camera, path) = eye(&scene, arguments)?;
    let derived = Derived::new(&scene);
    if derived.clouds().iter().all(|cloud| cloud.sprites.is_empty()) {
        let what = format!("{}: clouds: there are no sprites, so all methods draw the same", arguments.scene.display());
        return Err(Failure::argument(what, "add a cloud, with boxes in its model"));
    }
    let moment = Moment { clock_s: arguments.at.unwrap_or_default(), time_h: arguments.time };
    let camera = match path {
        Some(_) => camera,
        None => derived.timeline().camera_at(&camera, moment.clock_s),
    };
    let sight = &Sight { moment, ..Sight::still(&camera, arguments.size) };
    let subject = Subject { scene: &scene, derived: &derived, atlas: beside.sheet(), sight, path };
    let (charted, left_out) = choice::charted(&subject, &arguments.methods);
    if charted.is_empty() {
        let reasons: Vec<String> = left_out.iter().map(|one| format!("{}: {}", one.name, one.reason)).collect();
        let what = format!("--methods: none is left: {}", reasons.join("; "));
        return Err(Failure::argument(what, "leave --methods out for all that make sense"));
    }
    let adapters: Vec<String> = charted.iter().filter_map(Charted::adapter).collect();
    let head = Report {
        scene: scene.name.clone(),
        size: arguments.size,
        adapter: adapters.into_iter().next().unwrap_or_else(|| "CPU".into()),
        view: Some(subject.view()),
        left_out,
        input: known::input(&arguments.scene, &subject)?,
        ..Report::default()
    };
    let _folder = Folder::make(&arguments.output)?;
    let [json, page] = ["chart.json", "chart.html"].map(|name| arguments.output.join(name));
    [&json, &page].into_iter().try_for_each(|file| input::check_output(&scene, &arguments.scene, file))?;
    let known = known::read(&json, head)?;
    for left_out in &known.left_out {
        say(&format!("left out: {}: {}", left_out.name, left_out.reason));
    }

    let progress = Progress::start("charting");
    let hear = |share| progress.set(share);
    let truth = Charted::new(subject, method::truth(), &AdapterChoice::Any)?;
    let mut run = Run::new(&subject, truth, charted, arguments.repeat, known, &hear);
    let mut kept_at = None::<Instant>;
    let mut keep = |report: &Report| {
        // More often than that would cost more than what it saves.
        if kept_at.is_none_or(|kept_at| kept_at.elapsed() >= KEPT_EVERY) {
            write_report(&json, report)?;
            kept_at = Some(Instant::now());
        }
        Ok::<(), Failure>(())
    };
    run.measure_errors(&mut keep)?;
    let pictures = run.draw()?;
    let write_page = |report: &Report| {
        let looks = pictures.looks();
        let text =
            html::write(&html::Page { report, truth: &pictures.truth, looks: &looks, tolerance: arguments.tolerance })
                .map_err(|error| {
                    Failure::could_not(format!("the page can't be packed: {error}"), "try a smaller --size")
                })?;
        Ok::<(), Failure>(storage::write_atomic(&page, text.as_bytes()).map(drop)?)
    };
    write_page(&run.report())?;
    run.measure_costs(&mut keep)?;
    let report = run.report();
    write_report(&json, &report)?;
    write_page(&report)?;
    drop(progress);
    if arguments.json {
        return answer(&visible::json(&json_text(&report)?));
    }
    answer(&in_words(&report, arguments.tolerance))?;
    say(&format!("chart: {}", page.display()));
    Ok(())
}

/// The flight, if there is one, and the camera at its start or of the still.
fn eye<'a>(scene: &'a Scene, arguments: &Arguments) -> Result<(Camera, Option<&'a CameraPath>), Failure> {
    let file = &arguments.scene;
    let path = match (&arguments.camera, &arguments.path) {
        (None, Some(name)) => Some(input::path(scene, file, name)?),
        // A moment is a still's.
        (None, None) if arguments.at.is_some() => None,
        (None, None) => scene.paths.iter().find(|path| path.keys.len() > 1),
        (Some(_), _) => None,
    };
    let camera = match path {
        Some(path) => PathCurve::new(path).camera_at(0.0),
        None => input::camera(scene, file, arguments.camera.as_deref())?.clone(),
    };
    Ok((camera, path))
}

fn json_text(report: &Report) -> Result<String, Failure> {
    report::write(report)
        .map_err(|error| Failure::could_not(format!("the report can't be said: {error}"), "report this"))
}

fn write_report(file: &std::path::Path, report: &Report) -> Result<(), Failure> {
    storage::write_atomic(file, json_text(report)?.as_bytes())?;
    Ok(())
}

/// A line for each method, from cheap to dear, and which one to take.
fn in_words(report: &Report, tolerance: f64) -> String {
    let mut methods: Vec<_> = report.methods.iter().collect();
    let cost = |method: &report::MethodFigures| method.cost.frame_ms.unwrap_or(f64::INFINITY);
    methods.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    let mut out = format!("{:<20}{:>10}{:>12}{:>15}\n", "method", "ms", "FLIP", "excess change");
    for method in methods {
        let excess = method.stability.as_ref().and_then(|stability| stability.excess_mean);
        let [ms, error, excess] = [method.cost.frame_ms, method.error.flip_mean, excess].map(text::figure);
        let front = if method.on_front { "  front" } else { "" };
        let _ = writeln!(out, "{:<20}{ms:>10}{error:>12}{excess:>15}{front}", method.name);
    }
    let cheapest = front::cheapest_within(&report.methods, tolerance);
    let _ = match cheapest {
        Some(method) => writeln!(out, "cheapest within FLIP {tolerance}: {}", method.name),
        None => writeln!(out, "no method keeps within FLIP {tolerance}"),
    };
    out
}
