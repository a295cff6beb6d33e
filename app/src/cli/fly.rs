//! `cloudwright fly`: the pictures of a flight along a camera path, or of weather from one camera, and a video of them.

use super::failure::Failure;
use super::painter::PainterArguments;
use super::progress::Progress;
use super::{arguments, input, say};
use crate::opening;
use crate::picture_kind::PictureKind;
use crate::rendering::{self, Eye, Film, Flight, IN_LAYERS, check_memory, check_size, is_video, last_key_s};
use crate::storage::{FilmSettings, There};
use crate::units::time_of_day;
use cloudwright_core::draw_list::Sorting;
use std::ops::Range;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright fly fair_weather.cloudscene --path through -o through.mp4
  cloudwright fly fair_weather.cloudscene --path through -o pictures --size 1920x1080
  cloudwright fly fair_weather.cloudscene --path through -o pictures --frames 90..120 --fps 60
  cloudwright fly fair_weather.cloudscene --path through -o smooth.mp4 --samples 4 --sorting crossfade
  cloudwright fly summer_day.cloudscene --still main -o day.mp4
  cloudwright fly summer_day.cloudscene --still main --seconds 10 --fps 24 -o pictures
  cloudwright fly fair_weather.cloudscene --path through -o pictures --format exr --layers
  cloudwright fly fair_weather.cloudscene --path through -o through.mp4 --anew

Frame I shows the scene I / FPS seconds after the clock's 0, as PATH_0000I.png or still_CAMERA_0000I.png; in PATH and CAMERA, letters and numbers are the name's. It is the same alone or in a sequence, so several machines may share a flight by --frames. What --layers writes, `cloudwright render --help` tells. From a camera it is what render --at draws: sprites near it face it, whatever it has seen before.
Frames that are there already, whole and of the same size, are kept: a run that was broken off goes on. Say --anew when
scene or options have changed. A video needs ffmpeg; its frames stay in a folder beside it, OUT_frames.")]
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
    #[arg(long, value_name = "A..B|A-B", value_parser = rendering::range)]
    frames: Option<Range<u32>>,
    /// Frames a second, 1 to 240
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..=i64::from(FilmSettings::MAX_FRAMES_A_SECOND)))]
    fps: u32,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = arguments::picture_size)]
    size: [u32; 2],
    /// Draw frames anew that are there already
    #[arg(long)]
    anew: bool,
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
    let is_video = is_video(&arguments.output);
    let kind = arguments.format;
    if is_video && kind != PictureKind::Png {
        let what = format!("--format {}: a video is made of PNG frames", kind.ending());
        return Err(Failure::argument(what, "leave it out, or write the frames to a folder"));
    }
    let painting = if arguments.layers { arguments.painter.in_layers(kind)? } else { arguments.painter.clone() };
    let mut rules = painting.rules()?;
    match arguments.sorting {
        Some(SortingChoice::EachFrame) => rules = rules.sorted(Sorting::EachFrame),
        Some(SortingChoice::Crossfade) => rules = rules.sorted(Sorting::Crossfade),
        None => {}
    }
    check_memory(arguments.size, rules.pixels_a_pixel(), if arguments.layers { IN_LAYERS } else { 1 })?;
    if is_video {
        check_size(arguments.size)?;
    }
    let (scene, beside) = opening::open(&arguments.scene)?;
    let eye = match (&arguments.path, &arguments.still) {
        (Some(path), _) => Eye::along(input::path(&scene, &arguments.scene, path)?, rules),
        (None, camera) => {
            let camera = input::camera(&scene, &arguments.scene, camera.as_deref())?;
            let asked_s = arguments.frames.as_ref().map(|frames| f64::from(frames.end) / f64::from(arguments.fps));
            // Where nothing moves, a film lasts as long as the frames that are asked for.
            let Some(seconds) = arguments.seconds.or_else(|| last_key_s(&scene)).or(asked_s) else {
                let what = format!("{}: tracks: none has a key after second 0", arguments.scene.display());
                return Err(Failure::argument(what, "say how long to film: --seconds 20"));
            };
            Eye::Still(camera, seconds)
        }
    };
    let film = Film {
        output: arguments.output.clone(),
        kind,
        in_layers: arguments.layers,
        size: arguments.size,
        fps: arguments.fps,
        asked: arguments.frames.clone(),
        time_h: arguments.time,
        there: if arguments.anew { There::Replace } else { There::Keep },
    };
    let progress = Progress::start("flying");
    let flight = Flight { scene: &scene, beside: &beside, file: Some(&arguments.scene), eye };
    let filmed = flight.film(&film, || Ok(painting.painter(rules)?), progress.watch())?;
    drop(progress);
    say(&format!("frames: {} drawn, {} kept, in {}", filmed.drawn, filmed.kept, filmed.folder.display()));
    if is_video {
        say(&format!("video: {}", arguments.output.display()));
    }
    Ok(())
}
