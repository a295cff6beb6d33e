//! `cloudwright render`: a picture of a scene, without a window.

mod panorama;

use super::failure::Failure;
use super::painter::{self, PainterArguments};
use super::progress::Progress;
use super::{arguments, input};
use crate::rendering::{IN_LAYERS, Still, StillEye, check_memory};
use crate::units::time_of_day;
use crate::{opening, storage};
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::Hidden;
use cloudwright_core::weather::Moment;
use panorama::Projection;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright render fair_weather.cloudscene -o sky.png
  cloudwright render storm.cloudscene -o storm.png --camera cockpit --time 18:30 --size 1920x1080
  cloudwright render storm.cloudscene -o smooth.png --samples 4 --renderer cpu
  cloudwright render storm.cloudscene -o truth.png --truth --samples 64
  cloudwright render storm.cloudscene -o half.png --method half
  cloudwright render summer_day.cloudscene -o evening.png --at 45
  cloudwright render storm.cloudscene -o storm.exr --layers
  cloudwright render storm.cloudscene -o sky.hdr --panorama equirect --size 4096x2048
  cloudwright render storm.cloudscene -o sky.png --panorama cube --size 1024x1024

An OpenEXR or HDR file holds linear light before exposure and tone curve. With --layers an OpenEXR file has, beside the picture in R, G, B: ambient, directional and haze (on the clouds, premultiplied), alpha, depth.Z (mean distance of the clouds, metres), motion.X and .Y (their mean motion in pixels a frame, to the right and up; in a still within 1/24 s), sky, ground and models (aircraft and props; .A is the share of the pixel that they fill). It is picture = ambient + directional + haze + (1 - alpha) * (sky + ground + models).

A panorama goes by the world's axes. The equirect map has south (+z) in its middle, east (+x) a quarter to the left and straight up at its top, as OpenEXR's maps of latitude and longitude. Each side of the cube is what a camera of 90 degrees sees, not mirrored: heading 90 for east, 0 for north; up has south at its top, down north.")]
pub(super) struct Arguments {
    /// Scene to draw
    scene: PathBuf,
    /// PNG, OpenEXR or Radiance HDR to write, by its ending
    #[arg(short, long, value_name = "PNG|EXR|HDR")]
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
    /// Width and height in pixels; if not given, 1280x720, or 2048x1024 of a map, or 1024x1024 of each side of a cube
    #[arg(long, value_name = "WxH", value_parser = arguments::picture_size)]
    size: Option<[u32; 2]>,
    /// All around the camera's place, whichever way it looks
    #[arg(long, value_enum, value_name = "PROJECTION", conflicts_with = "layers")]
    panorama: Option<Projection>,
    /// Write the layers for compositing too, into an OpenEXR file
    #[arg(long)]
    layers: bool,
    #[command(flatten)]
    painter: PainterArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(projection) = arguments.panorama {
        return panorama::run(arguments, projection);
    }
    let size = arguments.size.unwrap_or([1280, 720]);
    let kind = painter::kind_of(&arguments.output)?;
    let painting = if arguments.layers { arguments.painter.in_layers(kind)? } else { arguments.painter.clone() };
    let rules = painting.rules()?;
    let (scene, beside) = opening::open(&arguments.scene)?;
    let camera = input::camera(&scene, &arguments.scene, arguments.camera.as_deref())?;
    input::check_output(&scene, &arguments.scene, &arguments.output)?;
    check_memory(size, rules.pixels_a_pixel(), if arguments.layers { IN_LAYERS } else { 1 })?;
    let derived = Derived::new(&scene);
    let mut painter = painting.painter(rules)?;
    let moment = Moment { clock_s: arguments.at, time_h: arguments.time };
    let eye = StillEye::Saved(camera);
    let hidden = &Hidden::default();
    let still = Still { scene: &scene, derived: &derived, beside: &beside, eye, moment, size, hidden };
    let progress = Progress::start("rendering");
    let bytes = still.file(&mut painter, kind, arguments.layers, progress.watch())?;
    drop(progress);
    storage::write_atomic(&arguments.output, &bytes)?;
    Ok(())
}
