//! A video of a flight's frames, made by ffmpeg.
//!
//! ffmpeg works in the folder of the frames; what it made takes the video's name only when it is whole.

use super::frames::Frames;
use crate::cli::failure::Failure;
use crate::storage;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// In the folder of the frames, as long as ffmpeg works.
pub(super) const UNFINISHED: &str = "unfinished.mp4";

/// Whether frames are to become a video.
pub(super) fn is_name(output: &Path) -> bool {
    output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("mp4"))
}

/// Known before the work: a video's colors are stored for two by two pixels.
pub(super) fn check_size([width, height]: [u32; 2]) -> Result<(), Failure> {
    if width % 2 == 0 && height % 2 == 0 {
        return Ok(());
    }
    let what = format!("--size {width}x{height}: a video can't be of odd width or height");
    Err(Failure::argument(what, "use even numbers, or write the frames to a folder"))
}

/// Where the frames of a video lie.
pub(super) fn frames_folder(output: &Path) -> PathBuf {
    let name = output.file_stem().unwrap_or_default().to_string_lossy();
    output.with_file_name(format!("{name}_frames"))
}

/// Makes `output` of frames that are all there.
pub(super) fn write(output: &Path, frames: &Frames, fps: u32) -> Result<(), Failure> {
    let words = ffmpeg_words(&frames.name, &frames.numbers, fps);
    let by_hand = || {
        let name = output.file_name().unwrap_or_default().to_string_lossy();
        let folder = frames.folder.display();
        format!("the frames are in {folder}; run: cd \"{folder}\" && ffmpeg {} \"../{name}\"", words.join(" "))
    };
    let unfinished = frames.folder.join(UNFINISHED);
    let ran = Command::new("ffmpeg")
        .args(["-y", "-loglevel", "error"])
        .args(&words)
        .arg(UNFINISHED)
        .current_dir(&frames.folder)
        .stdin(Stdio::null())
        .output();
    let trouble = match ran {
        Ok(ran) if ran.status.success() => {
            storage::rename(&unfinished, output)?;
            say_done(output);
            return Ok(());
        }
        Ok(ran) => {
            format!("ffmpeg failed: {}", String::from_utf8_lossy(&ran.stderr).trim())
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => "there is no ffmpeg on this machine".into(),
        Err(error) => format!("ffmpeg can't be run: {error}"),
    };
    storage::remove_if_there(&unfinished);
    Err(Failure::could_not(format!("{}: no video: {trouble}", output.display()), by_hand()))
}

fn say_done(output: &Path) {
    crate::cli::say(&format!("video: {}", output.display()));
}

fn ffmpeg_words(name: &str, numbers: &Range<u32>, fps: u32) -> Vec<String> {
    let (first, count) = (numbers.start.to_string(), numbers.len().to_string());
    let (fps, pattern) = (fps.to_string(), format!("{name}_%05d.png"));
    [
        "-framerate",
        &fps,
        "-start_number",
        &first,
        "-i",
        &pattern,
        "-frames:v",
        &count,
        "-pix_fmt",
        "yuv420p",
        "-crf",
        "18",
    ]
    .map(str::to_owned)
    .to_vec()
}
