//! The aircraft: opaque, before the sprites, which read their depth.
//!
//! Depth is reversed, 1 at the near plane and 0 at infinity: a float's precision then lies where the quotient needs it,
//! and a kilometre away things a millimetre apart are told apart (Lapidous and Jiao 1999). OpenGL's way over −1 to 1
//! leaves it half a metre there.

use super::{FrameBinding, begin};
use crate::format::{DEPTH_FORMAT, LINEAR_FORMAT};
use crate::model_data::{ModelData, ModelInstance};
use crate::{Gpu, shader};
use cloudwright_core::model_mesh::ModelVertex;

#[derive(Debug)]
pub(crate) struct ModelsPass {
    pipeline: wgpu::RenderPipeline,
}

impl ModelsPass {
    pub(crate) fn new(gpu: &Gpu, frame: &FrameBinding) -> Self {
        Self { pipeline: pipeline(gpu, &[Some(&frame.layout)]) }
    }

    /// Draws `models` over what `target` shows, and clears `depth` before.
    pub(crate) fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBinding,
        models: &ModelData,
        target: &wgpu::TextureView,
        depth: &wgpu::TextureView,
    ) {
        let depth = wgpu::RenderPassDepthStencilAttachment {
            view: depth,
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Store }),
            stencil_ops: None,
        };
        let mut pass = begin(encoder, "models", target, wgpu::LoadOp::Load, Some(depth), None);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &frame.group, &[]);
        pass.set_vertex_buffer(1, models.placed.slice());
        for (mesh, instance) in models.meshes_in_order().zip(0..) {
            pass.set_vertex_buffer(0, mesh.slice());
            pass.draw(0..mesh.count(), instance..instance + 1);
        }
    }
}

fn pipeline(gpu: &Gpu, layouts: &[Option<&wgpu::BindGroupLayout>]) -> wgpu::RenderPipeline {
    let device = gpu.device();
    let module = shader::module(device, "models", shader::models());
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("models"),
        bind_group_layouts: layouts,
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("models"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("place_vertex"),
            compilation_options: Default::default(),
            buffers: &[
                Some(wgpu::VertexBufferLayout {
                    array_stride: size_of::<ModelVertex>() as u64,
                    step_mode: wgpu::VertexStepMode::Vertex,
                    attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x3],
                }),
                Some(wgpu::VertexBufferLayout {
                    array_stride: size_of::<ModelInstance>() as u64,
                    step_mode: wgpu::VertexStepMode::Instance,
                    attributes: &wgpu::vertex_attr_array![3 => Float32x4, 4 => Float32x4, 5 => Float32],
                }),
            ],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH_FORMAT,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Greater),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("draw_model"),
            compilation_options: Default::default(),
            targets: &[Some(LINEAR_FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
