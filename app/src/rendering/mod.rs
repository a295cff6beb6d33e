//! Pictures of a scene as files: the one way that the command line and the window's dialogs share.

mod flight;
mod kind;
mod painter;
mod still;

pub(crate) use flight::{Eye, Film, Filmed, Flight, NoFlight, check_size, count, is_video, last_key_s, range};
pub(crate) use kind::{Said, draw, kind_of, pack};
pub(crate) use painter::{Painter, Painting};
pub(crate) use still::{Still, StillEye};

use crate::renderer::RenderError;

/// Samples of one picture held in memory at once: 4K with 16 samples a pixel fits, some 4 GB at the most.
const MAX_SAMPLES: u64 = 1 << 27;
/// A sample in layers takes as much memory as so many without.
pub(crate) const IN_LAYERS: u64 = 6;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub(crate) enum NoPicture {
    /// What draws it refuses.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The file has no room for it, and why.
    #[error("the picture can't be packed: {0} (try a smaller size)")]
    TooLarge(String),
    /// It takes more memory than is given to one.
    #[error(transparent)]
    TooManySamples(#[from] TooManySamples),
    /// The rules keep no layers.
    #[error("these rules keep no layers")]
    NoLayers,
    /// It was no longer wanted.
    #[error("it was stopped")]
    Stopped,
}

/// How many samples a picture would take, and may take.
#[derive(Debug, Clone, Copy, thiserror::Error)]
#[error("{width}x{height} with {each} samples a pixel is {millions} million samples, and at most {most} million fit")]
pub(crate) struct TooManySamples {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) each: u32,
    pub(crate) millions: u64,
    pub(crate) most: u64,
}

/// That the samples of one picture fit into memory, of which each takes as much as `weight` samples of an ordinary one.
pub(crate) fn check_memory([width, height]: [u32; 2], side: u32, weight: u64) -> Result<(), TooManySamples> {
    let samples = u64::from(width) * u64::from(height) * u64::from(side * side);
    let most = MAX_SAMPLES / weight;
    if samples <= most {
        return Ok(());
    }
    let (millions, most) = (samples / 1_000_000, most / 1_000_000);
    Err(TooManySamples { width, height, each: side * side, millions, most })
}
