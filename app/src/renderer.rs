//! Where pictures come from: a GPU where there is one, the CPU everywhere.
//!
//! The rest of the program asks a [`Renderer`] and doesn't know which it is. Both draw the same [`Frame`].

use clap::ValueEnum;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::raster;

/// What the user asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum RendererChoice {
    /// A GPU if there is one, else the CPU
    #[default]
    Auto,
    /// A GPU, or an error
    Gpu,
    /// The CPU
    Cpu,
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// No graphics card to draw with.
    #[error("there is no GPU that can draw here: {0} (use --renderer cpu, or auto)")]
    NoGpu(String),
}

/// Draws frames.
#[derive(Debug)]
pub enum Renderer {
    /// All cores.
    Cpu,
    // GPU: `Gpu(Box<(cloudwright_render::Gpu, cloudwright_render::Renderer)>)` goes here.
}

impl Renderer {
    /// The renderer of that kind.
    ///
    /// # Errors
    /// If a GPU is asked for and there is none.
    pub fn new(choice: RendererChoice) -> Result<Self, RenderError> {
        match choice {
            // GPU: `Auto` tries `Gpu::headless` and takes it unless `is_software`.
            RendererChoice::Auto | RendererChoice::Cpu => Ok(Self::Cpu),
            RendererChoice::Gpu => Err(RenderError::NoGpu("this build has only the CPU renderer".into())),
        }
    }

    /// As the user is told.
    pub fn name(&self) -> String {
        match self {
            Self::Cpu => "CPU".into(),
        }
    }

    /// The finished picture of `frame`, whose view is `side` times as wide and high as the picture: `side` × `side`
    /// samples a pixel, averaged in linear light.
    ///
    /// # Errors
    /// If the GPU refuses.
    pub fn picture(&mut self, frame: &Frame<'_>, side: u32) -> Result<Picture, RenderError> {
        match self {
            Self::Cpu if side <= 1 => Ok(raster::fast::picture(frame)),
            Self::Cpu => Ok(raster::develop(&raster::fast::linear_picture(frame).reduced(side), frame.exposure)),
        }
    }
}
