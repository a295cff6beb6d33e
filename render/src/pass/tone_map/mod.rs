//! From linear light to what a display shows: exposure, tone curve, sRGB and dither.

use super::{FrameBinding, begin, full_screen_pipeline, picture_layout};
use crate::format::DISPLAY_FORMAT;
use crate::texture::Target;
use crate::{Gpu, shader};

#[derive(Debug)]
pub(crate) struct ToneMapPass {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
}

impl ToneMapPass {
    pub(crate) fn new(gpu: &Gpu, frame: &FrameBinding) -> Self {
        let layout = picture_layout(gpu, "tone map");
        let layouts = [Some(&frame.layout), Some(&layout)];
        let pipeline =
            full_screen_pipeline(gpu, "tone map", shader::tone_map(), "develop", &layouts, DISPLAY_FORMAT.into());
        Self { pipeline, layout }
    }

    /// The binding that reads `linear`.
    pub(crate) fn bind(&self, gpu: &Gpu, linear: &Target) -> wgpu::BindGroup {
        super::bind_picture(gpu, "tone map", &self.layout, linear)
    }

    /// Covers all of `target`.
    pub(crate) fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBinding,
        linear: &wgpu::BindGroup,
        target: &wgpu::TextureView,
    ) {
        let mut pass = begin(encoder, "tone map", target, wgpu::LoadOp::Clear(wgpu::Color::BLACK), None, None);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &frame.group, &[]);
        pass.set_bind_group(1, linear, &[]);
        pass.draw(0..3, 0..1);
    }
}
