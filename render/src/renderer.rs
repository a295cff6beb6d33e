//! Draws frames: into a texture for a window, or into memory.
//!
//! Keeps what it uploaded and uploads again only what another version number says has changed; targets follow the
//! frame's size. One renderer serves one device.

use crate::frame::{Passes, Targets};
use crate::readback::{read_texture, texels_from_f16};
use crate::timing::{PassClock, PassTime, PassTimer};
use crate::{Gpu, RenderError};
use cloudwright_core::color::{Premultiplied, Rgb};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::{Layer, LinearPicture, Picture};
use std::time::Instant;

/// Draws frames with one device.
#[derive(Debug)]
pub struct GpuRenderer {
    passes: Passes,
    targets: Option<Targets>,
    timer: Option<PassTimer>,
}

impl GpuRenderer {
    /// Compiles the shaders for `gpu`.
    ///
    /// # Errors
    /// If the device is lost, or its driver refuses a shader.
    pub fn new(gpu: &Gpu) -> Result<Self, RenderError> {
        gpu.check()?;
        let renderer = Self { passes: Passes::new(gpu)?, targets: None, timer: PassTimer::new(gpu) };
        gpu.check()?;
        Ok(renderer)
    }

    /// Draws `frame` and gives the texture that shows it: Rgba8Unorm, its values sRGB-encoded already, opaque, of the
    /// frame's size. Does not wait for the GPU. The texture is another one after a frame of another size.
    ///
    /// # Errors
    /// If the picture or the scene exceeds the device's limits, or the device fails.
    pub fn draw(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<&wgpu::TextureView, RenderError> {
        Ok(&self.submit_frame(gpu, frame)?.display.view)
    }

    /// The frame as a display shows it, in memory. Waits for the GPU.
    ///
    /// # Errors
    /// As [`GpuRenderer::draw`]; also if the GPU gives no answer.
    pub fn picture(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<Picture, RenderError> {
        let targets = self.submit_frame(gpu, frame)?;
        let [width, height] = targets.size;
        let bytes = read_texture(gpu, &targets.display.texture, 4)?;
        Ok(Picture { width, height, pixels: bytes.as_chunks::<4>().0.to_vec() })
    }

    /// The frame in linear light, before exposure, in memory: 16-bit floats' precision. Waits for the GPU.
    ///
    /// # Errors
    /// As [`GpuRenderer::picture`].
    pub fn linear_picture(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<LinearPicture, RenderError> {
        let targets = self.submit_frame(gpu, frame)?;
        let [width, height] = targets.size;
        let bytes = read_texture(gpu, &targets.linear.texture, 8)?;
        let pixels = texels_from_f16(&bytes).map(|[r, g, b, _]| Rgb::new(r, g, b)).collect();
        Ok(LinearPicture { width, height, pixels })
    }

    /// The frame's clouds alone over nothing, in memory. Waits for the GPU.
    ///
    /// # Errors
    /// As [`GpuRenderer::picture`].
    pub fn clouds(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<Layer, RenderError> {
        let (passes, targets) = self.update(gpu, frame)?;
        submit(gpu, |encoder| passes.record_clouds(encoder, targets))?;
        let [width, height] = targets.size;
        let bytes = read_texture(gpu, &targets.linear.texture, 8)?;
        let pixels = texels_from_f16(&bytes).map(|[r, g, b, a]| Premultiplied { r, g, b, a }).collect();
        Ok(Layer { width, height, pixels })
    }

    /// How long the sprites pass of `frame` takes, uploads left out. Draws it once and waits; a measure takes several
    /// and their median, after one or two to warm up.
    ///
    /// # Errors
    /// As [`GpuRenderer::picture`].
    pub fn sprites_pass_time(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<PassTime, RenderError> {
        self.update(gpu, frame)?;
        submit(gpu, |_| ())?;
        gpu.wait_until(|| true)?;
        let (passes, Some(targets), timer) = (&self.passes, &self.targets, &self.timer) else {
            return Err(RenderError::Refused("there is no target to draw into".into()));
        };
        let start = Instant::now();
        submit(gpu, |encoder| {
            passes.record_sprites(encoder, targets, timer.as_ref().map(PassTimer::writes));
            if let Some(timer) = timer {
                timer.resolve(encoder);
            }
        })?;
        match timer {
            Some(timer) => Ok(PassTime { duration: timer.read(gpu)?, clock: PassClock::Timestamps }),
            None => {
                gpu.wait_until(|| true)?;
                Ok(PassTime { duration: start.elapsed(), clock: PassClock::Wall })
            }
        }
    }

    /// How many bytes of the clouds' data the last frame uploaded: a cost that does not depend on the machine.
    pub fn bytes_uploaded(&self) -> u64 {
        self.passes.bytes_uploaded()
    }

    fn submit_frame(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<&Targets, RenderError> {
        let (passes, targets) = self.update(gpu, frame)?;
        submit(gpu, |encoder| passes.record(encoder, targets))?;
        Ok(targets)
    }

    /// Uploads what changed and makes targets of the frame's size.
    fn update(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<(&Passes, &Targets), RenderError> {
        gpu.check()?;
        let size = [frame.view.width, frame.view.height];
        let fitting = self.targets.take().filter(|targets| targets.size == size);
        let targets = match fitting {
            Some(targets) => targets,
            None => self.passes.targets(gpu, size)?,
        };
        let targets = self.targets.insert(targets);
        self.passes.update(gpu, frame)?;
        self.passes.complete(gpu, targets)?;
        gpu.check()?;
        Ok((&self.passes, targets))
    }
}

fn submit(gpu: &Gpu, record: impl FnOnce(&mut wgpu::CommandEncoder)) -> Result<(), RenderError> {
    let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("frame") });
    record(&mut encoder);
    gpu.queue().submit([encoder.finish()]);
    gpu.check()
}
