//! Textures: the frame's targets, and tables of numbers that vertex shaders read.

use crate::{Gpu, RenderError};

/// A data texture's rows have 2 to this many texels: every device has textures that wide.
pub(crate) const DATA_ROW_BITS: u32 = 11;
const DATA_ROW: usize = 1 << DATA_ROW_BITS;
const TEXEL_BYTES: usize = size_of::<[u32; 4]>();

/// A texture to draw into, to read in a shader and to copy from.
#[derive(Debug)]
pub(crate) struct Target {
    pub(crate) texture: wgpu::Texture,
    pub(crate) view: wgpu::TextureView,
}

impl Target {
    /// # Errors
    /// If a side exceeds the device's limit.
    pub(crate) fn new(
        gpu: &Gpu,
        label: &str,
        format: wgpu::TextureFormat,
        [width, height]: [u32; 2],
    ) -> Result<Self, RenderError> {
        let limit = gpu.device().limits().max_texture_dimension_2d;
        if width.max(height) > limit {
            return Err(RenderError::TooLarge {
                what: "the picture's longer side",
                wanted: width.max(height).into(),
                limit_name: "max_texture_dimension_2d",
                limit: limit.into(),
                remedy: "make the picture smaller, or draw on the CPU",
            });
        }
        let texture = gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Ok(Self { texture, view })
    }
}

/// A long table of texels of four 32-bit words each, in rows of [`DATA_ROW`]: OpenGL ES 3.0 has no storage buffers,
/// and software rasterizers read textures faster. The words are bits; shaders turn them into floats where they are.
#[derive(Debug)]
pub(crate) struct DataTexture {
    label: &'static str,
    texture: wgpu::Texture,
    pub(crate) view: wgpu::TextureView,
}

impl DataTexture {
    pub(crate) fn new(gpu: &Gpu, label: &'static str) -> Self {
        let (texture, view) = Self::with_rows(gpu, label, 1);
        Self { label, texture, view }
    }

    fn with_rows(gpu: &Gpu, label: &str, rows: u32) -> (wgpu::Texture, wgpu::TextureView) {
        let texture = gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size: wgpu::Extent3d { width: DATA_ROW as u32, height: rows, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Uint,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        (texture, view)
    }

    /// Writes the table anew. True if the view is a new one, as after growth.
    ///
    /// # Errors
    /// If there are more texels than a texture holds.
    pub(crate) fn write<T: bytemuck::Pod>(&mut self, gpu: &Gpu, table: &[T]) -> Result<bool, RenderError> {
        let is_new = self.reserve::<T>(gpu, table.len())?;
        self.write_at(gpu, 0, table);
        Ok(is_new)
    }

    /// Makes room for so many elements. True if texture and view are new ones, which hold nothing.
    ///
    /// # Errors
    /// If there are more texels than a texture holds.
    pub(crate) fn reserve<T: bytemuck::Pod>(&mut self, gpu: &Gpu, elements: usize) -> Result<bool, RenderError> {
        let rows = (elements * size_of::<T>()).div_ceil(DATA_ROW * TEXEL_BYTES);
        let limit = gpu.device().limits().max_texture_dimension_2d;
        if rows > limit as usize {
            return Err(RenderError::TooLarge {
                what: "the scene's sprites, in rows of a data texture,",
                wanted: rows as u64,
                limit_name: "max_texture_dimension_2d",
                limit: limit.into(),
                remedy: "show fewer sprites, or draw on the CPU",
            });
        }
        let grow = rows as u32 > self.texture.height();
        if grow {
            // What grows once may grow again: a drag must not make a texture at each of its steps.
            let room = if self.texture.height() > 1 { rows / 2 } else { 0 };
            (self.texture, self.view) = Self::with_rows(gpu, self.label, (rows + room).min(limit as usize) as u32);
        }
        Ok(grow)
    }

    /// Writes over what the table holds from element `first` on; there must be room.
    pub(crate) fn write_at<T: bytemuck::Pod>(&self, gpu: &Gpu, first: usize, elements: &[T]) {
        let bytes: &[u8] = bytemuck::cast_slice(elements);
        let texel = first * size_of::<T>() / TEXEL_BYTES;
        let (row, column) = (texel / DATA_ROW, texel % DATA_ROW);
        // The rest of a row that is begun, whole rows, and the beginning of one.
        let (head, bytes) = bytes.split_at(bytes.len().min((DATA_ROW - column) % DATA_ROW * TEXEL_BYTES));
        let (body, tail) = bytes.split_at(bytes.len() - bytes.len() % (DATA_ROW * TEXEL_BYTES));
        let next = row + usize::from(column > 0);
        self.write_rows(gpu, head, [column, row]);
        self.write_rows(gpu, body, [0, next]);
        self.write_rows(gpu, tail, [0, next + body.len() / (DATA_ROW * TEXEL_BYTES)]);
    }

    /// Whole rows, or part of one.
    fn write_rows(&self, gpu: &Gpu, bytes: &[u8], [x, y]: [usize; 2]) {
        if bytes.is_empty() {
            return;
        }
        let texels = bytes.len() / TEXEL_BYTES;
        let (width, height) = (texels.min(DATA_ROW) as u32, texels.div_ceil(DATA_ROW) as u32);
        gpu.queue().write_texture(
            wgpu::TexelCopyTextureInfo {
                texture: &self.texture,
                mip_level: 0,
                origin: wgpu::Origin3d { x: x as u32, y: y as u32, z: 0 },
                aspect: wgpu::TextureAspect::All,
            },
            bytes,
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(width * TEXEL_BYTES as u32),
                rows_per_image: Some(height),
            },
            wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        );
    }
}
