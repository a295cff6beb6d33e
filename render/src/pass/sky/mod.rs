//! The background: sky dome, sun's disc, ground and haze, in one triangle that covers the picture.

use super::{FrameBinding, begin, full_screen_pipeline};
use crate::format::LINEAR_FORMAT;
use crate::pass::shadows::ShadowsPass;
use crate::{Gpu, shader};

#[derive(Debug)]
pub(crate) struct SkyPass {
    pipeline: wgpu::RenderPipeline,
}

impl SkyPass {
    pub(crate) fn new(gpu: &Gpu, frame: &FrameBinding, shadows: &ShadowsPass) -> Self {
        let layouts = [Some(&frame.layout), Some(&shadows.layout)];
        Self {
            pipeline: full_screen_pipeline(
                gpu,
                "sky",
                shader::sky(),
                "draw_background",
                &layouts,
                LINEAR_FORMAT.into(),
            ),
        }
    }

    /// Covers all of `target`.
    pub(crate) fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBinding,
        shadows: &ShadowsPass,
        target: &wgpu::TextureView,
    ) {
        let mut pass = begin(encoder, "sky", target, wgpu::LoadOp::Clear(wgpu::Color::BLACK), None, None);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &frame.group, &[]);
        pass.set_bind_group(1, &shadows.binding, &[]);
        pass.draw(0..3, 0..1);
    }
}
