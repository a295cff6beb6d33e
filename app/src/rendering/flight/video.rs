//! A video of a flight's frames, made by ffmpeg.
//!
//! ffmpeg works in the folder of the frames; what it made takes the video's name only when it is whole.

use super::NoFlight;
use super::frames::Frames;
use crate::rendering::NoPicture;
use crate::storage;
use cloudwright_core::watch::Watch;
use std::io::{self, Read};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::Duration;

/// In the folder of the frames, as long as ffmpeg works.
pub(super) const UNFINISHED: &str = "unfinished.mp4";

/// Of what ffmpeg complains about, so much is told, bytes.
const MAX_COMPLAINT: u64 = 1 << 14;

/// Between two looks at whether ffmpeg is done, or no longer wanted.
const LOOK: Duration = Duration::from_millis(20);

/// Whether frames are to become a video.
pub(crate) fn is_video(output: &Path) -> bool {
    output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("mp4"))
}

/// Known before the work: a video's colors are stored for two by two pixels.
pub(crate) fn check_size([width, height]: [u32; 2]) -> Result<(), NoFlight> {
    if width % 2 == 0 && height % 2 == 0 { Ok(()) } else { Err(NoFlight::OddSize(width, height)) }
}

/// Where the frames of a video lie.
pub(super) fn frames_folder(output: &Path) -> PathBuf {
    let name = output.file_stem().unwrap_or_default().to_string_lossy();
    output.with_file_name(format!("{name}_frames"))
}

/// Makes `output` of frames that are all there.
pub(super) fn write(output: &Path, frames: &Frames, fps: u32, watch: &Watch) -> Result<(), NoFlight> {
    let words = ffmpeg_words(&frames.name, &frames.numbers, fps);
    let unfinished = frames.folder.join(UNFINISHED);
    let ran = Command::new("ffmpeg")
        .args(["-y", "-loglevel", "error"])
        .args(&words)
        .arg(UNFINISHED)
        .current_dir(&frames.folder)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .and_then(|ffmpeg| wait(ffmpeg, watch));
    let trouble = match ran {
        Ok((status, _)) if status.success() => return Ok(storage::rename(&unfinished, output)?),
        _ if watch.is_cancelled() => {
            storage::remove_if_there(&unfinished);
            return Err(NoPicture::Stopped.into());
        }
        Ok((_, said)) => format!("ffmpeg failed: {}", said.trim()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => "there is no ffmpeg on this machine".into(),
        Err(error) => format!("ffmpeg can't be run: {error}"),
    };
    storage::remove_if_there(&unfinished);
    let (name, folder) = (output.file_name().unwrap_or_default().to_string_lossy(), frames.folder.display());
    let words = words.join(" ");
    let by_hand = format!("the frames are in {folder}; run: cd \"{folder}\" && ffmpeg {words} \"../{name}\"");
    Err(NoFlight::NoVideo { output: output.into(), trouble, by_hand })
}

/// How it ended, and what it complained about. It is ended when it is no longer wanted.
fn wait(mut ffmpeg: Child, watch: &Watch) -> io::Result<(ExitStatus, String)> {
    let mut complaints = ffmpeg.stderr.take();
    // Read all along: who complains much would else wait for a reader.
    let said = std::thread::spawn(move || {
        let mut said = Vec::new();
        if let Some(complaints) = &mut complaints {
            let _ = complaints.by_ref().take(MAX_COMPLAINT).read_to_end(&mut said);
            let _ = io::copy(complaints, &mut io::sink());
        }
        String::from_utf8_lossy(&said).into_owned()
    });
    let status = loop {
        if let Some(status) = ffmpeg.try_wait()? {
            break status;
        }
        if watch.is_cancelled() {
            ffmpeg.kill()?;
            return Ok((ffmpeg.wait()?, String::new()));
        }
        std::thread::sleep(LOOK);
    };
    Ok((status, said.join().unwrap_or_default()))
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
