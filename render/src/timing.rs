//! How long a pass takes: by the GPU's own timestamps where it has them, else by the clock on the wall.

use crate::readback::read_buffer;
use crate::{Gpu, RenderError};
use std::time::Duration;

/// What a time was taken with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PassClock {
    /// The GPU's timestamps: the pass alone.
    Timestamps,
    /// From submission to completion, with the driver's own work.
    Wall,
}

/// A pass's time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PassTime {
    /// How long.
    pub duration: Duration,
    /// By which clock.
    pub clock: PassClock,
}

/// Two timestamps around a pass.
#[derive(Debug)]
pub(crate) struct PassTimer {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    readable: wgpu::Buffer,
}

const STAMPS: u32 = 2;
const STAMPS_BYTES: u64 = STAMPS as u64 * size_of::<u64>() as u64;

impl PassTimer {
    /// None where the device has no timestamps.
    pub(crate) fn new(gpu: &Gpu) -> Option<Self> {
        if !gpu.device().features().contains(wgpu::Features::TIMESTAMP_QUERY) {
            return None;
        }
        let buffer = |usage| {
            gpu.device().create_buffer(&wgpu::BufferDescriptor {
                label: Some("timestamps"),
                size: STAMPS_BYTES,
                usage,
                mapped_at_creation: false,
            })
        };
        Some(Self {
            queries: gpu.device().create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("timestamps"),
                ty: wgpu::QueryType::Timestamp,
                count: STAMPS,
            }),
            resolved: buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC),
            readable: buffer(wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST),
        })
    }

    /// For the pass to be timed.
    pub(crate) fn writes(&self) -> wgpu::RenderPassTimestampWrites<'_> {
        wgpu::RenderPassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        }
    }

    /// After the pass, before submission.
    pub(crate) fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.resolve_query_set(&self.queries, 0..STAMPS, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.readable, 0, STAMPS_BYTES);
    }

    /// After submission: waits.
    pub(crate) fn read(&self, gpu: &Gpu) -> Result<Duration, RenderError> {
        let mut stamps = [0_u64; STAMPS as usize];
        read_buffer(gpu, &self.readable, |bytes| bytemuck::bytes_of_mut(&mut stamps).copy_from_slice(bytes))?;
        let ticks = stamps[1].saturating_sub(stamps[0]);
        let nanoseconds = ticks as f64 * f64::from(gpu.queue().get_timestamp_period());
        Ok(Duration::from_nanos(nanoseconds as u64))
    }
}
