//! The air inside a cloud, before everything: one colour over the whole picture.

use super::{FrameBinding, begin, full_screen_pipeline};
use crate::format::LINEAR_FORMAT;
use crate::{Gpu, shader};

#[derive(Debug)]
pub(crate) struct VeilPass {
    pipeline: wgpu::RenderPipeline,
}

impl VeilPass {
    pub(crate) fn new(gpu: &Gpu, frame: &FrameBinding) -> Self {
        let target = wgpu::ColorTargetState {
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            ..LINEAR_FORMAT.into()
        };
        let layouts = [Some(&frame.layout)];
        Self { pipeline: full_screen_pipeline(gpu, "veil", shader::veil(), "draw_veil", &layouts, target) }
    }

    /// Over all that `target` shows.
    pub(crate) fn record(&self, encoder: &mut wgpu::CommandEncoder, frame: &FrameBinding, target: &wgpu::TextureView) {
        let mut pass = begin(encoder, "veil", target, wgpu::LoadOp::Load, None, None);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &frame.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
