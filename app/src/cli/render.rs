//! `cloudwright render`: a picture of a scene, without a window.

use super::failure::Failure;
use super::painter::{Painter, PainterArguments};
use super::progress::Progress;
use super::{arguments, counted, input};
use crate::units::time_of_day;
use crate::{opening, picture_png, storage};
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::sight::Sight;
use cloudwright_core::weather::Moment;
use std::path::PathBuf;

/// Samples of one picture held in memory at once: 4K with 16 samples a pixel fits, some 4 GB at the most.
const MAX_SAMPLES: u64 = 1 << 27;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright render fair_weather.cloudscene -o sky.png
  cloudwright render storm.cloudscene -o storm.png --camera cockpit --time 18:30 --size 1920x1080
  cloudwright render storm.cloudscene -o smooth.png --samples 4 --renderer cpu
  cloudwright render storm.cloudscene -o truth.png --truth --samples 64
  cloudwright render storm.cloudscene -o half.png --method half
  cloudwright render summer_day.cloudscene -o evening.png --at 45")]
pub(super) struct Arguments {
    /// Scene to draw
    scene: PathBuf,
    /// PNG to write
    #[arg(short, long, value_name = "PNG")]
    output: PathBuf,
    /// Name of the camera; the scene's first if not given
    #[arg(long, value_name = "NAME")]
    camera: Option<String>,
    /// Time of day; the scene's if not given
    #[arg(long, value_name = "HH:MM", value_parser = time_of_day)]
    time: Option<f64>,
    /// Seconds of the scene's clock: what its tracks and the wind have moved by then, how far clouds have formed, and
    /// where aircraft are
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = arguments::seconds)]
    at: f64,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = arguments::picture_size)]
    size: [u32; 2],
    #[command(flatten)]
    painter: PainterArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    check_output_name(arguments)?;
    let rules = arguments.painter.rules()?;
    let (scene, beside) = opening::open(&arguments.scene)?;
    let camera = input::camera(&scene, &arguments.scene, arguments.camera.as_deref())?;
    input::check_output(&scene, &arguments.scene, &arguments.output)?;
    check_memory(arguments.size, rules.pixels_a_pixel())?;
    let derived = Derived::new(&scene);
    let mut painter = Painter::new(&arguments.painter, rules)?;
    let sight = Sight {
        moment: Moment { clock_s: arguments.at, time_h: arguments.time },
        meshes: beside.meshes().clone(),
        rules: painter.rules,
        ..Sight::still(&derived.timeline().camera_at(camera, arguments.at), arguments.size)
    };
    let progress = Progress::start("rendering");
    let frame = Frame::new(&scene, &derived, beside.sheet(), &sight);
    let picture = painter.picture(frame, progress.watch())?;
    drop(progress);
    let png = picture_png::encode(&picture)
        .map_err(|error| Failure::could_not(format!("the picture can't be packed: {error}"), "try a smaller --size"))?;
    storage::write_atomic(&arguments.output, &png)?;
    Ok(())
}

fn check_output_name(arguments: &Arguments) -> Result<(), Failure> {
    let output = &arguments.output;
    if output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png")) {
        return Ok(());
    }
    Err(Failure::argument(
        format!("--output {}: a picture is written as PNG", output.display()),
        "end its name in .png",
    ))
}

/// That the samples of one picture fit into memory.
pub(super) fn check_memory([width, height]: [u32; 2], side: u32) -> Result<(), Failure> {
    let samples = u64::from(width) * u64::from(height) * u64::from(side * side);
    if samples <= MAX_SAMPLES {
        return Ok(());
    }
    Err(Failure::argument(
        format!(
            "--size {width}x{height} with {} a pixel is {} million samples",
            counted((side * side) as usize, "sample", "samples"),
            samples / 1_000_000
        ),
        format!("stay within {} million: lower --size or --samples", MAX_SAMPLES / 1_000_000),
    ))
}
