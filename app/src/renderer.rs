//! Where pictures come from: a GPU where there is one, the CPU everywhere.
//!
//! The rest of the program asks a [`Renderer`] and doesn't know which it is. Both draw the same [`Frame`]. The
//! viewport draws with the window's own device instead, see viewport/picture.rs.

use clap::ValueEnum;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::raster;
use cloudwright_render::{AdapterChoice, Gpu, GpuError};

/// What the user asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum RendererChoice {
    /// A GPU if there is one, else the CPU
    #[default]
    Auto,
    /// A GPU, also one that is a program on the CPU, or an error
    Gpu,
    /// The CPU
    Cpu,
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// No GPU to draw with.
    #[error("{0} (use --renderer cpu, or auto)")]
    NoGpu(#[from] GpuError),
    /// The GPU refuses this picture.
    #[error("{0} (or use --renderer cpu)")]
    Gpu(#[from] cloudwright_render::RenderError),
}

/// Draws frames.
#[derive(Debug)]
pub enum Renderer {
    /// All cores.
    Cpu,
    /// A device without a window.
    Gpu(Box<(Gpu, cloudwright_render::Renderer)>),
}

impl Renderer {
    /// The renderer of that kind.
    ///
    /// # Errors
    /// If a GPU is asked for and there is none.
    pub fn new(choice: RendererChoice) -> Result<Self, RenderError> {
        match choice {
            RendererChoice::Cpu => Ok(Self::Cpu),
            // A program that plays a GPU is slower than our own on the same cores.
            RendererChoice::Auto => Ok(Self::on_gpu(&AdapterChoice::HardwareOnly).unwrap_or(Self::Cpu)),
            RendererChoice::Gpu => Self::on_gpu(&AdapterChoice::Any),
        }
    }

    fn on_gpu(choice: &AdapterChoice) -> Result<Self, RenderError> {
        let gpu = Gpu::headless(choice)?;
        let renderer = cloudwright_render::Renderer::new(&gpu)?;
        Ok(Self::Gpu(Box::new((gpu, renderer))))
    }

    /// As the user is told.
    pub fn name(&self) -> String {
        match self {
            Self::Cpu => "CPU".into(),
            Self::Gpu(parts) => gpu_name(&parts.0),
        }
    }

    /// The finished picture of `frame`, whose view is `side` times as wide and high as the picture: `side` × `side`
    /// samples a pixel, averaged in linear light.
    ///
    /// # Errors
    /// If the GPU refuses.
    pub fn picture(&mut self, frame: &Frame<'_>, side: u32) -> Result<Picture, RenderError> {
        let linear = match self {
            Self::Cpu if side <= 1 => return Ok(raster::fast::picture(frame)),
            Self::Cpu => raster::fast::linear_picture(frame),
            Self::Gpu(parts) => {
                let (gpu, renderer) = parts.as_mut();
                if side <= 1 {
                    return Ok(renderer.picture(gpu, frame)?);
                }
                renderer.linear_picture(gpu, frame)?
            }
        };
        Ok(raster::develop(&linear.reduced(side), frame.exposure))
    }
}

/// A device as the user is told.
pub(crate) fn gpu_name(gpu: &Gpu) -> String {
    let kind = if gpu.is_software() { "software GPU" } else { "GPU" };
    format!("{kind}: {}", gpu.label())
}
