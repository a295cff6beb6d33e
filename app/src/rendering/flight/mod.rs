//! The pictures of a flight along a camera path, or of weather from one camera, and a video of them.
//!
//! A frame depends on its number alone, not on what was drawn before it ([`Eye`] makes the view's history in fixed
//! steps). So a run that was broken off can go on where it stopped: frames that are there whole may be kept.

mod eye;
mod frames;
mod video;

pub(crate) use eye::{Eye, last_key_s};
pub(crate) use frames::{count, range};
pub(crate) use video::{check_size, is_video};

use super::{NoPicture, Painter, Said, draw};
use crate::opening::Beside;
use crate::picture_kind::PictureKind;
use crate::saving::{SaveError, check_unused};
use crate::storage::{self, StorageError, There};
use crate::units::counted;
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Change;
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::layers::Later;
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;
use frames::Frames;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Why there is no film, or not all of it. What was drawn of it stays.
#[derive(Debug, thiserror::Error)]
pub(crate) enum NoFlight {
    #[error(transparent)]
    Picture(#[from] NoPicture),
    #[error(transparent)]
    Storage(#[from] StorageError),
    #[error(transparent)]
    Save(#[from] SaveError),
    /// Too many frames for their numbers.
    #[error("there are {0} frames (film fewer a second, or for a shorter time)")]
    TooMany(f64),
    /// Beyond the film's end.
    #[error("of {count} frames, those from {} up to {} are not all there", asked.start, asked.end)]
    NotAll { asked: Range<u32>, count: u32 },
    /// Whose path or camera is gone.
    #[error("the path or camera is no longer there")]
    NoEye,
    /// Of a video.
    #[error("{0} × {1} pixels: a video can't be of odd width or height (use even numbers)")]
    OddSize(u32, u32),
    /// Frames, and where, when they may be neither kept nor lost.
    #[error("{0} in {folder} already (choose to keep them or to draw them anew)", folder = .1.display())]
    Taken(String, PathBuf),
    /// The frames are there, but no video of them.
    #[error("{}: no video: {trouble} ({by_hand})", output.display())]
    NoVideo { output: PathBuf, trouble: String, by_hand: String },
}

/// What a flight is drawn into, and how.
#[derive(Debug, Clone)]
pub(crate) struct Film {
    /// A folder for the frames, or a video, .mp4.
    pub(crate) output: PathBuf,
    /// Of each frame; a video's is PNG.
    pub(crate) kind: PictureKind,
    pub(crate) in_layers: bool,
    /// Width and height, pixels.
    pub(crate) size: [u32; 2],
    /// Frames a second.
    pub(crate) fps: u32,
    /// Which frames, if not all.
    pub(crate) asked: Option<Range<u32>>,
    /// The time of day in hours, if not the scene's.
    pub(crate) time_h: Option<f64>,
    /// What becomes of frames that lie there.
    pub(crate) there: There,
}

/// What has been filmed.
#[derive(Debug)]
pub(crate) struct Filmed {
    pub(crate) drawn: usize,
    pub(crate) kept: usize,
    /// Where the frames are.
    pub(crate) folder: PathBuf,
}

/// Who looks at what.
pub(crate) struct Flight<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) beside: &'a Beside,
    /// The scene's file, if it has one: it is not drawn over.
    pub(crate) file: Option<&'a Path>,
    pub(crate) eye: Eye<'a>,
}

impl Flight<'_> {
    /// Draws the film; what makes the renderer is asked for it once all is known to be in order. Looks at `watch` between
    /// frames, and tells it how far it is.
    ///
    /// # Errors
    /// If it can't be drawn or written, if frames are in the way, and if `watch` was cancelled; frames that were drawn
    /// by then stay.
    pub(crate) fn film<'t>(
        mut self,
        film: &Film,
        painter: impl FnOnce() -> Result<Painter<'t>, NoPicture>,
        watch: &Watch,
    ) -> Result<Filmed, NoFlight> {
        let video = is_video(&film.output).then_some(film.output.as_path());
        let count = count(self.eye.duration_s(), film.fps)?;
        let numbers = match film.asked.clone() {
            Some(asked) if asked.end > count => return Err(NoFlight::NotAll { asked, count }),
            Some(asked) => asked,
            None => 0..count,
        };
        let frames = Frames {
            folder: video.map_or_else(|| film.output.clone(), video::frames_folder),
            name: frames::file_name_of(self.eye.thing(), self.scene),
            kind: film.kind,
            in_layers: film.in_layers,
            size: film.size,
            numbers: numbers.clone(),
        };
        let spare = |output: &Path| check_unused(self.scene, self.file, output);
        let there = frames.there();
        there.iter().try_for_each(|frame| spare(frame))?;
        if film.there == There::Refuse && !there.is_empty() {
            let words = counted(there.len(), "frame of this name is", "frames of these names are");
            return Err(NoFlight::Taken(words, frames.folder));
        }
        if let Some(video) = video {
            spare(&frames.folder.join(video::UNFINISHED))?;
            spare(video)?;
            storage::check_writable(video)?;
        }
        let folder = frames.make_folder()?;
        // Progress is the film's; what a part tells goes nowhere.
        let of_part = || Watch::cancelled_by(watch.cancelled());
        let plan = Derived::default();
        let plan = plan.plan(self.scene, &Change::everything());
        let derived = plan.carry_out(&of_part()).ok_or(NoPicture::Stopped)?;
        let mut painter = painter()?;
        let mut kept = 0;
        for (done, number) in numbers.clone().enumerate() {
            watch.reach(done as f32 / numbers.len() as f32);
            if film.there == There::Keep && frames.is_whole(number) {
                kept += 1;
                continue;
            }
            let bytes = self.frame(number, film, &derived, &mut painter, watch)?;
            storage::write_one_of_many(&frames.file(number), &bytes)?;
        }
        drop(folder);
        if let Some(video) = video {
            video::write(video, &frames, film.fps, watch)?;
        }
        Ok(Filmed { drawn: numbers.len() - kept, kept, folder: frames.folder })
    }

    /// The file of one frame.
    fn frame(
        &mut self,
        number: u32,
        film: &Film,
        derived: &Derived,
        painter: &mut Painter<'_>,
        watch: &Watch,
    ) -> Result<Vec<u8>, NoPicture> {
        let rules = painter.rules;
        let clock_of = |number| f64::from(number) / f64::from(film.fps);
        let meshes = self.beside.meshes();
        let sight_at = |camera: &Camera, clock_s| Sight {
            moment: Moment { clock_s, time_h: film.time_h },
            meshes: meshes.clone(),
            rules,
            ..Sight::still(camera, film.size)
        };
        let (clock_s, next_s) = (clock_of(number), clock_of(number.saturating_add(1)));
        let (camera, history) = self.eye.at(derived, clock_s);
        let next = || sight_at(&self.eye.camera_at(derived, next_s), next_s);
        let later = film.in_layers.then(|| Later::new(self.scene, derived, &next()));
        let sight = Sight { history, ..sight_at(&camera, clock_s) };
        let frame = Frame::new(self.scene, derived, self.beside.sheet(), &sight);
        let said = Said::new(&self.scene.name, self.eye.name(), clock_s, &frame);
        let said = Said { frames_a_second: Some(film.fps), ..said };
        // Progress is the whole film's; what a frame's own drawing tells goes nowhere.
        let of_frame = Watch::cancelled_by(watch.cancelled());
        let bytes = draw(film.kind, painter, (frame, later.as_ref()), &said, &of_frame)?;
        if watch.is_cancelled() { Err(NoPicture::Stopped) } else { Ok(bytes) }
    }
}
