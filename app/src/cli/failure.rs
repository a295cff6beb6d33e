//! What ends a subcommand early, and with which exit code.

use crate::opening::{self, OpenError};
use crate::renderer::RenderError;
use crate::rendering::{NoFlight, NoPicture, TooManySamples};
use crate::saving::SaveError;
use crate::storage::StorageError;
use crate::units::counted;

/// `check` found something.
pub(super) const PROBLEMS_FOUND: u8 = 1;
/// A file or an argument can't be used.
pub(super) const UNUSABLE_INPUT: u8 = 2;
/// Input is fine, but there is no place to write, no adapter, no display.
pub(super) const COULD_NOT: u8 = 3;

#[derive(Debug, thiserror::Error)]
pub(super) enum Failure {
    #[error(transparent)]
    Open(#[from] OpenError),
    #[error(transparent)]
    Storage(#[from] StorageError),
    #[error(transparent)]
    Render(#[from] RenderError),
    /// An argument that doesn't fit the scene.
    #[error("{what} ({hint})")]
    Argument { what: String, hint: String },
    #[error("{what} ({hint})")]
    CouldNot { what: String, hint: String },
    #[error("the answer can't be written: {0} (send it to a file on a disk with space)")]
    Stdout(std::io::Error),
    /// All has been said already.
    #[error("")]
    Told(u8),
}

impl Failure {
    pub(super) fn argument(what: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::Argument { what: what.into(), hint: hint.into() }
    }

    pub(super) fn could_not(what: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::CouldNot { what: what.into(), hint: hint.into() }
    }

    /// What to tell, a line each; nothing if all has been said already.
    pub(super) fn lines(&self) -> Vec<String> {
        match self {
            Self::Open(OpenError::Problems { path, problems }) => opening::problem_lines(path, problems),
            Self::Told(_) => Vec::new(),
            _ => vec![self.to_string()],
        }
    }

    /// The user ended it.
    pub(super) fn stopped() -> Self {
        Self::could_not("stopped", "nothing is written")
    }

    pub(super) fn exit_code(&self) -> u8 {
        match self {
            Self::Open(_) | Self::Argument { .. } | Self::Storage(StorageError::Read { .. }) => UNUSABLE_INPUT,
            Self::Storage(StorageError::Write { .. } | StorageError::InTheWay { .. })
            | Self::Render(_)
            | Self::CouldNot { .. }
            | Self::Stdout(_) => COULD_NOT,
            Self::Told(code) => *code,
        }
    }
}

impl From<TooManySamples> for Failure {
    fn from(TooManySamples { width, height, each, millions, most }: TooManySamples) -> Self {
        let each = counted(each as usize, "sample", "samples");
        Self::argument(
            format!("--size {width}x{height} with {each} a pixel is {millions} million samples"),
            format!("stay within {most} million: lower --size or --samples"),
        )
    }
}

impl From<NoPicture> for Failure {
    fn from(error: NoPicture) -> Self {
        match error {
            NoPicture::Render(error) => error.into(),
            NoPicture::TooManySamples(error) => error.into(),
            NoPicture::TooLarge(why) => {
                Self::could_not(format!("the picture can't be packed: {why}"), "try a smaller --size")
            }
            NoPicture::NoLayers => Self::could_not(error.to_string(), "report this"),
            NoPicture::Stopped => Self::stopped(),
        }
    }
}

impl From<SaveError> for Failure {
    fn from(error: SaveError) -> Self {
        match error {
            SaveError::Storage(error @ StorageError::InTheWay { .. }) => {
                Self::argument(error.to_string(), "choose another name, or --force")
            }
            SaveError::Storage(error) => error.into(),
            SaveError::Text(_) => Self::could_not(error.to_string(), "report this"),
            SaveError::Another { .. } => Self::argument(error.to_string(), "choose another folder"),
            SaveError::InUse { .. } | SaveError::NoScene { .. } => {
                Self::argument(error.to_string(), "choose another name")
            }
        }
    }
}

impl From<NoFlight> for Failure {
    fn from(error: NoFlight) -> Self {
        match error {
            NoFlight::Picture(error) => error.into(),
            NoFlight::Storage(error) => error.into(),
            NoFlight::Save(SaveError::InUse { path, what }) => {
                let what = format!("--output {}: that is {what}", path.display());
                Self::argument(what, "choose another name; it would be lost")
            }
            NoFlight::Save(error) => error.into(),
            NoFlight::TooMany(frames) => {
                Self::argument(format!("there are {frames} frames"), "lower --fps, or shorten the path or --seconds")
            }
            NoFlight::NotAll { asked, count } => {
                let (is, frames) = (if count == 1 { "is" } else { "are" }, counted(count as usize, "frame", "frames"));
                let what = format!("--frames {}..{}: at this --fps there {is} {frames}", asked.start, asked.end);
                Self::argument(what, format!("stay within 0..{count}"))
            }
            NoFlight::OddSize(width, height) => {
                let what = format!("--size {width}x{height}: a video can't be of odd width or height");
                Self::argument(what, "use even numbers, or write the frames to a folder")
            }
            NoFlight::NoEye => Self::could_not(error.to_string(), "report this"),
            NoFlight::Taken(..) => Self::argument(error.to_string(), "say --anew"),
            NoFlight::NoVideo { output, trouble, by_hand } => {
                Self::could_not(format!("{}: no video: {trouble}", output.display()), by_hand)
            }
        }
    }
}
