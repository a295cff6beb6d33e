//! The GPU renderer: draws a [`cloudwright_core::frame::Frame`] with wgpu, the same picture as
//! [`cloudwright_core::raster::plain`] within the rounding of a 16-bit float target.
//!
//! [`Gpu`] is an adapter's device and queue, for a window, headless or a test; [`GpuRenderer`] draws frames with it.
//! frame.rs is the recipe of a frame, pass/ has a folder for each step of it, shader/ the snippets that steps share.
//! Nothing here panics for what a user does: a lost device, a scene too large, a driver that gives up are errors.
//!
//! ```no_run
//! # fn picture(frame: &cloudwright_core::frame::Frame<'_>) -> Result<(), Box<dyn std::error::Error>> {
//! use cloudwright_render::{AdapterChoice, Gpu, GpuRenderer};
//! let gpu = Gpu::headless(&AdapterChoice::Any)?;
//! let picture = GpuRenderer::new(&gpu)?.picture(&gpu, frame)?;
//! # Ok(()) }
//! ```

mod adapter;
mod atlas_texture;
mod buffer;
mod cloud_data;
mod error;
mod fault;
mod format;
mod frame;
mod frame_uniform;
mod gpu;
pub mod layout;
mod model_data;
mod pass;
mod readback;
mod renderer;
pub mod shader;
mod shadow_data;

mod texels;
mod texture;
mod timing;

pub use adapter::AdapterChoice;
pub use error::{GpuError, RenderError};
pub use gpu::Gpu;
pub use renderer::GpuRenderer;
pub use timing::{PassClock, PassTime};
pub use wgpu;
