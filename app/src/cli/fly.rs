//! `cloudwright fly`: the pictures of a flight along a camera path, or of weather from one camera, and a video of them.
//!
//! A frame depends on its number alone, not on what was drawn before it ([`Eye`] makes the view's history in fixed
//! steps). So a run that was broken off goes on where it stopped: frames that are there whole are kept.

mod eye;
mod frames;
mod video;

use super::failure::Failure;
use super::painter::PainterArguments;
use super::progress::Progress;
use super::{arguments, input, say};
use crate::picture_kind::PictureKind;
use crate::rendering::{IN_LAYERS, Said, check_memory, draw};
use crate::units::time_of_day;
use crate::{opening, storage};
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::Sorting;
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::layers::Later;
use cloudwright_core::scene::Camera;
use cloudwright_core::sight::Sight;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;
use eye::Eye;
use frames::Frames;
use std::ops::Range;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright fly fair_weather.cloudscene --path through -o through.mp4
  cloudwright fly fair_weather.cloudscene --path through -o pictures --size 1920x1080
  cloudwright fly fair_weather.cloudscene --path through -o pictures --frames 90..120 --fps 60
  cloudwright fly fair_weather.cloudscene --path through -o smooth.mp4 --samples 4 --sorting crossfade
  cloudwright fly summer_day.cloudscene --still main -o day.mp4
  cloudwright fly summer_day.cloudscene --still main --seconds 10 --fps 24 -o pictures
  cloudwright fly fair_weather.cloudscene --path through -o pictures --format exr --layers

Frame I shows the scene I / FPS seconds after the clock's 0, as PATH_0000I.png or still_CAMERA_0000I.png; in PATH and CAMERA, letters and numbers are the name's. It is the same alone or in a sequence, so several machines may share a flight by --frames. What --layers writes, `cloudwright render --help` tells. From a camera it is what render --at draws: sprites near it face it, whatever it has seen before.
Frames that are there already, whole and of the same size, are kept: a run that was broken off goes on. Empty the folder
when scene or options have changed. A video needs ffmpeg; its frames stay in a folder beside it, OUT_frames.")]
pub(super) struct Arguments {
    /// Scene to fly through
    scene: PathBuf,
    /// Name of the camera path
    #[arg(long, value_name = "NAME", required_unless_present = "still")]
    path: Option<String>,
    /// Name of a camera to film the weather from: it stands still, or goes as its tracks say
    #[arg(long, value_name = "CAMERA", conflicts_with_all = ["path", "sorting"])]
    still: Option<String>,
    /// How long to film from that camera; up to the last key of all tracks if not given
    #[arg(long, value_name = "SECONDS", requires = "still", value_parser = arguments::seconds)]
    seconds: Option<f64>,
    /// Folder to write the frames to, or a video, .mp4
    #[arg(short, long, value_name = "DIR|MP4")]
    output: PathBuf,
    /// Frames to draw, from A up to but without B, or as queues of jobs write it, A-B, with B; all if not given
    #[arg(long, value_name = "A..B|A-B", value_parser = frames::range)]
    frames: Option<Range<u32>>,
    /// Frames a second, 1 to 240
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..=240))]
    fps: u32,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = arguments::picture_size)]
    size: [u32; 2],
    /// What each frame is written as
    #[arg(long, value_enum, default_value_t = PictureKind::Png)]
    format: PictureKind,
    /// Write the layers for compositing too, into OpenEXR files
    #[arg(long)]
    layers: bool,
    #[command(flatten)]
    painter: PainterArguments,
    /// Time of day; the scene's if not given
    #[arg(long, value_name = "HH:MM", value_parser = time_of_day)]
    time: Option<f64>,
    /// When sprites are sorted again, each-frame if not given: a sprite that comes before another pops unless it is faded
    /// over
    #[arg(long, value_enum, conflicts_with_all = ["method", "truth"])]
    sorting: Option<SortingChoice>,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum SortingChoice {
    /// For every frame
    EachFrame,
    /// Every half second, faded over; some 20 % slower
    Crossfade,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let is_video = video::is_name(&arguments.output);
    let kind = arguments.format;
    if is_video && kind != PictureKind::Png {
        let what = format!("--format {}: a video is made of PNG frames", kind.ending());
        return Err(Failure::argument(what, "leave it out, or write the frames to a folder"));
    }
    let painting = if arguments.layers { arguments.painter.in_layers(kind)? } else { arguments.painter.clone() };
    let mut rules = painting.rules()?;
    match arguments.sorting {
        Some(SortingChoice::EachFrame) => rules.sorting = Sorting::EachFrame,
        Some(SortingChoice::Crossfade) => rules.sorting = Sorting::Crossfade,
        None => {}
    }
    check_memory(arguments.size, rules.pixels_a_pixel(), if arguments.layers { IN_LAYERS } else { 1 })?;
    if is_video {
        video::check_size(arguments.size)?;
    }
    let (scene, beside) = opening::open(&arguments.scene)?;
    let mut eye = match (&arguments.path, &arguments.still) {
        (Some(path), _) => Eye::along(input::path(&scene, &arguments.scene, path)?, rules),
        (None, camera) => {
            let camera = input::camera(&scene, &arguments.scene, camera.as_deref())?;
            let asked_s = arguments.frames.as_ref().map(|frames| f64::from(frames.end) / f64::from(arguments.fps));
            Eye::still(camera, (arguments.seconds, asked_s), (&scene, &arguments.scene))?
        }
    };
    let numbers = frames::chosen(arguments.frames.clone(), eye.duration_s(), arguments.fps)?;
    let folder = if is_video { video::frames_folder(&arguments.output) } else { arguments.output.clone() };
    let name = frames::file_name_of(eye.thing(), &scene);
    let frames =
        Frames { folder, name, kind, in_layers: arguments.layers, size: arguments.size, numbers: numbers.clone() };
    let spare = |output: &Path| input::spare_inputs(&scene, &arguments.scene, output);
    frames.there().iter().try_for_each(|frame| spare(frame))?;
    if is_video {
        spare(&frames.folder.join(video::UNFINISHED))?;
        input::check_output(&scene, &arguments.scene, &arguments.output)?;
    }
    let _folder = frames.make_folder()?;

    let derived = Derived::new(&scene);
    let mut painter = painting.painter(rules)?;
    let progress = Progress::start("flying");
    let mut kept = 0;
    for (done, number) in numbers.clone().enumerate() {
        progress.set(done as f32 / numbers.len() as f32);
        if frames.is_whole(number) {
            kept += 1;
            continue;
        }
        let clock_of = |number| f64::from(number) / f64::from(arguments.fps);
        let sight_at = |camera: &Camera, clock_s| Sight {
            moment: Moment { clock_s, time_h: arguments.time },
            meshes: beside.meshes().clone(),
            rules: painter.rules,
            ..Sight::still(camera, arguments.size)
        };
        let (clock_s, next_s) = (clock_of(number), clock_of(number.saturating_add(1)));
        let (camera, history) = eye.at(&derived, clock_s);
        let later =
            arguments.layers.then(|| Later::new(&scene, &derived, &sight_at(&eye.camera_at(&derived, next_s), next_s)));
        let sight = Sight { history, ..sight_at(&camera, clock_s) };
        let frame = Frame::new(&scene, &derived, beside.sheet(), &sight);
        let said = Said { frames_a_second: Some(arguments.fps), ..Said::new(&scene.name, eye.name(), clock_s, &frame) };
        let bytes = draw(kind, &mut painter, (frame, later.as_ref()), &said, &Watch::default())?;
        storage::write_one_of_many(&frames.file(number), &bytes)?;
    }
    drop(progress);
    say(&format!("frames: {} drawn, {kept} kept, in {}", numbers.len() - kept, frames.folder.display()));
    if is_video { video::write(&arguments.output, &frames, arguments.fps) } else { Ok(()) }
}
