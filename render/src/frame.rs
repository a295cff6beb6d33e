//! THE RECIPE: the passes of a frame, top to bottom.
//!
//! ```text
//! sky       covers the linear target
//! models    over it, with depth, if there are any
//! sprites   back to front over both, as far as they lie before the models
//! tone_map  linear target → display target
//! ```
//! A new pass is a folder in pass/ and a line here.

use crate::atlas_texture::AtlasTexture;
use crate::cloud_data::CloudData;
use crate::frame_uniform::FrameUniform;
use crate::model_data::ModelData;
use crate::pass::FrameBinding;
use crate::pass::models::ModelsPass;
use crate::pass::sky::SkyPass;
use crate::pass::sprites::SpritesPass;
use crate::pass::tone_map::ToneMapPass;
use crate::texture::{DEPTH_FORMAT, DISPLAY_FORMAT, LINEAR_FORMAT, Target};
use crate::{Gpu, RenderError};
use cloudwright_core::frame::Frame;

const CLEAR: wgpu::LoadOp<wgpu::Color> = wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT);

/// Everything that a frame is drawn with but the targets.
#[derive(Debug)]
pub(crate) struct Passes {
    frame: FrameBinding,
    sky: SkyPass,
    models: ModelsPass,
    sprites: SpritesPass,
    tone_map: ToneMapPass,
    clouds: CloudData,
    atlas: AtlasTexture,
    models_in_view: ModelData,
    sprites_binding: wgpu::BindGroup,
}

/// What a frame is drawn into.
#[derive(Debug)]
pub(crate) struct Targets {
    pub(crate) size: [u32; 2],
    pub(crate) linear: Target,
    pub(crate) display: Target,
    tone_map_binding: wgpu::BindGroup,
    /// The models' depth and the sprites' binding of it, made for the first frame that has models.
    depth: Option<(Target, wgpu::BindGroup)>,
}

impl Passes {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let frame = FrameBinding::new(gpu);
        let sprites = SpritesPass::new(gpu, &frame);
        let (clouds, atlas) = (CloudData::new(gpu), AtlasTexture::new(gpu));
        Self {
            sky: SkyPass::new(gpu, &frame),
            models: ModelsPass::new(gpu, &frame),
            tone_map: ToneMapPass::new(gpu, &frame),
            sprites_binding: sprites.bind(gpu, &clouds, &atlas),
            frame,
            sprites,
            clouds,
            atlas,
            models_in_view: ModelData::new(gpu),
        }
    }

    /// Uploads what changed since the last frame.
    pub(crate) fn update(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<(), RenderError> {
        self.frame.write(gpu, &FrameUniform::new(frame));
        self.atlas.update(gpu, frame.atlas);
        self.models_in_view.update(gpu, frame)?;
        if self.clouds.update(gpu, frame)? {
            self.sprites_binding = self.sprites.bind(gpu, &self.clouds, &self.atlas);
        }
        Ok(())
    }

    /// By the last update: the clouds' data. Uniform and atlas are not counted.
    pub(crate) fn bytes_uploaded(&self) -> u64 {
        self.clouds.bytes_uploaded
    }

    pub(crate) fn targets(&self, gpu: &Gpu, size: [u32; 2]) -> Result<Targets, RenderError> {
        let linear = Target::new(gpu, "linear", LINEAR_FORMAT, size)?;
        let display = Target::new(gpu, "display", DISPLAY_FORMAT, size)?;
        Ok(Targets { size, tone_map_binding: self.tone_map.bind(gpu, &linear), linear, display, depth: None })
    }

    /// Gives `targets` a depth if the last update's frame needs one.
    pub(crate) fn complete(&self, gpu: &Gpu, targets: &mut Targets) -> Result<(), RenderError> {
        if targets.depth.is_none() && !self.models_in_view.is_empty() {
            let depth = Target::new(gpu, "depth", DEPTH_FORMAT, targets.size)?;
            let binding = self.sprites.bind_models(gpu, &depth);
            targets.depth = Some((depth, binding));
        }
        Ok(())
    }

    /// A whole frame.
    pub(crate) fn record(&self, encoder: &mut wgpu::CommandEncoder, targets: &Targets) {
        self.sky.record(encoder, &self.frame, &targets.linear.view);
        let depth = targets.depth.as_ref().filter(|_| !self.models_in_view.is_empty());
        if let Some((depth, _)) = depth {
            self.models.record(encoder, &self.frame, &self.models_in_view, &targets.linear.view, &depth.view);
        }
        let clouds = (&self.clouds, &self.sprites_binding);
        let over = (&targets.linear.view, wgpu::LoadOp::Load);
        self.sprites.record(encoder, &self.frame, clouds, over, depth.map(|(_, binding)| binding), None);
        self.tone_map.record(encoder, &self.frame, &targets.tone_map_binding, &targets.display.view);
    }

    /// The sprites alone, over nothing and before nothing.
    pub(crate) fn record_sprites(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        targets: &Targets,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let clouds = (&self.clouds, &self.sprites_binding);
        self.sprites.record(encoder, &self.frame, clouds, (&targets.linear.view, CLEAR), None, timestamps);
    }
}
