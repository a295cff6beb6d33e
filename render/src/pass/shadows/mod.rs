//! The clouds' shadows on the ground: what is left of the light, on a plane across it.
//!
//! An instance is a sprite of a cloud that casts one. It is drawn when clouds or light have moved, and kept while only the
//! eye does.

use super::{FrameBinding, begin};
use crate::cloud_data::Instance;
use crate::format::SHADOW_FORMAT;
use crate::pass::sprites::SpritesPass;
use crate::shadow_data::ShadowData;
use crate::texture::Target;
use crate::{Gpu, RenderError, shader};
use cloudwright_core::weather::shadows::MOST_TEXELS;

#[derive(Debug)]
pub(crate) struct ShadowsPass {
    pipeline: wgpu::RenderPipeline,
    map: Target,
    /// Of bind group 1 of the pass that reads it.
    pub(crate) layout: wgpu::BindGroupLayout,
    pub(crate) binding: wgpu::BindGroup,
}

impl ShadowsPass {
    /// # Errors
    /// If the device has no textures that large.
    pub(crate) fn new(gpu: &Gpu, frame: &FrameBinding, sprites: &SpritesPass) -> Result<Self, RenderError> {
        let map = Target::new(gpu, "shadows", SHADOW_FORMAT, [MOST_TEXELS; 2])?;
        let layout = layout(gpu);
        let sampler = gpu.device().create_sampler(&wgpu::SamplerDescriptor {
            label: Some("shadows"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..Default::default()
        });
        let binding = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("shadows"),
            layout: &layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&map.view) },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
            ],
        });
        let pipeline = pipeline(gpu, &[Some(&frame.layout), Some(&sprites.layout)]);
        Ok(Self { pipeline, map, layout, binding })
    }

    /// Draws them anew, if they are others than those that it holds.
    pub(crate) fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBinding,
        shadows: &ShadowData,
        clouds: &wgpu::BindGroup,
    ) {
        if !shadows.is_to_draw() {
            return;
        }
        let clear = wgpu::LoadOp::Clear(wgpu::Color::WHITE);
        let mut pass = begin(encoder, "shadows", &self.map.view, clear, None, None);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &frame.group, &[]);
        pass.set_bind_group(1, clouds, &[]);
        pass.set_vertex_buffer(0, shadows.casters.slice());
        shadows.runs.iter().for_each(|run| pass.draw(0..4, run.clone()));
        shadows.is_drawn();
    }
}

fn layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    gpu.device().create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("shadows"),
        entries: &[
            wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::FRAGMENT,
                ty: wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: true },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
                count: None,
            },
            wgpu::BindGroupLayoutEntry {
                binding: 1,
                visibility: wgpu::ShaderStages::FRAGMENT,
                ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
                count: None,
            },
        ],
    })
}

fn pipeline(gpu: &Gpu, layouts: &[Option<&wgpu::BindGroupLayout>]) -> wgpu::RenderPipeline {
    let device = gpu.device();
    let module = shader::module(device, "shadows", shader::shadows());
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("shadows"),
        bind_group_layouts: layouts,
        immediate_size: 0,
    });
    // What is there, times what comes.
    let multiplied = wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::Zero,
        dst_factor: wgpu::BlendFactor::Src,
        operation: wgpu::BlendOperation::Add,
    };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("shadows"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("place_spot"),
            compilation_options: Default::default(),
            buffers: &[Some(wgpu::VertexBufferLayout {
                array_stride: size_of::<Instance>() as u64,
                step_mode: wgpu::VertexStepMode::Instance,
                attributes: &wgpu::vertex_attr_array![0 => Uint32x3],
            })],
        },
        primitive: wgpu::PrimitiveState { topology: wgpu::PrimitiveTopology::TriangleStrip, ..Default::default() },
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("draw_spot"),
            compilation_options: Default::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format: SHADOW_FORMAT,
                blend: Some(wgpu::BlendState { color: multiplied, alpha: multiplied }),
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}
