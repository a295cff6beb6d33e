//! `cloudwright fly`: the pictures of a flight along a camera path, and a video of them.
//!
//! A frame depends on its number alone, not on what was drawn before it ([`Playback`] makes the view's history in fixed
//! steps). So a run that was broken off goes on where it stopped: frames that are there whole are kept.

mod frames;
mod video;

use super::failure::Failure;
use super::painter::Painter;
use super::progress::Progress;
use super::{arguments, input, render, say};
use crate::renderer::RendererChoice;
use crate::units::time_of_day;
use crate::{opening, picture_png, storage};
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::{Hidden, Sorting};
use cloudwright_core::facing::FacingRule;
use cloudwright_core::flight::Playback;
use cloudwright_core::frame::{Frame, Sight};
use frames::Frames;
use std::ops::Range;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright fly fair_weather.cloudscene --path through -o through.mp4
  cloudwright fly fair_weather.cloudscene --path through -o pictures --size 1920x1080
  cloudwright fly fair_weather.cloudscene --path through -o pictures --frames 90..120 --fps 60
  cloudwright fly fair_weather.cloudscene --path through -o smooth.mp4 --samples 4 --sorting crossfade

Frame I shows the flight I / FPS seconds after its start, as PATH_0000I.png. It is the same alone or in a sequence.
Frames that are there already, whole and of the same size, are kept: a run that was broken off goes on. Empty the folder
when scene or options have changed. A video needs ffmpeg; its frames stay in a folder beside it, OUT_frames.")]
pub(super) struct Arguments {
    /// Scene to fly through
    scene: PathBuf,
    /// Name of the camera path
    #[arg(long, value_name = "NAME")]
    path: String,
    /// Folder to write the frames to, or a video, .mp4
    #[arg(short, long, value_name = "DIR|MP4")]
    output: PathBuf,
    /// Frames to draw, from A up to but without B; all if not given
    #[arg(long, value_name = "A..B", value_parser = frames::range)]
    frames: Option<Range<u32>>,
    /// Frames a second, 1 to 240
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..=240))]
    fps: u32,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = arguments::picture_size)]
    size: [u32; 2],
    /// What draws
    #[arg(long, value_enum, default_value_t)]
    renderer: RendererChoice,
    /// Time of day; the scene's if not given
    #[arg(long, value_name = "HH:MM", value_parser = time_of_day)]
    time: Option<f64>,
    /// Samples a pixel, a square number up to 64
    #[arg(long = "samples", value_name = "N", default_value = "1", value_parser = arguments::samples_side)]
    side: u32,
    /// When sprites are sorted again: a sprite that comes before another pops unless it is faded over
    #[arg(long, value_enum, default_value_t)]
    sorting: SortingChoice,
}

#[derive(Debug, Clone, Copy, Default, clap::ValueEnum)]
enum SortingChoice {
    /// For every frame
    #[default]
    EachFrame,
    /// Every half second, faded over; some 20 % slower
    Crossfade,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let is_video = video::is_name(&arguments.output);
    render::check_memory(arguments.size, arguments.side)?;
    if is_video {
        video::check_size(arguments.size)?;
    }
    let (scene, beside) = opening::open(&arguments.scene)?;
    let path = input::path(&scene, &arguments.scene, &arguments.path)?;
    let sorting = match arguments.sorting {
        SortingChoice::EachFrame => Sorting::EachFrame,
        SortingChoice::Crossfade => Sorting::Crossfade,
    };
    let mut playback = Playback::new(path, FacingRule::default(), sorting);
    let numbers = frames::chosen(arguments.frames.clone(), playback.duration_s(), arguments.fps)?;
    let folder = if is_video { video::frames_folder(&arguments.output) } else { arguments.output.clone() };
    let frames = Frames { folder, path_name: frames::file_name_of(&path.name), size: arguments.size };
    if is_video {
        input::check_output(&arguments.scene, &arguments.output)?;
    }
    frames.make_folder(numbers.start)?;

    let derived = Derived::new(&scene);
    let time_h = arguments.time.unwrap_or(scene.time_of_day_h);
    let mut painter = Painter::new(arguments.renderer)?;
    let size = arguments.size.map(|length| length * arguments.side);
    let progress = Progress::start("flying");
    let mut kept = 0;
    for (done, number) in numbers.clone().enumerate() {
        progress.set(done as f32 / numbers.len() as f32);
        if frames.is_whole(number) {
            kept += 1;
            continue;
        }
        let clock_s = f64::from(number) / f64::from(arguments.fps);
        let (camera, history) = playback.seek(&derived, clock_s);
        let (camera, hidden) = (&camera, &Hidden::default());
        let meshes = beside.meshes();
        let sight = Sight { camera, time_h, clock_s, size, hidden, meshes, history };
        let picture = painter.picture(&Frame::of(&scene, &derived, beside.sheet(), &sight), arguments.side)?;
        let png = picture_png::encode(&picture).map_err(|error| {
            Failure::could_not(format!("frame {number} can't be packed: {error}"), "try a smaller --size")
        })?;
        storage::write_one_of_many(&frames.file(number), &png)?;
    }
    drop(progress);
    say(&format!("frames: {} drawn, {kept} kept, in {}", numbers.len() - kept, frames.folder.display()));
    if is_video { video::write(&arguments.output, &frames, &numbers, arguments.fps) } else { Ok(()) }
}
