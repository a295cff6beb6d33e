//! `cloudwright render`: a picture of a scene, without a window.

use super::failure::Failure;
use super::painter::{self, Painter};
use super::progress::Progress;
use super::{arguments, input, say};
use crate::renderer::RendererChoice;
use crate::units::time_of_day;
use crate::{opening, picture_png, storage};
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::Hidden;
use cloudwright_core::frame::{Frame, Sight};
use cloudwright_core::image::Picture;
use cloudwright_core::raster;
use cloudwright_core::view_history::ViewHistory;
use std::path::PathBuf;

/// Samples of one picture held in memory at once: 4K with 16 samples a pixel fits, some 4 GB at the most.
const MAX_SAMPLES: u64 = 1 << 27;
/// Without `--samples`, the truth has 4 × 4.
const TRUTH_SIDE: u32 = 4;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright render fair_weather.cloudscene -o sky.png
  cloudwright render storm.cloudscene -o storm.png --camera cockpit --time 18:30 --size 1920x1080
  cloudwright render storm.cloudscene -o smooth.png --samples 4 --renderer cpu
  cloudwright render storm.cloudscene -o truth.png --truth --samples 64")]
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
    /// Seconds of the scene's clock: how far clouds have formed, and where aircraft are
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = arguments::seconds)]
    at: f64,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = arguments::picture_size)]
    size: [u32; 2],
    /// What draws
    #[arg(long, value_enum, default_value_t)]
    renderer: RendererChoice,
    /// Order the fragments of every ray by their own depth: slow, what errors are measured against (on the CPU)
    #[arg(long)]
    truth: bool,
    /// Samples a pixel, a square number up to 64; 1 if not given, 16 for --truth
    #[arg(long = "samples", value_name = "N", value_parser = arguments::samples_side)]
    side: Option<u32>,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    check_output_name(arguments)?;
    if arguments.truth && arguments.renderer == RendererChoice::Gpu {
        return Err(Failure::argument("--truth runs on the CPU", "leave --renderer gpu or --truth out"));
    }
    let (scene, beside) = opening::open(&arguments.scene)?;
    let camera = input::camera(&scene, &arguments.scene, arguments.camera.as_deref())?;
    input::check_output(&arguments.scene, &arguments.output)?;
    let time_h = arguments.time.unwrap_or(scene.time_of_day_h);
    let derived = Derived::new(&scene);
    let (hidden, history) = (&Hidden::default(), &ViewHistory::default());
    let frame = |size| {
        let sight = Sight { camera, time_h, clock_s: arguments.at, size, hidden, meshes: beside.meshes(), history };
        Frame::of(&scene, &derived, beside.sheet(), &sight)
    };
    let picture = if arguments.truth { truth(arguments, frame)? } else { fast(arguments, frame)? };
    let png = picture_png::encode(&picture)
        .map_err(|error| Failure::could_not(format!("the picture can't be packed: {error}"), "try a smaller --size"))?;
    storage::write_atomic(&arguments.output, &png)?;
    Ok(())
}

fn fast<'a>(arguments: &Arguments, frame: impl Fn([u32; 2]) -> Frame<'a>) -> Result<Picture, Failure> {
    let side = arguments.side.unwrap_or(1);
    check_memory(arguments.size, side)?;
    let mut painter = Painter::new(arguments.renderer)?;
    let _progress = Progress::start("rendering");
    Ok(painter.picture(&frame(arguments.size.map(|length| length * side)), side)?)
}

fn truth<'a>(arguments: &Arguments, frame: impl Fn([u32; 2]) -> Frame<'a>) -> Result<Picture, Failure> {
    let side = arguments.side.unwrap_or(TRUTH_SIDE);
    check_memory(arguments.size, 1)?;
    say(&format!("renderer: CPU, truth with {} samples a pixel", side * side));
    let frame = frame(arguments.size);
    painter::tell_what_is_left_out(&frame);
    let progress = Progress::start("rendering the truth");
    let linear = raster::truth::linear_picture(&frame, side, progress.watch());
    Ok(raster::develop(&linear, frame.exposure))
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
            "--size {width}x{height} with {} samples a pixel is {} million samples",
            side * side,
            samples / 1_000_000
        ),
        format!("stay within {} million: lower --size or --samples", MAX_SAMPLES / 1_000_000),
    ))
}
