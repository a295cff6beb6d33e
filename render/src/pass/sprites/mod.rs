//! The sprites: instanced quads, back to front, premultiplied `over`.
//!
//! An instance is three numbers: the cloud, the sprite, and the pose of one near the eye. The vertex shader reads what they
//! are from data textures, turns the quad to the eye and lights its corners. Sprites have no depth buffer, the draw list's
//! order is the order; where there are models, another fragment shader compares with their depth and fades what is behind.

use super::{FrameBinding, begin};
use crate::atlas_texture::AtlasTexture;
use crate::buffer::VertexBuffer;
use crate::cloud_data::{CloudData, Instance};
use crate::format::LINEAR_FORMAT;
use crate::texture::Target;
use crate::{Gpu, shader};

#[derive(Debug)]
pub(crate) struct SpritesPass {
    pipeline: wgpu::RenderPipeline,
    among_models: wgpu::RenderPipeline,
    pub(crate) layout: wgpu::BindGroupLayout,
    models_layout: wgpu::BindGroupLayout,
    sampler: wgpu::Sampler,
}

impl SpritesPass {
    pub(crate) fn new(gpu: &Gpu, frame: &FrameBinding) -> Self {
        let layout = gpu.device().create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("sprites"),
            entries: &[
                data_entry(0),
                data_entry(1),
                data_entry(2),
                data_entry(3),
                data_entry(4),
                wgpu::BindGroupLayoutEntry {
                    binding: 5,
                    visibility: wgpu::ShaderStages::FRAGMENT,
                    ty: wgpu::BindingType::Texture {
                        sample_type: wgpu::TextureSampleType::Float { filterable: true },
                        view_dimension: wgpu::TextureViewDimension::D2Array,
                        multisampled: false,
                    },
                    count: None,
                },
                wgpu::BindGroupLayoutEntry {
                    binding: 6,
                    visibility: wgpu::ShaderStages::FRAGMENT,
                    ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
                    count: None,
                },
                data_entry(7),
                data_entry(8),
                data_entry(9),
            ],
        });
        // Clamped to the edge, which is clear at every level.
        let sampler = gpu.device().create_sampler(&wgpu::SamplerDescriptor {
            label: Some("atlas"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: wgpu::MipmapFilterMode::Linear,
            ..Default::default()
        });
        let models_layout = gpu.device().create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("nearness of models"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::FRAGMENT,
                // Not as a depth: OpenGL could then only compare with it.
                ty: wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: false },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
                count: None,
            }],
        });
        let layouts = [Some(&frame.layout), Some(&layout), Some(&models_layout)];
        Self {
            pipeline: pipeline(gpu, "draw_sprite", &layouts[..2]),
            among_models: pipeline(gpu, "draw_sprite_among_models", &layouts),
            layout,
            models_layout,
            sampler,
        }
    }

    /// The binding that reads `clouds` and `atlas`; stale when a texture of theirs is replaced.
    pub(crate) fn bind(&self, gpu: &Gpu, clouds: &CloudData, atlas: &AtlasTexture) -> wgpu::BindGroup {
        let data = [&clouds.sprites, &clouds.groups, &clouds.clouds, &clouds.moments, &clouds.poses];
        let views = data.map(|data| &data.view).into_iter().chain([&atlas.view]);
        let mut entries: Vec<_> = views
            .zip(0..)
            .map(|(view, binding)| wgpu::BindGroupEntry { binding, resource: wgpu::BindingResource::TextureView(view) })
            .collect();
        entries.push(wgpu::BindGroupEntry { binding: 6, resource: wgpu::BindingResource::Sampler(&self.sampler) });
        for (data, binding) in [(&clouds.stirs, 7), (&clouds.baked, 8), (&clouds.shades, 9)] {
            entries.push(wgpu::BindGroupEntry { binding, resource: wgpu::BindingResource::TextureView(&data.view) });
        }
        gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("sprites"),
            layout: &self.layout,
            entries: &entries,
        })
    }

    /// The binding that reads the depth of models, a target of the frame's.
    pub(crate) fn bind_models(&self, gpu: &Gpu, depth: &Target) -> wgpu::BindGroup {
        gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("nearness of models"),
            layout: &self.models_layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&depth.view) }],
        })
    }

    /// Blends the sprites in `order` over what `target` shows, or over nothing where `load` clears it; if there are
    /// `models`, what lies before them.
    pub(crate) fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &FrameBinding,
        (order, binding): (&VertexBuffer, &wgpu::BindGroup),
        (target, load): (&wgpu::TextureView, wgpu::LoadOp<wgpu::Color>),
        models: Option<&wgpu::BindGroup>,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let mut pass = begin(encoder, "sprites", target, load, None, timestamps);
        pass.set_pipeline(if models.is_some() { &self.among_models } else { &self.pipeline });
        if let Some(models) = models {
            pass.set_bind_group(2, models, &[]);
        }
        pass.set_bind_group(0, &frame.group, &[]);
        pass.set_bind_group(1, binding, &[]);
        pass.set_vertex_buffer(0, order.slice());
        pass.draw(0..4, 0..order.count());
    }
}

fn data_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX,
        ty: wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Uint,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    }
}

fn pipeline(gpu: &Gpu, entry_point: &str, layouts: &[Option<&wgpu::BindGroupLayout>]) -> wgpu::RenderPipeline {
    let device = gpu.device();
    let module = shader::module(device, "sprites", shader::sprites());
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("sprites"),
        bind_group_layouts: layouts,
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("sprites"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("place_corner"),
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
            entry_point: Some(entry_point),
            compilation_options: Default::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format: LINEAR_FORMAT,
                blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}
