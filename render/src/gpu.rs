//! An adapter's device and queue: headless, or a window's own.
//!
//! Asks for no more than OpenGL ES 3.0 has (WebGL 2's limits: no compute, no storage buffers) but for the sizes of
//! textures and buffers, so that software rasterizers and old machines draw too. Timestamps are taken where they are
//! offered. Losing the device is an event ([`Gpu::check`]), never a panic.

use crate::adapter::{self, AdapterChoice};
use crate::fault::Faults;
use crate::{GpuError, RenderError};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A device to draw with.
#[derive(Debug, Clone)]
pub struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    info: wgpu::AdapterInfo,
    faults: Arc<Faults>,
}

/// How long a frame may take before the device is given up. A software rasterizer may need many seconds.
const PATIENCE: Duration = Duration::from_secs(180);
/// One wait. Short, because Mesa's OpenGL gives up a long one half-way and says so with an error.
const ONE_WAIT: Duration = Duration::from_secs(1);

impl Gpu {
    /// A device without a window.
    ///
    /// # Errors
    /// If no adapter fits the choice, or it gives no device.
    pub fn headless(choice: &AdapterChoice) -> Result<Self, GpuError> {
        let adapter = adapter::find(choice)?;
        let info = adapter.get_info();
        let no_device = |source| GpuError::NoDevice { adapter: adapter::label(&info), source };
        let descriptor = Self::device_descriptor(&adapter);
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).map_err(no_device)?;
        Ok(Self::from_parts(device, queue, info))
    }

    /// Draws with a window's own device. It should have been asked for with [`Gpu::device_descriptor`]; its handlers
    /// for lost devices and uncaptured errors are replaced.
    pub fn from_parts(device: wgpu::Device, queue: wgpu::Queue, info: wgpu::AdapterInfo) -> Self {
        let faults = Faults::of(&device);
        Self { device, queue, info, faults }
    }

    /// What a device must be able to do to draw frames, for a window that asks for its own.
    pub fn device_descriptor(adapter: &wgpu::Adapter) -> wgpu::DeviceDescriptor<'static> {
        let limits = adapter.limits();
        wgpu::DeviceDescriptor {
            label: Some("cloudwright"),
            required_features: adapter.features() & wgpu::Features::TIMESTAMP_QUERY,
            required_limits: wgpu::Limits {
                max_buffer_size: limits.max_buffer_size,
                ..wgpu::Limits::downlevel_webgl2_defaults().using_resolution(limits)
            },
            ..Default::default()
        }
    }

    /// The adapters of this machine, best first, software included.
    pub fn adapters() -> Vec<wgpu::AdapterInfo> {
        adapter::all().iter().map(wgpu::Adapter::get_info).collect()
    }

    /// Whether this machine has an adapter that is more than a program on the CPU.
    pub fn is_hardware_here() -> bool {
        adapter::all().iter().any(|adapter| !adapter::is_software(&adapter.get_info()))
    }

    /// wgpu's device.
    pub fn device(&self) -> &wgpu::Device {
        &self.device
    }

    /// Its queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// What the driver says of itself.
    pub fn info(&self) -> &wgpu::AdapterInfo {
        &self.info
    }

    /// Name and backend, for people.
    pub fn label(&self) -> String {
        adapter::label(&self.info)
    }

    /// Whether the “GPU” is a program on the CPU.
    pub fn is_software(&self) -> bool {
        adapter::is_software(&self.info)
    }

    /// What the device reported since the last look.
    ///
    /// # Errors
    /// [`RenderError::DeviceLost`] from then on, [`RenderError::Refused`] once.
    pub fn check(&self) -> Result<(), RenderError> {
        // wgpu tells of a loss when it is polled.
        self.poll(wgpu::PollType::Poll)?;
        self.faults.check()
    }

    /// Waits for all that was submitted, and until `done` says so.
    pub(crate) fn wait_until(&self, mut done: impl FnMut() -> bool) -> Result<(), RenderError> {
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            let all_done = self.poll(wgpu::PollType::Wait { submission_index: None, timeout: Some(ONE_WAIT) })?;
            self.faults.check()?;
            if all_done && done() {
                return Ok(());
            }
        }
        Err(RenderError::TimedOut(PATIENCE.as_secs()))
    }

    /// False if a wait was in vain. wgpu panics where it polls a device that is gone; to us that is an event.
    fn poll(&self, how: wgpu::PollType) -> Result<bool, RenderError> {
        match catch_unwind(AssertUnwindSafe(|| self.device.poll(how))) {
            Ok(Ok(_)) => Ok(true),
            Ok(Err(wgpu::PollError::Timeout)) => Ok(false),
            Ok(Err(error)) => Err(RenderError::Refused(error.to_string())),
            Err(_) => {
                self.faults.note_loss("it does not answer");
                self.faults.check().map(|()| false)
            }
        }
    }
}
