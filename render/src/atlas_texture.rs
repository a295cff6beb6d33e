//! The atlas on the GPU: sixteen layers with mip levels, premultiplied, uploaded when the sheet is another.

use crate::Gpu;
use cloudwright_core::sprites::{Atlas, MIP_LEVELS, TILE_SIZE, TILES};
use cloudwright_core::version::Version;

/// The tiles as an array texture.
#[derive(Debug)]
pub(crate) struct AtlasTexture {
    texture: wgpu::Texture,
    pub(crate) view: wgpu::TextureView,
    uploaded: Option<Version>,
}

impl AtlasTexture {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let texture = gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some("atlas"),
            size: wgpu::Extent3d {
                width: TILE_SIZE as u32,
                height: TILE_SIZE as u32,
                depth_or_array_layers: TILES as u32,
            },
            mip_level_count: MIP_LEVELS as u32,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2Array),
            ..Default::default()
        });
        Self { texture, view, uploaded: None }
    }

    /// Uploads `atlas` unless it is there already.
    pub(crate) fn update(&mut self, gpu: &Gpu, atlas: &Atlas) {
        if self.uploaded == Some(atlas.version()) {
            return;
        }
        for tile in 0..TILES {
            for mip in 0..MIP_LEVELS {
                self.write(gpu, atlas, tile, mip);
            }
        }
        self.uploaded = Some(atlas.version());
    }

    fn write(&self, gpu: &Gpu, atlas: &Atlas, tile: usize, mip: usize) {
        let level = atlas.level(tile, mip);
        let size = level.size as u32;
        gpu.queue().write_texture(
            wgpu::TexelCopyTextureInfo {
                texture: &self.texture,
                mip_level: mip as u32,
                origin: wgpu::Origin3d { x: 0, y: 0, z: tile as u32 },
                aspect: wgpu::TextureAspect::All,
            },
            bytemuck::cast_slice(&level.texels),
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * size), rows_per_image: Some(size) },
            wgpu::Extent3d { width: size, height: size, depth_or_array_layers: 1 },
        );
    }
}
