//! THE RECIPE: the passes of a frame, top to bottom.
//!
//! ```text
//! sky       covers the linear target
//! sprites   back to front over it
//! tone_map  linear target → display target
//! ```
//! A new pass is a folder in pass/ and a line here.

use crate::atlas_texture::AtlasTexture;
use crate::cloud_data::CloudData;
use crate::frame_uniform::FrameUniform;
use crate::pass::FrameBinding;
use crate::pass::sky::SkyPass;
use crate::pass::sprites::SpritesPass;
use crate::pass::tone_map::ToneMapPass;
use crate::texture::{DISPLAY_FORMAT, LINEAR_FORMAT, Target};
use crate::{Gpu, RenderError};
use cloudwright_core::frame::Frame;

/// Everything that a frame is drawn with but the targets.
#[derive(Debug)]
pub(crate) struct Passes {
    frame: FrameBinding,
    sky: SkyPass,
    sprites: SpritesPass,
    tone_map: ToneMapPass,
    clouds: CloudData,
    atlas: AtlasTexture,
    sprites_binding: wgpu::BindGroup,
}

/// What a frame is drawn into.
#[derive(Debug)]
pub(crate) struct Targets {
    pub(crate) size: [u32; 2],
    pub(crate) linear: Target,
    pub(crate) display: Target,
    tone_map_binding: wgpu::BindGroup,
}

impl Passes {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let frame = FrameBinding::new(gpu);
        let sprites = SpritesPass::new(gpu, &frame);
        let (clouds, atlas) = (CloudData::new(gpu), AtlasTexture::new(gpu));
        Self {
            sky: SkyPass::new(gpu, &frame),
            tone_map: ToneMapPass::new(gpu, &frame),
            sprites_binding: sprites.bind(gpu, &clouds, &atlas),
            frame,
            sprites,
            clouds,
            atlas,
        }
    }

    /// Uploads what changed since the last frame.
    pub(crate) fn update(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<(), RenderError> {
        self.frame.write(gpu, &FrameUniform::new(frame));
        self.atlas.update(gpu, frame.atlas);
        if self.clouds.update(gpu, frame)? {
            self.sprites_binding = self.sprites.bind(gpu, &self.clouds, &self.atlas);
        }
        Ok(())
    }

    pub(crate) fn targets(&self, gpu: &Gpu, size: [u32; 2]) -> Result<Targets, RenderError> {
        let linear = Target::new(gpu, "linear", LINEAR_FORMAT, size)?;
        let display = Target::new(gpu, "display", DISPLAY_FORMAT, size)?;
        Ok(Targets { size, tone_map_binding: self.tone_map.bind(gpu, &linear), linear, display })
    }

    /// A whole frame.
    pub(crate) fn record(&self, encoder: &mut wgpu::CommandEncoder, targets: &Targets) {
        self.sky.record(encoder, &self.frame, &targets.linear.view);
        self.record_sprites(encoder, targets, wgpu::LoadOp::Load, None);
        self.tone_map.record(encoder, &self.frame, &targets.tone_map_binding, &targets.display.view);
    }

    /// The sprites alone.
    pub(crate) fn record_sprites(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        targets: &Targets,
        load: wgpu::LoadOp<wgpu::Color>,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let clouds = (&self.clouds, &self.sprites_binding);
        self.sprites.record(encoder, &self.frame, clouds, (&targets.linear.view, load), timestamps);
    }
}
