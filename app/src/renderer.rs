//! Where pictures come from: a GPU where there is one, the CPU everywhere.
//!
//! A frame says by its rules what draws it; a [`Renderer`] brings the adapter for those that ask for one. The viewport
//! draws with the window's own device instead, see viewport/picture.rs.

use clap::ValueEnum;
use cloudwright_core::draw::{self, Drawn};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::{LinearPicture, Picture};
use cloudwright_core::raster::develop;
use cloudwright_core::rules::{Rasterizer, Rules};
use cloudwright_core::watch::Watch;
use cloudwright_render::{AdapterChoice, Gpu, GpuError, PassClock};
use serde::{Deserialize, Serialize};
use std::time::Duration;

/// What the user asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
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

/// Draws frames by their rules: on the CPU, or on its adapter those that ask for one.
#[derive(Debug, Default)]
pub struct Renderer {
    adapter: Option<Box<(Gpu, cloudwright_render::GpuRenderer)>>,
}

impl Renderer {
    /// The renderer of that kind.
    ///
    /// # Errors
    /// If a GPU is asked for and there is none.
    pub fn new(choice: RendererChoice) -> Result<Self, RenderError> {
        match choice {
            RendererChoice::Cpu => Ok(Self::default()),
            // A program that plays a GPU is slower than our own on the same cores.
            RendererChoice::Auto => Ok(Self::with_adapter(&AdapterChoice::HardwareOnly).unwrap_or_default()),
            RendererChoice::Gpu => Self::with_adapter(&AdapterChoice::Any),
        }
    }

    /// One that has an adapter.
    ///
    /// # Errors
    /// If there is no such adapter.
    pub fn with_adapter(choice: &AdapterChoice) -> Result<Self, RenderError> {
        let gpu = Gpu::headless(choice)?;
        let renderer = cloudwright_render::GpuRenderer::new(&gpu)?;
        Ok(Self { adapter: Some(Box::new((gpu, renderer))) })
    }

    /// What it draws by unless a method is chosen.
    pub fn rules(&self) -> Rules {
        let rasterizer = if self.adapter.is_some() { Rasterizer::Gpu } else { Rules::SHIPPED.rasterizer };
        Rules { rasterizer, ..Rules::SHIPPED }
    }

    /// As the user is told.
    pub fn name(&self) -> String {
        self.adapter_name().unwrap_or_else(|| "CPU".into())
    }

    /// That of its adapter, if it has one.
    pub fn adapter_name(&self) -> Option<String> {
        self.adapter.as_ref().map(|parts| gpu_name(&parts.0))
    }

    /// The finished picture of `frame`. The truth tells `watch` how far it is, as [`draw::picture`].
    ///
    /// # Errors
    /// If the frame asks for a GPU, and there is none or it refuses.
    pub fn picture(&mut self, frame: &Frame<'_>, watch: &Watch) -> Result<Picture, RenderError> {
        if let Some(picture) = draw::picture(frame, watch) {
            return Ok(picture);
        }
        if frame.rules.pixels_a_pixel() > 1 {
            return Ok(develop(&self.linear(frame, watch)?, frame.now.exposure));
        }
        let (gpu, renderer) = self.adapter()?;
        Ok(renderer.picture(gpu, frame)?)
    }

    /// As [`Renderer::picture`], in linear light, before exposure.
    ///
    /// # Errors
    /// As [`Renderer::picture`].
    pub fn linear(&mut self, frame: &Frame<'_>, watch: &Watch) -> Result<LinearPicture, RenderError> {
        if let Some(linear) = draw::linear(frame, watch) {
            return Ok(linear);
        }
        let (gpu, renderer) = self.adapter()?;
        let (linear, side) = (renderer.linear_picture(gpu, frame)?, frame.rules.pixels_a_pixel());
        Ok(if side > 1 { linear.reduced(side) } else { linear })
    }

    /// `frame` for figures. The truth as in [`Renderer::picture`].
    ///
    /// # Errors
    /// As [`Renderer::picture`].
    pub fn drawn(&mut self, frame: &Frame<'_>, watch: &Watch) -> Result<Drawn, RenderError> {
        if let Some(drawn) = draw::drawn(frame, watch) {
            return Ok(drawn);
        }
        let (gpu, renderer) = self.adapter()?;
        let drawn = Drawn { linear: renderer.linear_picture(gpu, frame)?, clouds: Some(renderer.clouds(gpu, frame)?) };
        Ok(drawn.reduced(frame.rules.pixels_a_pixel()))
    }

    /// How long the sprites of `frame` take by the adapter's own clock; none if it has no clock.
    ///
    /// # Errors
    /// If there is no adapter, or it refuses.
    pub fn sprites_time(&mut self, frame: &Frame<'_>) -> Result<Option<Duration>, RenderError> {
        let (gpu, renderer) = self.adapter()?;
        let pass = renderer.sprites_pass_time(gpu, frame)?;
        Ok((pass.clock == PassClock::Timestamps).then_some(pass.duration))
    }

    fn adapter(&mut self) -> Result<(&Gpu, &mut cloudwright_render::GpuRenderer), RenderError> {
        let none = || {
            cloudwright_render::RenderError::Refused("this is drawn on a graphics adapter, and there is none".into())
        };
        let (gpu, renderer) = self.adapter.as_deref_mut().ok_or_else(none)?;
        Ok((gpu, renderer))
    }
}

/// A device as the user is told.
pub(crate) fn gpu_name(gpu: &Gpu) -> String {
    let kind = if gpu.is_software() { "software GPU" } else { "GPU" };
    format!("{kind}: {}", gpu.label())
}
