//! A vertex buffer that grows: rewritten whenever its elements change, allocated anew only when they need more.

use crate::{Gpu, RenderError};

/// Elements for the vertex stage.
#[derive(Debug)]
pub(crate) struct VertexBuffer {
    what: &'static str,
    buffer: wgpu::Buffer,
    count: u32,
    bytes: u64,
}

impl VertexBuffer {
    /// Empty; `what` it holds, for messages.
    pub(crate) fn new(gpu: &Gpu, what: &'static str) -> Self {
        Self { what, buffer: Self::with_size(gpu, what, 1024), count: 0, bytes: 0 }
    }

    fn with_size(gpu: &Gpu, what: &str, size: u64) -> wgpu::Buffer {
        gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some(what),
            size,
            usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    }

    /// Replaces the elements.
    ///
    /// # Errors
    /// If they exceed the device's largest buffer.
    pub(crate) fn write<T: bytemuck::Pod>(&mut self, gpu: &Gpu, elements: &[T]) -> Result<(), RenderError> {
        let bytes: &[u8] = bytemuck::cast_slice(elements);
        let (wanted, limit) = (bytes.len() as u64, gpu.device().limits().max_buffer_size);
        if wanted > limit {
            return Err(RenderError::TooLarge {
                what: self.what,
                wanted,
                limit_name: "max_buffer_size",
                limit,
                remedy: "show less, or draw on the CPU",
            });
        }
        if wanted > self.buffer.size() {
            // Room to grow, so that a flight into a cloud does not allocate every frame.
            self.buffer = Self::with_size(gpu, self.what, (wanted + wanted / 2).next_multiple_of(4).min(limit));
        }
        gpu.queue().write_buffer(&self.buffer, 0, bytes);
        (self.count, self.bytes) = (elements.len() as u32, wanted);
        Ok(())
    }

    pub(crate) fn slice(&self) -> wgpu::BufferSlice<'_> {
        self.buffer.slice(..)
    }

    /// How large its elements are together, bytes.
    pub(crate) fn bytes(&self) -> u64 {
        self.bytes
    }

    /// How many elements it holds.
    pub(crate) fn count(&self) -> u32 {
        self.count
    }
}
