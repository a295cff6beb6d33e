//! From linear light to what a display shows: exposure, tone curve, sRGB and dither.

use super::{FrameBinding, begin, full_screen_pipeline};
use crate::texture::{DISPLAY_FORMAT, Target};
use crate::{Gpu, shader};

#[derive(Debug)]
pub(crate) struct ToneMapPass {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
}

impl ToneMapPass {
    pub(crate) fn new(gpu: &Gpu, frame: &FrameBinding) -> Self {
        let layout = gpu.device().create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("tone map"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::FRAGMENT,
                ty: wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: false },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
                count: None,
            }],
        });
        let layouts = [Some(&frame.layout), Some(&layout)];
        let pipeline = full_screen_pipeline(gpu, "tone map", shader::tone_map(), "develop", &layouts, DISPLAY_FORMAT);
        Self { pipeline, layout }
    }

    /// The binding that reads `linear`.
    pub(crate) fn bind(&self, gpu: &Gpu, linear: &Target) -> wgpu::BindGroup {
        gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("tone map"),
            layout: &self.layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&linear.view) }],
        })
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
