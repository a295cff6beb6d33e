//! THE RECIPE: the passes of a frame, top to bottom.
//!
//! ```text
//! shadows    the clouds' on the ground, on a map of their own, when clouds or light have moved
//! sky        covers the linear target
//! models     over it, with depth, if there are any
//! sprites    back to front over both, as far as they lie before the models
//! crossfade  while another order fades out: all of that again in that one, mixed in
//! veil       inside a cloud: the air before everything
//! tone_map   linear target → display target
//! ```
//! A new pass is a folder in pass/ and a line here.

use crate::atlas_texture::AtlasTexture;
use crate::cloud_data::CloudData;
use crate::format::{DEPTH_FORMAT, DISPLAY_FORMAT, LINEAR_FORMAT};
use crate::frame_uniform::FrameUniform;
use crate::model_data::ModelData;
use crate::pass::FrameBinding;
use crate::pass::crossfade::CrossfadePass;
use crate::pass::models::ModelsPass;
use crate::pass::shadows::ShadowsPass;
use crate::pass::sky::SkyPass;
use crate::pass::sprites::SpritesPass;
use crate::pass::tone_map::ToneMapPass;
use crate::pass::veil::VeilPass;
use crate::shadow_data::ShadowData;
use crate::texture::Target;
use crate::{Gpu, RenderError};
use cloudwright_core::frame::Frame;

const CLEAR: wgpu::LoadOp<wgpu::Color> = wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT);

/// Everything that a frame is drawn with but the targets.
#[derive(Debug)]
pub(crate) struct Passes {
    frame: FrameBinding,
    shadows: ShadowsPass,
    sky: SkyPass,
    models: ModelsPass,
    sprites: SpritesPass,
    crossfade: CrossfadePass,
    veil: VeilPass,
    tone_map: ToneMapPass,
    clouds: CloudData,
    atlas: AtlasTexture,
    models_in_view: ModelData,
    casters: ShadowData,
    sprites_binding: wgpu::BindGroup,
    /// Of this frame: the share of the older order, if one fades out, and whether there is a veil.
    fading: Option<f32>,
    veiled: bool,
}

/// What a frame is drawn into.
#[derive(Debug)]
pub(crate) struct Targets {
    pub(crate) size: [u32; 2],
    pub(crate) linear: Target,
    pub(crate) display: Target,
    tone_map_binding: wgpu::BindGroup,
    /// The picture in the order that fades out, once there has been one, and the binding that reads it.
    older: Option<(Target, wgpu::BindGroup)>,
    /// The models' depth and the sprites' binding of it, made for the first frame that has models.
    depth: Option<(Target, wgpu::BindGroup)>,
}

impl Passes {
    pub(crate) fn new(gpu: &Gpu) -> Result<Self, RenderError> {
        let frame = FrameBinding::new(gpu);
        let sprites = SpritesPass::new(gpu, &frame);
        let shadows = ShadowsPass::new(gpu, &frame, &sprites)?;
        let (clouds, atlas) = (CloudData::new(gpu), AtlasTexture::new(gpu));
        Ok(Self {
            sky: SkyPass::new(gpu, &frame, &shadows),
            models: ModelsPass::new(gpu, &frame),
            crossfade: CrossfadePass::new(gpu, &frame),
            veil: VeilPass::new(gpu, &frame),
            tone_map: ToneMapPass::new(gpu, &frame),
            sprites_binding: sprites.bind(gpu, &clouds, &atlas),
            frame,
            sprites,
            clouds,
            atlas,
            models_in_view: ModelData::new(gpu),
            casters: ShadowData::new(gpu),
            shadows,
            fading: None,
            veiled: false,
        })
    }

    /// Uploads what changed since the last frame.
    pub(crate) fn update(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<(), RenderError> {
        self.frame.write(gpu, &FrameUniform::new(frame));
        self.atlas.update(gpu, frame.atlas);
        self.models_in_view.update(gpu, frame)?;
        if self.clouds.update(gpu, frame)? {
            self.sprites_binding = self.sprites.bind(gpu, &self.clouds, &self.atlas);
        }
        self.casters.update(gpu, frame, &self.clouds)?;
        self.fading = frame.fading.as_ref().map(|(_, share)| *share);
        self.veiled = frame.veil.a > 0.0;
        Ok(())
    }

    /// By the last update: the clouds' data. Uniform and atlas are not counted.
    pub(crate) fn bytes_uploaded(&self) -> u64 {
        self.clouds.bytes_uploaded + self.casters.bytes_uploaded
    }

    pub(crate) fn targets(&self, gpu: &Gpu, size: [u32; 2]) -> Result<Targets, RenderError> {
        let linear = Target::new(gpu, "linear", LINEAR_FORMAT, size)?;
        let display = Target::new(gpu, "display", DISPLAY_FORMAT, size)?;
        let tone_map_binding = self.tone_map.bind(gpu, &linear);
        Ok(Targets { size, tone_map_binding, linear, display, older: None, depth: None })
    }

    /// Sees to it that `targets` has all that the updated frame is drawn into.
    pub(crate) fn complete(&self, gpu: &Gpu, targets: &mut Targets) -> Result<(), RenderError> {
        if self.fading.is_some() && targets.older.is_none() {
            let older = Target::new(gpu, "older order", LINEAR_FORMAT, targets.size)?;
            let binding = self.crossfade.bind(gpu, &older);
            targets.older = Some((older, binding));
        }
        if targets.depth.is_none() && !self.models_in_view.is_empty() {
            let depth = Target::new(gpu, "depth", DEPTH_FORMAT, targets.size)?;
            let binding = self.sprites.bind_models(gpu, &depth);
            targets.depth = Some((depth, binding));
        }
        Ok(())
    }

    /// A whole frame.
    pub(crate) fn record(&self, encoder: &mut wgpu::CommandEncoder, targets: &Targets) {
        self.shadows.record(encoder, &self.frame, &self.casters, &self.sprites_binding);
        self.record_behind(encoder, &targets.linear.view, targets);
        if let Some((older, _)) = self.older(targets) {
            self.record_behind(encoder, older, targets);
        }
        self.record_in_orders(encoder, targets, wgpu::LoadOp::Load, self.depth(targets).map(|(_, binding)| binding));
        self.tone_map.record(encoder, &self.frame, &targets.tone_map_binding, &targets.display.view);
    }

    /// The clouds alone, over nothing and before nothing.
    pub(crate) fn record_clouds(&self, encoder: &mut wgpu::CommandEncoder, targets: &Targets) {
        self.record_in_orders(encoder, targets, CLEAR, None);
    }

    /// Sky and models.
    fn record_behind(&self, encoder: &mut wgpu::CommandEncoder, target: &wgpu::TextureView, targets: &Targets) {
        self.sky.record(encoder, &self.frame, &self.shadows, target);
        if let Some((depth, _)) = self.depth(targets) {
            self.models.record(encoder, &self.frame, &self.models_in_view, target, &depth.view);
        }
    }

    /// Sprites, in the order that fades out too, and what comes over them.
    fn record_in_orders(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        targets: &Targets,
        load: wgpu::LoadOp<wgpu::Color>,
        models: Option<&wgpu::BindGroup>,
    ) {
        let linear = &targets.linear.view;
        let sprites = |encoder: &mut wgpu::CommandEncoder, order, target| {
            self.sprites.record(encoder, &self.frame, (order, &self.sprites_binding), (target, load), models, None);
        };
        sprites(encoder, &self.clouds.order, linear);
        if let (Some((older, binding)), Some(share)) = (self.older(targets), self.fading) {
            sprites(encoder, &self.clouds.older_order, older);
            self.crossfade.record(encoder, &self.frame, binding, share, linear);
        }
        if self.veiled {
            self.veil.record(encoder, &self.frame, linear);
        }
    }

    /// Where the order that fades out is drawn, if one does.
    fn older<'t>(&self, targets: &'t Targets) -> Option<(&'t wgpu::TextureView, &'t wgpu::BindGroup)> {
        self.fading.and(targets.older.as_ref()).map(|(target, binding)| (&target.view, binding))
    }

    /// That of the models, if there are any.
    fn depth<'t>(&self, targets: &'t Targets) -> Option<&'t (Target, wgpu::BindGroup)> {
        targets.depth.as_ref().filter(|_| !self.models_in_view.is_empty())
    }

    /// The sprites alone, over nothing and before nothing.
    pub(crate) fn record_sprites(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        targets: &Targets,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let order = (&self.clouds.order, &self.sprites_binding);
        self.sprites.record(encoder, &self.frame, order, (&targets.linear.view, CLEAR), None, timestamps);
    }
}
