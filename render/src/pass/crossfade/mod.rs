//! The picture in the order that fades out, mixed into the one in the newest order (W's suggestion against popping).

use super::{FrameBinding, begin, full_screen_pipeline, picture_layout};
use crate::format::LINEAR_FORMAT;
use crate::texture::Target;
use crate::{Gpu, shader};

#[derive(Debug)]
pub(crate) struct CrossfadePass {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
}

/// Its share of the older picture, the rest of the newer one.
const MIX: wgpu::BlendComponent = wgpu::BlendComponent {
    src_factor: wgpu::BlendFactor::Constant,
    dst_factor: wgpu::BlendFactor::OneMinusConstant,
    operation: wgpu::BlendOperation::Add,
};

impl CrossfadePass {
    pub(crate) fn new(gpu: &Gpu, frame: &FrameBinding) -> Self {
        let layout = picture_layout(gpu, "crossfade");
        let blend = Some(wgpu::BlendState { color: MIX, alpha: MIX });
        let target = wgpu::ColorTargetState { blend, ..LINEAR_FORMAT.into() };
        let layouts = [Some(&frame.layout), Some(&layout)];
        let pipeline = full_screen_pipeline(gpu, "crossfade", shader::crossfade(), "fade", &layouts, target);
        Self { pipeline, layout }
    }

    /// The binding that reads `older`.
    pub(crate) fn bind(&self, gpu: &Gpu, older: &Target) -> wgpu::BindGroup {
        super::bind_picture(gpu, "crossfade", &self.layout, older)
    }

    /// Mixes a `share` (0 to 1) of the older picture into `target`.
    pub(crate) fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBinding,
        older: &wgpu::BindGroup,
        share: f32,
        target: &wgpu::TextureView,
    ) {
        let mut pass = begin(encoder, "crossfade", target, wgpu::LoadOp::Load, None, None);
        let share = f64::from(share);
        pass.set_pipeline(&self.pipeline);
        pass.set_blend_constant(wgpu::Color { r: share, g: share, b: share, a: share });
        pass.set_bind_group(0, &frame.group, &[]);
        pass.set_bind_group(1, older, &[]);
        pass.draw(0..3, 0..1);
    }
}
